//! "the axis", where one axis alone is spoken of: "The body turns about the axis through O along z", "no moment about the axis
//! acts on it".

use super::heads::AXES;
use super::is_body;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};

const AXIS: &str = "axis";

/// Puts the axis about which things turn in the place of "the axis".
pub(crate) fn tell_the_axis(declarations: &mut [Declaration]) {
    let Some(axis) = the_only_axis(declarations) else {
        return;
    };
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Is { what, .. } | Statement::Premise(what) => name_axis(what, &axis),
            _ => {}
        }
        for term in declaration.statement.terms_mut() {
            if let Term::Phrase(phrase) = term {
                name_axis(phrase, &axis);
            }
        }
    }
}

/// The axis of all turns, where it is one and none else is spoken of.
fn the_only_axis(declarations: &[Declaration]) -> Option<Term> {
    let mut axes: Vec<&Term> = vec![];
    for declaration in declarations {
        if let Statement::Is { what, .. } = &declaration.statement
            && (what.head == "symmetric" || is_axis(what))
        {
            return None;
        }
        let Some((_, slots)) = declaration.statement.does("turn") else {
            continue;
        };
        let about = slot(slots, Slot::About).filter(|about| !is_bare(about))?;
        // "the shaft" is called by its own noun.
        if matches!(about, Term::Phrase(thing) if is_body(thing.head)) {
            continue;
        }
        if declaration.extent != Extent::Document {
            return None;
        }
        if !axes.contains(&about) {
            axes.push(about);
        }
    }
    let [axis @ (Term::Phrase(_) | Term::Formula(_))] = axes.as_slice() else {
        return None;
    };
    // Another axis that is spoken of may be meant.
    let mut spoken = declarations.iter().flat_map(|d| d.statement.terms());
    let other = |term: &Term| {
        matches!(term, Term::Phrase(other) if AXES.contains(&other.head))
            && !is_bare(term)
            && term != *axis
    };
    (!spoken.any(other)).then(|| (*axis).clone())
}

fn is_axis(what: &NounPhrase) -> bool {
    what.head == AXIS
}

/// "the axis", of which no more is said.
fn is_bare(term: &Term) -> bool {
    matches!(term, Term::Phrase(axis) if is_axis(axis) && axis.slots.is_empty() && axis.adjectives.is_empty())
}

fn name_axis(phrase: &mut NounPhrase, axis: &Term) {
    for (slot, term) in &mut phrase.slots {
        let from = *slot == Slot::RelativeTo && phrase.head == "distance";
        if (from || matches!(slot, Slot::About | Slot::Along)) && is_bare(term) {
            term.clone_from(axis);
        }
        if let Term::Phrase(inner) = term {
            name_axis(inner, axis);
        }
    }
}
