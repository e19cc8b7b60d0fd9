//! Turns of one thing that one sentence tells one after the other: "by `$a$` about z and then by `$b$` about x".

use super::clause::as_formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, Touched};

/// The noun for angles that lead from one frame to another, one after the other.
const EULER_ANGLES: &str = "Euler angles";

/// Puts the turns of a sentence together: by angles they are Euler angles; several rates of one thing are not understood.
pub(crate) fn turn_in_order(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut all: Vec<Declaration> = vec![];
    let mut rest = declarations.into_iter().peekable();
    while let Some(first) = rest.next() {
        let mut row = vec![first];
        while let Some(next) = rest.next_if(|next| is_next_turn(&row[0], next)) {
            row.push(next);
        }
        match row.len() {
            1 => all.append(&mut row),
            _ => all.push(in_order(&row)),
        }
    }
    all
}

/// Whether a sentence goes on with another turn of the same thing against the same frame.
fn is_next_turn(one: &Declaration, next: &Declaration) -> bool {
    let turn = |d: &Declaration| match &d.statement {
        Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } => {
            let relative = term_in(slots, Slot::RelativeTo);
            Some((subjects.clone(), relative))
        }
        _ => None,
    };
    one.line == next.line
        && one.extent == next.extent
        && turn(one).is_some_and(|t| turn(next) == Some(t))
}

fn in_order(row: &[Declaration]) -> Declaration {
    let turns: Option<Vec<(Term, Term)>> = row.iter().map(angle_and_axis).collect();
    let first = row[0].clone();
    let (
        Some(turns),
        Statement::Does {
            subjects, slots, ..
        },
    ) = (turns, &first.statement)
    else {
        let terms = row.iter().flat_map(|d| d.statement.terms());
        let formulas = terms.filter_map(as_formula).collect();
        let touched = Touched::Letters {
            formulas,
            anew: false,
        };
        let letters = vec![];
        return Declaration {
            statement: Statement::Unread { letters, touched },
            ..first
        };
    };
    let of = subjects.iter().map(|s| (Slot::Of, s.clone()));
    let relative = term_in(slots, Slot::RelativeTo).map(|term| (Slot::RelativeTo, term));
    let axes = turns.iter().map(|(_, axis)| (Slot::InOrder, axis.clone()));
    let what = NounPhrase::new(EULER_ANGLES, of.chain(relative).chain(axes).collect());
    let subjects = turns.iter().map(|(angle, _)| angle.clone()).collect();
    Declaration {
        statement: Statement::Is { subjects, what },
        ..first
    }
}

/// The angle of a turn and the axis that it is about.
fn angle_and_axis(turn: &Declaration) -> Option<(Term, Term)> {
    let Statement::Does { slots, .. } = &turn.statement else {
        return None;
    };
    let angle = match term_in(slots, Slot::By)? {
        Term::Phrase(angle) => angle.slot(Slot::Which)?.clone(),
        angle => angle,
    };
    as_formula(&angle)?;
    Some((angle, term_in(slots, Slot::About)?))
}

fn term_in(slots: &[(Slot, Term)], wanted: Slot) -> Option<Term> {
    let mut slots = slots.iter();
    slots
        .find(|(slot, _)| *slot == wanted)
        .map(|(_, term)| term.clone())
}
