//! Parts that are counted in one sentence and named in others: "the body consists of two particles; P and Q are particles".

use super::counted::{count_of_part, without_counts};
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Puts the names in the place of the count, where as many things are said to be of this noun.
pub(super) fn name_counted(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for at in 0..declarations.len() {
        let Some((_, parts)) = declarations[at].statement.does("consist") else {
            continue;
        };
        let named = parts.iter().map(|(_, part)| named(part, declarations));
        let named: Vec<Option<(Vec<Term>, NounPhrase)>> = named.collect();
        let own = declarations[at].clone();
        let Statement::Does { slots, .. } = &mut declarations[at].statement else {
            continue;
        };
        let parts = slots.iter().zip(&named);
        let parts = parts.flat_map(|(part, named)| match named {
            Some((names, _)) => names.iter().map(|n| (Slot::Of, n.clone())).collect(),
            None => vec![part.clone()],
        });
        *slots = parts.collect();
        for (subjects, what) in named.into_iter().flatten() {
            if !what.slots.is_empty() || !what.adjectives.is_empty() {
                told.push(own.saying(Statement::Is { subjects, what }));
            }
        }
    }
    declarations.extend(told);
}

/// The names of the things that a part counts, and what that says of each.
fn named(part: &Term, declarations: &[Declaration]) -> Option<(Vec<Term>, NounPhrase)> {
    let (count, part) = count_of_part(part)?;
    let names = named_things(part.head, declarations);
    let mut what = part.clone();
    without_counts(&mut what);
    (names.len() == count).then_some((names, what))
}

/// The things that sentences say to be one of a noun, by names of their own: "P is a particle of mass `$m$`".
pub(super) fn named_things(noun: &str, declarations: &[Declaration]) -> Vec<Term> {
    let mut named: Vec<Term> = vec![];
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        for subject in subjects.iter().filter(|_| what.head == noun) {
            let proper = |name: &str| name.starts_with(char::is_uppercase);
            let own = match subject {
                Term::Name(name) => proper(name),
                Term::Formula(letter) => proper(&letter.source),
                _ => false,
            };
            if own && !named.contains(subject) {
                named.push(subject.clone());
            }
        }
    }
    named
}
