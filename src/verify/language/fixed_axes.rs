//! Axes that are fixed and have no letter: "The door turns about a fixed axis". A unit vector points along each.

use super::kinds::name;
use super::reader::formula;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;

/// The letter of the directions of such axes, which no author writes.
const LETTER: &str = "\\hat{e}_{fixed";

/// Gives each fixed axis about which something turns a direction.
pub(crate) fn name_fixed_axes(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let Some(ground) = inertial_frame(declarations) else {
        return;
    };
    let mut told: Vec<Declaration> = vec![];
    for at in 0..declarations.len() {
        let Some(axis) = fixed_axis(&declarations[at].statement, &ground).cloned() else {
            continue;
        };
        // "a fixed axis" of another thing may be another axis.
        let about = |d: &&Declaration| {
            let turn = d.statement.does("turn");
            turn.is_some_and(|(_, slots)| slot(slots, Slot::About) == Some(&axis))
        };
        if declarations.iter().filter(about).count() > 1 {
            continue;
        }
        let letter = format!("{LETTER}{}}}", told.len() + 1);
        let Some(letter) = formula(&letter, false, macros).map(Term::Formula) else {
            return;
        };
        let mut direction = NounPhrase::new("unit vector", vec![(Slot::FixedIn, ground.clone())]);
        if matches!(&axis, Term::Phrase(axis) if axis.is("horizontal")) {
            direction.adjectives.push("horizontal");
        }
        let direction = Statement::one_is(letter.clone(), direction);
        told.push(Declaration {
            extent: Extent::Document,
            ..declarations[at].saying(direction)
        });
        if let Statement::Does { slots, .. } = &mut declarations[at].statement
            && slot(slots, Slot::RelativeTo).is_none()
        {
            slots.push((Slot::RelativeTo, ground.clone()));
        }
        let plain = plain_axis(&axis, letter);
        for declaration in declarations.iter_mut() {
            let terms = declaration.statement.terms_mut().into_iter();
            terms.for_each(|term| replace(term, &axis, &plain));
        }
    }
    declarations.extend(told);
}

/// The inertial frame, where there is one.
pub(super) fn inertial_frame(declarations: &[Declaration]) -> Option<Term> {
    let mut frames = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" && what.is("inertial") => {
            subjects.first()
        }
        _ => None,
    });
    let first = frames.next()?;
    frames.next().is_none().then(|| first.clone())
}

/// The axis of a turn, where it is fixed in the inertial frame and nothing says along what it points.
fn fixed_axis<'s>(statement: &'s Statement, ground: &Term) -> Option<&'s Term> {
    let (_, slots) = statement.does("turn")?;
    let about @ Term::Phrase(axis) = slot(slots, Slot::About)? else {
        return None;
    };
    let base = slot(slots, Slot::RelativeTo);
    let of_ground = |term: &Term| name(term) == name(ground);
    let called = axis.adjectives.iter().filter(|a| **a != "horizontal");
    let called: Vec<_> = called.copied().collect();
    let rests = called == ["fixed"] && base.is_none_or(of_ground)
        || called.is_empty() && axis.slot(Slot::FixedIn).is_some_and(of_ground);
    let plain = axis.slots.iter().all(|(slot, term)| match slot {
        Slot::FixedIn => of_ground(term),
        slot => *slot == Slot::Through,
    });
    (axis.head == "axis" && rests && plain && base.is_none_or(of_ground)).then_some(about)
}

/// The axis through its point along a letter.
fn plain_axis(axis: &Term, letter: Term) -> Term {
    let through = match axis {
        Term::Phrase(axis) => axis.slot(Slot::Through),
        _ => None,
    };
    let Some(through) = through.cloned() else {
        return letter;
    };
    let slots = vec![(Slot::Through, through), (Slot::Along, letter)];
    Term::Phrase(Box::new(NounPhrase::new("axis", slots)))
}

/// A term in the place of another one, in a phrase as well.
pub(super) fn replace(term: &mut Term, old: &Term, new: &Term) {
    if term == old {
        term.clone_from(new);
    } else if let Term::Phrase(phrase) = term {
        let inner = phrase.slots.iter_mut();
        inner.for_each(|(_, term)| replace(term, old, new));
    }
}
