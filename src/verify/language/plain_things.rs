//! Things by their plain names: "the rigid body" is the body, and "an inertial frame" the one that a sentence names.

use super::body_axes::is_thing_with_sizes;
use super::frames_by_adjective::name_frames;
use super::heads::{UNIT_VECTOR, VERTICAL};
use super::is_body;
use super::kinds::{name, rename};
use super::named_places::{PLACES, names_place_again};
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use super::verticals::tell_verticals;
use std::collections::{BTreeMap, BTreeSet};

/// Adjectives that say of a thing nothing that could tell it from another.
const IDLE: [&str; 4] = ["rigid", "whole", "heavy", "one"];

/// What hangs on a quantity, and not on the thing that has it.
const HOISTED: [Slot; 4] = [
    Slot::About,
    Slot::RelativeTo,
    Slot::On,
    Slot::VelocitiesRelativeTo,
];

/// The name of the inertial frame where no sentence gives it one.
const INERTIAL_FRAME: &str = "inertial frame";

/// Names of the place that is at rest.
const LABORATORY: [&str; 2] = ["laboratory", "lab"];

/// Names the things that sentences speak of by a noun and adjectives that tell nothing new.
pub(crate) fn name_plainly(declarations: &mut Vec<Declaration>) {
    name_frames(declarations);
    let inertial = inertial_frame(declarations);
    let ground = inertial
        .clone()
        .unwrap_or_else(|| INERTIAL_FRAME.to_owned());
    let mut unnamed = None;
    for declaration in declarations.iter_mut() {
        let before = declaration.clone();
        turn_about(&mut declaration.statement);
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

/// "It turns relative to an inertial frame about z": what turns does so about z.
fn turn_about(statement: &mut Statement) {
    let Statement::Does {
        verb: "turn",
        slots,
        ..
    } = statement
    else {
        return;
    };
    let mut about = vec![];
    for (slot, term) in slots.iter_mut() {
        if let (Slot::RelativeTo, Term::Phrase(frame)) = (&slot, term)
            && frame.head == "frame"
            && frame.is("inertial")
        {
            let own = frame.slots.iter().filter(|(slot, _)| *slot == Slot::About);
            about.extend(own.cloned());
            frame.slots.retain(|(slot, _)| *slot != Slot::About);
        }
    }
    slots.extend(about);
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

/// Names of all that a document says in formulas.
const FORMULAS: [&str; 4] = ["formulas", "equations", "relations", "lines"];

/// "The rigid body is symmetric about z" says it of the body, "the formulas hold to first order" of all lines.
pub(crate) fn say_of_things(declarations: &mut [Declaration]) {
    fix_what_rests(declarations);
    for declaration in declarations {
        if let Statement::Does {
            subjects,
            verb: "hold",
            slots,
        } = &declaration.statement
            && let [Term::Name(all)] = subjects.as_slice()
            && FORMULAS.contains(&all.as_str())
        {
            declaration.statement = Statement::LineHolds {
                lines: Extent::Document,
                slots: slots.clone(),
            };
        }
        hold_always(&mut declaration.statement);
        let Statement::Premise(premise) = &declaration.statement else {
            continue;
        };
        if let [idle @ .., said] = premise.adjectives.as_slice()
            && is_body(premise.head)
            && !idle.is_empty()
            && idle.iter().all(|adjective| IDLE.contains(adjective))
        {
            declaration.statement = Statement::Is {
                subjects: vec![Term::Name(premise.head.to_owned())],
                what: NounPhrase::new(said, premise.slots.clone()),
            };
        }
    }
}

/// "O stays at rest in N": where N is a frame, it is fixed there.
fn fix_what_rests(declarations: &mut [Declaration]) {
    let is_frame = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" => subjects.clone(),
        _ => vec![],
    };
    let frames: Vec<Term> = declarations.iter().flat_map(is_frame).collect();
    for declaration in declarations {
        if let Some((subjects, [(Slot::In | Slot::RelativeTo, frame)])) =
            declaration.statement.does("rest")
            && frames.contains(frame)
        {
            declaration.statement = Statement::Is {
                subjects: subjects.to_vec(),
                what: NounPhrase::new("fixed", vec![(Slot::FixedIn, frame.clone())]),
            };
        }
    }
}

/// "`$a = b$` at every instant" says no more than the formula.
fn hold_always(statement: &mut Statement) {
    let every = |(slot, at): &(Slot, Term)| {
        let instant = |at: &NounPhrase| matches!(at.head, "instant" | "time") && at.is("any");
        *slot == Slot::At && matches!(at, Term::Phrase(at) if instant(at))
    };
    if let Some(([Term::Formula(formula)], slots)) = statement.does("hold")
        && slots.iter().all(every)
    {
        *statement = Statement::Holds(formula.clone());
    }
}

/// "the inertia tensor of the whole spacecraft about C": about C is the tensor, and not the spacecraft.
pub(crate) fn hang_on_quantities(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        let mut moved = vec![];
        for (slot, term) in &mut what.slots {
            if let (Slot::Of, Term::Phrase(thing)) = (&slot, &mut *term)
                && is_body(thing.head)
                && !thing.slots.is_empty()
                && thing.slots.iter().all(is_hoisted_or_number)
            {
                let slots = std::mem::take(&mut thing.slots).into_iter();
                let (hoisted, own) = slots.partition(|(slot, _)| HOISTED.contains(slot));
                thing.slots = own;
                moved.extend::<Vec<_>>(hoisted);
                let idle = |adjective: &&str| IDLE.contains(adjective);
                if thing.slots.is_empty() && thing.adjectives.iter().all(idle) {
                    *term = Term::Name(thing.head.to_owned());
                }
            }
        }
        what.slots.append(&mut moved);
    }
}

/// What hangs on a quantity, or the number of the thing that has it: "the velocity of the first particle relative to N".
fn is_hoisted_or_number((slot, term): &(Slot, Term)) -> bool {
    let number = *slot == Slot::Which && matches!(term, Term::Numbers(_));
    number || HOISTED.contains(slot)
}

/// Gives a thing its plain name; whether the inertial frame was spoken of.
fn plain(term: &mut Term, ground: &str) -> bool {
    if matches!(term, Term::Name(place) if LABORATORY.contains(&place.as_str())) {
        *term = Term::Name(ground.to_owned());
        return true;
    }
    let Term::Phrase(phrase) = term else {
        return false;
    };
    let bare = phrase.slots.is_empty();
    let only = |allowed: &[&str]| phrase.adjectives.iter().all(|a| allowed.contains(a));
    let at_rest = phrase.is("inertial") || phrase.is("laboratory");
    if bare && phrase.head == "frame" && at_rest && only(&["inertial", "fixed", "laboratory"]) {
        *term = Term::Name(ground.to_owned());
        return true;
    }
    if bare && is_body(phrase.head) && !phrase.adjectives.is_empty() && only(&IDLE) {
        *term = Term::Name(phrase.head.to_owned());
        return false;
    }
    if phrase.head == "diameter" && phrase.is("vertical") {
        *term = Term::Phrase(Box::new(NounPhrase::new(VERTICAL, vec![])));
        return false;
    }
    if matches!(phrase.head, "axis" | "line")
        && phrase.is("vertical")
        && phrase.slot(Slot::Along).is_none()
    {
        phrase.adjectives.retain(|said| *said != "vertical");
        let vertical = NounPhrase::new(VERTICAL, vec![]);
        let along = Term::Phrase(Box::new(vertical));
        phrase.slots.push((Slot::Along, along));
    }
    // "its axis `$a$`"
    if let (Some(letter @ Term::Formula(_)), "axis") = (phrase.slot(Slot::Which), phrase.head)
        && !phrase.is("negative")
        && phrase
            .slots
            .iter()
            .all(|(slot, _)| matches!(slot, Slot::Which | Slot::Of))
    {
        *term = letter.clone();
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

/// "the axes of the frame B of the disc", "the outer gimbal A turns": what is said of a frame or a body beside its name is a
/// sentence of its own.
pub(crate) fn tell_named_things(declarations: &mut Vec<Declaration>) {
    let before = declarations.len();
    say_besides(declarations, |statement| {
        // "It consists of the particles P and Q" says it of all of them.
        let listed = statement.does("consist").is_some();
        let terms = statement.terms_mut().into_iter();
        terms.flat_map(|term| named_things(term, listed)).collect()
    });
    let mut told = declarations.split_off(before);
    told.retain(|new| !names_place_again(&new.statement, declarations));
    // "the inner gimbal" is the one that has got a name.
    for (noun, called) in names_of_bodies(&told) {
        for term in declarations
            .iter_mut()
            .flat_map(|d| d.statement.terms_mut())
        {
            rename(term, noun, &called);
        }
    }
    declarations.extend(told);
}

/// "about the vertical axis through O along `$k$`": k is vertical; and what turns about it in a horizontal plane only turns.
pub(crate) fn tell_upright_axes(declarations: &mut Vec<Declaration>) {
    tell_verticals(declarations);
    say_besides(declarations, |statement| {
        let Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } = statement
        else {
            return vec![];
        };
        let mut told = vec![];
        let mut upright = false;
        for (slot, term) in slots.iter_mut() {
            let Term::Phrase(axis) = term else { continue };
            if *slot != Slot::About || axis.head != "axis" {
                continue;
            }
            let along = axis.slot(Slot::Along).cloned();
            upright |= along.as_ref().is_some_and(|along| along.is_noun(VERTICAL));
            if let (Some(along @ Term::Formula(_)), true) = (along, axis.is("vertical")) {
                axis.adjectives.retain(|said| *said != "vertical");
                let up = NounPhrase {
                    adjectives: vec!["upward"],
                    ..NounPhrase::new(VERTICAL, vec![])
                };
                let up = vec![(Slot::Along, Term::Phrase(Box::new(up)))];
                told.push(Statement::one_is(along, NounPhrase::new(UNIT_VECTOR, up)));
                upright = true;
            }
        }
        let level = |term: &Term| matches!(term, Term::Phrase(p) if p.head == "plane" && p.adjectives == ["horizontal"] && p.slots.is_empty());
        let before = slots.len();
        slots.retain(|(_, term)| !(upright && level(term)));
        if let ([mover], true) = (subjects.as_slice(), slots.len() < before) {
            let level = NounPhrase::new("horizontal", vec![]);
            told.push(Statement::one_is(mover.clone(), level));
        }
        told
    });
}

/// The nouns by which only one thing is called, each with the name of that.
fn names_of_bodies(told: &[Declaration]) -> Vec<(&'static str, String)> {
    let mut names: BTreeMap<&'static str, BTreeSet<String>> = BTreeMap::new();
    for declaration in told {
        if let Statement::Is { subjects, what } = &declaration.statement
            && is_body(what.head)
            && let Some(called) = subjects.first().and_then(name)
        {
            names.entry(what.head).or_default().insert(called);
        }
    }
    let single = names.into_iter().filter(|(_, names)| names.len() == 1);
    single
        .flat_map(|(noun, names)| names.into_iter().map(move |name| (noun, name)))
        .collect()
}

/// Bodies that are points, whose names are those of points.
fn is_point(noun: &str) -> bool {
    matches!(noun, "particle" | "element" | "bob" | "bead")
}

/// Whether a thing has a name of its own, and no number.
fn is_proper(term: &Term) -> bool {
    name(term).is_some_and(|name| name.starts_with(char::is_uppercase))
}

/// Puts the name of a thing in the place of its phrase, and gives what the phrases say.
fn named_things(term: &mut Term, listed: bool) -> Vec<Statement> {
    let Term::Phrase(phrase) = term else {
        return vec![];
    };
    let mut told = vec![];
    for (_, inner) in &mut phrase.slots {
        told.extend(named_things(inner, listed));
    }
    // "A uniform rod of mass `$m$` goes from O to P"
    if is_thing_with_sizes(phrase) && !is_point(phrase.head) {
        let called = Term::Name(phrase.head.to_owned());
        told.push(Statement::Is {
            subjects: vec![called.clone()],
            what: (**phrase).clone(),
        });
        *term = called;
        return told;
    }
    // "a frame fixed in the platform"
    if let ("frame", [(Slot::FixedIn, Term::Name(body))]) = (phrase.head, phrase.slots.as_slice()) {
        let called = Term::Name(format!("frame of {body}"));
        told.push(Statement::Is {
            subjects: vec![called.clone()],
            what: (**phrase).clone(),
        });
        *term = called;
        return told;
    }
    let called: Vec<&Term> = phrase.all(Slot::Which).collect();
    let alone = phrase.slots.len() == 1;
    let particle =
        alone && !listed && is_point(phrase.head) && called.iter().all(|called| is_proper(called));
    let point = alone && phrase.head == "point" && phrase.is("fixed");
    let body = is_body(phrase.head) && !is_point(phrase.head);
    let place = PLACES.contains(&phrase.head);
    let thing = phrase.head == "frame" || body || particle || point || place;
    if let (true, [called @ Term::Name(_)]) = (thing, called.as_slice()) {
        let called = (*called).clone();
        phrase.slots.retain(|(slot, _)| *slot != Slot::Which);
        let says_more = !phrase.slots.is_empty() || !phrase.adjectives.is_empty();
        if says_more || phrase.head != "frame" {
            told.push(Statement::Is {
                subjects: vec![called.clone()],
                what: (**phrase).clone(),
            });
        }
        *term = called;
    }
    told
}
