//! Lines that are told by their angle with an axis, towards another one: they turn in the plane of both.

use super::frames_by_nodes::turn_by_nodes;
use super::heads::{POSITIVE_ABOUT, POSITIVE_TOWARDS, TOWARDS, VERTICAL};
use super::inclined_frames::incline_frames;
use super::kinds::name;
use super::planar_axes::{axes_of, axis, turns_by};
use super::planar_lines::{Line, line_between, place_along, place_ends};
use super::reader::formula;
use super::spherical_angles::place_by_spherical_angles;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use super::turned_frames::turn_frames;
use super::turned_triads::turn_triads;
use super::turned_vectors::turn_vectors;
use super::vectors_by_components::tell_by_components;
use crate::notation::Macros;

/// Words of the sense in which an angle grows.
const SENSES: [&str; 2] = [TOWARDS, POSITIVE_TOWARDS];

/// An axis of a frame, from 1, and whether a direction goes against it.
pub(super) struct Direction {
    pub(super) frame: Term,
    pub(super) number: usize,
    pub(super) reversed: bool,
}

impl Direction {
    /// The name of its axis, where a sentence names those of its frame.
    pub(super) fn axis_name(&self, declarations: &[Declaration]) -> Option<String> {
        let axes = axes_of(&self.frame, declarations)?;
        name(axes.get(self.number - 1)?)
    }
}

/// "`$\theta$` is the angle from y to the line from O to P towards x": the line turns in their plane by it.
pub(crate) fn turn_lines(declarations: &mut Vec<Declaration>, macros: &Macros) {
    turn_by_nodes(declarations, macros);
    place_by_spherical_angles(declarations, macros);
    turn_vectors(declarations, macros);
    tell_by_components(declarations, macros);
    turn_triads(declarations, macros);
    turn_frames(declarations);
    incline_frames(declarations, macros);
    let mut at = 0;
    while at < declarations.len() {
        let turned = turned(&declarations[at].statement, declarations, macros);
        match turned {
            Some((line, number, turn)) => {
                let said = declarations.remove(at);
                place_along(&line, number, declarations);
                name_ways(&line, number, declarations);
                let ends = place_ends(&line, number, declarations, macros);
                let told = [Some(turn), line.besides(number)].into_iter().flatten();
                let told = told.chain(ends);
                declarations.extend(told.map(|statement| said.saying(statement)));
            }
            None => at += 1,
        }
    }
}

/// "the force along the line from C to A": along the axis of what turns with it, or against that.
fn name_ways(line: &Line, number: usize, declarations: &mut [Declaration]) {
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        for (slot, along) in &mut what.slots {
            if let (Slot::Along, Term::Phrase(way)) = (slot, &*along)
                && let Some(against) = line.leads_along(way)
            {
                *along = axis(number, Some(line.turning()));
                if let (true, Term::Phrase(axis)) = (against, along) {
                    axis.adjectives.push("negative");
                }
            }
        }
    }
}

/// The line of an angle, the axis along which it lies in what turns with it, and how that turns.
fn turned(
    statement: &Statement,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<(Line, usize, Statement)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(letter)], "angle") = (subjects.as_slice(), what.head) else {
        return None;
    };
    let from = direction(what.slot(Slot::RelativeTo)?, declarations)?;
    let (about, forwards) = sense(what, &from, declarations)?;
    let line = match what.slot(Slot::To).or_else(|| what.slot(Slot::Of))? {
        Term::Phrase(way) if way.head == "axis" => line_between(way, declarations)?,
        body @ Term::Name(_) => Line::Body(body.clone()),
        _ => return None,
    };
    // What turns by an angle that another sentence tells does not turn by this one besides.
    let turns = |d: &Declaration| {
        d.statement.does("turn").is_some_and(|(subjects, slots)| {
            let by = slot(slots, Slot::By).is_some();
            by && subjects.contains(line.turning())
                && slot(slots, Slot::RelativeTo) == Some(&from.frame)
        })
    };
    if line.is_of_long_body() && declarations.iter().any(turns)
        || line.is_told_otherwise(declarations)
    {
        return None;
    }
    let source = match (from.reversed, forwards) {
        (false, true) => letter.source.clone(),
        (false, false) => format!("-{}", letter.source),
        (true, true) => format!("{}+\\pi", letter.source),
        (true, false) => format!("\\pi-{}", letter.source),
    };
    let angle = Term::Formula(formula(&source, false, macros)?);
    let about = axis(about, Some(&from.frame));
    let turn = turns_by(line.turning(), &from.frame, about, angle);
    Some((line, from.number, turn))
}

/// The number of the axis about which a line turns from a direction, and whether it turns forwards about it: towards another
/// direction, or about a third one.
pub(super) fn sense(
    what: &NounPhrase,
    from: &Direction,
    declarations: &[Declaration],
) -> Option<(usize, bool)> {
    let said = |senses: &[&str]| {
        what.all(Slot::With).find_map(|with| match with {
            Term::Phrase(sense) if senses.contains(&sense.head) => sense.slot(Slot::Of),
            _ => None,
        })
    };
    let across = |other: &Direction| other.frame == from.frame && other.number != from.number;
    if let Some(towards) = said(&SENSES) {
        let towards = direction(towards, declarations).filter(across)?;
        // About the third axis the first one turns towards the second.
        let cyclic = towards.number == from.number % 3 + 1;
        let forwards = cyclic != (from.reversed != towards.reversed);
        return Some((6 - from.number - towards.number, forwards));
    }
    let about = said(&[POSITIVE_ABOUT]).or_else(|| what.slot(Slot::About))?;
    let about = direction(about, declarations).filter(across)?;
    Some((about.number, !about.reversed))
}

/// An axis by its name, or the vertical where that is one of the axes.
pub(super) fn direction(term: &Term, declarations: &[Declaration]) -> Option<Direction> {
    if let Term::Phrase(vertical) = term
        && vertical.head == VERTICAL
    {
        let down = vertical.is("downward");
        let (own, points_down) = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == VERTICAL => {
                Some((subjects.first()?, what.is("downward")))
            }
            _ => None,
        })?;
        let own = direction(own, declarations)?;
        let reversed = own.reversed != (down != points_down);
        return (down || vertical.is("upward")).then_some(Direction { reversed, ..own });
    }
    let called = name(term)?;
    let (called, reversed) = match called.strip_prefix('-') {
        Some(opposite) => (opposite.to_owned(), true),
        None => (called, false),
    };
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" => {
            let mut names = subjects.iter().filter_map(name);
            Some(Direction {
                number: names.position(|own| own == called)? + 1,
                frame: what.slot(Slot::Of)?.clone(),
                reversed,
            })
        }
        _ => None,
    })
}
