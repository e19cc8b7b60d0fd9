//! "`$J$` is the moment of inertia of the ball about any axis through S": each of its principal moments about S.

use super::heads::{MASS_CENTRE, MOMENT_OF_INERTIA, PRINCIPAL_MOMENTS};
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeSet;

/// Says of a moment of inertia about any axis through a point that it is each of the three principal moments.
pub(super) fn tell_round_moments(declarations: &mut [Declaration]) {
    let uniform = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.is("uniform") => Some(subjects),
        _ => None,
    });
    let uniform: BTreeSet<String> = uniform.flatten().filter_map(name).collect();
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let ([letter @ Term::Formula(_)], MOMENT_OF_INERTIA) = (subjects.as_slice(), what.head)
        else {
            continue;
        };
        let [(Slot::Of, body), (Slot::About, Term::Phrase(axis))] = what.slots.as_slice() else {
            continue;
        };
        let [(Slot::Through, point)] = axis.slots.as_slice() else {
            continue;
        };
        if axis.head != "axis" || axis.adjectives != ["any"] {
            continue;
        }
        let mut point = point.clone();
        // The centre of what is uniform is its mass centre.
        if let Term::Phrase(centre) = &mut point
            && centre.head == "centre"
            && name(body).is_some_and(|body| uniform.contains(&body))
        {
            centre.head = MASS_CENTRE;
        }
        let of = vec![(Slot::Of, body.clone()), (Slot::About, point)];
        let three = vec![letter.clone(); 3];
        *what = NounPhrase::new(PRINCIPAL_MOMENTS, of);
        *subjects = three;
    }
}
