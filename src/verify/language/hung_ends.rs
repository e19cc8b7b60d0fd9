//! The ends of rods that lie along an axis from one of them.

use super::hung_rods::is_rod;
use super::statement::{Declaration, Slot, Statement, Term, slot};

/// "O and A are the ends of the rod": A lies as far from O along it as it is long.
pub(super) fn place_other_ends(
    rod: &Term,
    slots: &[(Slot, Term)],
    declarations: &mut [Declaration],
) {
    let (Some(from), Some(along)) = (slot(slots, Slot::From), slot(slots, Slot::Along)) else {
        return;
    };
    let length = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { what, .. } if is_rod(rod, &d.statement) => what.size("length").cloned(),
        _ => None,
    });
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let ends = what.head == "end" && what.slot(Slot::Of) == Some(rod);
        let other: Vec<Term> = subjects.iter().filter(|s| *s != from).cloned().collect();
        if let (true, 1, Some(length)) = (ends, other.len(), &length) {
            declaration.statement = Statement::Does {
                subjects: other,
                verb: "lie",
                slots: vec![
                    (Slot::At, length.clone()),
                    (Slot::From, from.clone()),
                    (Slot::Along, along.clone()),
                ],
            };
        }
    }
}

/// "O is an end of the rod", of the end from which it lies.
pub(super) fn is_only_end(statement: &Statement, rod: &Term, slots: &[(Slot, Term)]) -> bool {
    match statement {
        Statement::Is { subjects, what } if what.head == "end" => {
            let from = slot(slots, Slot::From);
            what.slot(Slot::Of) == Some(rod) && subjects.iter().all(|end| Some(end) == from)
        }
        _ => false,
    }
}
