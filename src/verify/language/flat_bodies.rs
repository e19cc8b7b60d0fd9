//! Discs and rings that lie in a plane of two axes: they turn about the third one, which is their axis of symmetry.

use super::kinds::name;
use super::planar_axes::axis;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use super::traits::is_round_and_flat;
use super::turned_lines::{Direction, direction};

/// Gives each flat body of which no sentence says otherwise how it turns the turn about what stands on its plane.
pub(crate) fn turn_in_own_planes(declarations: &mut Vec<Declaration>) {
    let before = declarations.clone();
    let mut told = vec![];
    // What is symmetric is so everywhere, and not in a part of the document.
    let everywhere = |d: &&mut Declaration| d.extent == Extent::Document;
    for declaration in declarations.iter_mut().filter(everywhere) {
        if let Some((bodies, plane, axes)) = lying(&declaration.statement, &before) {
            told.extend(turning_across(&bodies, axes).map(|said| declaration.saying(said)));
            declaration.statement = Statement::Does {
                subjects: bodies,
                verb: "move",
                slots: vec![(Slot::In, plane)],
            };
        }
    }
    declarations.extend(told);
}

/// That bodies turn about the third axis, and are symmetric about it.
fn turning_across(bodies: &[Term], (one, other): (Direction, Direction)) -> [Statement; 2] {
    let third = axis(6 - one.number - other.number, Some(&one.frame));
    turning_about(bodies, one.frame, third)
}

/// That bodies turn relative to a frame about one of its axes, and are symmetric about it.
pub(super) fn turning_about(bodies: &[Term], frame: Term, axis: Term) -> [Statement; 2] {
    let about = (Slot::About, axis);
    let turn = Statement::Does {
        subjects: bodies.to_vec(),
        verb: "turn",
        slots: vec![(Slot::RelativeTo, frame), about.clone()],
    };
    let symmetric = Statement::Is {
        subjects: bodies.to_vec(),
        what: NounPhrase::new("symmetric", vec![about]),
    };
    [turn, symmetric]
}

/// "The disc lies in the plane of x and y": what lies there, the plane, and its two axes.
fn lying(
    statement: &Statement,
    all: &[Declaration],
) -> Option<(Vec<Term>, Term, (Direction, Direction))> {
    let (bodies, [(Slot::In, plane)]) = statement.does("lie")? else {
        return None;
    };
    let Term::Phrase(of_axes) = plane else {
        return None;
    };
    let [(Slot::Of, one), (Slot::Of, other)] = of_axes.slots.as_slice() else {
        return None;
    };
    let (one, other) = (direction(one, all)?, direction(other, all)?);
    let flat = |body: &Term| is_flat(body, all) && !is_told_to_turn(body, all);
    let told = of_axes.head == "plane"
        && of_axes.adjectives.is_empty()
        && one.frame == other.frame
        && is_inertial(&one.frame, all)
        && one.number != other.number
        && bodies.iter().all(flat);
    told.then(|| (bodies.to_vec(), plane.clone(), (one, other)))
}

/// Whether a frame is said to be inertial: in another one the plane moves.
pub(super) fn is_inertial(frame: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            what.head == "frame" && what.is("inertial") && subjects.contains(frame)
        }
        _ => false,
    })
}

/// Whether sentences say that a body is a disc or a ring.
fn is_flat(body: &Term, all: &[Declaration]) -> bool {
    let own = |subjects: &[Term]| subjects.iter().any(|subject| name(subject) == name(body));
    let named = name(body).is_some_and(|name| is_round_and_flat(&name));
    let said = all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => is_round_and_flat(what.head) && own(subjects),
        _ => false,
    });
    named || said
}

/// Whether a sentence says how a body turns, about what it is symmetric, or which frame is fixed in it.
pub(super) fn is_told_to_turn(body: &Term, all: &[Declaration]) -> bool {
    let own = |term: &Term| name(term).is_some() && name(term) == name(body);
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let frame =
                what.head == "frame" && what.all(Slot::FixedIn).chain(what.all(Slot::Of)).any(own);
            frame || what.head == "symmetric" && subjects.iter().any(own)
        }
        statement => {
            let turning = statement.does("turn").or_else(|| statement.does("swing"));
            turning.is_some_and(|(subjects, _)| subjects.iter().any(own))
        }
    })
}
