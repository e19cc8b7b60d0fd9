//! Which adjectives are understood before which nouns: any other one may turn what a noun means into something else.

use super::statement::{NounPhrase, Slot, Statement, Term};
use super::{heads, is_load, is_thing};

/// What may stand before any noun: it counts, points, or says nothing new.
const OF_ALL: [&str; 13] = [
    "any",
    "also",
    "constant",
    "steady",
    "instantaneous",
    "corresponding",
    "zero",
    "one",
    "two",
    "three",
    "four",
    "whole",
    "common",
];

/// What says of a load that it stays the same: nothing works with it but where a letter carries it.
const UNCHANGING: [&str; 3] = ["constant", "steady", "instantaneous"];

/// Nouns of what is worked out of another quantity, of which an adjective of that one would say something as well.
const WORKED_OUT: [&str; 4] = ["component", "magnitude", "part", "rate"];

/// What may be said of bodies, frames, points and planes without making them others.
const OF_THINGS: [&str; 46] = [
    "moving",
    "uniform",
    "thin",
    "straight",
    "main",
    "solid",
    "hollow",
    "rigid",
    "circular",
    "square",
    "rectangular",
    "right",
    "small",
    "heavy",
    "massive",
    "massless",
    "simple",
    "physical",
    "taut",
    "inextensible",
    "inclined",
    "rolling",
    "planar",
    "smooth",
    "rough",
    "symmetric",
    "ideal",
    "desired",
    "internal",
    "external",
    "inertial",
    "body-fixed",
    "laboratory",
    "rotating",
    "turning",
    "intermediate",
    "orbital",
    "right-handed",
    "fixed",
    "horizontal",
    "vertical",
    "upward",
    "downward",
    "orthogonal",
    "parallel",
    "free",
];

/// What is understood of some quantities alone.
const OF_QUANTITIES: [(&str, &[&str]); 34] = [
    (
        "initial",
        &[
            heads::ANGULAR_VELOCITY,
            heads::VELOCITY,
            heads::ANGULAR_MOMENTUM,
            heads::MOMENTUM,
            heads::KINETIC_ENERGY,
            heads::POTENTIAL_ENERGY,
            heads::TOTAL_ENERGY,
            heads::HEIGHT,
            "speed",
            "angle",
            "distance",
            "rate",
            "component",
        ],
    ),
    (
        "total",
        &[
            heads::FORCE,
            heads::MOMENT,
            heads::MASS,
            heads::MOMENTUM,
            heads::ANGULAR_MOMENTUM,
            heads::KINETIC_ENERGY,
            heads::POTENTIAL_ENERGY,
            heads::AERODYNAMIC_FORCE,
            "load",
            "impulse",
        ],
    ),
    (
        "external",
        &[heads::FORCE, heads::MOMENT, "load", "impulse"],
    ),
    ("non-gravitational", &[heads::FORCE]),
    ("no", &[heads::FORCE, heads::MOMENT, heads::MASS, "load"]),
    ("only", &[heads::FORCE, heads::MOMENT, "load", "impulse"]),
    ("working", &[heads::FORCE, heads::MOMENT, "load"]),
    (
        "not",
        &["zero", "symmetric", "constant", "small", "negative"],
    ),
    ("small", &["disturbance", "angle", "oscillation", "value"]),
    ("axial", &[heads::MOMENT_OF_INERTIA]),
    ("transverse", &[heads::MOMENT_OF_INERTIA]),
    ("negative", &["axis"]),
    ("other", &["end"]),
    ("upper", &["end"]),
    ("lower", &["end"]),
    ("largest", &["value"]),
    ("smallest", &["value"]),
    ("positive", &["constant", "principal moments", "scalar"]),
    ("real", &["constant", "scalar"]),
    ("horizontal", &["vector", "unit vector", heads::NORMAL]),
    ("vertical", &["vector", "unit vector", heads::NORMAL]),
    ("upward", &["vector", "unit vector", heads::NORMAL]),
    ("downward", &["vector", "unit vector", heads::NORMAL]),
    ("tangential", &["part"]),
    ("radial", &["part"]),
    ("diagonal", &["entry", "matrix"]),
    ("symmetric", &["matrix"]),
    ("orthogonal", &["matrix"]),
    ("natural", &["frequency"]),
    (
        "same",
        &[
            "frequency",
            "body",
            heads::MASS,
            heads::ANGULAR_MOMENTUM,
            heads::ANGULAR_VELOCITY,
        ],
    ),
    ("local", &[heads::GRAVITY]),
    ("equal", &[heads::MASS]),
    ("first", &["end"]),
    ("second", &["end"]),
];

/// Whether all adjectives of a statement are understood.
pub(crate) fn has_plain_adjectives(statement: &Statement) -> bool {
    let predicate = match statement {
        Statement::Is { what, .. } | Statement::Premise(what) => is_plain(what),
        _ => true,
    };
    let terms = statement.terms().into_iter();
    predicate && terms.filter_map(phrase).all(is_plain)
}

/// The first adjective of a statement that is not understood of its noun, and that noun.
pub(crate) fn idle_adjective(statement: &Statement) -> Option<(&str, &str)> {
    let predicate = match statement {
        Statement::Is { what, .. } | Statement::Premise(what) => Some(what),
        _ => None,
    };
    let terms = statement.terms().into_iter().filter_map(phrase);
    predicate.into_iter().chain(terms).find_map(|phrase| {
        let mut own = phrase.adjectives.iter();
        let idle = own.find(|adjective| !goes_with(adjective, phrase.head))?;
        Some((*idle, phrase.head))
    })
}

fn phrase(term: &Term) -> Option<&NounPhrase> {
    match term {
        Term::Phrase(phrase) => Some(phrase),
        _ => None,
    }
}

/// A sum of several masses is none of them.
fn is_sum_of_several(phrase: &NounPhrase) -> bool {
    let several = phrase.all(Slot::Of).count() > 1;
    phrase.is("total") && phrase.head == heads::MASS && several
}

/// Whether what is said of a part, a component or a rate would be said of the whole: "the component of the constant force".
fn is_of_unchanging(phrase: &NounPhrase) -> bool {
    let unchanging = |term: &Term| match term {
        Term::Phrase(of) => of.adjectives.iter().any(|a| UNCHANGING.contains(a)),
        _ => false,
    };
    WORKED_OUT.contains(&phrase.head) && phrase.all(Slot::Of).any(unchanging)
}

fn is_plain(phrase: &NounPhrase) -> bool {
    if is_sum_of_several(phrase) || is_of_unchanging(phrase) {
        return false;
    }
    let mut own = phrase.adjectives.iter();
    own.all(|adjective| goes_with(adjective, phrase.head))
}

/// Whether an adjective before or behind a noun is understood.
pub(super) fn goes_with(adjective: &str, noun: &str) -> bool {
    let mut quantities = OF_QUANTITIES.iter();
    let idle = UNCHANGING.contains(&adjective) && is_load(noun);
    OF_ALL.contains(&adjective) && !idle
        || is_thing(noun) && OF_THINGS.contains(&adjective)
        || quantities.any(|(said, of)| *said == adjective && of.contains(&noun))
}
