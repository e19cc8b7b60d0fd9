//! Lines of which nothing is left: both sides vanish by what the document supposes, and so they would with any factor.

use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{passes_filter, reached};
use crate::verify::theory::{Name, Taken, Theory};
use crate::verify::values::value::Value;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Whether a line that holds says that nothing is nothing: no side is written as a zero, each is one by assumptions,
    /// and without some of these, so that anything is left of the sides, it does not hold.
    pub(crate) fn is_emptied(&mut self, read: &Read) -> bool {
        let theory = &mut self.theory;
        let sides: Vec<Value> = read
            .equations
            .iter()
            .flat_map(|e| [e.left.clone(), e.right.clone()])
            .collect();
        if read.to_order || sides.iter().any(Value::is_zero) || !all_vanish(theory, &sides) {
            return false;
        }
        let entries: Vec<_> = sides.iter().flat_map(|s| s.entries.clone()).collect();
        let premises = theory.premises().iter().filter(|p| !p.definition);
        let premises: BTreeSet<Name> = premises.map(|p| p.name.clone()).collect();
        let met: Vec<Name> = reached(theory, &entries)
            .into_iter()
            .filter(|name| premises.contains(name))
            .collect();
        let left_out = theory.left_out.clone();
        let holds = |theory: &mut Theory| {
            !all_vanish(theory, &sides)
                && read
                    .equations
                    .iter()
                    .all(|e| passes_filter(theory, &e.residual) == Some(true))
        };
        let one = met.iter().map(|name| BTreeSet::from([name.clone()]));
        let trials: Vec<BTreeSet<Name>> = one.chain([met.iter().cloned().collect()]).collect();
        !met.is_empty()
            && !trials.into_iter().any(|mut names| {
                names.extend(left_out.iter().cloned());
                theory.without(names, holds)
            })
            && !met
                .iter()
                .any(|name| holds_without_a_part(theory, name, &holds))
    }
}

/// Whether something holds without one of the equations of a premise: of `ω_y = ω_z = 0`, each alone.
fn holds_without_a_part(
    theory: &Theory,
    name: &Name,
    holds: &impl Fn(&mut Theory) -> bool,
) -> bool {
    let Some(premise) = theory.premises().iter().find(|p| p.name == *name).cloned() else {
        return false;
    };
    premise.residuals.len() > 1
        && (0..premise.residuals.len()).any(|i| {
            let mut rest = premise.clone();
            rest.residuals.remove(i);
            let mut less = theory.clone();
            less.retain(|premise| premise.name != *name);
            less.assume(rest) != Taken::Contradiction && holds(&mut less)
        })
}

fn all_vanish(theory: &mut Theory, sides: &[Value]) -> bool {
    sides
        .iter()
        .all(|side| passes_filter(theory, side) == Some(true))
}
