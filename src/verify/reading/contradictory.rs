//! Sentences that contradict each other: none of them tells anything.

use crate::verify::language::heads::{DYNAMICALLY_BALANCED, UNBALANCED, VERTICAL};
use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::language::traits::{Trait, has};
use crate::verify::reading::names::name_of;
use std::collections::BTreeMap;

/// What a direction is said to be: of one thing one of them holds.
const SIDES: [&str; 2] = ["upward", "downward"];

/// What is called a radius and a diameter of one thing is neither.
const ACROSS: [&str; 2] = ["radius", "diameter"];

/// The sentences, those that contradict another one as such that were not understood; and these by their texts, each with that
/// other one.
pub(super) fn unless_contradictory(
    declarations: Vec<Declaration>,
) -> (Vec<Declaration>, BTreeMap<String, String>) {
    let others = contradicted(&declarations);
    let all = declarations.iter().zip(&others);
    let pairs = all.filter_map(|(declaration, other)| {
        let other = declarations[(*other)?].sentence().to_owned();
        Some((declaration.sentence().to_owned(), other))
    });
    let contradictions = pairs.collect();
    let all = declarations.into_iter().zip(others);
    let left = all.map(|(declaration, other)| match other {
        Some(_) => declaration.not_understood(),
        None => declaration,
    });
    (left.collect(), contradictions)
}

/// For each sentence the place of the first other one that it contradicts.
fn contradicted(declarations: &[Declaration]) -> Vec<Option<usize>> {
    let verticals: Vec<_> = declarations.iter().map(vertical).collect();
    let turned = |one: &(String, &str)| {
        let says_otherwise = |other: &(String, &str)| match other.0 == one.0 {
            true => other.1 != one.1,
            false => are_axes_of_one(declarations, [&one.0, &other.0]),
        };
        let mut all = verticals.iter();
        all.position(|other| other.as_ref().is_some_and(says_otherwise))
    };
    let told: Vec<Told<'_>> = declarations.iter().map(Told::of).collect();
    let telling: Vec<usize> = (0..told.len()).filter(|&at| told[at].tells()).collect();
    let denies = |one: &Told<'_>, other: &Told<'_>| {
        places_otherwise(one, other)
            || turns_otherwise(one, other)
            || balances_otherwise(one, other)
            || measures_otherwise(one, other)
            || has_other_axis(one, other, declarations)
    };
    let denied = |one: &Told<'_>| {
        let mut others = telling.iter().copied();
        others.find(|&other| one.tells() && denies(one, &told[other]))
    };
    let each = verticals.iter().zip(&told);
    each.map(|(vertical, told)| vertical.as_ref().and_then(turned).or_else(|| denied(told)))
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

