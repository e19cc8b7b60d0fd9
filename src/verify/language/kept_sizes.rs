//! Lengths of rods that formulas tell: a rod of length `$2a$` stays as long, and so does its half.

use super::heads::{CONSTANT, SIZES};
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term};
use super::traits::{Trait, has};
use crate::notation::ast::Kind;

/// Says of each such size that it is constant. Of a size with a letter of its own the letter is.
pub(super) fn keep_sizes(declarations: &mut Vec<Declaration>) {
    let mut told: Vec<Declaration> = vec![];
    for declaration in declarations.iter() {
        let Statement::Is { what, .. } = &declaration.statement else {
            continue;
        };
        if !has(what.head, Trait::Slender) || declaration.extent != Extent::Document {
            continue;
        }
        for size in what.slots.iter().filter_map(|(_, size)| formula_of(size)) {
            let subject = Term::Formula(size.clone());
            let constant = Statement::one_is(subject, NounPhrase::new(CONSTANT, vec![]));
            if !declarations
                .iter()
                .chain(&told)
                .any(|d| d.statement == constant)
            {
                told.push(declaration.saying(constant));
            }
        }
    }
    declarations.extend(told);
}

/// The formula of a size that is no letter and no number.
fn formula_of(size: &Term) -> Option<&Formula> {
    let Term::Phrase(size) = size else {
        return None;
    };
    let Some(Term::Formula(formula)) = size
        .slot(Slot::Which)
        .filter(|_| SIZES.contains(&size.head))
    else {
        return None;
    };
    let made_up = matches!(
        formula.node()?.kind,
        Kind::Product(_) | Kind::Sum(_) | Kind::Quotient(..)
    );
    made_up.then_some(formula)
}
