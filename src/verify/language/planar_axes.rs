//! The axes of what moves in a plane, and how far one point is from another in it.

use super::heads::VERTICAL;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// The axis that is vertical where the angle is zero, from 1.
pub(super) const UPRIGHT: usize = 3;
/// The axis of the turn.
pub(super) const ACROSS: usize = 2;
/// Towards this one the upright axis turns.
pub(super) const TOWARDS: usize = 1;

/// "the second axis of A"
pub(super) fn axis(number: usize, of: Option<&Term>) -> Term {
    let which = (Slot::Which, Term::Numbers(vec![number]));
    let of = of.map(|of| (Slot::Of, of.clone()));
    let slots = std::iter::once(which).chain(of).collect();
    Term::Phrase(Box::new(NounPhrase::new("axis", slots)))
}

/// "B turns relative to A about `$k$` by `$\theta$`"
pub(super) fn turns_by(frame: &Term, from: &Term, about: Term, angle: Term) -> Statement {
    let by = NounPhrase::new("angle", vec![(Slot::Which, angle)]);
    Statement::Does {
        subjects: vec![frame.clone()],
        verb: "turn",
        slots: vec![
            (Slot::RelativeTo, from.clone()),
            (Slot::About, about),
            (Slot::By, Term::Phrase(Box::new(by))),
        ],
    }
}

/// "the upward vertical", "the downward vertical"
pub(super) fn vertical(sense: &'static str) -> NounPhrase {
    let mut vertical = NounPhrase::new(VERTICAL, vec![]);
    vertical.adjectives.push(sense);
    vertical
}

/// The names of the axes of a frame.
pub(super) fn axes_of<'d>(frame: &Term, declarations: &'d [Declaration]) -> Option<&'d [Term]> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" => {
            (what.slot(Slot::Of) == Some(frame)).then_some(subjects.as_slice())
        }
        _ => None,
    })
}

/// Whether a statement tells where one point is from another.
pub(super) fn tells_distance(statement: &Statement) -> Option<(&Term, &Term, &Term)> {
    match statement {
        Statement::Does {
            subjects,
            verb: "lie",
            slots,
        } => match (subjects.as_slice(), slots.as_slice()) {
            ([of], [(Slot::At, at), (Slot::From, from)]) => Some((of, from, at)),
            _ => None,
        },
        Statement::Is { subjects, what } if what.head == "distance" => {
            let ends: Vec<&Term> = [Slot::Of, Slot::RelativeTo, Slot::Between]
                .iter()
                .flat_map(|slot| what.all(*slot))
                .collect();
            match (subjects.as_slice(), ends.as_slice()) {
                ([letter], [of, from]) => Some((of, from, letter)),
                _ => None,
            }
        }
        _ => None,
    }
}
