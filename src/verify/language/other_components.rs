//! "`$\\omega$` is the second component of `$w$`, and the other two components are zero": which ones these are.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Puts the numbers of the other components in their place, by the sentence before.
pub(crate) fn number_other_components(declarations: &mut [Declaration]) {
    let mut before: Option<NounPhrase> = None;
    for declaration in declarations {
        if let Some((before, others)) = before.as_ref().zip(others_zero(&mut declaration.statement))
        {
            put_numbers(others, before);
        }
        before = match &declaration.statement {
            Statement::Is { what, .. } if what.head == "component" => Some(what.clone()),
            _ => None,
        };
    }
}

/// "the other two components", of which a sentence says that they are zero.
fn others_zero(statement: &mut Statement) -> Option<&mut NounPhrase> {
    let others = match statement {
        Statement::Premise(premise) if premise.is("zero") => premise,
        Statement::Is { subjects, what } if what.head == "zero" => match subjects.as_mut_slice() {
            [Term::Phrase(others)] => others.as_mut(),
            _ => return None,
        },
        _ => return None,
    };
    let counted = others.is("other") && others.head == "component" && !others.is("not");
    (counted && others.slot(Slot::Which).is_none()).then_some(others)
}

/// The components of the same vector that the sentence before does not name.
fn put_numbers(others: &mut NounPhrase, before: &NounPhrase) {
    let named: Option<Vec<usize>> = before
        .all(Slot::Which)
        .map(|number| match number {
            Term::Numbers(numbers) => numbers.first().copied().filter(|_| numbers.len() == 1),
            _ => None,
        })
        .collect();
    let Some(named) = named.filter(|named| !named.is_empty()) else {
        return;
    };
    let rest: Vec<usize> = (1..=3).filter(|number| !named.contains(number)).collect();
    let whose: Vec<(Slot, Term)> = before
        .slots
        .iter()
        .filter(|(slot, _)| *slot != Slot::Which)
        .cloned()
        .collect();
    let counted = match rest.len() {
        1 => !others.is("two"),
        2 => !others.is("one"),
        _ => false,
    };
    if counted && (others.slots.is_empty() || others.slots == whose) {
        others
            .adjectives
            .retain(|said| !["other", "two", "one"].contains(said));
        let numbers = rest
            .into_iter()
            .map(|number| (Slot::Which, Term::Numbers(vec![number])));
        others.slots = numbers.chain(whose).collect();
    }
}
