//! "The mass centre of the rod lies at the distance `$l$` from O along e": the mass centre gets a name, to be placed by that; so
//! does the centre of a uniform shape that is the same point.

use super::centres::MIDDLES;
use super::heads::MASS_CENTRE;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::traits::{
    Trait::{OneSided, Shape},
    has,
};

/// Names the mass centres that sentences place.
pub(crate) fn name_placed_centres(declarations: &mut Vec<Declaration>) {
    let mut told: Vec<Declaration> = vec![];
    for at in 0..declarations.len() {
        let Some(body) = placed_centre(&declarations[at].statement, declarations).cloned() else {
            continue;
        };
        let all = declarations.iter().chain(&told);
        let known = all
            .into_iter()
            .find_map(|d| centre_named(&d.statement, &body));
        let name = match known {
            Some(name) => name.clone(),
            None => {
                let name = Term::Name(new_name(declarations, told.len()));
                let what = NounPhrase::new(MASS_CENTRE, vec![(Slot::Of, body)]);
                told.push(declarations[at].saying(Statement::one_is(name.clone(), what)));
                name
            }
        };
        if let Statement::Does { subjects, .. } = &mut declarations[at].statement {
            *subjects = vec![name];
        }
    }
    declarations.extend(told);
}

/// A name of a mass centre that no sentence writes.
fn new_name(declarations: &[Declaration], known: usize) -> String {
    let written = |number: &usize| {
        let names = [format!("G{number}"), format!("G_{number}")];
        let mut all = declarations.iter();
        all.any(|d| names.iter().any(|name| d.text.contains(name)))
    };
    let mut numbers = known + 1..;
    let free = numbers.find(|number| !written(number));
    format!("G{}", free.unwrap_or_default())
}

/// The body whose mass centre a sentence places.
fn placed_centre<'d>(statement: &'d Statement, declarations: &[Declaration]) -> Option<&'d Term> {
    let (subjects, slots) = statement.does("lie").or_else(|| statement.does("place"))?;
    let [Term::Phrase(centre)] = subjects else {
        return None;
    };
    let placed = slots.iter().any(|(slot, _)| *slot == Slot::From);
    match centre.slots.as_slice() {
        [(Slot::Of, body)] if placed => {
            let middle = MIDDLES.contains(&centre.head) && is_even(body, declarations);
            (centre.head == MASS_CENTRE || middle).then_some(body)
        }
        _ => None,
    }
}

/// Whether a body is a uniform shape whose mass centre is in its middle.
fn is_even(body: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let shape = has(what.head, Shape) && !has(what.head, OneSided);
            shape && what.is("uniform") && subjects.contains(body)
        }
        _ => false,
    })
}

/// The name that a sentence gives the mass centre of a body.
fn centre_named<'d>(statement: &'d Statement, body: &Term) -> Option<&'d Term> {
    match statement {
        Statement::Is { subjects, what } if what.head == MASS_CENTRE => {
            let own = what.slots.as_slice() == [(Slot::Of, body.clone())];
            subjects.first().filter(|_| own && subjects.len() == 1)
        }
        _ => None,
    }
}
