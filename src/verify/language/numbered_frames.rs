//! Frames that are called by numbers: "1 turns relative to 0", once a sentence says that 0 and 1 are frames.

use super::chains::name_chains;
use super::statement::{Declaration, Slot, Statement, Term};
use crate::notation::Macros;
use std::collections::BTreeSet;

/// Puts names in the places of numbers that sentences say to be frames.
pub(crate) fn name_frames_by_numbers(declarations: &mut Vec<Declaration>, macros: &Macros) {
    name_chains(declarations, macros);
    let frames = declarations.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" => subjects.as_slice(),
        _ => &[],
    });
    let frames: BTreeSet<usize> = frames.filter_map(number).collect();
    if frames.is_empty() {
        return;
    }
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Is { subjects, what } => {
                subjects.iter_mut().for_each(|term| name(term, &frames));
                name_in(&mut what.slots, &frames);
            }
            Statement::Does {
                subjects, slots, ..
            } => {
                subjects.iter_mut().for_each(|term| name(term, &frames));
                name_in(slots, &frames);
            }
            Statement::Premise(premise) => name_in(&mut premise.slots, &frames),
            _ => {}
        }
    }
}

fn number(term: &Term) -> Option<usize> {
    match term {
        Term::Numbers(numbers) => match numbers.as_slice() {
            [number] => Some(*number),
            _ => None,
        },
        Term::Phrase(phrase) => match (phrase.head, phrase.slots.as_slice()) {
            ("frame", [(Slot::Which, which)]) => number(which),
            _ => None,
        },
        _ => None,
    }
}

/// Which entry or axis is meant is said by a number as well.
fn name_in(slots: &mut [(Slot, Term)], frames: &BTreeSet<usize>) {
    let things = slots.iter_mut().filter(|(slot, _)| *slot != Slot::Which);
    things.for_each(|(_, term)| name(term, frames));
}

fn name(term: &mut Term, frames: &BTreeSet<usize>) {
    if let Some(number) = number(term).filter(|number| frames.contains(number)) {
        *term = Term::Name(number.to_string());
    }
    if let Term::Phrase(phrase) = term {
        name_in(&mut phrase.slots, frames);
    }
}
