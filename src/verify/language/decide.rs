//! What statement a subject and a noun behind "is" make.

use super::in_turn::each_of_its_own;
use super::lexicon::{Class, Entry};
use super::sign::{is_operator, operating};
use super::statement::{Formula, NotationMeaning, NounPhrase, Slot, Statement, Term};
use super::traits::Trait;

/// The statement that a phrase behind "is" makes.
pub(super) fn decide(
    mut subjects: Vec<Term>,
    formulas: Option<Vec<Formula>>,
    mut what: NounPhrase,
    entry: &Entry,
) -> Vec<Statement> {
    let mut statements = vec![];
    if let Some(formulas) = formulas {
        let parted = formulas
            .into_iter()
            .partition(|formula| is_operator(formula, &what, entry));
        let (operators, letters): (Vec<Formula>, Vec<Formula>) = parted;
        statements = operating(operators, &NotationMeaning::Noun(what.clone()));
        if letters.is_empty() {
            return statements;
        }
        subjects = letters.into_iter().map(Term::Formula).collect();
    }
    if let Some(statement) = symmetric_about(&subjects, &what) {
        return vec![statement];
    }
    if let Some(statements) = frame_by_name(&subjects, &what) {
        return statements;
    }
    if entry.traits.has(Trait::Premise) || what.is("only") || what.is("no") {
        what.slots
            .extend(subjects.into_iter().map(|subject| (Slot::With, subject)));
        return vec![Statement::Premise(what)];
    }
    if entry.class == Class::Adjective
        && let [Term::Phrase(phrase)] = subjects.as_slice()
    {
        let mut premise = (**phrase).clone();
        premise.adjectives.extend(what.adjectives);
        premise.adjectives.push(what.head);
        premise.slots.extend(what.slots);
        return vec![Statement::Premise(premise)];
    }
    statements.extend(each_of_its_own(subjects, what));
    statements
}

/// "`$n$` is the symmetry axis of the top" says of the top that it is symmetric about `$n$`.
fn symmetric_about(subjects: &[Term], what: &NounPhrase) -> Option<Statement> {
    let [axis] = subjects else { return None };
    let bodies: Vec<Term> = what.all(Slot::Of).cloned().collect();
    let alone = what.slots.len() == bodies.len() && !bodies.is_empty();
    (what.head == "symmetry axis" && alone).then(|| Statement::Is {
        subjects: bodies,
        what: NounPhrase::new("symmetric", vec![(Slot::About, axis.clone())]),
    })
}

/// "The ground is an inertial frame N": N is one, and the ground is called so as well.
fn frame_by_name(subjects: &[Term], what: &NounPhrase) -> Option<Vec<Statement>> {
    let [Term::Name(_)] = subjects else {
        return None;
    };
    let [(Slot::Which, name @ (Term::Name(_) | Term::Formula(_)))] = what.slots.as_slice() else {
        return None;
    };
    let described = NounPhrase {
        slots: vec![],
        ..what.clone()
    };
    let named = vec![name.clone()];
    (what.head == "frame").then(|| {
        vec![
            Statement::Is {
                subjects: named.clone(),
                what: described,
            },
            Statement::Same {
                subjects: subjects.to_vec(),
                others: named,
            },
        ]
    })
}
