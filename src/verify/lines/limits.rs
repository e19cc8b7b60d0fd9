//! Limits in passing: "for a thin body (⟨C → 0⟩) the frequency becomes ⟨…⟩" says what it is with C = 0.

use crate::algebra::Variable;
use crate::notation::ast::{Kind, Line};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::theory::Name;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use std::collections::BTreeSet;

/// A value that something is taken to have to the end of a sentence.
#[derive(Clone, Debug)]
pub(crate) struct Limit {
    name: Name,
    /// The formula as the running sentence keeps it.
    said: String,
}

/// How arrows of a limit are written.
pub(crate) const ARROWS: [&str; 5] = ["\\to", "\\rightarrow", "→", "->", "\\longrightarrow"];

impl Checker<'_> {
    /// Takes a limit in, of what does not change, for the sentence that speaks of it.
    pub(crate) fn takes_limit(&mut self, line: &Line, finding: &mut Finding) {
        let [left, right] = line.sides.as_slice() else {
            return;
        };
        let lone = matches!(inner(left).kind, Kind::Symbol(_));
        let number = matches!(inner(right).kind, Kind::Number(_));
        if self.displayed || !lone || !number {
            return;
        }
        let value = self.lowering(Frame::Moving).scalar(left);
        let Some(variable) = value.and_then(|value| value.as_variable()) else {
            return;
        };
        if !self.rests_as_input(variable) {
            return;
        }
        let name = self.line_name(finding);
        self.accept(&line.sides, Role::Assume, finding);
        if finding.verdict == Verdict::Accepted {
            finding.role = Role::Assume;
            finding.reason = None;
            let said = self.as_heard(line.span).trim().to_owned();
            self.limits.push(Limit { name, said });
        }
    }

    /// Whether a variable is a moment of inertia, a mass or a constant of the document.
    fn rests_as_input(&self, variable: Variable) -> bool {
        let atoms = &self.theory.atoms;
        match atoms.owner(variable) {
            Some(Owner::Quantity(Quantity::Inertia | Quantity::Mass, _)) => true,
            Some(Owner::Symbol(_)) => {
                let entity = atoms.entity_of(variable);
                entity.is_some_and(|entity| atoms.info(entity).constant)
            }
            _ => false,
        }
    }

    /// Ends the limits that no sentence speaks of any more.
    pub(crate) fn end_limits(&mut self) {
        if self.limits.is_empty() {
            return;
        }
        let sentence = &self.sentence;
        let (kept, ended): (Vec<Limit>, Vec<Limit>) = std::mem::take(&mut self.limits)
            .into_iter()
            .partition(|limit| sentence.contains(&limit.said));
        self.limits = kept;
        let ended: BTreeSet<Name> = ended.into_iter().map(|limit| limit.name).collect();
        self.end_premises(&ended);
    }
}
