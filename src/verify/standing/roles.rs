//! What a line is for, by the words that lead into it.

use crate::verify::Role;
use crate::verify::language::cues::{Cue, cues};

/// The role of a line and whether words derive it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Purpose {
    pub(crate) role: Role,
    /// "hence", "we find": it is said to follow.
    pub(crate) derived: bool,
}

impl Default for Purpose {
    fn default() -> Self {
        Self {
            role: Role::Claim,
            derived: false,
        }
    }
}

/// What the words of a sentence so far make of the next formula: the last cue counts.
pub(crate) fn purpose(sentence: &str) -> Purpose {
    let mut purpose = Purpose::default();
    for cue in cues(sentence) {
        purpose = match cue {
            Cue::Derive => Purpose {
                role: Role::Claim,
                derived: true,
            },
            Cue::Define => Purpose {
                role: Role::Define,
                derived: false,
            },
            Cue::Assume => Purpose {
                role: Role::Assume,
                derived: false,
            },
            Cue::Give => Purpose {
                role: Role::Given,
                derived: false,
            },
        };
    }
    purpose
}
