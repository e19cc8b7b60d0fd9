//! "The rotor spins about `$a$` relative to B. The spin rate is `$q$` and is constant": the rate of the turn that was told just
//! before.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::leave_out;

/// What the rate of a turn is called, where no sentence says of what.
const CALLED: [&str; 4] = ["rate", "spin", "angular speed", "speed"];

/// Gives a turn of which no rate and no angle is told the rate that the next sentence tells of nothing else.
pub(super) fn give_rates_behind(declarations: &mut Vec<Declaration>) {
    let mut left = vec![];
    for at in 1..declarations.len() {
        let (before, behind) = declarations.split_at_mut(at);
        let (Some(turn), Some((told, others))) = (before.last_mut(), behind.split_first_mut())
        else {
            break;
        };
        let Some((called, rate)) = rate_alone(told) else {
            continue;
        };
        if turn.extent != told.extent || !give(turn, &rate) {
            continue;
        }
        left.push(at);
        // "It is constant."
        if let Some(next) = others.first_mut()
            && let Statement::Is { subjects, .. } = &mut next.statement
            && matches!(subjects.as_slice(), [subject] if is_unowned(subject, called))
        {
            *subjects = vec![rate];
        }
    }
    leave_out(declarations, &left);
}

/// A letter that is said to be a rate, of nothing.
fn rate_alone(declaration: &Declaration) -> Option<(&'static str, Term)> {
    match &declaration.statement {
        Statement::Is { subjects, what } => match subjects.as_slice() {
            [rate @ Term::Formula(_)] if what.slots.is_empty() && what.adjectives.is_empty() => {
                let called = CALLED.into_iter().find(|called| *called == what.head)?;
                Some((called, rate.clone()))
            }
            _ => None,
        },
        _ => None,
    }
}

/// Puts a rate into a sentence of a turn about an axis that has none: whether it does.
fn give(turn: &mut Declaration, rate: &Term) -> bool {
    match &mut turn.statement {
        Statement::Does {
            verb: "turn",
            slots,
            subjects,
        } if subjects.len() == 1 => {
            let told = |(slot, _): &(Slot, Term)| matches!(slot, Slot::At | Slot::By | Slot::With);
            let about = slots.iter().any(|(slot, _)| *slot == Slot::About);
            if !about || slots.iter().any(told) {
                return false;
            }
            let rate = NounPhrase::new("rate", vec![(Slot::Which, rate.clone())]);
            slots.push((Slot::At, Term::Phrase(Box::new(rate))));
            true
        }
        _ => false,
    }
}

/// "the spin", of nothing.
fn is_unowned(term: &Term, called: &str) -> bool {
    match term {
        Term::Phrase(phrase) => phrase.head == called && phrase.slots.is_empty(),
        _ => false,
    }
}
