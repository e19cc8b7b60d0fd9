//! What a student is told: all, or less where staff hold it back.

use crate::grade::{Graded, Line, Reached, Slip};

/// How much a student is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// The marks alone.
    Marks,
    /// Also which line holds and which does not.
    Place,
    /// Also why, with the mistake, the line as it should stand, and numbers in which a false line fails.
    Full,
}

/// What a student is told who waits for a person.
const WAITS: &str = "a person will look at this work";

/// What is left of the work of a student when the rest is held back. Every page, file and table for students is made of it.
pub fn told(graded: &Graded, detail: Detail) -> Graded {
    let mut told = graded.clone();
    if detail < Detail::Full {
        told.lines = told.lines.into_iter().map(verdict_alone).collect();
        told.first_slip = told.first_slip.map(|slip| Slip {
            kind: String::new(),
            message: String::new(),
            repair: None,
            ..slip
        });
    }
    if detail < Detail::Place {
        told.milestones = told.milestones.into_iter().map(marks_alone).collect();
        told.first_slip = None;
        told.assumptions.clear();
        told.lines.clear();
        told.questions.clear();
        told.notes.clear();
        // Why it waits may tell what is wrong.
        told.queue = told.queue.map(|_| WAITS.to_owned());
    }
    told
}

fn verdict_alone(line: Line) -> Line {
    Line {
        reason: None,
        mistake: None,
        repair: None,
        counterexample: None,
        ..line
    }
}

fn marks_alone(reached: Reached) -> Reached {
    Reached {
        place: None,
        reason: String::new(),
        ..reached
    }
}
