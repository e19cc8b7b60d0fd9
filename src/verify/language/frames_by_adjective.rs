//! Frames that have no name but their adjective: "the moving frame", "the body axes".

use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use std::collections::{BTreeMap, BTreeSet};

/// Adjectives that tell a frame from the inertial one.
const TELLING: [&str; 2] = ["rotating", "body-fixed"];

/// Those by which a frame may be called that has no other name.
const CALLING: [&str; 5] = ["world", "laboratory", "orbital", "wind", "local"];

/// What is said of a frame that it may be told of by its adjective.
const SAID: [&str; 2] = ["fixed", "frame"];

/// Puts names in the places of frames that an adjective tells from the inertial one: that of the only frame that is fixed in
/// a body, or one of its own where a sentence says what the frame is fixed in.
pub(super) fn name_frames(declarations: &mut Vec<Declaration>) {
    declarations.retain(|d| !is_of_axes_that_meet(&d.statement));
    let only = only_frame_of_bodies(declarations);
    let mut names: BTreeMap<&'static str, String> = BTreeMap::new();
    for declaration in declarations.iter() {
        if let Statement::Is { subjects, what } = &declaration.statement
            && let [Term::Phrase(frame)] = subjects.as_slice()
            && let Some(adjective) = adjective_of(frame, "frame")
            && SAID.contains(&what.head)
            && what.slot(Slot::FixedIn).is_some()
        {
            names.insert(adjective, format!("{adjective} frame"));
        }
    }
    if let (Some(only), true) = (only, names.is_empty()) {
        names.extend(TELLING.map(|adjective| (adjective, only.clone())));
    }
    for adjective in CALLING {
        names.extend(called_by(adjective, declarations).map(|name| (adjective, name)));
    }
    for declaration in declarations.iter_mut() {
        if let Statement::Is { what, .. } = &mut declaration.statement {
            give_axes(what, &names);
        }
        for term in declaration.statement.terms_mut() {
            put_name(term, &names);
        }
    }
}

/// "Its axes meet at O": those of each frame do, and where is of no account.
fn is_of_axes_that_meet(statement: &Statement) -> bool {
    let axes = |term: &Term| match term {
        Term::Phrase(axes) => axes.head == "axes" && axes.slot(Slot::Of).is_some(),
        _ => false,
    };
    match statement.does("touch") {
        Some((subjects, slots)) => {
            subjects.iter().all(axes) && slots.iter().all(|(slot, _)| *slot == Slot::At)
        }
        None => false,
    }
}

/// "B is a body-fixed frame": it is fixed in the body, where one is spoken of, or in the only one that a sentence tells of.
pub(super) fn fix_body_frames(declarations: &mut [Declaration]) {
    let fixed = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if what.slot(Slot::FixedIn).is_some() => subjects.clone(),
        _ => vec![],
    };
    let fixed: Vec<Term> = declarations.iter().flat_map(fixed).collect();
    let Some(body) = only_body(declarations) else {
        return;
    };
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let anew = !subjects.iter().any(|frame| fixed.contains(frame));
        if what.head == "frame" && what.is("body-fixed") && what.slots.is_empty() && anew {
            what.adjectives.retain(|said| *said != "body-fixed");
            what.slots = vec![(Slot::FixedIn, body.clone())];
        }
    }
}

/// "A moves with the ring", where something turns relative to A: a frame that is fixed in the ring.
pub(super) fn fix_carried_frames(declarations: &mut [Declaration]) {
    let bases = declarations
        .iter()
        .flat_map(|d| match d.statement.does("turn") {
            Some((turning, slots)) => {
                let base = slots.iter().filter(|(slot, _)| *slot == Slot::RelativeTo);
                let mut all: Vec<Term> = base.map(|(_, frame)| frame.clone()).collect();
                all.extend(turning.iter().cloned());
                all
            }
            None => vec![],
        });
    let turning: Vec<Term> = bases.collect();
    let told = declarations.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, .. } => subjects.clone(),
        _ => vec![],
    });
    let told: Vec<Term> = told.collect();
    for declaration in declarations {
        let carried = match declaration.statement.does("move") {
            Some(([frame @ Term::Name(own)], [(Slot::With, body @ Term::Name(thing))])) => {
                let named = own.starts_with(char::is_uppercase) && !told.contains(frame);
                let carries = thing.starts_with(char::is_lowercase) && turning.contains(frame);
                (named && carries).then(|| (frame.clone(), body.clone()))
            }
            _ => None,
        };
        if let Some((frame, body)) = carried {
            let what = NounPhrase::new("frame", vec![(Slot::FixedIn, body)]);
            declaration.statement = Statement::one_is(frame, what);
        }
    }
}

