//! What kind of thing a name is, as other sentences show it: what has axes is a frame, and "the mass centre G of the body"
//! says what G is.

use super::lexicon::{Class, Lexicon};
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

/// "The top is a rigid body" and then "the body": of the only thing that is said to be one it is another name.
pub(crate) fn name_the_only_one(declarations: &mut [Declaration], lexicon: &Lexicon) {
    for noun in ["body", "particle"] {
        let is_one = |what: &NounPhrase| match noun {
            "particle" => what.head == noun,
            _ => what.head != "particle" && lexicon.entry(what.head, &[Class::Thing]).is_some(),
        };
        let own = |term: &Term| name(term).is_some_and(|name| name == noun);
        if declarations
            .iter()
            .any(|d| d.statement.subjects().iter().any(own))
        {
            continue;
        }
        let mut things = BTreeSet::new();
        for declaration in declarations.iter() {
            if let Statement::Is { subjects, what } = &declaration.statement
                && is_one(what)
            {
                things.extend(subjects.iter().filter_map(name));
            }
        }
        let only = things.pop_first().filter(|_| things.is_empty());
        if let Some(only) = only.filter(|only| only != noun) {
            for term in declarations
                .iter_mut()
                .flat_map(|d| d.statement.terms_mut())
            {
                rename(term, noun, &only);
            }
        }
    }
}

fn rename(term: &mut Term, from: &str, to: &str) {
    match term {
        Term::Name(name) if name == from => to.clone_into(name),
        Term::Phrase(phrase) => {
            for (_, inner) in &mut phrase.slots {
                rename(inner, from, to);
            }
        }
        _ => {}
    }
}

/// "No moment acts on the body about its mass centre G" tells what G is, where no sentence of its own does.
pub(crate) fn tell_mass_centres(declarations: &mut Vec<Declaration>) {
    let told: BTreeSet<String> = declarations
        .iter()
        .filter_map(|declaration| match &declaration.statement {
            Statement::Is { subjects, .. } => Some(subjects.iter().filter_map(name)),
            _ => None,
        })
        .flatten()
        .collect();
    let mut found: Vec<Declaration> = vec![];
    for declaration in declarations.iter() {
        let mentioned = declaration.statement.terms();
        for centre in mentioned.into_iter().filter_map(named_centre) {
            let new = subject_name(&centre).is_some_and(|name| !told.contains(&name));
            if new && !found.iter().any(|known| known.statement == centre) {
                found.push(Declaration {
                    statement: centre,
                    ..declaration.clone()
                });
            }
        }
    }
    declarations.extend(found);
}

/// "The mass centre G of the body", "the body with its mass centre at G": the statement that G is it.
fn named_centre(term: &Term) -> Option<Statement> {
    let Term::Phrase(phrase) = term else {
        return None;
    };
    let called = phrase.slot(Slot::Which).or(phrase.slot(Slot::At))?;
    let of = phrase
        .slot(Slot::Of)
        .filter(|_| phrase.head == "mass centre")?;
    name(called)?;
    Some(Statement::Is {
        subjects: vec![called.clone()],
        what: NounPhrase::new(phrase.head, vec![(Slot::Of, of.clone())]),
    })
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

fn subject_name(statement: &Statement) -> Option<String> {
    match statement {
        Statement::Is { subjects, .. } => name(subjects.first()?),
        _ => None,
    }
}
