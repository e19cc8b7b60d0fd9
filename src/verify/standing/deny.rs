//! Links that fail: numbers that show it, or why none are given.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Line;
use crate::source::Span;
use crate::verify::Role;
use crate::verify::facts::Source;
use crate::verify::facts::proof::prove;
use crate::verify::facts::small::Small;
use crate::verify::facts::world::World;
use crate::verify::language::messages;
use crate::verify::model::atoms::Nature;
use crate::verify::model::loads::Called;
use crate::verify::model::system::BodyId;
use crate::verify::reading::Premise;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Held, nothing_made_of};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::kept::moves;
use crate::verify::standing::roles::Purpose;
use crate::verify::standing::shown::shown;
use crate::verify::standing::verdicts::{Answer, Standing};
use crate::verify::term::integrals::has_integral;

use num_traits::Zero;
use std::collections::BTreeSet;
use std::sync::Arc;

impl Judge<'_> {
    /// A link that fails is shown by a motion, unless what was not taken in could make it true.
    pub(super) fn deny(&mut self, link: &Link<'_>, held: &mut Held, residuals: &[Fraction]) {
        if let Some(sentence) = self.unused_of(link.sides()) {
            held.doubt = Some(nothing_made_of(sentence));
            return;
        }
        if let Some(line) = self.again.not_taken_in.first() {
            held.doubt = Some(messages::not_taken_in(&line.text()));
            return;
        }
        if let Some(untold) = self.may_tell_attitude(link) {
            held.doubt = Some(untold);
            return;
        }
        if self.holds_by_wider_meanings(link) {
            held.doubt = Some(messages::WIDER_MEANINGS.into());
            return;
        }
        if self.speaks_of_unlisted_load(residuals) {
            held.doubt = Some(messages::LOADS_NOT_LISTED.into());
            return;
        }
        if let Some(body) = self.holds_on_principal_axes(held, residuals) {
            held.doubt = Some(messages::untold_products(&body));
            return;
        }
        if self.speaks_of_one_element(link, residuals) {
            held.doubt = Some(messages::ONE_ELEMENT.into());
            return;
        }
        if self.may_hold_nearby(residuals) {
            held.doubt = Some(messages::OTHER_MOTIONS.into());
            return;
        }
        match self.facts.missing().map(Source::text) {
            None => self.deny_by_world(held, residuals),
            Some(_) if self.deny_in_all_cases(held) => {}
            Some(premise) => {
                held.doubt = Some(format!(
                    "this premise is beyond what is worked out: {premise}"
                ));
                held.beyond = true;
            }
        }
    }

    /// Whether a difference has what one body does to another, of both of which no sentence says that nothing else acts there:
    /// by what they do to each other alone the difference may vanish.
    fn speaks_of_unlisted_load(&self, residuals: &[Fraction]) -> bool {
        let told: BTreeSet<Variable> = residuals.iter().flat_map(Fraction::variables).collect();
        let loads = &self.reading.system.loads;
        let listed = |body: BodyId| {
            loads
                .iter()
                .any(|load| load.listed && load.on == Some(body))
        };
        loads.iter().any(|load| {
            let Called::Between(_, agent, on) = load.called else {
                return false;
            };
            let mut letters = load.value.iter().flat_map(Fraction::variables);
            !listed(agent) && !listed(on) && letters.any(|letter| told.contains(&letter))
        })
    }

    /// Keeps in mind a line that is taken as given and of which nothing is made: others may hold by it.
    pub(super) fn note_if_not_taken_in(
        &mut self,
        row: &Line,
        purpose: Purpose,
        verdict: Answer,
        held: &[Held],
    ) {
        let line = self.source();
        self.again.not_taken_in.retain(|open| *open != line);
        let taken = purpose.declared && matches!(purpose.role, Role::Given | Role::Assume);
        let ill_typed = |h: &Held| h.standing == Standing::Denied && h.sides.is_empty();
        let open = verdict == Answer::Undecided || held.iter().any(ill_typed);
        if taken && (open || self.unused_of(&row.sides).is_some()) {
            self.again.not_taken_in.push(line);
        }
    }

    /// The same of one that cannot be read.
    pub(super) fn note_unreadable(&mut self, span: Span) {
        let place = self.document.place_of_row(span.start);
        (self.at.cell, self.at.line) = (place.cell, place.line);
        let role = self.reading.role(&self.at, &[]);
        if matches!(role, Some(Role::Given | Role::Assume)) {
            self.again.not_taken_in.push(self.source());
        }
    }

    /// Whether a link fails in each case that premises leave which do not say what vanishes.
    fn deny_in_all_cases(&mut self, held: &mut Held) -> bool {
        let atoms = &mut self.reading.system.atoms;
        let Some(cases) = self.facts.cases(atoms).filter(|cases| !cases.is_empty()) else {
            return false;
        };
        let all = std::mem::take(&mut self.facts);
        let fails = cases.into_iter().all(|case| {
            self.facts = case;
            let residuals = self.residuals(&held.sides);
            let Ok(residuals) = residuals else {
                return false;
            };
            self.deny_by_world(held, &residuals);
            held.doubt.is_none() && !residuals.iter().all(Zero::is_zero)
        });
        self.facts = all;
        if !fails {
            (held.doubt, held.shown) = (None, None);
        }
        fails
    }

    /// Whether nothing ties a letter to the motion whose value at an instant it is: of a time only what is kept in the motion
    /// may.
    fn is_untied(&self, letter: Variable) -> bool {
        let instants = &self.reading.instants;
        let kept = |premise: &Premise| {
            let of_instant = matches!(premise.source, Source::Instant(_));
            of_instant && premise.equation.variables().contains(&letter)
        };
        let is_tied = || self.reading.settled.iter().any(kept);
        instants.untied.contains(&letter) || instants.times.contains(&letter) && !is_tied()
    }

    /// Shows numbers in which a link fails, or tells why there are none.
    fn deny_by_world(&mut self, held: &mut Held, residuals: &[Fraction]) {
        let small = self.small_here();
        let atoms = &self.reading.system.atoms;
        if small
            .variables()
            .iter()
            .any(|v| self.facts.told_at(atoms, *v).is_some())
        {
            held.doubt = Some(messages::SMALL_BY_OTHERS.into());
            return;
        }
        let squares = self.squares(held);
        // A length may have the value of the other side where its square has.
        if let Some(squares) = squares.as_ref().filter(|squares| squares.agree())
            && !self.are_opposite(held)
        {
            return self.hold_by_squares(held, &squares.sides);
        }
        // The value of a root at an instant is that of its square.
        let may_hold = moves(&mut self.reading.system.atoms, residuals)
            && (self.may_hold_in_motion(&held.sides)
                || (squares.as_ref()).is_some_and(|s| self.may_hold_in_motion(&s.sides)));
        if may_hold {
            held.doubt = Some(messages::HOLDS_AT_INSTANT.into());
            return;
        }
        let mut letters = residuals.iter().flat_map(Fraction::variables);
        if letters.any(|letter| self.is_untied(letter)) {
            held.doubt = Some(messages::UNTIED.into());
            return;
        }
        let told = |v: &Variable| self.facts.rule(*v).is_some();
        let angles = residuals.iter().flat_map(Fraction::variables);
        let angles = angles.filter_map(|v| self.reading.system.atoms.angle_of(v));
        // The sine of an angle that a premise tells is not put in.
        let hidden = angles
            .into_iter()
            .any(|angle| angle.variables().iter().any(told));
        let orders = self.orders();
        let atoms = &mut self.reading.system.atoms;
        match World::refuting(&self.facts, atoms, residuals, &orders).filter(|_| !hidden) {
            Some(world) => {
                let shown = shown(&mut self.facts, atoms, &held.sides, residuals, &world);
                held.shown = shown.map(Arc::new);
                // A length that gets no number may have the one that makes it true.
                if held.shown.is_none() && has_letter(&held.sides, |v| atoms.is_length(v)) {
                    held.doubt = Some(messages::NO_NUMBERS.into());
                }
            }
            None if !hidden && squares.is_some_and(|s| self.is_refuted(&s.residuals, &orders)) => {
                held.reason = Some(messages::SQUARES_DIFFER.into());
            }
            // Roots and lengths may still make it true.
            None => held.doubt = Some(messages::NO_NUMBERS.into()),
        }
    }

    /// The squares of the sides, where these have roots or lengths. To an order of what is small they tell nothing.
    fn squares(&mut self, held: &Held) -> Option<Squares> {
        let atoms = &self.reading.system.atoms;
        let root = |v| matches!(atoms.atom(v).nature, Nature::Root(_));
        let lengths = has_letter(&held.sides, |v| root(v) || atoms.is_length(v));
        if !lengths || !self.small_here().is_empty() {
            return None;
        }
        let square = |f: &Fraction| f.clone() * f.clone();
        let sides = held.sides.iter().map(|(l, r)| (square(l), square(r)));
        let sides: Vec<_> = sides.collect();
        let residuals = self.residuals(&sides).ok()?;
        Some(Squares { sides, residuals })
    }

    /// Whether each side is the other one with its sign changed: then they have the same squares, and differ.
    fn are_opposite(&mut self, held: &Held) -> bool {
        let opposite = held.sides.iter().map(|(l, r)| (l.clone(), -r.clone()));
        let residuals = self.residuals(&opposite.collect::<Vec<_>>());
        residuals.is_ok_and(|residuals| residuals.iter().all(Zero::is_zero))
    }

    /// Of sides with the same squares those are the same that are no less than zero, and of the rest nothing is said.
    fn hold_by_squares(&mut self, held: &mut Held, squares: &[(Fraction, Fraction)]) {
        let atoms = &mut self.reading.system.atoms;
        let mut sides = held.sides.iter().flat_map(|(l, r)| [l, r]);
        if sides.all(|side| atoms.is_never_negative(side)) {
            held.proof = prove(&mut self.facts, atoms, squares, &Small::default());
        }
        match held.proof {
            Some(_) => held.standing = Standing::Entailed,
            None => held.doubt = Some(messages::NO_NUMBERS.into()),
        }
    }

    /// Whether there are numbers in which something does not vanish.
    fn is_refuted(&self, residuals: &[Fraction], orders: &[Fraction]) -> bool {
        let atoms = &self.reading.system.atoms;
        World::refuting(&self.facts, atoms, residuals, orders).is_some()
    }

    /// Whether a density, or what belongs to one element, is left over beside an integral over all of them: it may be
    /// meant to be the same for each.
    fn speaks_of_one_element(&self, link: &Link<'_>, residuals: &[Fraction]) -> bool {
        let system = &self.reading.system;
        let integral = has_integral(&link.left) || has_integral(&link.right);
        let of_one =
            |r: &Fraction| system.has_volume_of_element(r) || integral && system.is_of_element(r);
        residuals.iter().any(of_one)
    }
}

/// The squares of the sides of a link, and what is left of their differences.
struct Squares {
    sides: Vec<(Fraction, Fraction)>,
    residuals: Vec<Fraction>,
}

impl Squares {
    fn agree(&self) -> bool {
        self.residuals.iter().all(Zero::is_zero)
    }
}

/// Whether a letter of some kind stands in the sides of a link.
fn has_letter(sides: &[(Fraction, Fraction)], is: impl Fn(Variable) -> bool) -> bool {
    let sides = sides.iter().flat_map(|(left, right)| [left, right]);
    sides.flat_map(Fraction::variables).any(is)
}
