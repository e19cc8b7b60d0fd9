//! Components on axes: each is the component along its axis, and not those on a frame.

use super::heads::{UNIT_VECTOR, VERTICAL};
use super::statement::{Declaration, Slot, Statement, Term};

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
