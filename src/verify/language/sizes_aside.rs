//! Sizes that stand aside: "a uniform rod (mass `$m$`, length `$l$`)" is one of that mass and length.

use super::heads::SIZES;
use super::statement::{Declaration, Slot, Statement, Term};

/// Puts sizes behind "of".
pub(crate) fn give_sizes_aside(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        for (slot, term) in &mut what.slots {
            let size = match term {
                Term::Phrase(size) => {
                    let letter = matches!(size.slots.as_slice(), [(Slot::Which, Term::Formula(_))]);
                    SIZES.contains(&size.head) && letter
                }
                _ => false,
            };
            if size && matches!(slot, Slot::Which | Slot::With) {
                *slot = Slot::Of;
            }
        }
    }
}
