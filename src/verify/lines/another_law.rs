//! A control law in the place of another: "the simpler law without cancellation, that is ⟨u = -k\,I\omega⟩".

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::theory::Name;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role};
use crate::verify::words::book::{has_any, lowered};
use std::collections::BTreeSet;

/// Words of a control law in the place of another.
const ANOTHER: &[&str] = &[
    "simpler law",
    "simpler control",
    "simpler feedback",
    "another law",
    "another control",
    "another feedback",
    "alternative law",
    "alternative control",
    "other law",
    "law without",
    "feedback without",
    "control without",
];

impl Checker<'_> {
    /// Takes in a torque that the words call another law, where a line before assumed one; that ends.
    pub(crate) fn chooses_another_law(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, _] = sides else { return false };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let said = lowered(&self.sentence);
        if !has_any(&said, ANOTHER) {
            return false;
        }
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return false;
        };
        let atoms = &self.theory.atoms;
        let moment = matches!(
            &atoms.info(entity).owner,
            Owner::Quantity(Quantity::Moment, _)
        );
        let chosen = |v: &u32| atoms.entity_of(*v) == Some(entity);
        let premises = self.theory.premises().iter();
        let laws = premises.filter(|premise| {
            let by_line = !premise.definition && premise.name.starts_with("line ");
            by_line && premise.preferred.iter().any(chosen)
        });
        let laws: BTreeSet<Name> = laws.map(|premise| premise.name.clone()).collect();
        let Some(last) = laws.iter().next_back().filter(|_| moment).cloned() else {
            return false;
        };
        self.end_premises(&laws);
        finding.role = Role::Assume;
        self.accept(sides, Role::Assume, finding);
        finding.remarks.push(format!("in the place of {last}"));
        true
    }
}
