//! Lines or terms of which nothing is left: they vanish by what the document supposes, and so they would with any
//! factor.

use crate::algebra::Proof;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Equation, passes_filter, reached};
use crate::verify::theory::{Name, Taken, Theory};
use crate::verify::values::value::Value;
use std::collections::BTreeSet;

/// Terms of a line that are looked at.
const MOST_TERMS: usize = 8;

impl Checker<'_> {
    /// Whether a line that holds says that nothing is nothing: no side is written as a zero, each is one by assumptions,
    /// and without some of these, so that anything is left of the sides, it does not hold. Or whether a term of a sum is
    /// nothing in that way.
    pub(crate) fn is_emptied(&mut self, sides: &[Node], read: &Read, proof: &Proof) -> bool {
        // What is nothing by an assumption is proved to be equal by it.
        let premises = self.theory.premises();
        let inside = proof.premises();
        if !premises.iter().any(|p| inside.contains(p.name.as_str())) {
            return false;
        }
        let values: Vec<Value> = read
            .equations
            .iter()
            .flat_map(|e| [e.left.clone(), e.right.clone()])
            .collect();
        if read.to_order || values.iter().any(Value::is_zero) {
            return false;
        }
        if all_vanish(&mut self.theory, &values)
            && self.is_saved_by_nothing(&values, &read.equations)
        {
            return true;
        }
        let terms = self.terms(sides, read.unlabelled);
        terms.into_iter().take(MOST_TERMS).any(|(side, term)| {
            let term = [term];
            // What goes on from the side may do so without the term.
            let near = [side.checked_sub(1), Some(side)].into_iter().flatten();
            let near = near.filter_map(|at| read.equations.get(at..=at));
            all_vanish(&mut self.theory, &term)
                && near
                    .into_iter()
                    .all(|one| self.is_saved_by_nothing(&term, one))
        })
    }

    /// The values of the terms of sums, each with the place of the side that is one.
    fn terms(&mut self, sides: &[Node], unlabelled: Frame) -> Vec<(usize, Value)> {
        let mut lowering = self.lowering(unlabelled);
        let mut found = vec![];
        for (at, side) in sides.iter().enumerate() {
            let Kind::Sum(terms) = &side.kind else {
                continue;
            };
            let values = terms
                .iter()
                .filter_map(|term| lowering.value(&term.node).ok());
            found.extend(
                values
                    .filter(|value| !value.is_zero())
                    .map(|value| (at, value)),
            );
        }
        found
    }

    /// Whether no assumption can be left out so that the line holds and these do not all vanish.
    fn is_saved_by_nothing(&mut self, vanishing: &[Value], equations: &[Equation]) -> bool {
        let theory = &mut self.theory;
        let entries: Vec<_> = vanishing.iter().flat_map(|s| s.entries.clone()).collect();
        let premises = theory.premises().iter().map(|p| p.name.clone());
        let premises: BTreeSet<Name> = premises.collect();
        let met: Vec<Name> = reached(theory, &entries)
            .into_iter()
            .filter(|name| premises.contains(name))
            .collect();
        let left_out = theory.left_out.clone();
        let holds = |theory: &mut Theory| {
            !all_vanish(theory, vanishing)
                && equations
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
