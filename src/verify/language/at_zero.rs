//! "d points along k when `$\alpha$` is zero", of a vector that is fixed in what turns by `$\alpha$`: it is an axis of that, as
//! a frame and the one against which it turns have the same axes where the angle is zero.

use super::at_zero_placed::{carried_by, same_at_zero};
use super::inclinations::is_zero_of;
use super::planar_axes::axis;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};

/// Names the axes along which vectors point where the angle of their frame is zero.
pub(crate) fn tell_axes_at_zero(declarations: &mut [Declaration]) {
    for at in 0..declarations.len() {
        let statement = &declarations[at].statement;
        let told = axis_at_zero(statement, declarations);
        if let Some(told) = told.or_else(|| axis_by_angle(statement, declarations)) {
            declarations[at].statement = told;
        }
    }
}

fn axis_at_zero(statement: &Statement, all: &[Declaration]) -> Option<Statement> {
    let (vector, along, zero) = points_at_zero(statement).or_else(|| same_at_zero(statement))?;
    let carrier = all.iter().find_map(|d| fixed_in(&d.statement, vector))?;
    let own = carried_by(carrier, all);
    let mut turns = own.iter().flat_map(|own| all.iter().map(move |d| (own, d)));
    let base = turns.find_map(|(own, d)| turns_by(&d.statement, own, zero))?;
    let number = all
        .iter()
        .find_map(|d| number_of(&d.statement, along, base))?;
    let axis = (Slot::Along, axis(number, Some(carrier)));
    let what = NounPhrase::new("unit vector", vec![axis]);
    Some(Statement::one_is(vector.clone(), what))
}

/// What points along what under a condition.
pub(super) fn points_at_zero(statement: &Statement) -> Option<(&Term, &Term, &Formula)> {
    let (subjects, slots) = statement.does("point")?;
    let ([vector], [_, _]) = (subjects, slots) else {
        return None;
    };
    match slot(slots, Slot::At).filter(|at| at.is_condition())? {
        Term::Formula(zero) => Some((vector, slot(slots, Slot::Along)?, zero)),
        _ => None,
    }
}

/// "`$\\theta$` is the angle from j to u about k", of u that is fixed in what turns about k by this angle: where it is zero u
/// points along j.
fn axis_by_angle(statement: &Statement, all: &[Declaration]) -> Option<Statement> {
    let (Term::Formula(letter), angle) = angle_told(statement)? else {
        return None;
    };
    let (along, vector) = (angle.slot(Slot::RelativeTo)?, angle.slot(Slot::To)?);
    let about = angle.slot(Slot::About)?;
    if angle.head != "angle" || angle.slots.len() != 3 {
        return None;
    }
    let carrier = all.iter().find_map(|d| fixed_in(&d.statement, vector))?;
    let base = all.iter().find_map(|d| {
        let (subjects, slots) = d.statement.does("turn")?;
        let same = subjects.contains(carrier) && slot(slots, Slot::About) == Some(about);
        let by = slot(slots, Slot::By).and_then(angle_of_turn)?;
        let same = same && by.source == letter.source;
        slot(slots, Slot::RelativeTo).filter(|_| same)
    })?;
    let number = all
        .iter()
        .find_map(|d| number_of(&d.statement, along, base))?;
    let across = all
        .iter()
        .find_map(|d| number_of(&d.statement, about, base))?;
    let axis = (Slot::Along, axis(number, Some(carrier)));
    let what = NounPhrase::new("unit vector", vec![axis]);
    (number != across).then(|| Statement::one_is(vector.clone(), what))
}

/// A letter and the angle that it is.
fn angle_told(statement: &Statement) -> Option<(&Term, &NounPhrase)> {
    match statement {
        Statement::Is { subjects, what } => match subjects.as_slice() {
            [letter] => Some((letter, what)),
            _ => None,
        },
        Statement::Same { subjects, others } => match (subjects.as_slice(), others.as_slice()) {
            ([Term::Phrase(angle)], [letter]) => Some((letter, angle)),
            _ => None,
        },
        _ => None,
    }
}

/// The formula of "by the angle `$\\theta$`".
pub(super) fn angle_of_turn(by: &Term) -> Option<&Formula> {
    match by {
        Term::Phrase(angle) if angle.head == "angle" => match angle.slot(Slot::Which)? {
            Term::Formula(letter) => Some(letter),
            _ => None,
        },
        _ => None,
    }
}

/// What carries a vector.
fn fixed_in<'d>(statement: &'d Statement, vector: &Term) -> Option<&'d Term> {
    match statement {
        Statement::Is { subjects, what } if subjects.contains(vector) => what.slot(Slot::FixedIn),
        _ => None,
    }
}

/// Against what a frame turns by an angle that is zero under a condition.
pub(super) fn turns_by<'d>(
    statement: &'d Statement,
    frame: &Term,
    zero: &Formula,
) -> Option<&'d Term> {
    let (subjects, slots) = statement.does("turn")?;
    let by = slot(slots, Slot::By).filter(|_| subjects.contains(frame))?;
    let letter = angle_of_turn(by)?;
    let letter = letter.source.replace(' ', "");
    let letter = letter.strip_prefix('-').unwrap_or(&letter);
    slot(slots, Slot::RelativeTo).filter(|_| is_zero_of(zero, letter))
}

/// The number of an axis of a frame.
pub(super) fn number_of(statement: &Statement, along: &Term, frame: &Term) -> Option<usize> {
    match statement {
        Statement::Is { subjects, what }
            if what.head == "axes" && what.slot(Slot::Of) == Some(frame) && subjects.len() == 3 =>
        {
            Some(subjects.iter().position(|axis| axis == along)? + 1)
        }
        _ => None,
    }
}
