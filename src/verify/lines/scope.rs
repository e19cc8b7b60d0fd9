//! How long premises hold: to the end of their section, or from where they are made onwards.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::lines::given::is_zero;
use crate::verify::lines::laws_in_words::is_of_swings;
use crate::verify::theory::{Name, Premise};
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::prose::Said;
use std::collections::BTreeSet;

/// Words for what ends with no section.
pub(crate) const ONWARDS: &[&str] = &[
    "from here on",
    "from now on",
    "henceforth",
    "throughout",
    "in all that follows",
    "in everything that follows",
    "for the rest of",
];

/// Words of a sentence that says what acts.
const LOADS: &[&str] = &["torque", "moment", "couple"];

impl Checker<'_> {
    /// Keeps a premise of the document to the end of its section; definitions stay, and what holds "from here on".
    pub(crate) fn keep(&mut self, name: &str, definition: bool) {
        let lasts = definition || has_any(&lowered(&self.sentence), ONWARDS);
        let level = if lasts { 0 } else { self.level };
        self.scopes.push((name.to_owned(), level));
    }

    /// Ends premises. What a frequency was in a motion that is over leaves its symbol in doubt.
    pub(crate) fn end_premises(&mut self, ended: &BTreeSet<Name>) {
        if ended.is_empty() {
            return;
        }
        let premises = self.theory.premises().iter();
        let laws = premises.filter(|p| ended.contains(&p.name) && is_of_swings(&p.name));
        let frequencies: Vec<_> = laws.flat_map(|p| p.preferred.clone()).collect();
        for frequency in frequencies {
            self.leave_in_doubt(frequency);
        }
        self.scopes.retain(|(name, _)| !ended.contains(name));
        self.theory.retain(|premise| !ended.contains(&premise.name));
    }

    /// Ends what was supposed of a body that spins about one axis alone, "if ⟨ω_1 = ω_2 = 0⟩, it goes on so", where a
    /// component that vanished by it is called small: that is no longer nothing.
    pub(crate) fn end_exact_spin(&mut self, small: Variable) {
        let nothing = |r: &Fraction| r.as_variable().is_some();
        let premises = self.theory.premises().iter();
        let ended = premises.filter(|premise| {
            self.is_supposed(&premise.name)
                && premise.residuals.iter().all(nothing)
                && premise
                    .residuals
                    .iter()
                    .any(|r| r.as_variable() == Some(small))
        });
        let ended: BTreeSet<Name> = ended.map(|premise| premise.name.clone()).collect();
        self.end_premises(&ended);
    }

    /// Ends that no torque acts, where a sentence about one gives a component of it in numbers.
    pub(crate) fn end_freedom_from_torque(&mut self, sides: &[Node]) {
        let [left, right] = sides else { return };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return;
        };
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let of_moment = matches!(self.meaning_of(symbol), Meaning::Component(entity, _) | Meaning::Whole(entity) if entity == moment);
        let given = !self.displayed && symbols(right).is_empty() && !is_zero(right);
        if of_moment && given && has_any(&lowered(&self.sentence), LOADS) {
            let name = Said::TorqueFree.words();
            self.end_premises(&BTreeSet::from([name]));
        }
    }

    /// Ends what an earlier case said of one component alone; the others keep their values.
    pub(crate) fn end_component(&mut self, own: Variable) {
        let alone = |r: &Fraction| r.variables() == [own];
        let earlier = |p: &&Premise| self.is_set_before(&p.name) && p.residuals.iter().any(alone);
        let premises = self.theory.premises().iter();
        let met: Vec<Premise> = premises.filter(earlier).cloned().collect();
        for mut premise in met {
            self.theory.retain(|p| p.name != premise.name);
            premise.residuals.retain(|r| !alone(r));
            premise.preferred.retain(|&v| v != own);
            if !premise.residuals.is_empty() {
                self.theory.assume(premise);
            }
        }
    }

    /// Whether a premise is the number of a mass, which goes on where a case is about something else.
    pub(crate) fn weighs_something_else(&self, name: &Name, of_case: &BTreeSet<Variable>) -> bool {
        let mass = |v: Variable| {
            let owner = self.theory.atoms.owner(v);
            matches!(owner, Some(Owner::Quantity(Quantity::Mass, _))) && !of_case.contains(&v)
        };
        let weighs = |r: &Fraction| matches!(r.variables()[..], [one] if mass(one));
        let mut premises = self.theory.premises().iter().filter(|p| p.name == *name);
        premises.any(|p| p.residuals.iter().all(weighs))
    }

    /// Whether premises say what a component of ω is.
    pub(crate) fn set_the_spin(&mut self, names: &BTreeSet<Name>) -> bool {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let of_omega = |&v: &Variable| self.theory.atoms.entity_of(v) == Some(omega);
        let premises = self.theory.premises().iter();
        let mut ended = premises.filter(|p| names.contains(&p.name));
        ended.any(|p| p.preferred.iter().any(of_omega))
    }
}
