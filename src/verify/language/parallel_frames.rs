//! Frames whose axes are parallel to those of another one.

use super::heads::KEEPS_DIRECTION;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};

/// "The axes of B are parallel to the axes of A": B is a frame that does not turn relative to A, where no sentence says how it
/// turns.
pub(crate) fn tell_parallel_frames(declarations: &mut Vec<Declaration>) {
    let turned: Vec<Term> = declarations
        .iter()
        .filter_map(|d| d.statement.does("turn"))
        .flat_map(|(subjects, _)| subjects.to_vec())
        .collect();
    let mut told = vec![];
    for declaration in declarations.iter_mut() {
        let Some((frame, other)) = parallel(&declaration.statement) else {
            continue;
        };
        if turned.contains(&frame) || declaration.extent != Extent::Document {
            continue;
        }
        let relative = vec![(Slot::RelativeTo, other)];
        let what = NounPhrase::new("frame", relative.clone());
        told.push(declaration.saying(Statement::one_is(frame.clone(), what)));
        declaration.statement = Statement::Does {
            subjects: vec![frame],
            verb: KEEPS_DIRECTION,
            slots: relative,
        };
    }
    declarations.extend(told);
}

/// The frame of which the axes are parallel, and that of the others.
fn parallel(statement: &Statement) -> Option<(Term, Term)> {
    let Statement::Premise(premise) = statement else {
        return None;
    };
    let (("axes", true), [(Slot::Of, frame), (Slot::With, Term::Phrase(others))]) = (
        (premise.head, premise.is("parallel")),
        premise.slots.as_slice(),
    ) else {
        return None;
    };
    match (others.head, others.slots.as_slice()) {
        ("axes", [(Slot::Of, other)]) => Some((frame.clone(), other.clone())),
        _ => None,
    }
}
