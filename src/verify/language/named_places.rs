//! Places of bodies that are called by a name beside their noun.

use super::heads::MASS_CENTRE;
use super::statement::{Declaration, Slot, Statement};

/// Places of a body that are called by a name beside the noun: "the mass centre G lies at …".
pub(super) const PLACES: [&str; 6] = [MASS_CENTRE, "centre", "middle", "tip", "corner", "apex"];

/// Whether a statement that says of no thing whose place it is only repeats another one's noun: "about the mass centre G".
pub(super) fn names_place_again(new: &Statement, others: &[Declaration]) -> bool {
    let Statement::Is { subjects, what } = new else {
        return false;
    };
    let again = |other: &Declaration| match &other.statement {
        Statement::Is {
            subjects: others,
            what: other,
        } => others == subjects && other.head == what.head,
        _ => false,
    };
    PLACES.contains(&what.head) && what.slot(Slot::Of).is_none() && others.iter().any(again)
}