/// The only body of which sentences speak: "the body", or the only thing that is said to be one.
fn only_body(declarations: &[Declaration]) -> Option<Term> {
    let said = declarations.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if is_body(what.head) => subjects.as_slice(),
        _ => &[],
    });
    let mut bodies: BTreeSet<String> = said.filter_map(name).collect();
    let speaks = |d: &Declaration| d.statement.terms().into_iter().any(is_the_body);
    match (bodies.len(), declarations.iter().any(speaks)) {
        (0, true) => Some(Term::Name("body".to_owned())),
        (1, false) => {
            let only = bodies.pop_first()?;
            let other = |d: &Declaration| {
                let mut terms = d.statement.terms().into_iter();
                terms.any(|term| names_another(term, &only))
            };
            let alone = !declarations.iter().any(other);
            alone.then(|| Term::Name(only.clone()))
        }
        _ => None,
    }
}

/// Whether a term has the name of another thing: "the wheel".
fn names_another(term: &Term, only: &str) -> bool {
    match term {
        Term::Name(name) => {
            name.chars().count() > 1 && name.starts_with(char::is_lowercase) && name != only
        }
        Term::Member { .. } => true,
        Term::Phrase(phrase) => phrase
            .slots
            .iter()
            .any(|(_, term)| names_another(term, only)),
        _ => false,
    }
}

/// "the body"
fn is_the_body(term: &Term) -> bool {
    let inner = match term {
        Term::Phrase(phrase) => phrase.slots.iter().any(|(_, term)| is_the_body(term)),
        _ => false,
    };
    inner || name(term).is_some_and(|name| name == "body")
}

/// "The frame of the body", where nothing is called the body, is the body-fixed one.
pub(super) fn tell_body_frames(declarations: &mut [Declaration]) {
    let the_body = |term: &Term| name(term).is_some_and(|name| name == "body");
    let told = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, .. } => subjects.iter().any(the_body),
        _ => false,
    };
    for declaration in declarations.iter_mut() {
        tell_subject(&mut declaration.statement);
        if let Statement::Is { what, .. } = &mut declaration.statement {
            take_base(what);
        }
    }
    if declarations.iter().any(told) {
        return;
    }
    for term in declarations
        .iter_mut()
        .flat_map(|d| d.statement.terms_mut())
    {
        tell_body_frame(term);
    }
}

/// "The Euler angles of the body frame relative to N" are relative to N: the frame itself is relative to none.
fn take_base(what: &mut NounPhrase) {
    let relative = |(slot, _): &(Slot, Term)| *slot == Slot::RelativeTo;
    if what.slots.iter().any(relative) {
        return;
    }
    let frames = what.slots.iter_mut().filter_map(|(slot, term)| match term {
        Term::Phrase(frame) if *slot == Slot::Of && frame.head == "frame" => Some(frame),
        _ => None,
    });
    let mut bases = vec![];
    for frame in frames {
        bases.extend(frame.slots.extract_if(.., |said| relative(said)));
    }
    what.slots.extend(bases);
}

