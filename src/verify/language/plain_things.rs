//! Things by their plain names: "the rigid body" is the body, and "an inertial frame" the one that a sentence names.

use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Adjectives that say of a thing nothing that could tell it from another.
const IDLE: [&str; 3] = ["rigid", "whole", "heavy"];

/// The name of the inertial frame where no sentence gives it one.
const INERTIAL_FRAME: &str = "inertial frame";

/// Names the things that sentences speak of by a noun and adjectives that tell nothing new.
pub(crate) fn name_plainly(declarations: &mut Vec<Declaration>) {
    let inertial = inertial_frame(declarations);
    let ground = inertial
        .clone()
        .unwrap_or_else(|| INERTIAL_FRAME.to_owned());
    let mut unnamed = None;
    for declaration in declarations.iter_mut() {
        let before = declaration.clone();
        let mut used = false;
        for term in declaration.statement.terms_mut() {
            used |= plain(term, &ground);
        }
        if used && inertial.is_none() {
            unnamed.get_or_insert(before);
        }
    }
    declarations.extend(unnamed.map(|sentence| Declaration {
        statement: Statement::Is {
            subjects: vec![Term::Name(ground)],
            what: NounPhrase {
                adjectives: vec!["inertial"],
                ..NounPhrase::new("frame", vec![])
            },
        },
        ..sentence
    }));
}

/// The inertial frame that sentences name.
fn inertial_frame(declarations: &[Declaration]) -> Option<String> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" && what.is("inertial") => {
            subjects.first().and_then(name)
        }
        _ => None,
    })
}

/// Gives a thing its plain name; whether the inertial frame was spoken of.
fn plain(term: &mut Term, ground: &str) -> bool {
    let Term::Phrase(phrase) = term else {
        return false;
    };
    let bare = phrase.slots.is_empty();
    let only = |allowed: &[&str]| phrase.adjectives.iter().all(|a| allowed.contains(a));
    if bare && phrase.head == "frame" && phrase.is("inertial") && only(&["inertial", "fixed"]) {
        *term = Term::Name(ground.to_owned());
        return true;
    }
    if bare && is_body(phrase.head) && !phrase.adjectives.is_empty() && only(&IDLE) {
        *term = Term::Name(phrase.head.to_owned());
        return false;
    }
    if let [(Slot::Which, Term::Numbers(number))] = phrase.slots.as_slice()
        && let ([number], true) = (number.as_slice(), is_body(phrase.head))
    {
        *term = Term::Name(format!("{} {number}", phrase.head));
        return false;
    }
    let mut used = false;
    for (_, inner) in &mut phrase.slots {
        used |= plain(inner, ground);
    }
    used
}

/// "the axes of the frame B of the disc": what is said of a frame beside its name is a sentence of its own.
pub(crate) fn tell_named_frames(declarations: &mut Vec<Declaration>) {
    let mut told: Vec<Declaration> = vec![];
    for declaration in declarations.iter_mut() {
        let before = declaration.clone();
        for term in declaration.statement.terms_mut() {
            for statement in named_frames(term) {
                told.push(Declaration {
                    statement,
                    ..before.clone()
                });
            }
        }
    }
    declarations.extend(told);
}

/// Puts the name of a frame in the place of its phrase, and gives what the phrases say.
fn named_frames(term: &mut Term) -> Vec<Statement> {
    let Term::Phrase(phrase) = term else {
        return vec![];
    };
    let mut told = vec![];
    for (_, inner) in &mut phrase.slots {
        told.extend(named_frames(inner));
    }
    let called: Vec<&Term> = phrase.all(Slot::Which).collect();
    if let ("frame", [called @ Term::Name(_)]) = (phrase.head, called.as_slice()) {
        let called = (*called).clone();
        phrase.slots.retain(|(slot, _)| *slot != Slot::Which);
        if !phrase.slots.is_empty() || !phrase.adjectives.is_empty() {
            told.push(Statement::Is {
                subjects: vec![called.clone()],
                what: (**phrase).clone(),
            });
        }
        *term = called;
    }
    told
}
