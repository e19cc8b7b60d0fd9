//! Loads that only the list of them names: "The weight, the force F and the moment K are the only loads on the aircraft."

use super::heads::MOMENT;
use super::statement::{Declaration, Slot, Statement, Term};

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
        let moments = list.all(Slot::With);
        let named = moments.filter_map(|load| Some((load, letter_of_moment(load)?)));
        let new = named.filter(|(_, letter)| !declarations.iter().any(|d| tells(d, letter)));
        told.extend(new.map(|(moment, _)| {
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
fn letter_of_moment(load: &Term) -> Option<&Term> {
    match load {
        Term::Phrase(moment) if moment.head == MOMENT => match moment.slots.as_slice() {
            [(Slot::Which, letter)] => Some(letter),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a sentence says what a letter is, or on what the moment acts that it names.
fn tells(declaration: &Declaration, letter: &Term) -> bool {
    let own = |term: &Term| match term {
        Term::Phrase(phrase) => phrase.all(Slot::Which).any(|own| own == letter),
        term => term == letter,
    };
    declaration.statement.subjects().iter().any(own)
}
