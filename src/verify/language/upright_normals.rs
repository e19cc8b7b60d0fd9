//! "`$k$` is the upward normal of the table", which is level: the upward vertical.

use super::heads::{NORMAL, UNIT_VECTOR, VERTICAL};
use super::statement::{Declaration, Slot, Statement, Term};

/// The adjective of what is level, and its noun.
const LEVEL: &str = "horizontal";

/// The ways in which a normal may point.
const WAYS: [&str; 2] = ["upward", "downward"];

/// Says so of the normals of level planes of which it is said which way they point.
pub(super) fn tell_upright_normals(declarations: &mut [Declaration]) {
    let level = declarations.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let level = what.head == "plane" && what.is(LEVEL) || what.head == LEVEL;
            subjects.iter().filter(|_| level).cloned().collect()
        }
        _ => vec![],
    });
    let level: Vec<Term> = level.collect();
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        // "the upward vertical unit vector"
        if matches!(what.head, "vector" | UNIT_VECTOR) && what.is(VERTICAL) && what.slots.is_empty()
        {
            let upright = |said: &&str| WAYS.contains(said) || *said == VERTICAL;
            let ways = what.adjectives.iter().filter(|said| WAYS.contains(*said));
            if ways.count() == 1 && what.adjectives.iter().all(upright) {
                what.head = VERTICAL;
                what.adjectives.retain(|said| *said != VERTICAL);
            }
            continue;
        }
        let [way] = what.adjectives.as_slice() else {
            continue;
        };
        let of_level = match what.slots.as_slice() {
            [(Slot::Of, plane)] => level.contains(plane) || is_level(plane),
            _ => false,
        };
        if what.head == NORMAL && subjects.len() == 1 && WAYS.contains(way) && of_level {
            what.head = VERTICAL;
            what.slots.clear();
        }
    }
}

/// "a horizontal plane"
fn is_level(plane: &Term) -> bool {
    matches!(plane, Term::Phrase(plane) if plane.head == "plane" && plane.is(LEVEL))
}
