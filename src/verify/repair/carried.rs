//! Errors carried forward: a false line that follows from an earlier false line.
//!
//! A line follows from an earlier line e if there is a set A of laws with A ∪ {e} consistent, A ∪ {e} ⊢ line and
//! A alone ⊬ line. The sets tried are all laws and premises in force less the few that e contradicts.

use crate::algebra::{Fraction, Variable};
use crate::verify::check::Checker;
use crate::verify::theory::decide::{Equation, passes_filter, reached};
use crate::verify::theory::{Premise, Taken};
use crate::verify::verdict::Finding;
use std::collections::BTreeSet;

/// A false line, kept to see what follows from it.
#[derive(Clone, Debug)]
pub(crate) struct Slip {
    /// The line of the source, and the cell.
    pub place: (usize, Option<usize>),
    /// Its name as a premise.
    pub name: String,
    /// Left less right.
    pub residuals: Vec<Fraction>,
    /// What the author solved for.
    pub preferred: Vec<Variable>,
}

/// Earlier slips that are looked at.
const LOOKED_BACK: usize = 8;

impl Checker<'_> {
    /// Notes a false line, and says which earlier one it carries forward.
    pub(crate) fn carry(&mut self, equations: &[Equation], finding: &mut Finding) {
        let slips: Vec<Slip> = self.slips.iter().rev().take(LOOKED_BACK).cloned().collect();
        let follows = |checker: &mut Self, slip: &Slip| checker.follows(slip, equations);
        if let Some(slip) = slips.iter().find(|slip| follows(self, slip)) {
            finding.follows_from = Some(slip.place.0);
        }
        let preferred = equations.first().map_or(vec![], |e| {
            e.left
                .entries
                .iter()
                .flat_map(Fraction::variables)
                .collect()
        });
        self.slips.push(Slip {
            place: (finding.source_line, finding.cell),
            name: self.line_name(finding),
            residuals: equations
                .iter()
                .flat_map(|e| e.residual.entries.clone())
                .collect(),
            preferred,
        });
    }

    fn follows(&mut self, slip: &Slip, equations: &[Equation]) -> bool {
        let laws = reached(&mut self.theory, &slip.residuals);
        let sets = std::iter::once(BTreeSet::new())
            .chain(laws.into_iter().map(|law| BTreeSet::from([law])));
        let sets: Vec<BTreeSet<String>> = sets.collect();
        sets.into_iter().any(|left_out| {
            self.theory.without(left_out, |theory| {
                let holds = |theory: &mut _| {
                    equations
                        .iter()
                        .all(|e| passes_filter(theory, &e.residual) == Some(true))
                };
                if holds(theory) {
                    return false;
                }
                let taken = theory.assume(Premise {
                    name: slip.name.clone(),
                    residuals: slip.residuals.clone(),
                    preferred: slip.preferred.clone(),
                    definition: false,
                });
                let follows = taken == Taken::Solved && holds(theory);
                theory.retain(|premise| premise.name != slip.name);
                follows
            })
        })
    }
}
