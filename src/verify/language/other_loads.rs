//! "No other moment acts on the ball": none but those that sentences tell.

use super::heads::{EXCEPT, MOMENT};
use super::is_load;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Says which moments are meant, where sentences tell letters or formulas of moments on the same body, and no force on it.
pub(super) fn tell_other_moments(declarations: &mut [Declaration]) {
    for at in 0..declarations.len() {
        let Statement::Premise(premise) = &declarations[at].statement else {
            continue;
        };
        let body = premise.slot(Slot::Of).filter(|_| {
            let whole = premise
                .slots
                .iter()
                .all(|(slot, _)| matches!(slot, Slot::Of | Slot::About | Slot::Along));
            premise.head == MOMENT && premise.adjectives == ["no", "other"] && whole
        });
        let along = premise.slot(Slot::Along);
        let Some(told) = body.and_then(|body| moments_on(body, along, declarations)) else {
            continue;
        };
        let except = NounPhrase::new(EXCEPT, told);
        let mut only = premise.clone();
        only.adjectives.retain(|said| *said != "other");
        only.slots
            .push((Slot::With, Term::Phrase(Box::new(except))));
        declarations[at].statement = Statement::Premise(only);
    }
}

/// The moments on a body, all or those along an axis, that sentences tell by letters or formulas, if these are all loads on it.
fn moments_on(
    body: &Term,
    along: Option<&Term>,
    declarations: &[Declaration],
) -> Option<Vec<(Slot, Term)>> {
    let mut moments = vec![];
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let on_it = what.slot(Slot::Upon).or(what.slot(Slot::Of)) == Some(body);
        if !on_it || !is_load(what.head) {
            continue;
        }
        let ([letter @ Term::Formula(_)], [(Slot::Of, of), (Slot::Upon, _), axis @ ..], MOMENT) =
            (subjects.as_slice(), what.slots.as_slice(), what.head)
        else {
            return None;
        };
        match axis {
            [] if along.is_none() => {}
            [(Slot::Along, own)] if Some(own) == along => {}
            _ => return None,
        }
        let slots = vec![(Slot::Which, letter.clone()), (Slot::Of, of.clone())];
        let moment = Term::Phrase(Box::new(NounPhrase::new(MOMENT, slots)));
        moments.push((Slot::Of, moment));
    }
    Some(moments).filter(|moments| !moments.is_empty())
}
