//! Links that fail: numbers that show it, or why none are given.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::proof::prove;
use crate::verify::facts::small::Small;
use crate::verify::facts::world::World;
use crate::verify::language::messages;
use crate::verify::model::atoms::Nature;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Held, nothing_made_of};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::kept::moves;
use crate::verify::standing::shown::shown;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::integrals::has_integral;
use num_traits::Zero;

impl Judge<'_> {
    /// A link that fails is shown by a motion, unless what was not taken in could make it true.
    pub(super) fn deny(&mut self, link: &Link, held: &mut Held, residuals: &[Fraction]) {
        if let Some(sentence) = self.unused_of([&link.left, &link.right]) {
            held.doubt = Some(nothing_made_of(sentence));
            return;
        }
        if self.speaks_of_one_element(link, residuals) {
            held.doubt = Some(messages::ONE_ELEMENT.into());
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
        if moves(&mut self.reading.system.atoms, residuals) && self.may_hold_in_motion(&held.sides)
        {
            held.doubt = Some(messages::HOLDS_AT_INSTANT.into());
            return;
        }
        let untied = &self.reading.instants.untied;
        if residuals
            .iter()
            .flat_map(Fraction::variables)
            .any(|v| untied.contains(&v))
        {
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
        // A length may have the value of the other side where its square has.
        if self.agrees_by_squares(held) {
            return;
        }
        let atoms = &mut self.reading.system.atoms;
        match World::refuting(&self.facts, atoms, residuals, &orders).filter(|_| !hidden) {
            Some(world) => {
                held.shown = shown(&mut self.facts, atoms, &held.sides, residuals, &world);
                // A length that gets no number may have the one that makes it true.
                let mut sides = held.sides.iter().flat_map(|(l, r)| [l, r]);
                let mut length = |of: &Fraction| {
                    of.variables()
                        .into_iter()
                        .any(|v| self.reading.system.atoms.is_length(v))
                };
                if held.shown.is_none() && sides.any(&mut length) {
                    held.doubt = Some(messages::NO_NUMBERS.into());
                }
            }
            // Roots and lengths may still make it true.
            None if !hidden && self.differs_by_squares(held, &orders) => {}
            None => held.doubt = Some(messages::NO_NUMBERS.into()),
        }
    }

    /// The squares of the sides, where these have roots or lengths.
    fn squares(&self, held: &Held) -> Option<Vec<(Fraction, Fraction)>> {
        let atoms = &self.reading.system.atoms;
        let root = |v: Variable| matches!(atoms.atom(v).nature, Nature::Root(_));
        let has_root = |side: &Fraction| {
            let mut letters = side.variables().into_iter();
            letters.any(|v| root(v) || atoms.is_length(v))
        };
        let mut sides = held.sides.iter();
        let any = sides.any(|(l, r)| has_root(l) || has_root(r));
        let square = |f: &Fraction| f.clone() * f.clone();
        let sides = held.sides.iter();
        any.then(|| sides.map(|(l, r)| (square(l), square(r))).collect())
    }

    /// Whether the sides have the same squares: what is no less than zero is the same then, and of the rest nothing is said.
    fn agrees_by_squares(&mut self, held: &mut Held) -> bool {
        let Some(squares) = self.squares(held) else {
            return false;
        };
        // What is the other side with its sign changed has the same square, and differs.
        let opposite = held.sides.iter().map(|(l, r)| (l.clone(), -r.clone()));
        let opposite: Vec<_> = opposite.collect();
        let vanishes = |residuals: Vec<Fraction>| residuals.iter().all(Zero::is_zero);
        if self.residuals(&opposite).is_ok_and(vanishes) {
            return false;
        }
        let residuals = self.residuals(&squares);
        if !residuals.is_ok_and(|residuals| residuals.iter().all(Zero::is_zero)) {
            return false;
        }
        let atoms = &mut self.reading.system.atoms;
        let mut sides = held.sides.iter();
        if sides.all(|(l, r)| atoms.is_never_negative(l) && atoms.is_never_negative(r)) {
            held.proof = prove(&mut self.facts, atoms, &squares, &Small::default());
        }
        match held.proof {
            Some(_) => held.standing = Standing::Entailed,
            None => held.doubt = Some(messages::NO_NUMBERS.into()),
        }
        true
    }

    /// Whether the squares of the sides differ: then so do the sides.
    fn differs_by_squares(&mut self, held: &mut Held, orders: &[Fraction]) -> bool {
        let residuals = self.squares(held).map(|squares| self.residuals(&squares));
        let Some(Ok(residuals)) = residuals else {
            return false;
        };
        let atoms = &mut self.reading.system.atoms;
        let differ = World::refuting(&self.facts, atoms, &residuals, orders).is_some();
        if differ {
            held.reason = Some(messages::SQUARES_DIFFER.into());
        }
        differ
    }

    /// Whether a density, or what belongs to one element, is left over beside an integral over all of them: it may be
    /// meant to be the same for each.
    fn speaks_of_one_element(&self, link: &Link, residuals: &[Fraction]) -> bool {
        let system = &self.reading.system;
        let integral = has_integral(&link.left) || has_integral(&link.right);
        let of_one =
            |r: &Fraction| system.has_volume_of_element(r) || integral && system.is_of_element(r);
        residuals.iter().any(of_one)
    }
}
