//! What holds at one time alone, or at one place of a motion, where no relation tells which.

use crate::verify::language::heads::{
    CONSTANT, INSTANT, KINETIC_ENERGY, START_OF_MOTION, TOTAL_ENERGY,
};
use crate::verify::language::is_body;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::impacts_read::{tells_loads_after_strike, tells_place_at_blow};
use crate::verify::reading::instants_read::is_of_instant;
use crate::verify::reading::loads_read::AT_REST;
use crate::verify::reading::names::{POTENTIAL, node_of};

/// What something is as long as a sentence holds, and not at a place.
const STATES: [&str; 9] = [
    "zero",
    AT_REST,
    "fixed",
    CONSTANT,
    "equal",
    "parallel",
    "orthogonal",
    "horizontal",
    "vertical",
];

/// Times, and parts of a motion, by their nouns.
const TIMES: [&str; 6] = [INSTANT, START_OF_MOTION, "time", "impact", "step", "end"];

/// Quantities that a thing has at a time, and whose place other words tell.
const LASTING: [&str; 5] = [
    POTENTIAL,
    KINETIC_ENERGY,
    TOTAL_ENERGY,
    "Lagrangian",
    "momentum",
];

/// Verbs of where things are and how they move.
const MOTIONS: [&str; 5] = ["place", "move", "slide", "swing", "fall"];

impl Builder<'_> {
    /// What holds at a time or under a condition that no relation tells is not worked with.
    pub(super) fn say_conditional(&mut self, declarations: &[Declaration]) {
        let others = declarations
            .iter()
            .filter(|d| !is_of_instant(d) && !tells_place_at_blow(d));
        let all = self.declarations;
        let others = others.filter(|d| !tells_loads_after_strike(d, all));
        others.for_each(|d| self.say_unused(d));
    }
}

/// Whether a sentence holds at one time alone.
pub(super) fn is_momentary(declaration: &Declaration) -> bool {
    match &declaration.statement {
        Statement::Is { what, .. } if STATES.contains(&what.head) => {
            what.slot(Slot::At).is_some() && !is_measure(what)
        }
        // "P is at rest at the top": where such a point is fixed is not told.
        Statement::Is { what, .. } if what.slot(Slot::FixedIn).is_some() => {
            what.all(Slot::At).any(|at| is_time(at) || is_thing(at))
        }
        Statement::Is { what, .. } if LASTING.contains(&what.head) => {
            what.all(Slot::At).any(|at| is_time(at) || is_thing(at))
        }
        Statement::Is { what, .. } => {
            !is_value_at_step(what) && what.all(Slot::At).any(is_time_alone)
        }
        Statement::Does { verb, slots, .. } if MOTIONS.contains(verb) => slots
            .iter()
            .any(|(slot, at)| *slot == Slot::At && (is_time(at) || is_thing(at))),
        Statement::Does { slots, .. } => slots
            .iter()
            .any(|(slot, at)| *slot == Slot::At && is_time_alone(at)),
        _ => false,
    }
}

/// "fixed at the distance `$a$` from O", "constant at the value `$b$`": how far, and how much.
fn is_measure(what: &NounPhrase) -> bool {
    what.all(Slot::At).all(|at| match at {
        Term::Phrase(at) => !TIMES.contains(&at.head) && at.slots.iter().any(is_letter),
        _ => false,
    })
}

fn is_letter((_, term): &(Slot, Term)) -> bool {
    matches!(term, Term::Formula(letter) if node_of(letter).is_some())
}

/// "the value of `$x$` at step `$k$`"
fn is_value_at_step(what: &NounPhrase) -> bool {
    what.head == "value"
}

fn is_time(term: &Term) -> bool {
    matches!(term, Term::Phrase(time) if TIMES.contains(&time.head) && !is_end_of_thing(time))
}

/// A time that is no place: things have ends.
fn is_time_alone(term: &Term) -> bool {
    is_time(term) && !term.is_noun("end")
}

/// "the end of the rod"
fn is_end_of_thing(end: &NounPhrase) -> bool {
    end.head == "end" && end.slot(Slot::Of).is_some()
}

/// "at the top": of a body no motion is a part.
fn is_thing(term: &Term) -> bool {
    match term {
        Term::Phrase(thing) => is_body(thing.head),
        Term::Name(name) => is_body(name),
        _ => false,
    }
}
