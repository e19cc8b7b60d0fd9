//! Sizes of things, by the letters that sentences give them.

use super::statement::{Declaration, Formula, Slot, Statement, Term};

/// The letter of a size of a thing, where a sentence of its own tells it or the one that says what the thing is.
pub(super) fn told_size<'d>(
    noun: &str,
    thing: &Term,
    declarations: &'d [Declaration],
) -> Option<&'d Formula> {
    declarations.iter().find_map(|d| {
        let Statement::Is { subjects, what } = &d.statement else {
            return None;
        };
        let size = match subjects.as_slice() {
            [size] if what.head == noun => {
                Some(size).filter(|_| what.slot(Slot::Of) == Some(thing))
            }
            _ if subjects.contains(thing) => what.size(noun),
            _ => None,
        };
        match size? {
            Term::Formula(letter) => Some(letter),
            _ => None,
        }
    })
}
