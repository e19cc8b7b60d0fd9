//! What things are said to have.

use super::heads::MASS;
use super::statement::{NounPhrase, Slot, Statement, Term};

/// Words for what is the same of several.
const ALIKE: [&str; 2] = ["equal", "same"];

/// "The rod has its mass centre at G": G is the mass centre of the rod.
pub(super) fn place_at(subjects: &[Term], place: &NounPhrase, at: &Term) -> Statement {
    let mut what = place.clone();
    if what.slot(Slot::Of).is_none() {
        let of = subjects.iter().map(|subject| (Slot::Of, subject.clone()));
        what.slots.extend(of);
    }
    Statement::Is {
        subjects: vec![at.clone()],
        what,
    }
}

/// "P and Q have equal masses": as of a thing that is spoken of.
pub(super) fn alike(subjects: &[Term], slots: &[(Slot, Term)]) -> Option<Statement> {
    let [(Slot::With, Term::Phrase(mass))] = slots else {
        return None;
    };
    let plain = mass.head == MASS && mass.slots.is_empty();
    let alike = plain && mass.adjectives.iter().any(|said| ALIKE.contains(said));
    let of = subjects.iter().map(|subject| (Slot::Of, subject.clone()));
    alike.then(|| {
        let mut what = NounPhrase::new(mass.head, of.collect());
        what.adjectives = vec![ALIKE[0]];
        Statement::Premise(what)
    })
}

/// "The rod has the length `$l$` and the mass `$m$`": `$l$` is its length, and `$m$` its mass.
pub(super) fn possessions(subjects: &[Term], slots: &[(Slot, Term)]) -> Option<Vec<Statement>> {
    let mut said = vec![];
    for (number, subject) in subjects.iter().enumerate() {
        for (_, term) in slots {
            let Term::Phrase(phrase) = term else {
                return None;
            };
            let mut letters: Vec<Term> = phrase.all(Slot::Which).cloned().collect();
            // "The hub and the wheel have the masses `$M$` and `$m$`": each its own.
            if subjects.len() > 1 && letters.len() == subjects.len() {
                letters = vec![letters.swap_remove(number)];
            }
            if letters.is_empty() || !letters.iter().all(|l| matches!(l, Term::Formula(_))) {
                return None;
            }
            let mut what = (**phrase).clone();
            what.slots.retain(|(slot, _)| *slot != Slot::Which);
            // A total is that of all together.
            if phrase.is("total") && subjects.len() > 1 {
                let of = subjects.iter().map(|subject| (Slot::Of, subject.clone()));
                what.slots.splice(0..0, of);
                let whole = Statement::Is {
                    subjects: letters,
                    what,
                };
                said.extend(Some(whole).filter(|_| number == 0));
                continue;
            }
            what.slots.insert(0, (Slot::Of, subject.clone()));
            said.push(Statement::Is {
                subjects: letters,
                what,
            });
        }
    }
    Some(said)
}
