//! Frames that share an axis, told by the angle between two others of their axes: they turn about the shared one by it.

use super::kinds::name;
use super::planar_axes::{axes_of, axis, turns_by};
use super::reader::formula;
use super::statement::{Declaration, Slot, Statement, Term};
use super::turned_lines::{direction, sense};
use crate::notation::Macros;

/// "`$b_2$` and `$t$` are the same vector. `$\beta$` is the angle from `$e$` to `$b_1$`, positive about `$t$`", where e, t are
/// the first and the second axis of A, and b_1, b_2 those of B: B turns relative to A about t by β.
pub(super) fn turn_triads(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let mut at = 0;
    while at < declarations.len() {
        if let Some((turn, shared)) = turned(&declarations[at].statement, declarations, macros) {
            declarations[at].statement = turn;
            if let Some(shared) = shared {
                declarations.remove(shared);
                at -= usize::from(shared < at);
            }
        }
        at += 1;
    }
}

/// How a frame turns, and the sentence that says that it shares the axis.
fn turned(
    statement: &Statement,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<(Statement, Option<usize>)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(letter)], "angle") = (subjects.as_slice(), what.head) else {
        return None;
    };
    let from = direction(what.slot(Slot::RelativeTo)?, declarations)?;
    let to = direction(what.slot(Slot::To)?, declarations)?;
    let (about, forwards) = sense(what, &from, declarations)?;
    let alike = to.number == from.number && to.reversed == from.reversed;
    let turns = |d: &Declaration| {
        let said = d.statement.does("turn");
        said.is_some_and(|(subjects, _)| subjects.contains(&to.frame))
    };
    if !alike || to.frame == from.frame || declarations.iter().any(turns) {
        return None;
    }
    let one = axis_called(&from.frame, about, declarations)?;
    let other = axis_called(&to.frame, about, declarations)?;
    let shared = match one == other {
        true => None,
        false => Some(are_one(&[one, other], declarations)?),
    };
    let source = match forwards {
        true => letter.source.clone(),
        false => format!("-{}", letter.source),
    };
    let angle = Term::Formula(formula(&source, false, macros)?);
    let about = axis(about, Some(&from.frame));
    let turn = turns_by(&to.frame, &from.frame, about, angle);
    Some((turn, shared))
}

/// The name of an axis of a frame, by its number from 1.
fn axis_called(frame: &Term, number: usize, declarations: &[Declaration]) -> Option<String> {
    name(axes_of(frame, declarations)?.get(number - 1)?)
}

/// The sentence by which two vectors are one.
fn are_one(both: &[String; 2], declarations: &[Declaration]) -> Option<usize> {
    let named = |terms: &[Term]| -> Vec<String> { terms.iter().filter_map(name).collect() };
    declarations.iter().position(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let names = named(subjects);
            let vector = matches!(what.head, "vector" | "axis" | "axes" | "unit vector");
            let same = what.is("same") && vector && what.slots.is_empty();
            same && names.len() == 2 && both.iter().all(|own| names.contains(own))
        }
        Statement::Same { subjects, others } => {
            let (one, other) = (named(subjects), named(others));
            let names = [one, other].concat();
            names.len() == 2 && both.iter().all(|own| names.contains(own))
        }
        _ => false,
    })
}
