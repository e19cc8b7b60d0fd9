//! The axis about which a thing turns, where a sentence says how it turns: "the wheel is symmetric about its axis of rotation".

use super::heads::MOMENT_OF_INERTIA;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::traits::{Trait, has};

/// The noun of the axis about which a thing turns.
const SPIN_AXIS: &str = "spin axis";

/// Puts the axis about which things are said to turn in the place of "the axis of rotation of the wheel".
pub(crate) fn name_spin_axes(declarations: &mut Vec<Declaration>) {
    let turns: Vec<(Term, Term)> = declarations.iter().flat_map(turns).collect();
    if turns.is_empty() {
        return;
    }
    part_shared_axes(declarations);
    for declaration in declarations {
        let (slots, round) = match &mut declaration.statement {
            Statement::Is { what, .. } => {
                let round = ABOUT_ONE_AXIS.contains(&what.head);
                (&mut what.slots, round)
            }
            Statement::Premise(premise) => (&mut premise.slots, false),
            Statement::Does { slots, .. } => (slots, false),
            _ => continue,
        };
        let slots = slots.iter_mut();
        slots.for_each(|(_, term)| name_axis(term, &turns, round));
    }
}

/// The things that a sentence says to turn, each with its axis by a letter.
fn turns(declaration: &Declaration) -> Vec<(Term, Term)> {
    let turn = declaration.statement.does("turn");
    let Some((subjects, slots)) = turn.filter(|_| declaration.extent == Extent::Document) else {
        return vec![];
    };
    let axis = slot(slots, Slot::About).filter(|axis| !matches!(axis, Term::Phrase(_)));
    // Against two frames it may turn about two axes.
    let against = slots.iter().filter(|(slot, _)| *slot == Slot::RelativeTo);
    match axis.filter(|_| against.count() < 2) {
        Some(axis) => {
            let things = subjects.iter().cloned();
            things.map(|thing| (thing, axis.clone())).collect()
        }
        None => vec![],
    }
}

/// What is said of a wheel about "its axis" is said about that about which it turns.
const ABOUT_ONE_AXIS: [&str; 2] = ["symmetric", MOMENT_OF_INERTIA];

fn name_axis(term: &mut Term, turns: &[(Term, Term)], round: bool) {
    if let Term::Phrase(phrase) = term {
        match axis_of(phrase, turns, round) {
            Some(axis) => *term = axis,
            None => {
                let inner = phrase.slots.iter_mut();
                inner.for_each(|(_, inner)| name_axis(inner, turns, round));
            }
        }
    }
}

/// The axis that a phrase speaks of, where its thing turns about no other one.
fn axis_of(phrase: &NounPhrase, turns: &[(Term, Term)], round: bool) -> Option<Term> {
    let [(Slot::Of, thing)] = phrase.slots.as_slice() else {
        return None;
    };
    let named = match phrase.head {
        SPIN_AXIS => true,
        // What turns as a wheel does is round about that.
        "axis" => round && is_wheel(thing),
        _ => false,
    };
    let mut axes = turns.iter().filter(|(own, _)| own == thing);
    let (_, axis) = axes
        .next()
        .filter(|_| named && phrase.adjectives.is_empty())?;
    axes.all(|(_, other)| other == axis).then(|| axis.clone())
}

fn is_wheel(thing: &Term) -> bool {
    match thing {
        Term::Name(name) => {
            let noun = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == ' ');
            has(noun, Trait::Wheel)
        }
        _ => false,
    }
}

/// "The wheels are symmetric about their axes of rotation": each is about its own.
fn part_shared_axes(declarations: &mut Vec<Declaration>) {
    let mut at = 0;
    while at < declarations.len() {
        let parted = parted(&declarations[at]);
        at += 1;
        if !parted.is_empty() {
            declarations.splice(at - 1..at, parted);
        }
    }
}

fn parted(declaration: &Declaration) -> Vec<Declaration> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return vec![];
    };
    let ("symmetric", [(Slot::About, Term::Phrase(axis))]) = (what.head, what.slots.as_slice())
    else {
        return vec![];
    };
    let all = match axis.slots.as_slice() {
        [] => true,
        // "the wheels", of wheel 1 and wheel 2
        [(Slot::Of, Term::Name(plural))] => subjects.iter().all(|subject| match subject {
            Term::Name(name) => {
                let noun = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == ' ');
                plural.strip_suffix('s') == Some(noun)
            }
            _ => false,
        }),
        _ => false,
    };
    if axis.head != SPIN_AXIS || subjects.len() < 2 || !all {
        return vec![];
    }
    let each = subjects.iter().map(|subject| {
        let of = vec![(Slot::Of, subject.clone())];
        let own = Term::Phrase(Box::new(NounPhrase::new(SPIN_AXIS, of)));
        let symmetric = NounPhrase::new("symmetric", vec![(Slot::About, own)]);
        declaration.saying(Statement::one_is(subject.clone(), symmetric))
    });
    each.collect()
}
