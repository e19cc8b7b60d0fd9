//! Letters of the whole force where a body touches something.

use crate::verify::language::heads::FORCE;
use crate::verify::language::statement::{Slot, Statement, Term};
use crate::verify::model::contact::Contact;
use crate::verify::model::loads::Lasting;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::loads_read::is_force_at;
use crate::verify::reading::names::is_marked_vector;

impl Builder<'_> {
    /// The letter that a sentence gives to the whole force at a contact stands for the one that is counted.
    pub(super) fn name_whole_at(&mut self, contact: &Contact) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let whole = what.head == FORCE && what.slot(Slot::Along).is_none() && is_force_at(what);
            let here = |c: Contact| c.point == contact.point;
            let [Term::Formula(letter)] = subjects.as_slice() else {
                continue;
            };
            if whole
                && is_marked_vector(letter)
                && self.load(letter, Lasting::Always).is_none()
                && self.contact_of(what).is_some_and(here)
            {
                self.add_load(FORCE, letter, &what.slots, declaration);
            }
        }
    }
}
