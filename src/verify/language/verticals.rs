//! Which way is up: "y is upward", "`$-y$` is the downward vertical".

use super::heads::VERTICAL;
use super::statement::{Declaration, Formula, Statement, Term};
use crate::notation::ast::Kind;

/// "`$k$` is upward": it is the upward vertical.
pub(super) fn tell_verticals(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && SENSES_OF_VERTICAL.contains(&what.head)
            && what.slots.is_empty()
            && what.adjectives.is_empty()
            && matches!(subjects.as_slice(), [Term::Name(_) | Term::Formula(_)])
        {
            what.adjectives.push(what.head);
            what.head = VERTICAL;
        }
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == VERTICAL
            && let ([Term::Formula(axis)], [sense]) =
                (subjects.as_mut_slice(), what.adjectives.as_mut_slice())
            && let (Some(opposite), Some(other)) = (negated(axis), other_sense(sense))
        {
            *axis = opposite;
            *sense = other;
        }
    }
}

/// The letter that has a minus before it.
fn negated(formula: &Formula) -> Option<Formula> {
    match &formula.node()?.kind {
        Kind::Negate(letter) => Some(Formula::of(letter)),
        _ => None,
    }
}

fn other_sense(sense: &str) -> Option<&'static str> {
    let at = SENSES_OF_VERTICAL.iter().position(|own| *own == sense)?;
    Some(SENSES_OF_VERTICAL[1 - at])
}

/// How the vertical points.
const SENSES_OF_VERTICAL: [&str; 2] = ["upward", "downward"];
