//! The angle of one frame relative to another about an axis that both have: the one turns about it by this angle.

use super::frames_shown::frames_shown;
use super::kinds::name;
use super::planar_axes::turns_by;
use super::statement::{Declaration, Slot, Statement, Term};

/// "`$\theta$` is the angle of A relative to N about z", of frames A and N: A turns relative to N about z by the angle θ.
pub(super) fn turn_frames(declarations: &mut [Declaration]) {
    let frames = frames_shown(declarations);
    let turned: Vec<Term> = declarations
        .iter()
        .filter_map(|d| d.statement.does("turn"))
        .filter(|(_, slots)| slots.iter().any(|(slot, _)| *slot == Slot::By))
        .flat_map(|(subjects, _)| subjects.to_vec())
        .collect();
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let ([angle @ Term::Formula(_)], "angle", 3) =
            (subjects.as_slice(), what.head, what.slots.len())
        else {
            continue;
        };
        let ends = [Slot::Of, Slot::RelativeTo, Slot::About].map(|slot| what.slot(slot));
        let [Some(of), Some(from), Some(about)] = ends else {
            continue;
        };
        let frame = |term: &Term| name(term).is_some_and(|name| frames.contains(&name));
        let plain = what.adjectives.is_empty() && frame(of) && frame(from);
        if !plain || turned.contains(of) {
            continue;
        }
        declaration.statement = turns_by(of, from, about.clone(), angle.clone());
    }
}
