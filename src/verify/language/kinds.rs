//! What kind of thing a name is, as other sentences show it: what has axes is a frame.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeSet;

/// "B is fixed in the body" says of a frame what "B is a frame fixed in the body" says.
pub(crate) fn show_frames(declarations: &mut [Declaration]) {
    let mut frames = BTreeSet::new();
    for declaration in declarations.iter() {
        if let Statement::Is { subjects, what } = &declaration.statement {
            if what.head == "frame" {
                frames.extend(subjects.iter().filter_map(name));
            }
            seen_in(what, &mut frames);
        }
        for term in declaration.statement.terms() {
            if let Term::Phrase(phrase) = term {
                seen_in(phrase, &mut frames);
            }
        }
    }
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

/// The frames that a phrase shows: what has axes, from where a rate is seen, on what components are taken.
fn seen_in(phrase: &NounPhrase, frames: &mut BTreeSet<String>) {
    let on_frame = ["component", "entry"].contains(&phrase.head);
    for (slot, term) in &phrase.slots {
        let frame = match slot {
            Slot::SeenFrom => true,
            Slot::Of => phrase.head == "axes",
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

/// A thing by its name, plain or between dollar signs.
fn name(term: &Term) -> Option<String> {
    match term {
        Term::Name(name) => Some(name.clone()),
        Term::Formula(formula) => Some(formula.source.clone()),
        _ => None,
    }
}
