//! "The corresponding moments of inertia of the head about P": about the same axes as those that were told before, through P.

use super::heads::MOMENT_OF_INERTIA;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Says of each letter about which axis the moment of inertia is that it is said to correspond to.
pub(crate) fn tell_corresponding(declarations: &mut Vec<Declaration>) {
    let mut at = 0;
    while at < declarations.len() {
        let told = corresponding(&declarations[..at], &declarations[at]);
        let count = told.as_ref().map_or(1, Vec::len);
        if let Some(told) = told {
            declarations.splice(at..=at, told);
        }
        at += count;
    }
}

/// What a sentence says of corresponding moments; it is not understood where none are told before, or not as many.
fn corresponding(before: &[Declaration], said: &Declaration) -> Option<Vec<Declaration>> {
    let Statement::Is { subjects, what } = &said.statement else {
        return None;
    };
    if what.head != MOMENT_OF_INERTIA || !what.is("corresponding") {
        return None;
    }
    let before = before
        .iter()
        .filter_map(|d| Some((d.line, told_about_axis(d)?)));
    let before: Vec<(usize, &NounPhrase)> = before.collect();
    let line = before.last().map(|(line, _)| *line);
    let told = before.into_iter().filter(|(own, _)| Some(*own) == line);
    let told: Vec<NounPhrase> = told
        .filter_map(|(_, told)| of_another(told, what))
        .collect();
    if told.len() != subjects.len() {
        return Some(vec![said.clone().not_understood()]);
    }
    let each = subjects.iter().zip(told);
    let each = each.map(|(subject, what)| said.saying(Statement::one_is(subject.clone(), what)));
    Some(each.collect())
}

/// A moment of inertia of one letter about an axis.
fn told_about_axis(declaration: &Declaration) -> Option<&NounPhrase> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == MOMENT_OF_INERTIA => {
            let about = what.slot(Slot::About)?;
            (subjects.len() == 1 && about.is_noun("axis")).then_some(what)
        }
        _ => None,
    }
}

/// A moment of inertia of another body about the same axis through another point.
fn of_another(told: &NounPhrase, other: &NounPhrase) -> Option<NounPhrase> {
    let (body, point) = match other.slots.as_slice() {
        [(Slot::Of, body), (Slot::About, point)] => (body, point),
        _ => return None,
    };
    let mut own = told.clone();
    for (slot, term) in &mut own.slots {
        match (slot, term) {
            (Slot::Of, of) => *of = body.clone(),
            (Slot::About, Term::Phrase(axis)) => {
                let (_, through) = axis.slots.iter_mut().find(|(s, _)| *s == Slot::Through)?;
                *through = point.clone();
            }
            _ => return None,
        }
    }
    Some(own)
}
