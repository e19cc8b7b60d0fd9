//! Three orthogonal unit vectors that are fixed in a thing are its axes, where no sentence says how they lie or gives it others.

use super::heads::UNIT_VECTOR;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// "`$a$`, `$b$` and `$c$` are right-handed orthogonal unit vectors fixed in the plate": the axes of the plate.
pub(crate) fn name_triads(declarations: &mut [Declaration]) {
    for at in 0..declarations.len() {
        let Some((letters, owner)) = triad(&declarations[at].statement) else {
            continue;
        };
        let (letters, owner) = (letters.to_vec(), owner.clone());
        let others = declarations
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != at);
        let told = |d: &Declaration| has_axes(&d.statement, &owner) || lies(&d.statement, &letters);
        if others.into_iter().all(|(_, d)| !told(d)) {
            declarations[at].statement = Statement::Is {
                subjects: letters,
                what: NounPhrase::new("axes", vec![(Slot::Of, owner)]),
            };
        }
    }
}

fn triad(statement: &Statement) -> Option<(&[Term], &Term)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let right = what.is("right-handed") && what.is("orthogonal");
    let letters = subjects.len() == 3 && subjects.iter().all(|s| matches!(s, Term::Formula(_)));
    match what.slots.as_slice() {
        [(Slot::FixedIn, owner)] if what.head == UNIT_VECTOR && right && letters => {
            Some((subjects, owner))
        }
        _ => None,
    }
}

/// Whether a sentence names axes of a thing, or a frame that is fixed in it.
fn has_axes(statement: &Statement, owner: &Term) -> bool {
    match statement {
        Statement::Is { what, .. } => match what.head {
            "axes" | "axis" => what.slot(Slot::Of) == Some(owner),
            "frame" => what.slot(Slot::FixedIn) == Some(owner),
            _ => false,
        },
        _ => false,
    }
}

/// Nouns and words by which a sentence says how a vector lies.
const LIES: [&str; 8] = [
    UNIT_VECTOR,
    "normal vector",
    "vector",
    "parallel",
    "orthogonal",
    "horizontal",
    "vertical",
    "same",
];

/// Whether a sentence says how one of some vectors lies.
fn lies(statement: &Statement, letters: &[Term]) -> bool {
    match statement {
        Statement::Is { subjects, what } => {
            LIES.contains(&what.head) && subjects.iter().any(|s| letters.contains(s))
        }
        Statement::Does { subjects, .. } => subjects.iter().any(|s| letters.contains(s)),
        _ => false,
    }
}
