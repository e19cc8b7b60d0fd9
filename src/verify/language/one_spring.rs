//! One spring by two names: "a torsion spring acts on the rod …" and then "the moment of the spring".

use super::heads::POTENTIAL_ENERGY;
use super::statement::{Declaration, Slot, Statement, Term};

/// The noun of a spring of any kind.
const SPRING: &str = "spring";

/// Calls a spring of a kind "the spring", where no sentence tells of a plain one: loads are listed by that name alone.
pub(crate) fn name_the_only_spring(declarations: &mut [Declaration]) {
    let mut names: Vec<&Term> = vec![];
    for term in declarations.iter().flat_map(|d| d.statement.terms()) {
        if is_named_spring(term) && !names.contains(&term) {
            names.push(term);
        }
    }
    let [one, other] = names.as_slice() else {
        return;
    };
    let plain = |term: &Term| spring_name(term).as_deref() == Some(SPRING);
    let (known, kind) = match (plain(one), plain(other)) {
        (true, false) => ((*one).clone(), (*other).clone()),
        (false, true) => ((*other).clone(), (*one).clone()),
        _ => return,
    };
    if declarations.iter().any(|d| tells_of(&d.statement, &known)) {
        return;
    }
    for declaration in declarations {
        for term in declaration.statement.terms_mut() {
            rename(term, &kind, &known);
        }
    }
}

fn is_named_spring(term: &Term) -> bool {
    spring_name(term).is_some()
}

/// The name of a spring with the adjectives of its kind.
fn spring_name(term: &Term) -> Option<String> {
    let named = match term {
        Term::Phrase(phrase) if phrase.slots.is_empty() => {
            let words = phrase.adjectives.iter().copied();
            words.chain([phrase.head]).collect::<Vec<_>>().join(" ")
        }
        Term::Name(name) => name.clone(),
        _ => return None,
    };
    let own = named.split(' ').next_back() == Some(SPRING);
    own.then_some(named)
}

/// Whether a sentence tells what a spring is or does, and does not only list it with others.
fn tells_of(statement: &Statement, spring: &Term) -> bool {
    match statement {
        Statement::Premise(_) => false,
        Statement::Is { subjects, what } => {
            let energy = what.head == POTENTIAL_ENERGY;
            let of = what.slots.iter().any(|(_, term)| speaks_of(term, spring));
            subjects.iter().any(|subject| speaks_of(subject, spring)) || of && !energy
        }
        statement => statement.terms().contains(&spring),
    }
}

fn speaks_of(term: &Term, spring: &Term) -> bool {
    match term {
        Term::Phrase(phrase) if term != spring => {
            let mut slots = phrase.slots.iter();
            slots.any(|(_, inner)| speaks_of(inner, spring))
        }
        term => term == spring,
    }
}

fn rename(term: &mut Term, from: &Term, to: &Term) {
    if term == from {
        term.clone_from(to);
    } else if let Term::Phrase(phrase) = term {
        let slots: &mut Vec<(Slot, Term)> = &mut phrase.slots;
        slots
            .iter_mut()
            .for_each(|(_, inner)| rename(inner, from, to));
    }
}
