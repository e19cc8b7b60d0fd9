//! Deviations from a spin, by their indices: "the spin is disturbed a little, ⟨ω_1 = ε_1⟩, ⟨ω_2 = ε_2⟩, ⟨ω_3 = Ω + ε_3⟩".

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::{Name, Premise};
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use std::collections::BTreeSet;

const DISTURBED: &[&str] = &[
    "disturb",
    "perturb",
    "deviat",
    "slightly",
    "a little",
    "small departure",
    "not quite",
];
/// Words of a document that drops what is small.
const LINEAR: &[&str] = &["lineari", "first order", "first-order", "small", "perturb"];

impl Checker<'_> {
    /// Whether a line says what a component of ω deviates by, where words tell of a disturbance; this is small then.
    pub(crate) fn is_disturbance(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Symbol(rate) = &inner(left).kind else {
            return false;
        };
        let Meaning::Component(entity, _) = self.meaning_of(rate) else {
            return false;
        };
        let of_omega = entity == self.theory.atoms.quantity(Quantity::AngularVelocity);
        if !of_omega {
            return false;
        }
        let deviation = match &inner(right).kind {
            Kind::Symbol(symbol) => Some(symbol).filter(|s| self.is_indexed_like(s, rate, 1)),
            Kind::Sum(terms) => {
                let mut terms = terms.iter().filter_map(|term| match &term.node.kind {
                    Kind::Symbol(symbol) => Some(symbol),
                    _ => None,
                });
                terms.find(|s| self.is_indexed_like(s, rate, 2))
            }
            _ => None,
        };
        let deviation = deviation.and_then(|symbol| self.entity_named(symbol));
        let new = |d: &Entity| !self.known.contains(d) || !self.theory.mentions_entity(*d);
        let Some(deviation) = deviation.filter(|d| self.small.contains(d) || new(d)) else {
            return false;
        };
        let said = self.text.says(LINEAR) || has_any(&lowered(&self.sentence), DISTURBED);
        if !self.cases.disturbed && !said {
            return false;
        }
        if !self.cases.disturbed {
            self.end_undisturbed(entity);
        }
        self.small.insert(deviation);
        self.linear = true;
        self.cases.disturbed = true;
        true
    }

    /// Ends what lines said of the motion that is disturbed now: it went on as they say only without that.
    fn end_undisturbed(&mut self, omega: Entity) {
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 0));
        let number = |v| {
            matches!(self.theory.atoms.owner(v), Some(Owner::Symbol(_)))
                && matches!(self.theory.atoms.atom(v), Atom::Part { order: 0, .. })
        };
        let sets = |p: &&Premise| {
            let mut all = p.residuals.iter().flat_map(Fraction::variables);
            p.preferred.iter().any(|v| parts.contains(v))
                && all.all(|v| parts.contains(&v) || number(v))
        };
        let ended = self.theory.premises().iter().filter(sets);
        let ended: BTreeSet<Name> = ended.map(|p| p.name.clone()).collect();
        if !ended.is_empty() {
            self.end_spin();
            self.end_premises(&ended);
        }
    }

    /// Whether a symbol has the index of a component of ω, and its letter so many others as well.
    fn is_indexed_like(&self, symbol: &Symbol, rate: &Symbol, others: usize) -> bool {
        let letter = Letter::of(symbol);
        let axes = ["1", "2", "3", "x", "y", "z"].into_iter();
        let met = axes.filter(|axis| self.reading.usage.has_index(&letter, axis));
        letter != Letter::of(rate)
            && symbol.subscripts.len() == 1
            && symbol.subscripts == rate.subscripts
            && met.count() > others
    }
}
