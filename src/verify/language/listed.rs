//! Loads that only the list of them names: "The weight, the force F and the moment K are the only loads on the aircraft."

use super::heads::MOMENT;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// A moment of which no other sentence speaks acts on the body whose loads are listed.
pub(crate) fn tell_listed_moments(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for declaration in declarations.iter() {
        let Statement::Premise(list) = &declaration.statement else {
            continue;
        };
        let Some(on) = list.slot(Slot::Of).filter(|_| list.is("only")) else {
            continue;
        };
        let moments = list.all(Slot::With).filter(|load| is_named_moment(load));
        let new = moments.filter(|moment| !declarations.iter().any(|d| tells(d, moment)));
        told.extend(new.map(|moment| {
            declaration.saying(Statement::Does {
                subjects: vec![moment.clone()],
                verb: "act",
                slots: vec![(Slot::Of, on.clone())],
            })
        }));
    }
    declarations.extend(told);
}

/// "the moment K", of which no more is said.
fn is_named_moment(load: &Term) -> bool {
    match load {
        Term::Phrase(moment) => moment.head == MOMENT && letter_of(moment).is_some(),
        _ => false,
    }
}

fn letter_of(moment: &NounPhrase) -> Option<&Term> {
    match moment.slots.as_slice() {
        [(Slot::Which, letter)] => Some(letter),
        _ => None,
    }
}

/// Whether a sentence says what a moment is, or what it acts on.
fn tells(declaration: &Declaration, moment: &Term) -> bool {
    let letter = match moment {
        Term::Phrase(moment) => letter_of(moment),
        _ => None,
    };
    let own = |term: &Term| match term {
        Term::Phrase(phrase) => phrase.all(Slot::Which).any(|own| Some(own) == letter),
        term => Some(term) == letter,
    };
    declaration.statement.subjects().iter().any(own)
}
