//! Loads of which a sentence does not say on what they act: "the total moment about G" is that on the body with the mass
//! centre G, or on the only body.

use super::heads::{FORCE, MASS_CENTRE, MOMENT, WEIGHT};
use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeSet;

/// Names the body.
pub(super) fn name_loaded_bodies(declarations: &mut [Declaration]) {
    let only = only_body(declarations);
    let loaded = |about: Option<&Term>| match about {
        Some(point) => centred_on(point, declarations).or_else(|| only.clone()),
        None => only.clone(),
    };
    let told: Vec<Option<Term>> = declarations
        .iter()
        .map(|d| match &d.statement {
            Statement::Is { what, .. } if wants_body(what) || of_loads(what) => {
                loaded(what.slot(Slot::About))
            }
            Statement::Premise(absent) if absent.is("no") && is_plain_load(absent) => {
                loaded(absent.slot(Slot::About))
            }
            _ => None,
        })
        .collect();
    for (declaration, body) in declarations.iter_mut().zip(told) {
        if let Statement::Is { what, .. } | Statement::Premise(what) = &mut declaration.statement {
            let Some(body) = body else { continue };
            let inner = what
                .slots
                .iter()
                .position(|(_, term)| matches!(term, Term::Phrase(loads) if are_external(loads)));
            let slots = match inner.and_then(|at| what.slots.get_mut(at)) {
                Some((_, Term::Phrase(loads))) => &mut loads.slots,
                _ => &mut what.slots,
            };
            slots.push((Slot::Of, body));
        }
    }
}

/// "`$M$` is the moment of the weight about O", where the weight is listed among the loads on one body alone: that of it.
pub(super) fn give_weights_to_loaded(declarations: &mut [Declaration]) {
    let mut loaded = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Premise(list) if list.is("only") && lists_weight(list) => {
            list.slot(Slot::Of).or(list.slot(Slot::Upon))
        }
        _ => None,
    });
    let Some(body) = loaded.next().cloned() else {
        return;
    };
    if loaded.any(|other| *other != body) {
        return;
    }
    for declaration in declarations.iter_mut() {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && let Some((_, Term::Phrase(weight))) =
                what.slots.iter_mut().find(|(slot, _)| *slot == Slot::Of)
            && weight.head == WEIGHT
            && weight.adjectives.is_empty()
            && weight
                .slots
                .iter()
                .all(|(slot, _)| matches!(slot, Slot::About | Slot::Along))
        {
            // Before what is said of its moment.
            weight.slots.insert(0, (Slot::Of, body.clone()));
        }
    }
}

fn lists_weight(list: &NounPhrase) -> bool {
    let mut loads = list.all(Slot::With);
    loads.any(|load| matches!(load, Term::Phrase(weight) if is_plain_weight(weight)))
}

/// "the weight": of which no word says whose it is.
fn is_plain_weight(load: &NounPhrase) -> bool {
    load.head == WEIGHT && load.slots.is_empty() && load.adjectives.is_empty()
}

/// "the total moment about G", "the moment of the external forces about G"
fn wants_body(what: &NounPhrase) -> bool {
    (what.is("total") || what.is("external")) && is_plain_load(what)
}

/// "the moment of the external forces about G"
fn of_loads(what: &NounPhrase) -> bool {
    let own = |(slot, term): &(Slot, Term)| match (slot, term) {
        (Slot::Of, Term::Phrase(loads)) => are_external(loads),
        (slot, _) => *slot == Slot::About,
    };
    what.head == MOMENT && what.slot(Slot::Of).is_some() && what.slots.iter().all(own)
}

fn are_external(loads: &NounPhrase) -> bool {
    matches!(loads.head, FORCE | "load") && loads.is("external") && loads.slots.is_empty()
}

fn is_plain_load(what: &NounPhrase) -> bool {
    let place = |(slot, _): &(Slot, Term)| {
        matches!(
            slot,
            Slot::About | Slot::On | Slot::Along | Slot::RelativeTo
        )
    };
    matches!(what.head, MOMENT | FORCE) && what.slots.iter().all(place)
}

/// What has its mass centre at a point.
fn centred_on(point: &Term, declarations: &[Declaration]) -> Option<Term> {
    let mut centred = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == MASS_CENTRE => {
            let own = subjects.iter().any(|s| name(s) == name(point));
            what.slot(Slot::Of).filter(|_| own)
        }
        _ => None,
    });
    let first = centred.next()?;
    centred.all(|other| other == first).then(|| first.clone())
}

/// The one thing that is a body, or has a mass centre.
fn only_body(declarations: &[Declaration]) -> Option<Term> {
    let told = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { what, .. } if what.head == MASS_CENTRE => what.slot(Slot::Of).cloned(),
        Statement::Is { subjects, what } if is_body(what.head) => subjects.first().cloned(),
        _ => None,
    });
    let mut bodies: Vec<Term> = told.collect();
    let names: BTreeSet<Option<String>> = bodies.iter().map(name).collect();
    bodies.pop().filter(|_| names.len() == 1)
}
