//! Against what frames and bodies are said to turn.

use crate::verify::language::statement::{Declaration, Slot, Statement, slot};
use crate::verify::reading::names::{EULER_ANGLES, name_of};
use std::collections::BTreeMap;

/// What is said to turn against what.
pub(super) fn turned_against(declarations: &[Declaration]) -> BTreeMap<String, String> {
    let mut parents = BTreeMap::new();
    let angles = declarations.iter().filter_map(of_euler_angles);
    let angles = angles.filter_map(|(of, relative)| Some((of, relative?)));
    let angles: BTreeMap<String, String> = angles.collect();
    for declaration in declarations {
        let (subjects, relative) = match &declaration.statement {
            Statement::Does {
                subjects,
                verb: "turn",
                slots,
            } => {
                // A rate tells less than angles do, and is a premise beside them.
                let by_angles = |term| name_of(term).is_some_and(|name| angles.contains_key(&name));
                if slot(slots, Slot::By).is_none() && subjects.iter().any(by_angles) {
                    continue;
                }
                (subjects, slot(slots, Slot::RelativeTo))
            }
            Statement::Is { subjects, what } if what.head == "frame" => {
                (subjects, what.slot(Slot::RelativeTo))
            }
            _ => continue,
        };
        let Some(relative) = relative.and_then(name_of) else {
            continue;
        };
        for name in subjects.iter().filter_map(name_of) {
            parents.entry(name).or_insert_with(|| relative.clone());
        }
    }
    for (name, relative) in angles {
        parents.entry(name).or_insert(relative);
    }
    parents
}

/// The body in which a sentence says that a frame is fixed, and the frame.
pub(super) fn carried_by_frames(declaration: &Declaration) -> Option<(String, String)> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == "frame" => {
            let body = what.slot(Slot::FixedIn).and_then(name_of)?;
            Some((body, subjects.first().and_then(name_of)?))
        }
        _ => None,
    }
}

/// The frame whose Euler angles a sentence names, and the one that they are relative to.
pub(super) fn of_euler_angles(declaration: &Declaration) -> Option<(String, Option<String>)> {
    match &declaration.statement {
        Statement::Is { what, .. } if what.head == EULER_ANGLES => {
            let name = |slot| what.slot(slot).and_then(name_of);
            Some((name(Slot::Of)?, name(Slot::RelativeTo)))
        }
        _ => None,
    }
}
