//! Names that sentences use as those of frames, whatever else is said of them.

use super::heads::EULER_ANGLES;
use super::kinds::name;
use super::statement::{Declaration, NotationMeaning, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeSet;

/// The slots of what a matrix takes components from and to.
const TAKEN: [Slot; 2] = [Slot::From, Slot::To];

/// "B is fixed in the body" says of a frame what "B is a frame fixed in the body" says.
pub(crate) fn show_frames(declarations: &mut [Declaration]) {
    let frames = frames_shown(declarations);
    for declaration in declarations {
        if let Statement::Is { subjects, .. } = &declaration.statement
            && subjects
                .iter()
                .all(|s| name(s).is_some_and(|name| frames.contains(&name)))
        {
            declaration.statement.is_of(Some("frame"));
        }
    }
}

/// The names that sentences use as those of frames.
pub(super) fn frames_shown(declarations: &[Declaration]) -> BTreeSet<String> {
    let mut frames = BTreeSet::new();
    for declaration in declarations.iter() {
        if let Statement::Is { subjects, what } = &declaration.statement {
            // What is inertial is a frame.
            if matches!(what.head, "frame" | "inertial") {
                frames.extend(subjects.iter().filter_map(name));
            }
            seen_in(what, &mut frames);
        }
        if let Statement::Notation {
            meaning: NotationMeaning::Noun(noun),
            ..
        } = &declaration.statement
        {
            seen_in(noun, &mut frames);
        }
        // What a matrix takes components from and to.
        if let Some((_, slots)) = declaration.statement.does("take") {
            let ends = slots.iter().filter(|(slot, _)| TAKEN.contains(slot));
            frames.extend(ends.filter_map(|(_, term)| name(term)));
        }
        for term in declaration.statement.terms() {
            if let Term::Phrase(phrase) = term {
                seen_in(phrase, &mut frames);
            }
        }
    }
    frames
}

/// The frames that a phrase shows: what has axes, from where a rate is seen, on what components are taken.
fn seen_in(phrase: &NounPhrase, frames: &mut BTreeSet<String>) {
    let on_frame = ["component", "entry"].contains(&phrase.head);
    for (slot, term) in &phrase.slots {
        let frame = match slot {
            Slot::SeenFrom => true,
            Slot::Of => matches!(phrase.head, "axes" | EULER_ANGLES),
            Slot::RelativeTo => phrase.head == EULER_ANGLES,
            Slot::On => on_frame,
            _ => false,
        };
        match term {
            term if frame => frames.extend(name(term)),
            Term::Phrase(inner) => seen_in(inner, frames),
            _ => {}
        }
    }
}
