//! Centres of shapes that are their mass centres, and sentences by which they may not be.

use super::heads::{DENSITY, MASS, MASS_CENTRE, UNBALANCED};
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::traits::{
    Trait::{OneSided, Shape},
    has,
};
use std::collections::BTreeSet;

/// Words for the place in the middle of a shape.
pub(crate) const MIDDLES: [&str; 2] = ["centre", "middle"];

/// Words of where the mass of a body is.
const OFF_CENTRE: [&str; 7] = [
    "centre",
    "center",
    "consists",
    "eccentric",
    "unbalanced",
    "loaded",
    "uneven",
];

/// Whether a sentence that is not understood may say where the mass of something is that has one of these names.
pub(crate) fn speaks_of_centre(sentence: &Declaration, names: &[&str]) -> bool {
    let words = sentence.text.split_whitespace();
    let words = words.map(|word| word.trim_matches(|c: char| !c.is_alphanumeric()));
    let words: Vec<&str> = words.collect();
    let has = |wanted: &[&str]| words.iter().any(|word| wanted.contains(word));
    has(names) && has(&OFF_CENTRE)
}

/// The names of the things of which a sentence says something.
fn names_with(
    declarations: &[Declaration],
    told: impl Fn(&NounPhrase) -> bool,
) -> BTreeSet<String> {
    let named = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if told(what) => {
            subjects.iter().filter_map(name).collect()
        }
        _ => vec![],
    };
    declarations.iter().flat_map(named).collect()
}

/// The names that sentences give to a place of each thing.
fn places_named(declarations: &[Declaration], place: &[&str]) -> BTreeSet<(String, String)> {
    let named = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if place.contains(&what.head) => {
            let of = what.slot(Slot::Of).and_then(name);
            let names = subjects.iter().filter_map(name);
            of.map_or(vec![], |of| names.map(|name| (of.clone(), name)).collect())
        }
        _ => vec![],
    };
    declarations.iter().flat_map(named).collect()
}

/// The things whose middle and whose mass centre have names of their own: their mass is not spread evenly.
fn off_centre(declarations: &[Declaration]) -> BTreeSet<String> {
    let centres = places_named(declarations, &[MASS_CENTRE]);
    let middles = places_named(declarations, &MIDDLES);
    let has_another = |(of, middle): &(String, String)| {
        let same = centres.contains(&(of.clone(), middle.clone()));
        (!same && centres.iter().any(|(thing, _)| thing == of)).then(|| of.clone())
    };
    middles.iter().filter_map(has_another).collect()
}

/// The things of whose density a sentence speaks: it need not be the same everywhere.
fn with_density(declarations: &[Declaration]) -> BTreeSet<String> {
    let of = |term: &Term| match term {
        Term::Phrase(what) if what.head == DENSITY => what.slot(Slot::Of).and_then(name),
        _ => None,
    };
    let told = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let mut told: Vec<String> = subjects.iter().filter_map(of).collect();
            if what.head == DENSITY {
                told.extend(what.slot(Slot::Of).and_then(name));
            }
            told
        }
        Statement::Does { subjects, .. } => subjects.iter().filter_map(of).collect(),
        _ => vec![],
    };
    declarations.iter().flat_map(told).collect()
}

/// The things that have a mass.
fn with_mass(declarations: &[Declaration]) -> BTreeSet<String> {
    let is_mass = |(_, term): &(Slot, Term)| matches!(term, Term::Phrase(of) if of.head == MASS);
    let mut massive = names_with(declarations, |what| what.slots.iter().any(is_mass));
    for declaration in declarations {
        if let Statement::Is { what, .. } = &declaration.statement
            && what.head == MASS
        {
            massive.extend(what.all(Slot::Of).filter_map(name));
        }
    }
    massive
}

/// The centre of a uniform disc is its mass centre, and so is the middle of a uniform rod; a shape that has a mass is uniform where
/// no sentence says otherwise.
pub(crate) fn centre_shapes(declarations: &mut [Declaration]) {
    let shaped = names_with(declarations, |what| has(what.head, Shape));
    let massive = with_mass(declarations);
    let mut uniform: BTreeSet<String> = shaped.intersection(&massive).cloned().collect();
    let otherwise = [off_centre(declarations), with_density(declarations)];
    uniform.retain(|thing| !otherwise.iter().any(|others| others.contains(thing)));
    uniform.extend(names_with(declarations, |what| what.is("uniform")));
    // Their centre is the middle of a face or of what they are cut from.
    let one_sided = names_with(declarations, |what| has(what.head, OneSided));
    let unbalanced = names_with(declarations, |what| what.head == UNBALANCED);
    uniform.retain(|thing| !one_sided.contains(thing) && !has(thing, OneSided));
    uniform.retain(|thing| !unbalanced.contains(thing));
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && MIDDLES.contains(&what.head)
            && let Some(of) = what.slot(Slot::Of).and_then(name)
            && uniform.contains(&of)
        {
            what.head = MASS_CENTRE;
        }
    }
}
