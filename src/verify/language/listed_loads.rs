//! Loads of which a list of the only ones on a body tells: wherever else sentences speak of them they act on that body, and
//! at the same point.

use super::heads::{CONTACT_POINT, WEIGHT};
use super::is_load;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// A load in the list of a body.
struct Listed {
    body: Term,
    load: NounPhrase,
}

/// "The force of the floor is along z", where a list has the force of the floor at P among the loads on the ladder: it is that
/// one.
pub(crate) fn act_as_listed(declarations: &mut [Declaration]) {
    let mut listed: Vec<Listed> = declarations.iter().flat_map(in_list).collect();
    // What acts where two bodies touch is found by the bodies.
    let touching = |at: &Term| declarations.iter().any(|d| is_contact(at, &d.statement));
    for Listed { load, .. } in &mut listed {
        load.slots
            .retain(|(slot, at)| *slot != Slot::At || !touching(at));
    }
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Is { subjects, what } => {
                subjects.iter_mut().for_each(|term| complete(term, &listed));
                complete_phrase(what, &listed);
            }
            Statement::Does { subjects, .. } => {
                subjects.iter_mut().for_each(|term| complete(term, &listed));
            }
            _ => {}
        }
    }
}

/// Whether a sentence says that bodies touch at a point.
fn is_contact(at: &Term, statement: &Statement) -> bool {
    match statement {
        Statement::Is { subjects, what } => what.head == CONTACT_POINT && subjects.contains(at),
        Statement::Does { verb, slots, .. } => {
            *verb == "touch" && slot(slots, Slot::At) == Some(at)
        }
        _ => false,
    }
}

/// The loads that a sentence lists as the only ones on a body, but for weights.
fn in_list(declaration: &Declaration) -> Vec<Listed> {
    let Statement::Premise(premise) = &declaration.statement else {
        return vec![];
    };
    let Some(body) = premise.slot(Slot::Of).filter(|_| premise.is("only")) else {
        return vec![];
    };
    let loads = premise.all(Slot::With).filter_map(|load| match load {
        Term::Phrase(load) if is_load(load.head) && load.head != WEIGHT => Some(Listed {
            body: body.clone(),
            load: (**load).clone(),
        }),
        _ => None,
    });
    loads.collect()
}

fn complete(term: &mut Term, listed: &[Listed]) {
    if let Term::Phrase(phrase) = term {
        complete_phrase(phrase, listed);
    }
}

/// The body on which a load acts, and its point, where one list has a load of this name and no other.
fn complete_phrase(phrase: &mut NounPhrase, listed: &[Listed]) {
    if !is_load(phrase.head) {
        let terms = phrase.slots.iter_mut();
        terms.for_each(|(_, term)| complete(term, listed));
        return;
    }
    let mut same = listed.iter().filter(|other| is_same(phrase, other));
    let (Some(found), None) = (same.next(), same.next()) else {
        return;
    };
    if phrase.slot(Slot::Upon).is_none() {
        let place = phrase.slots.iter().position(|(slot, _)| *slot == Slot::Of);
        let upon = (Slot::Upon, found.body.clone());
        phrase
            .slots
            .insert(place.map_or(0, |place| place + 1), upon);
    }
    let about = [Slot::At, Slot::About].map(|slot| phrase.slot(slot));
    if let (Some(at), [None, None]) = (found.load.slot(Slot::At), about) {
        phrase.slots.push((Slot::At, at.clone()));
    }
}

/// Whether a load may be one of a list: of the same name and the same agent, and on no other body.
fn is_same(phrase: &NounPhrase, listed: &Listed) -> bool {
    let agent = |load: &NounPhrase| load.slot(Slot::Of).cloned();
    let named = |load: &NounPhrase| (load.head, load.adjectives.clone(), agent(load));
    let upon = phrase.slot(Slot::Upon);
    let at = phrase.slot(Slot::At);
    named(phrase) == named(&listed.load)
        && agent(phrase).is_some_and(|agent| agent != listed.body)
        && phrase.slot(Slot::Which).is_none()
        && listed.load.slot(Slot::Which).is_none()
        && upon.is_none_or(|upon| *upon == listed.body)
        && at.is_none_or(|at| listed.load.slot(Slot::At).is_none_or(|own| own == at))
}
