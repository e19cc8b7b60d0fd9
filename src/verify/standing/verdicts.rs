//! The verdict of a line: a table of what it is for and what it is worth.

use crate::verify::Role;

/// What a line is worth by the facts alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Standing {
    /// It follows.
    Entailed,
    /// It fails in a world that the facts allow.
    Denied,
    /// It says what one letter is, of which nothing was told.
    Settles,
    /// Letters of which nothing is told leave it open.
    Free,
    /// It says that two things are not the same, and in some world they are not.
    Differs,
    /// It is beyond what is worked out.
    Open,
}

/// What is said of a line, the better before the worse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Answer {
    Proved,
    Accepted,
    Undecided,
    Refuted,
}

/// The table. A claim that words derive is never taken for a definition.
/// Nor is one where a sentence was not taken in: it may tell of the letter.
pub(crate) fn answer(role: Role, derived: bool, standing: Standing) -> Answer {
    match (role, standing) {
        (Role::Claim | Role::Define, Standing::Entailed) => Answer::Proved,
        (Role::Given | Role::Assume, Standing::Entailed) => Answer::Accepted,
        (Role::Given | Role::Assume, Standing::Denied) => Answer::Accepted,
        (_, Standing::Denied) => Answer::Refuted,
        (Role::Claim, Standing::Settles) if derived => Answer::Undecided,
        (_, Standing::Settles) => Answer::Accepted,
        (Role::Claim, Standing::Free) => Answer::Undecided,
        (Role::Define | Role::Given | Role::Assume, Standing::Free) => Answer::Accepted,

        (_, Standing::Differs) => Answer::Accepted,
        (_, Standing::Open) => Answer::Undecided,
    }
}