/// "The orbital frame is fixed in A" was taken for a premise about frames: it is about one.
fn tell_subject(statement: &mut Statement) {
    let Statement::Premise(premise) = statement else {
        return;
    };
    let ([kinds @ .., said], "frame") = (premise.adjectives.as_slice(), premise.head) else {
        return;
    };
    let of: Vec<(Slot, Term)> = premise
        .slots
        .iter()
        .filter(|(slot, _)| *slot == Slot::Of)
        .cloned()
        .collect();
    let calls = |kind: &&str| TELLING.contains(kind) || CALLING.contains(kind);
    if kinds.iter().all(calls) && kinds.len() + of.len() == 1 {
        let mut what = NounPhrase::new(said, premise.slots.clone());
        what.slots.retain(|(slot, _)| *slot != Slot::Of);
        let mut frame = NounPhrase::new("frame", of);
        frame.adjectives = kinds.to_vec();
        *statement = Statement::one_is(Term::Phrase(Box::new(frame)), what);
    }
}

fn tell_body_frame(term: &mut Term) {
    let Term::Phrase(phrase) = term else {
        return;
    };
    let of_body = match phrase.slots.as_slice() {
        [(Slot::Of, Term::Name(body))] => body == "body",
        [(Slot::Of, Term::Phrase(body))] => body.head == "body" && body.slots.is_empty(),
        _ => false,
    };
    if of_body && phrase.adjectives.is_empty() && matches!(phrase.head, "frame" | "axes") {
        phrase.slots.clear();
        phrase.adjectives.push("body-fixed");
    }
    phrase
        .slots
        .iter_mut()
        .for_each(|(_, inner)| tell_body_frame(inner));
}

/// The name of the frame that is called by an adjective: another one that a sentence gives it, or that.
fn called_by(adjective: &'static str, declarations: &[Declaration]) -> Option<String> {
    let called = |term: &&Term| match term {
        Term::Phrase(phrase) => phrase.head == "frame" && phrase.adjectives == [adjective],
        _ => false,
    };
    let named = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" && what.is(adjective) => {
            Some(subjects)
        }
        _ => None,
    });
    let names: BTreeSet<String> = named.flatten().filter_map(name).collect();
    let mut all = declarations.iter().flat_map(|d| d.statement.terms());
    let spoken_of = all.any(|term| called(&term));
    match names.len() {
        0 => spoken_of.then(|| format!("{adjective} frame")),
        1 => names.into_iter().next(),
        _ => None,
    }
}

/// The only frame that sentences say to be fixed in a body, by its name.
fn only_frame_of_bodies(declarations: &[Declaration]) -> Option<String> {
    let fixed = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" => {
            let of_body = what.slot(Slot::FixedIn).is_some() || what.is("body-fixed");
            of_body.then_some(subjects)
        }
        _ => None,
    });
    let mut names: BTreeSet<String> = fixed.flatten().filter_map(name).collect();
    names.pop_first().filter(|_| names.is_empty())
}

/// The adjective by which alone a noun tells a frame.
fn adjective_of(phrase: &NounPhrase, noun: &str) -> Option<&'static str> {
    match phrase.adjectives.as_slice() {
        [adjective] if phrase.head == noun && phrase.slots.is_empty() => TELLING
            .into_iter()
            .chain(CALLING)
            .find(|telling| telling == adjective),
        _ => None,
    }
}

/// "x, y, z are the body axes": those of the frame.
fn give_axes(what: &mut NounPhrase, names: &BTreeMap<&'static str, String>) {
    if let Some(called) = adjective_of(what, "axes").and_then(|adjective| names.get(adjective)) {
        what.adjectives.clear();
        what.slots = vec![(Slot::Of, Term::Name(called.clone()))];
    }
}

fn put_name(term: &mut Term, names: &BTreeMap<&'static str, String>) {
    let Term::Phrase(phrase) = term else {
        return;
    };
    let called = |noun| adjective_of(phrase, noun).and_then(|adjective| names.get(adjective));
    if let Some(called) = called("frame") {
        *term = Term::Name(called.clone());
        return;
    }
    for (slot, inner) in &mut phrase.slots {
        let axes = match inner {
            Term::Phrase(axes) if *slot == Slot::On => adjective_of(axes, "axes"),
            _ => None,
        };
        match axes.and_then(|adjective| names.get(adjective)) {
            // Components on the axes of a frame are those on the frame.
            Some(called) => *inner = Term::Name(called.clone()),
            None => put_name(inner, names),
        }
    }
    give_axes(phrase, names);
}
