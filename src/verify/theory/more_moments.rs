//! Moments that act beside the one that the law names: `J\dot\omega + \omega\times J\omega = \tau + \tau_d`.

use crate::algebra::{Fraction, Monomial, Variable};
use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{axis, symbols};
use crate::verify::lines::line::Read;
use crate::verify::values::atoms::{Atom, Atoms, Entity, Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::subscript::{LOADS, POINTS};
use crate::verify::verdict::{Diagnosis, Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// Moments that may act beside the one that the law names.
const MOST: usize = 4;

/// Vectors of the document that act as moments beside the one of the law, each with whether it is taken off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct OtherMoments([Option<(Entity, bool)>; MOST]);

/// The terms of Euler's equation, I ω̇ + ω × I ω = M.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum TermOfLaw {
    Rate,
    Turning,
    Load,
}

impl OtherMoments {
    /// A component of what they come to together.
    pub(crate) fn sum(self, atoms: &mut Atoms, component: u8) -> Fraction {
        let all = self.0.into_iter().flatten();
        all.fold(Fraction::zero(), |sum, (entity, negative)| {
            let value = atoms.value(entity, component, 0);
            if negative { sum - value } else { sum + value }
        })
    }

    /// Whether an entity is one of them.
    pub(crate) fn has(self, entity: Entity) -> bool {
        self.0
            .into_iter()
            .flatten()
            .any(|(other, _)| other == entity)
    }

    /// Takes one more in; `None` where there are too many.
    fn with(mut self, entity: Entity, negative: bool) -> Option<Self> {
        let slot = self.0.iter_mut().find(|slot| slot.is_none())?;
        *slot = Some((entity, negative));
        Some(self)
    }
}

impl Checker<'_> {
    /// Where an equation of motion is true but for vectors of the document beside the moment, these are moments too, and
    /// the law speaks of the sum.
    pub(crate) fn note_other_moments(&mut self, sides: &[Node]) {
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let entities = self.entities(sides);
        let new: Vec<Entity> = entities
            .iter()
            .copied()
            .filter(|&e| self.may_be_a_moment(e))
            .collect();
        let written = entities.contains(&moment);
        if new.is_empty() || !written && self.writes_moments() {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        let [equation] = read.equations.as_slice() else {
            return;
        };
        let entries = equation.residual.entries.clone();
        // Where no moment has the letter of the law, the law's own is zero, and could stand on either side.
        let signs: &[i64] = if written { &[0] } else { &[1, -1] };
        let mut tried = signs.iter();
        let Some(found) = tried.find_map(|&sign| self.all_beside(moment, &new, &entries, sign))
        else {
            return;
        };
        if !written {
            let name = "the moments that are written are all: no other acts";
            self.vanish(name, Quantity::Moment, &[0, 1, 2]);
        }
        let mut all = self.theory.setting.other_moments;
        for (entity, negative) in found {
            match all.with(entity, negative) {
                Some(more) => all = more,
                None => return,
            }
            self.theory.atoms.info_mut(entity).constant = false;
            self.known.insert(entity);
        }
        self.theory.set(|setting| setting.other_moments = all);
    }

    /// Leaves open what has the form of Euler's equation for a vector that nothing names, and is not that equation:
    /// as the moment it has a slip, and a definition of anything else it is not.
    pub(crate) fn slips_in_unnamed_law(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let entities = self.entities(sides).into_iter();
        let new: Vec<Entity> = entities.filter(|&e| self.may_be_a_moment(e)).collect();
        let [load] = new[..] else { return false };
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let slips = self.has_form_of_law(&read, load)
            && read
                .residuals()
                .any(|entry| !self.holds_as_moment(entry, load, 1));
        if slips {
            let name = &self.theory.atoms.info(load).latex;
            finding.reason = Some(format!("`{name}` is no moment by Euler's equation"));
        }
        slips
    }

    /// Settles a line that has the form of Euler's equation for one body of several, whose label every symbol has: it is
    /// taken in where it is that equation, and refuted where it is not, with either sign of what words call the moment.
    pub(crate) fn is_law_of_labelled_body(
        &mut self,
        sides: &[Node],
        finding: &mut Finding,
    ) -> bool {
        let mut labels = sides
            .iter()
            .flat_map(symbols)
            .map(|s| s.subscripts.as_slice());
        let Some([label]) = labels.next() else {
            return false;
        };
        if !labels.all(|other| other == [label.clone()]) || axis(label).is_some() {
            return false;
        }
        // A label of axes makes no other body.
        let main = [
            Quantity::Inertia,
            Quantity::AngularVelocity,
            Quantity::Moment,
        ];
        let main = main.map(|quantity| self.theory.atoms.quantity(quantity));
        let entities = self.entities(sides);
        let turned = |e: &Entity| self.theory.atoms.info(*e).in_body.is_some();
        if entities.iter().any(|e| main.contains(e) || turned(e)) {
            return false;
        }
        let mut bare = sides.to_vec();
        for side in &mut bare {
            side.change_symbols(&mut |symbol| symbol.subscripts.clear());
        }
        let entities = self.entities(&bare);
        let rated = entities.iter().copied().find(|&e| self.may_be_load(e));
        let (Some(load), Ok(read)) = (rated, self.read(&bare, Frame::Moving)) else {
            return false;
        };
        if !self.has_form_of_law(&read, load) {
            return false;
        }
        let holds = |checker: &mut Self, sign: i64| {
            let mut entries = read.residuals();
            entries.all(|entry| checker.holds_as_moment(entry, load, sign))
        };
        if holds(self, 1) {
            self.given(sides, finding);
            return finding.verdict == Verdict::Accepted;
        }
        if holds(self, -1) {
            return false;
        }
        let words = lowered(&self.sentence);
        let name = &self.theory.atoms.info(load).latex;
        finding.reason = Some(format!("`{name}` is no moment by Euler's equation"));
        if has_any(&words, &["moment", "torque", "couple", "euler"]) {
            finding.verdict = Verdict::Refuted;
            finding.diagnosis = Some(Diagnosis {
                kind: "sign",
                message: "ω × Iω stands on the side of Iω̇, with the same sign".to_owned(),
                suggestion: None,
                place: Some(finding.place),
            });
        }
        true
    }

    /// A moment by its letter, or a vector of the document.
    fn may_be_load(&self, entity: Entity) -> bool {
        let moment = Owner::Quantity(Quantity::Moment, String::new());
        self.may_be_a_moment(entity) || self.theory.atoms.info(entity).owner == moment
    }

    /// Whether an equation has the terms of Euler's equation, each kind, and no other.
    fn has_form_of_law(&self, read: &Read, load: Entity) -> bool {
        let entries = read.residuals();
        let terms = entries.flat_map(|entry| entry.numerator().terms());
        let kinds: Option<BTreeSet<TermOfLaw>> = terms
            .map(|(term, _)| self.term_of_law(term, load))
            .collect();
        kinds.is_some_and(|kinds| kinds.len() == 3)
    }

    /// Whether an entry vanishes with the moment, times a sign, in place of a vector.
    fn holds_as_moment(&mut self, entry: &Fraction, load: Entity, sign: i64) -> bool {
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let mut value = entry.clone();
        for component in 0..3 {
            let own = self.theory.atoms.part(load, component, 0);
            if let Some(factor) = coefficient(entry, own) {
                let acts = self.theory.atoms.value(moment, component, 0);
                let acts = acts * Fraction::from_ratio(sign, 1);
                value += factor * (acts - variable_fraction(own));
            }
        }
        self.theory.normal(&value).is_zero()
    }

    fn term_of_law(&self, term: &Monomial, load: Entity) -> Option<TermOfLaw> {
        let (mut inertia, mut rate, mut turning, mut own) = (0, 0, 0, 0);
        for (variable, exponent) in term.factors() {
            let Atom::Part { entity, order, .. } = *self.theory.atoms.atom(variable) else {
                return None;
            };
            let count = match (&self.theory.atoms.info(entity).owner, order) {
                _ if entity == load => &mut own,
                (Owner::Quantity(Quantity::Inertia, _), 0) => &mut inertia,
                (Owner::Quantity(Quantity::AngularVelocity, _), 0) => &mut turning,
                (Owner::Quantity(Quantity::AngularVelocity, _), 1)
                | (Owner::Quantity(Quantity::AngularAcceleration, _), 0) => &mut rate,
                _ => return None,
            };
            *count += exponent;
        }
        match (inertia, rate, turning, own) {
            (0, 0, 0, 1) => Some(TermOfLaw::Load),
            (1, 1, 0, 0) => Some(TermOfLaw::Rate),
            (1, 0, 2, 0) => Some(TermOfLaw::Turning),
            _ => None,
        }
    }

    /// Whether some symbol of the document is the moment of the law: not where its letter always has the label of one
    /// among others, as in `\mathbf T_d`.
    pub(crate) fn writes_moments(&self) -> bool {
        let moment = |q: &Quantity| *q == Quantity::Moment;
        let mut parts = self.reading.components.values().map(|(q, _)| q);
        let mut wholes = self.reading.quantities.iter().filter(|(_, q)| moment(q));
        let of_all = |label: &String| {
            let whole = [LOADS, POINTS]
                .iter()
                .any(|all| all.contains(&label.as_str()));
            whole || axis(label).is_some()
        };
        parts.any(moment)
            || wholes.any(|(letter, _)| {
                let labels = self.reading.usage.subscripts.get(letter);
                self.reading.usage.get(letter).naked > 0
                    || labels.is_none_or(|labels| labels.iter().any(of_all))
            })
    }

    /// The vectors that stand beside the moment in every component, the moment being added with a sign.
    fn all_beside(
        &mut self,
        moment: Entity,
        new: &[Entity],
        entries: &[Fraction],
        sign: i64,
    ) -> Option<Vec<(Entity, bool)>> {
        let mut found: Option<Vec<(Entity, bool)>> = None;
        for (at, entry) in entries.iter().enumerate() {
            let component = match entries.len() {
                3 => at as u8,
                _ => self.component_of(new, entry)?,
            };
            let own = self.theory.atoms.value(moment, component, 0);
            let entry = entry.clone() + own * Fraction::from_ratio(sign, 1);
            let beside = self.beside(moment, new, &entry)?;
            if found.get_or_insert_with(|| beside.clone()) != &beside {
                return None;
            }
        }
        found
    }

    /// The component in which one of some vectors stands in what must vanish.
    fn component_of(&self, of: &[Entity], entry: &Fraction) -> Option<u8> {
        let part = |v| match *self.theory.atoms.atom(v) {
            Atom::Part {
                entity, component, ..
            } => of.contains(&entity).then_some(component),
            _ => None,
        };
        entry.variables().into_iter().find_map(part)
    }

    fn may_be_a_moment(&self, entity: Entity) -> bool {
        let info = self.theory.atoms.info(entity);
        let own = match &info.owner {
            Owner::Symbol(_) => true,
            Owner::Quantity(quantity, variant) => {
                *quantity == Quantity::Moment && !variant.is_empty()
            }
        };
        // What a law turns to space axes is the moment of that law.
        let turned = info.in_body.is_some();
        own && !turned
            && info.shape == Shape::Vector
            && !self.theory.setting.other_moments.has(entity)
    }

    /// The vectors that stand beside a component of the moment in what must vanish, which does without them.
    fn beside(
        &mut self,
        moment: Entity,
        new: &[Entity],
        entry: &Fraction,
    ) -> Option<Vec<(Entity, bool)>> {
        let (main, component) =
            entry
                .variables()
                .into_iter()
                .find_map(|v| match *self.theory.atoms.atom(v) {
                    Atom::Part {
                        entity,
                        component,
                        order: 0,
                    } if entity == moment => Some((v, component)),
                    _ => None,
                })?;
        let by = coefficient(entry, main)?;
        let (mut rest, mut found) = (entry.clone(), vec![]);
        for &entity in new {
            let variable = self.theory.atoms.part(entity, component, 0);
            let Some(factor) = coefficient(entry, variable) else {
                continue;
            };
            let ratio = factor.clone() / by.clone();
            let negative = (ratio.clone() + Fraction::one()).is_zero();
            if !negative && !(ratio - Fraction::one()).is_zero() {
                return None;
            }
            rest -= factor * variable_fraction(variable);
            found.push((entity, negative));
        }
        let true_without = !found.is_empty() && self.theory.normal(&rest).is_zero();
        found.dedup();
        true_without.then_some(found)
    }
}

/// The factor of a variable that stands in a fraction linearly.
fn coefficient(entry: &Fraction, variable: Variable) -> Option<Fraction> {
    let above = entry.numerator();
    let linear = above.degree_in(variable) == 1 && entry.denominator().degree_in(variable) == 0;
    let factor = Fraction::from(above.coefficient_of(variable, 1));
    linear.then(|| factor / Fraction::from(entry.denominator().clone()))
}
