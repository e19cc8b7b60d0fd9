//! Components on axes: each is the component along its axis, and not those on a frame.

use super::heads::{UNIT_VECTOR, VERTICAL};
use super::statement::{
    Declaration, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};

/// The nouns by which a sentence says that something is a direction.
const DIRECTIONS: [&str; 4] = ["axes", "axis", UNIT_VECTOR, VERTICAL];

/// "`$x$` is the component of `$r$` on `$i$`", where i is an axis: the component along it.
pub(super) fn take_along_axes(declarations: &mut [Declaration]) {
    let directions = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if DIRECTIONS.contains(&what.head) => Some(subjects),
        _ => None,
    });
    let directions: Vec<Term> = directions.flatten().cloned().collect();
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        if what.head != "component" {
            continue;
        }
        for (slot, on) in &mut what.slots {
            if *slot == Slot::On && directions.contains(on) {
                *slot = Slot::Along;
            }
        }
    }
}

/// The sign of a cross product, and the noun of what it makes.
const CROSS: (&str, &str) = ("\\times", "cross product");

/// "`$\\times$` is the component of the cross product along z": a rule for the sign, and no letter.
pub(super) fn take_across_planes(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let [Term::Formula(sign)] = subjects.as_slice() else {
            continue;
        };
        if sign.source.trim() == CROSS.0 && is_component_of_cross(what) {
            declaration.statement = rule(sign, what);
        }
    }
}

fn is_component_of_cross(what: &NounPhrase) -> bool {
    let of = what.slot(Slot::Of);
    what.head == "component" && matches!(of, Some(Term::Phrase(of)) if of.head == CROSS.1)
}

fn rule(sign: &Formula, what: &NounPhrase) -> Statement {
    Statement::Notation {
        sign: Sign::Operator(sign.clone()),
        meaning: NotationMeaning::Noun(what.clone()),
    }
}
