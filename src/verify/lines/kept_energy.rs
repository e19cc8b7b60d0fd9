//! A total energy that a line writes out: in a motion that is known, with no other forces, it does not change.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::lines::growth::LONGEST;
use crate::verify::theory::Name;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;
use std::collections::BTreeSet;

/// What words call an energy that is conserved.
const WHOLE: &[&str] = &[
    "total energy",
    "whole energy",
    "mechanical energy",
    "energy integral",
    "conserved energy",
];
/// Words of what takes energy away, or gives it.
const EXCHANGES: &[&str] = &[
    "friction", "damp", "dissipat", "motor", "drag", "driven", "engine",
];

impl Checker<'_> {
    /// Leaves open what was taken in as the total energy and changes in the motion.
    pub(crate) fn withhold_changing_energy(&mut self, sides: &[Node], finding: &mut Finding) {
        let [left, right] = sides else { return };
        let lone = matches!(inner(left).kind, Kind::Symbol(_));
        if finding.verdict != Verdict::Accepted || !lone {
            return;
        }
        let words = lowered(self.sentence.rsplit('⟩').next().unwrap_or_default());
        if !has_any(&words, WHOLE) || self.text.says(EXCHANGES) {
            return;
        }
        // Under an assumption, such as a steady motion, it might not change whatever it is.
        let own = self.line_name(finding);
        let supposed = self.theory.premises().iter();
        let of_motion = |owner: &Owner| match owner {
            Owner::Quantity(quantity, _) => *quantity == Quantity::AngularVelocity,
            Owner::Symbol(_) => true,
        };
        // Beside the variable there may be π.
        let sets = |residual: &Fraction| {
            let variables = residual.variables();
            let owners = variables.iter().filter_map(|&v| self.theory.atoms.owner(v));
            let owners: Vec<&Owner> = owners.collect();
            owners.len() <= 1 && owners.into_iter().all(of_motion)
        };
        let supposed = supposed.filter(|p| p.residuals.iter().all(sets));
        let supposed = supposed.map(|p| p.name.clone());
        let names: BTreeSet<Name> = supposed.chain([own.clone()]).collect();
        let rate = self.lowering_without(names, |lowering| {
            let value = lowering.scalar(right)?;
            let rate = lowering.theory.atoms.derivative(&value);
            (value.numerator().len() <= LONGEST).then(|| lowering.theory.normal(&rate))
        });
        let Some(rate) = rate else { return };
        let open = |v: Variable| matches!(self.theory.atoms.atom(v), Atom::Part { order, .. } if *order > 1);
        let known = rate.is_valid() && !rate.variables().into_iter().any(open);
        if known && !rate.is_zero() {
            self.theory.retain(|premise| premise.name != own);
            finding.verdict = Verdict::Undecided;
            finding.remarks.clear();
            finding.reason = Some("it changes in the motion that the lines before have".to_owned());
        }
    }
}
