//! Axes of moments of inertia that stand across a plane: "about the axis through O perpendicular to the plane of x and y", "… to
//! the plane of motion". Which way such an axis points changes nothing of the moment.

use super::heads::MOMENT_OF_INERTIA;
use super::kinds::name;
use super::planar_axes::axis;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// Names the direction of each such axis.
pub(super) fn name_axes_across(declarations: &mut [Declaration]) {
    let told: Vec<Option<Term>> = declarations
        .iter()
        .map(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == MOMENT_OF_INERTIA => {
                across(what.slot(Slot::About)?, declarations)
            }
            _ => None,
        })
        .collect();
    for (declaration, along) in declarations.iter_mut().zip(told) {
        if let (Statement::Is { what, .. }, Some(along)) = (&mut declaration.statement, along) {
            for (slot, about) in &mut what.slots {
                if let (Slot::About, Term::Phrase(axis)) = (slot, about) {
                    axis.slots.retain(|(slot, _)| *slot != Slot::With);
                    axis.slots.push((Slot::Along, along.clone()));
                }
            }
        }
    }
}

/// The direction across the plane to which an axis is said to be perpendicular.
fn across(about: &Term, all: &[Declaration]) -> Option<Term> {
    let Term::Phrase(about) = about else {
        return None;
    };
    let plain = about.head == "axis" && about.slot(Slot::Along).is_none();
    let sides: Vec<&Term> = about.all(Slot::With).filter(|_| plain).collect();
    match sides.as_slice() {
        [Term::Phrase(plane)] if plane.head == "plane" => {
            let spanned: Vec<&Term> = plane.all(Slot::Of).collect();
            match spanned.as_slice() {
                [Term::Phrase(motion)] if motion.head == "motion" => motion_across(all),
                [one, other] => third_axis(one, other, all),
                _ => None,
            }
        }
        [one, other] => third_axis(one, other, all),
        _ => None,
    }
}

/// The axis of a frame beside two others of it.
fn third_axis(one: &Term, other: &Term, all: &[Declaration]) -> Option<Term> {
    all.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" && subjects.len() == 3 => {
            let number = |term: &Term| subjects.iter().position(|own| name(own) == name(term));
            let (one, other) = (number(one)?, number(other)?);
            let frame = what.slot(Slot::Of)?;
            (one != other).then(|| axis(4 - one - other, Some(frame)))
        }
        _ => None,
    })
}

/// Across the plane in which the only thing moves that is said to move in one, or along the axis about which all turns.
fn motion_across(all: &[Declaration]) -> Option<Term> {
    let told = all.iter().filter_map(|d| match &d.statement {
        Statement::Does {
            verb: "move",
            slots,
            ..
        } => {
            let plane = slots.iter().find_map(|(_, term)| in_plane(term))?;
            let spanned: Vec<&Term> = plane.all(Slot::Of).collect();
            match spanned.as_slice() {
                [one, other] => third_axis(one, other, all),
                _ => plane.slot(Slot::With).cloned(),
            }
        }
        Statement::Does {
            verb: "turn",
            slots,
            ..
        } => slot(slots, Slot::About).map(|about| match about {
            Term::Phrase(axis) if axis.head == "axis" => {
                axis.slot(Slot::Along).unwrap_or(about).clone()
            }
            about => about.clone(),
        }),
        _ => None,
    });
    let told: Vec<Term> = told.collect();
    let (first, others) = told.split_first()?;
    others
        .iter()
        .all(|other| other == first)
        .then(|| first.clone())
}

fn in_plane(term: &Term) -> Option<&NounPhrase> {
    match term {
        Term::Phrase(plane) if plane.head == "plane" => Some(plane),
        _ => None,
    }
}
