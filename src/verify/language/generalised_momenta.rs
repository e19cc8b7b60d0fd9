//! Generalised momenta: the derivative of the Lagrangian in the rate of a coordinate.

use super::clause::as_formula;
use super::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::notation::ast::{DerivativeStyle, Kind, Node};

/// "`$p$` is the generalised momentum of `$q$`": it is the same as `$\partial L/\partial\dot q$`.
pub(crate) fn tell_generalised_momenta(declarations: &mut [Declaration]) {
    let Some(function) = the_only_one(declarations, "Lagrangian") else {
        return;
    };
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let coordinates: Vec<&Term> = what.all(Slot::Of).collect();
        let plain = what.slots.len() == subjects.len() && coordinates.len() == subjects.len();
        let momenta = what.head == "generalised momentum" && what.adjectives.is_empty();
        if !momenta || !plain {
            continue;
        }
        let coordinates = coordinates.into_iter().map(as_formula);
        let derivatives = coordinates.map(|q| derivative(&function, q.as_ref()?));
        if let Some(others) = derivatives.collect() {
            declaration.statement = Statement::Same {
                subjects: subjects.clone(),
                others,
            };
        }
    }
}

/// The letter of a function of which only one is told.
fn the_only_one(declarations: &[Declaration], head: &str) -> Option<Node> {
    let letters = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == head => Some(subjects),
        _ => None,
    });
    let mut letters = letters.flatten();
    let only = letters.next().filter(|_| letters.next().is_none())?;
    as_formula(only)?.node().cloned()
}

/// `\partial L/\partial\dot q`
fn derivative(function: &Node, coordinate: &Formula) -> Option<Term> {
    let coordinate = coordinate.node()?;
    let span = coordinate.span;
    let rate = Kind::TimeDerivative {
        operand: Box::new(coordinate.clone()),
        order: 1,
        style: DerivativeStyle::Dots,
        frame: None,
    };
    let kind = Kind::Derivative {
        operand: Box::new(function.clone()),
        variables: vec![Node { kind: rate, span }],
        partial: true,
    };
    Some(Term::Formula(Formula::of(&Node { kind, span })))
}
