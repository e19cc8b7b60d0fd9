//! "d points along k when `$\alpha$` is zero", of a vector that is fixed in what turns by `$\alpha$`: it is an axis of that, as
//! a frame and the one against which it turns have the same axes where the angle is zero.

use super::inclinations::is_zero_of;
use super::planar_axes::axis;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};

/// Names the axes along which vectors point where the angle of their frame is zero.
pub(crate) fn tell_axes_at_zero(declarations: &mut [Declaration]) {
    for at in 0..declarations.len() {
        if let Some(told) = axis_at_zero(&declarations[at].statement, declarations) {
            declarations[at].statement = told;
        }
    }
}

fn axis_at_zero(statement: &Statement, all: &[Declaration]) -> Option<Statement> {
    let (subjects, slots) = statement.does("point")?;
    let ([vector], Some(along), Some(Term::Formula(zero))) = (
        subjects,
        slot(slots, Slot::Along),
        slot(slots, Slot::At).filter(|at| at.is_condition()),
    ) else {
        return None;
    };
    if slots.len() != 2 {
        return None;
    }
    let carrier = all.iter().find_map(|d| fixed_in(&d.statement, vector))?;
    let base = all
        .iter()
        .find_map(|d| turns_by(&d.statement, carrier, zero))?;
    let number = all
        .iter()
        .find_map(|d| number_of(&d.statement, along, base))?;
    let axis = (Slot::Along, axis(number, Some(carrier)));
    let what = NounPhrase::new("unit vector", vec![axis]);
    Some(Statement::one_is(vector.clone(), what))
}

/// What carries a vector.
fn fixed_in<'d>(statement: &'d Statement, vector: &Term) -> Option<&'d Term> {
    match statement {
        Statement::Is { subjects, what } if subjects.contains(vector) => what.slot(Slot::FixedIn),
        _ => None,
    }
}

/// Against what a frame turns by an angle that is zero under a condition.
fn turns_by<'d>(statement: &'d Statement, frame: &Term, zero: &Formula) -> Option<&'d Term> {
    let (subjects, slots) = statement.does("turn")?;
    let Some(Term::Phrase(angle)) = slot(slots, Slot::By).filter(|_| subjects.contains(frame))
    else {
        return None;
    };
    let Some(Term::Formula(letter)) = angle.slot(Slot::Which) else {
        return None;
    };
    let letter = letter.source.replace(' ', "");
    let letter = letter.strip_prefix('-').unwrap_or(&letter);
    let same = is_zero_of(zero, letter) && angle.head == "angle";
    slot(slots, Slot::RelativeTo).filter(|_| same)
}

/// The number of an axis of a frame.
fn number_of(statement: &Statement, along: &Term, frame: &Term) -> Option<usize> {
    match statement {
        Statement::Is { subjects, what }
            if what.head == "axes" && what.slot(Slot::Of) == Some(frame) && subjects.len() == 3 =>
        {
            Some(subjects.iter().position(|axis| axis == along)? + 1)
        }
        _ => None,
    }
}
