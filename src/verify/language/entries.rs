//! Arrays that are written out: "`$(p, q, r)^T$` is the angular velocity of B" says what p, q and r are.

use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;

/// Parts what is said of an array into what is said of its entries; "`$\omega = (p, q, r)$` is …" says it of the letter as
/// well.
pub(crate) fn tell_entries(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for declaration in declarations.iter_mut() {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let [Term::Formula(formula)] = subjects.as_slice() else {
            continue;
        };
        let Some(entries) = array_in(formula).and_then(entries_of) else {
            continue;
        };
        let entries = entries.iter().map(|node| Term::Formula(Formula::of(node)));
        let of_entries = Statement::Is {
            subjects: entries.collect(),
            what: component_of(what),
        };
        match letter_in(formula) {
            Some(letter) => {
                told.push(Declaration {
                    statement: of_entries,
                    ..declaration.clone()
                });
                let Statement::Is { subjects, .. } = &mut declaration.statement else {
                    continue;
                };
                *subjects = vec![Term::Formula(letter)];
            }
            None => declaration.statement = of_entries,
        }
    }
    declarations.extend(told);
}

/// "the components of the angular velocity of B on B"
fn component_of(what: &NounPhrase) -> NounPhrase {
    let (on, own) = what
        .slots
        .iter()
        .cloned()
        .partition(|(slot, _)| *slot == Slot::On);
    let of = NounPhrase {
        slots: own,
        ..what.clone()
    };
    let mut slots = vec![(Slot::Of, Term::Phrase(Box::new(of)))];
    slots.extend::<Vec<_>>(on);
    NounPhrase::new("component", slots)
}

/// The array that a formula is, or that it says its letter to be.
fn array_in(formula: &Formula) -> Option<&Node> {
    match &formula.row {
        Row::Expression(node) => Some(node),
        Row::Line(line) => line.sides.last().filter(|_| line.sides.len() == 2),
        Row::Unreadable { .. } => None,
    }
}

fn letter_in(formula: &Formula) -> Option<Formula> {
    match &formula.row {
        Row::Line(line) => line.sides.first().map(Formula::of),
        _ => None,
    }
}

/// The three entries of a row or a column.
fn entries_of(node: &Node) -> Option<Vec<&Node>> {
    match &node.kind {
        Kind::Transpose(inner) | Kind::Group(_, inner) => entries_of(inner),
        Kind::Tuple(entries) => (entries.len() == 3).then(|| entries.iter().collect()),
        Kind::Matrix(rows) => {
            let entries: Vec<&Node> = rows.iter().flatten().collect();
            let one = rows.len() == 1 || rows.iter().all(|row| row.len() == 1);
            (one && entries.len() == 3).then_some(entries)
        }
        _ => None,
    }
}