/// What a sentence tells of which there is only one.
struct Told<'d> {
    declaration: &'d Declaration,
    /// What is placed, from where and along what.
    placed: Option<(&'d [Term], Option<&'d Term>, &'d Term)>,
    sizes: Vec<(String, &'static str, String)>,
    /// The axis of a body, by their names.
    axis: Option<(String, String)>,
    turned: Option<Turned<'d>>,
    /// What is balanced or not, about an axis or about that about which it turns.
    balanced: Option<(&'d [Term], bool, Option<&'d Term>)>,
}

/// What turns, with the words that tell how.
type Turned<'d> = (&'d [Term], &'d [(Slot, Term)]);

impl<'d> Told<'d> {
    fn of(declaration: &'d Declaration) -> Self {
        Self {
            declaration,
            placed: placed(declaration),
            sizes: sizes_across(declaration),
            axis: axis(declaration),
            turned: declaration.statement.does("turn"),
            balanced: balanced(declaration),
        }
    }

    fn tells(&self) -> bool {
        let told = self.placed.is_some() || self.axis.is_some() || self.turned.is_some();
        told || self.balanced.is_some() || !self.sizes.is_empty()
    }
}

fn placed(declaration: &Declaration) -> Option<(&[Term], Option<&Term>, &Term)> {
    let (subjects, slots) = declaration.statement.does("lie")?;
    slot(slots, Slot::At)?;
    Some((subjects, slot(slots, Slot::From), slot(slots, Slot::Along)?))
}

/// Whether one sentence places one thing from another in two ways at once: at a distance along one axis and at another along
/// another.
fn places_otherwise(one: &Told<'_>, other: &Told<'_>) -> bool {
    let (first, second) = (one.declaration, other.declaration);
    let same = || first.line == second.line && first.text == second.text;
    match (one.placed, other.placed) {
        (Some(one), Some(other)) => {
            same()
                && first.extent == second.extent
                && one.0 == other.0
                && (one.1 == other.1 || one.1.is_none() || other.1.is_none())
                && one.2 != other.2
        }
        _ => false,
    }
}

/// Whether a thing is said to turn from one frame about one axis alone, and about another.
fn turns_otherwise(one: &Told<'_>, other: &Told<'_>) -> bool {
    let (Some((subjects, slots)), Some((others, besides))) = (one.turned, other.turned) else {
        return false;
    };
    let axis = |slots| match about(slots).as_slice() {
        [axis] => name_of(axis),
        _ => None,
    };
    let from = |slots| slot(slots, Slot::RelativeTo);
    subjects == others
        && one.declaration.extent == other.declaration.extent
        && from(slots) == from(besides)
        && matches!((axis(slots), axis(besides)), (Some(first), Some(second)) if first != second)
}

/// What is balanced statically alone may be called unbalanced.
fn balanced(declaration: &Declaration) -> Option<(&[Term], bool, Option<&Term>)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let balanced = match what.head {
        DYNAMICALLY_BALANCED => true,
        UNBALANCED => false,
        _ => return None,
    };
    Some((subjects, balanced, what.slot(Slot::About)))
}

/// Whether one thing is said to be balanced, and to be unbalanced about the same axis.
fn balances_otherwise(one: &Told<'_>, other: &Told<'_>) -> bool {
    match (one.balanced, other.balanced) {
        (Some((things, first, about)), Some((others, second, axis))) => {
            let same_axis = about == axis || about.is_none() || axis.is_none();
            things == others && first != second && same_axis
        }
        _ => false,
    }
}

fn about(slots: &[(Slot, Term)]) -> Vec<&Term> {
    let about = slots.iter().filter(|(slot, _)| *slot == Slot::About);
    about.map(|(_, axis)| axis).collect()
}

fn measures_otherwise(one: &Told<'_>, other: &Told<'_>) -> bool {
    one.sizes.iter().any(|(thing, size, letter)| {
        let otherwise = |(t, s, l): &(String, &str, String)| t == thing && l == letter && s != size;
        other.sizes.iter().any(otherwise)
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

/// The axis that is said to be that of a body, and the body.
fn axis(declaration: &Declaration) -> Option<(String, String)> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == "axis" => {
            match (subjects.as_slice(), what.slots.as_slice()) {
                ([axis], [(Slot::Of, body)]) => Some((name_of(axis)?, name_of(body)?)),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Whether two axes of one frame are each said to be the axis of one round body.
fn has_other_axis(one: &Told<'_>, other: &Told<'_>, all: &[Declaration]) -> bool {
    let (Some((axis, body)), Some((second, same))) = (&one.axis, &other.axis) else {
        return false;
    };
    let has_one = |noun: &str| has(noun, Trait::Round) || has(noun, Trait::Slender);
    let is_round = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => has_one(what.head) && names(subjects, body),
        _ => false,
    };
    body == same
        && axis != second
        && are_axes_of_one(all, [axis, second])
        && all.iter().any(is_round)
}

/// Whether a sentence names both as axes of one frame.
fn are_axes_of_one(all: &[Declaration], axes: [&String; 2]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            what.head == "axes" && axes.iter().all(|axis| names(subjects, axis))
        }
        _ => false,
    })
}

fn names(subjects: &[Term], name: &String) -> bool {
    let mut subjects = subjects.iter();
    subjects.any(|subject| name_of(subject).as_ref() == Some(name))
}
