//! "`$M_3$` is the angular momentum of the top about O along 3": axes by their numbers alone, of the one frame of which another
//! sentence numbers the axes, or that is fixed in a body; and "the third axis" without a frame.

use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeSet;

/// Puts the axis in the place of its number.
pub(crate) fn name_axes_by_number(declarations: &mut [Declaration]) {
    let Some(frame) = numbered_frame(declarations) else {
        return;
    };
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Is { what, .. } => put_axes(&mut what.slots, &frame),
            Statement::Does { slots, .. } => put_axes(slots, &frame),
            _ => {}
        }
    }
}

/// "the axes 1, 2, 3 of K"; else the only frame that is fixed in a body.
fn numbered_frame(declarations: &[Declaration]) -> Option<Term> {
    let axes = |term: &Term| match term {
        Term::Phrase(axes) if matches!(axes.head, "axes" | "axis") => {
            let mut which = axes.all(Slot::Which);
            let numbered = which.any(|axis| number(axis).is_some());
            axes.slot(Slot::Of).filter(|_| numbered).cloned()
        }
        _ => None,
    };
    let numbered = |d: &Declaration| -> Vec<Term> {
        let terms = d.statement.terms().into_iter();
        terms.filter_map(axes).collect()
    };
    let fixed = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what }
            if what.head == "frame" && what.slot(Slot::FixedIn).is_some() =>
        {
            subjects.clone()
        }
        _ => vec![],
    };
    let only = |frames: Vec<Term>| {
        let names: BTreeSet<String> = frames.iter().filter_map(name).collect();
        frames.into_iter().next().filter(|_| names.len() == 1)
    };
    only(declarations.iter().flat_map(numbered).collect())
        .or_else(|| only(declarations.iter().flat_map(fixed).collect()))
}

fn put_axes(slots: &mut [(Slot, Term)], frame: &Term) {
    // The matrix of a rotation by an angle has axes of its own.
    let by_angle = slots.iter().any(|(slot, _)| *slot == Slot::By);
    for (slot, term) in slots {
        match (&*slot, number(term)) {
            (Slot::Along | Slot::About, Some(number)) => {
                let which = (Slot::Which, Term::Numbers(vec![number]));
                let axis = NounPhrase::new("axis", vec![which, (Slot::Of, frame.clone())]);
                *term = Term::Phrase(Box::new(axis));
            }
            _ => {
                if let Term::Phrase(inner) = term {
                    if is_bare_axis(inner) && !by_angle {
                        inner.slots.push((Slot::Of, frame.clone()));
                    }
                    put_axes(&mut inner.slots, frame);
                }
            }
        }
    }
}

/// "the third axis", of which it is not said whose it is.
fn is_bare_axis(phrase: &NounPhrase) -> bool {
    let mut which = phrase.all(Slot::Which);
    phrase.head == "axis"
        && phrase.slot(Slot::Of).is_none()
        && which.any(|axis| number(axis).is_some())
}

/// The number that a term is.
fn number(term: &Term) -> Option<usize> {
    let number = match term {
        Term::Numbers(numbers) if numbers.len() == 1 => numbers.first().copied(),
        Term::Name(name) => name.parse().ok(),
        _ => None,
    };
    number.filter(|number| (1..=3).contains(number))
}
