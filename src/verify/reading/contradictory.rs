//! Sentences that contradict each other: none of them tells anything.

use crate::verify::language::heads::VERTICAL;
use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::reading::names::name_of;

/// What a direction is said to be: of one thing one of them holds.
const SIDES: [&str; 2] = ["upward", "downward"];

/// What is called a radius and a diameter of one thing is neither.
const ACROSS: [&str; 2] = ["radius", "diameter"];

/// Shapes with a single axis.
const ROUND: [&str; 6] = ["disc", "ring", "rod", "cylinder", "tube", "cone"];

/// The sentences, those that contradict another one as such that were not understood.
pub(super) fn unless_contradictory(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let verticals: Vec<(String, &str)> = declarations.iter().filter_map(vertical).collect();
    let turned = |one: &(String, &str)| {
        let mut all = verticals.iter();
        all.any(|other| other.0 == one.0 && other.1 != one.1)
    };
    let denies = |one: &Declaration, other: &Declaration| {
        places_otherwise(one, other)
            || measures_otherwise(one, other)
            || has_other_axis(one, other, &declarations)
    };
    let contradictory: Vec<bool> = declarations
        .iter()
        .map(|d| {
            let denied = declarations.iter().any(|other| denies(d, other));
            vertical(d).is_some_and(|one| turned(&one)) || denied
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

fn measures_otherwise(one: &Declaration, other: &Declaration) -> bool {
    let (one, other) = (sizes_across(one), sizes_across(other));
    one.iter().any(|(thing, size, letter)| {
        let otherwise = |(t, s, l): &(String, &str, String)| t == thing && l == letter && s != size;
        other.iter().any(otherwise)
    })
}

/// The things that have a radius or a diameter, which of them, and its letter.
fn sizes_across(declaration: &Declaration) -> Vec<(String, &'static str, String)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return vec![];
    };
    let across = |head: &str| ACROSS.into_iter().find(|size| *size == head);
    if let Some(size) = across(what.head) {
        let things = what.all(Slot::Of).filter_map(name_of);
        let letters: Vec<String> = subjects.iter().filter_map(name_of).collect();
        let each = things.flat_map(|thing| {
            letters
                .iter()
                .map(move |l| (thing.clone(), size, l.clone()))
        });
        return each.collect();
    }
    let sizes = what.all(Slot::Of).filter_map(|of| match of {
        Term::Phrase(size) => Some((
            across(size.head)?,
            size.slot(Slot::Which).and_then(name_of)?,
        )),
        _ => None,
    });
    let things: Vec<String> = subjects.iter().filter_map(name_of).collect();
    let each = sizes.flat_map(|(size, letter)| {
        let of_thing = move |thing: &String| (thing.clone(), size, letter.clone());
        things.iter().map(of_thing).collect::<Vec<_>>()
    });
    each.collect()
}

/// Whether two axes of one frame are each said to be the axis of one round body.
fn has_other_axis(one: &Declaration, other: &Declaration, all: &[Declaration]) -> bool {
    let axis = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axis" => {
            match (subjects.as_slice(), what.slots.as_slice()) {
                ([axis], [(Slot::Of, body)]) => Some((name_of(axis)?, name_of(body)?)),
                _ => None,
            }
        }
        _ => None,
    };
    let (Some((axis, body)), Some((second, same))) = (axis(one), axis(other)) else {
        return false;
    };
    let named = |subjects: &[Term], name: &String| {
        subjects
            .iter()
            .any(|subject| name_of(subject).as_ref() == Some(name))
    };
    let says = |d: &Declaration, heads: &[&str], names: [&String; 2]| match &d.statement {
        Statement::Is { subjects, what } => {
            heads.contains(&what.head) && names.iter().all(|name| named(subjects, name))
        }
        _ => false,
    };
    body == same
        && axis != second
        && all.iter().any(|d| says(d, &["axes"], [&axis, &second]))
        && all.iter().any(|d| says(d, &ROUND, [&body, &body]))
}
