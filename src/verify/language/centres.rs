//! Centres of shapes that are their mass centres, and sentences by which they may not be.

use super::heads::{MASS_CENTRE, UNBALANCED};
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement};
use super::traits::{Trait::OneSided, has};
use std::collections::BTreeSet;

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

/// The centre of a uniform disc is its mass centre, and so is the middle of a uniform rod.
pub(crate) fn centre_shapes(declarations: &mut [Declaration]) {
    let mut uniform = names_with(declarations, |what| what.is("uniform"));
    // Their centre is the middle of a face or of what they are cut from.
    let one_sided = names_with(declarations, |what| has(what.head, OneSided));
    let unbalanced = names_with(declarations, |what| what.head == UNBALANCED);
    uniform.retain(|thing| !one_sided.contains(thing) && !has(thing, OneSided));
    uniform.retain(|thing| !unbalanced.contains(thing));
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && matches!(what.head, "centre" | "middle")
            && let Some(of) = what.slot(Slot::Of).and_then(name)
            && uniform.contains(&of)
        {
            what.head = MASS_CENTRE;
        }
    }
}
