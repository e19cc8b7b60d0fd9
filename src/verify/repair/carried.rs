//! Errors carried forward: a false line that follows from an earlier false line.
//!
//! A line follows from an earlier line e if there is a set A of laws with A ∪ {e} consistent, A ∪ {e} ⊢ line and
//! A alone ⊬ line. The sets tried are all laws and premises in force less the few that e contradicts.

use crate::algebra::{Fraction, Variable};
use crate::verify::check::Checker;
use crate::verify::lines::line::SEARCHES;
use crate::verify::theory::decide::{Equation, passes_filter, reached};
use crate::verify::theory::{Premise, Theory};
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
/// Terms of the normal forms that the search may come to.
const MOST_TERMS: usize = 20_000;

impl Checker<'_> {
    /// Notes a false line, and says which earlier one it carries forward.
    pub(crate) fn carry(&mut self, equations: &[Equation], finding: &mut Finding) {
        let back = match self.slips.len() < SEARCHES {
            true => LOOKED_BACK,
            false => 0,
        };
        let slips: Vec<Slip> = self.slips.iter().rev().take(back).cloned().collect();
        let source = self.theory.within(MOST_TERMS, |theory| {
            slips.iter().find(|slip| follows(theory, slip, equations))
        });
        finding.follows_from = source.map(|slip| slip.place.0);
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
}

fn follows(theory: &mut Theory, slip: &Slip, equations: &[Equation]) -> bool {
    let laws = reached(theory, &slip.residuals);
    let one = laws.into_iter().map(|law| BTreeSet::from([law]));
    std::iter::once(BTreeSet::new())
        .chain(one)
        .any(|left_out| follows_without(theory, left_out, slip, equations))
}

/// Whether the slip makes the equations true, and the laws without it and less some do not.
fn follows_without(
    theory: &mut Theory,
    left_out: BTreeSet<String>,
    slip: &Slip,
    equations: &[Equation],
) -> bool {
    theory.without(left_out, |theory| {
        let holds = |theory: &mut Theory| {
            equations
                .iter()
                .all(|e| passes_filter(theory, &e.residual) == Some(true))
        };
        let supposed = Premise {
            name: slip.name.clone(),
            residuals: slip.residuals.clone(),
            preferred: slip.preferred.clone(),
            definition: false,
        };
        !holds(theory) && theory.supposing(&supposed, holds) == Some(true)
    })
}
