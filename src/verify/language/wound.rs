//! Strings that are wound on something, and the frame at rest in which they hang.

use super::heads::VERTICAL;
use super::kinds::name;
use super::planar::LEVEL;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Verbs of strings that unwind, with what the body is to them.
const WOUND: [(&str, Slot); 2] = [("unwind", Slot::From), ("wind", Slot::On)];

/// "The string unwinds from the axle", "the string is wound on the axle"
pub(super) fn winds(statement: &Statement) -> Option<(&Term, &Term)> {
    WOUND
        .iter()
        .find_map(|(verb, from)| match statement.does(verb)? {
            ([string], [(slot, Term::Phrase(rim))]) if slot == from && rim.head == "rim" => {
                Some((string, rim.slot(Slot::Of)?))
            }
            ([string], [(slot, part)]) if slot == from => Some((string, part)),
            _ => None,
        })
}

/// Whether a frame is said to be inertial; where none is, whether nothing is said of how it moves.
pub(super) fn is_at_rest(frame: &Term, declarations: &[Declaration]) -> bool {
    let said = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let inertial = what.head == "frame" && what.is("inertial");
            inertial.then(|| subjects.contains(frame))
        }
        _ => None,
    };
    let mut inertial = declarations.iter().filter_map(said).peekable();
    if inertial.peek().is_some() {
        return inertial.any(|own| own);
    }
    let moves = |d: &Declaration| match &d.statement {
        Statement::Does { subjects, .. } => subjects.contains(frame),
        Statement::Is { subjects, what } => {
            subjects.contains(frame) && what.slot(Slot::FixedIn).is_some()
        }
        _ => false,
    };
    !declarations.iter().any(moves)
}

/// That a frame is inertial, where no sentence says so.
pub(super) fn at_rest(frame: &Term, declarations: &[Declaration]) -> Option<Statement> {
    let said = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head == "frame" && subjects.contains(frame),
        _ => false,
    });
    let mut inertial = NounPhrase::new("frame", vec![]);
    inertial.adjectives.push("inertial");
    (!said).then(|| Statement::one_is(frame.clone(), inertial))
}

/// Whether the third axis of a frame points down, where it is the vertical and no other axis has a name.
pub(super) fn third_axis(ground: &Term, declarations: &[Declaration]) -> Option<bool> {
    let said = || {
        declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => Some((subjects, what)),
            _ => None,
        })
    };
    let upright: Vec<(&Term, bool)> = said()
        .filter(|(_, what)| what.head == VERTICAL && (what.is("downward") || what.is("upward")))
        .flat_map(|(subjects, what)| subjects.iter().map(|s| (s, what.is("downward"))))
        .collect();
    let level = |axis: &Term| name(axis).is_none_or(|name| LEVEL.contains(&name.as_str()));
    let others = said().any(|(subjects, what)| {
        let of_ground = what.all(Slot::Of).any(|of| of == ground);
        let axes = matches!(what.head, "axes" | "axis") && of_ground;
        axes && subjects
            .iter()
            .any(|s| upright.iter().all(|(own, _)| *own != s))
    });
    match upright.as_slice() {
        [] if !others => Some(false),
        [(axis, down)] if !others && !level(axis) => Some(*down),
        _ => None,
    }
}
