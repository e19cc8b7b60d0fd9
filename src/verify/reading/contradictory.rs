//! Sentences that contradict each other: none of them tells anything.

use crate::verify::language::heads::VERTICAL;
use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::reading::names::name_of;

/// What a direction is said to be: of one thing one of them holds.
const SIDES: [&str; 2] = ["upward", "downward"];

/// The sentences, those that contradict another one as such that were not understood.
pub(super) fn unless_contradictory(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let verticals: Vec<(String, &str)> = declarations.iter().filter_map(vertical).collect();
    let turned = |one: &(String, &str)| {
        let mut all = verticals.iter();
        all.any(|other| other.0 == one.0 && other.1 != one.1)
    };
    let contradictory: Vec<bool> = declarations
        .iter()
        .map(|d| {
            let placed = declarations.iter().any(|other| places_otherwise(d, other));
            vertical(d).is_some_and(|one| turned(&one)) || placed
        })
        .collect();
    let all = declarations.into_iter().zip(contradictory);
    all.map(|(declaration, contradictory)| match contradictory {
        true => declaration.not_understood(),
        false => declaration,
    })
    .collect()
}

/// What is said to be vertical, and which way it points.
fn vertical(declaration: &Declaration) -> Option<(String, &'static str)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let side = SIDES.into_iter().find(|side| what.is(side))?;
    let [subject] = subjects.as_slice() else {
        return None;
    };
    Some((name_of(subject).filter(|_| what.head == VERTICAL)?, side))
}

/// Whether one sentence places one thing from another in two ways at once: at a distance along one axis and at another along
/// another.
fn places_otherwise(one: &Declaration, other: &Declaration) -> bool {
    let same = one.line == other.line && one.text == other.text && one.extent == other.extent;
    let placed = |d: &'_ Declaration| -> Option<(Vec<Term>, Term, Term)> {
        let (subjects, slots) = d.statement.does("lie")?;
        slot(slots, Slot::At)?;
        let from = slot(slots, Slot::From)?.clone();
        Some((subjects.to_vec(), from, slot(slots, Slot::Along)?.clone()))
    };
    match (placed(one), placed(other)) {
        (Some(one), Some(other)) => {
            same && one.0 == other.0 && one.1 == other.1 && one.2 != other.2
        }
        _ => false,
    }
}
