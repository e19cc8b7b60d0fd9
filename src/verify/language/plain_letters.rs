//! Letters that stand in a sentence as they are, without the signs of a formula: "m is the mass of the disc".

use super::heads::UNIT_VECTOR;
use super::lexicon::{Class, Lexicon};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::{is_body, is_thing};
use crate::notation::Macros;
use crate::notation::ast::Kind;
use crate::notation::document::Row;
use std::collections::BTreeSet;

/// What is said of letters alone, beside the quantities that they are.
const OF_LETTERS: [&str; 5] = ["constant", "positive", "negative", "small", "nonzero"];

/// What is said of letters and of things.
const OF_BOTH: [&str; 2] = ["fixed", "orthogonal"];

/// Puts formulas in the places of names that sentences say to be quantities, where none says that they are things.
pub(crate) fn write_letters(declarations: &mut [Declaration], lexicon: &Lexicon, macros: &Macros) {
    let mut letters = BTreeSet::new();
    let mut things = BTreeSet::new();
    for declaration in declarations.iter() {
        if let Statement::Is { subjects, what } = &declaration.statement {
            let names = subjects.iter().filter_map(name);
            match is_quantity(what, lexicon) {
                true => letters.extend(names),
                false if OF_BOTH.contains(&what.head) => {}
                false => things.extend(names),
            }
        }
        for term in declaration.statement.terms() {
            letters.extend(called(term, lexicon));
            things.extend(things_in(term));
        }
    }
    letters.retain(|letter| !things.contains(letter));
    for declaration in declarations {
        for term in declaration.statement.terms_mut() {
            write(term, &letters, macros);
        }
    }
}

/// Whether a noun says what a letter is: a quantity, that it does not change, or a unit vector of which other sentences tell
/// where it points.
fn is_quantity(what: &NounPhrase, lexicon: &Lexicon) -> bool {
    let direction = what.head == UNIT_VECTOR && what.slots.is_empty();
    direction
        || lexicon.entry(what.head, &[Class::Noun]).is_some()
        || OF_LETTERS.contains(&what.head)
}

/// "the mass m": the names of a quantity.
fn called(term: &Term, lexicon: &Lexicon) -> Vec<String> {
    match term {
        Term::Phrase(phrase) if lexicon.entry(phrase.head, &[Class::Noun]).is_some() => {
            phrase.all(Slot::Which).filter_map(name).collect()
        }
        _ => vec![],
    }
}

/// What something is fixed in, relative to or from is a thing.
fn things_in(term: &Term) -> Vec<String> {
    match term {
        Term::Phrase(phrase) => {
            let placed = [Slot::FixedIn, Slot::RelativeTo, Slot::From, Slot::SeenFrom];
            let slots = phrase.slots.iter();
            let things = slots.filter(|(slot, _)| placed.contains(slot));
            things.filter_map(|(_, term)| name(term)).collect()
        }
        _ => vec![],
    }
}

fn name(term: &Term) -> Option<String> {
    match term {
        Term::Name(name) => Some(name.clone()),
        _ => None,
    }
}

fn write(term: &mut Term, letters: &BTreeSet<String>, macros: &Macros) {
    match term {
        Term::Name(letter) if letters.contains(letter) => {
            if let Some(formula) = formula(letter, true, macros) {
                *term = Term::Formula(formula);
            }
        }
        Term::Phrase(phrase) => {
            let slots = phrase.slots.iter_mut();
            slots.for_each(|(_, inner)| write(inner, letters, macros));
        }
        _ => {}
    }
}

/// "`$b_1$` is a rigid body": the letter is a name, as it is without the signs of a formula, where it is no quantity as well.
pub(crate) fn name_bodies(declarations: &mut [Declaration]) {
    let said = |body: bool| {
        let said = declarations.iter().filter_map(move |d| match &d.statement {
            Statement::Is { subjects, what } => {
                let named = is_body(what.head) && !PARTS.contains(&what.head);
                (if body { named } else { !is_thing(what.head) }).then_some(subjects)
            }
            _ => None,
        });
        said.flatten()
            .filter_map(letter_name)
            .collect::<BTreeSet<String>>()
    };
    let names: BTreeSet<String> = said(true).difference(&said(false)).cloned().collect();
    for declaration in declarations.iter_mut() {
        let terms = declaration.statement.terms_mut().into_iter();
        terms.for_each(|term| name_body(term, &names));
    }
}

/// Bodies whose letters are those of points and masses as well.
const PARTS: [&str; 4] = ["particle", "element", "bead", "bob"];

fn name_body(term: &mut Term, names: &BTreeSet<String>) {
    if let Some(name) = letter_name(term).filter(|name| names.contains(name)) {
        *term = Term::Name(name);
    } else if let Term::Phrase(phrase) = term {
        let inner = phrase.slots.iter_mut();
        inner.for_each(|(_, term)| name_body(term, names));
    }
}

/// A letter with its labels, without marks.
fn letter_name(term: &Term) -> Option<String> {
    let Term::Formula(Formula {
        row: Row::Expression(node),
        ..
    }) = term
    else {
        return None;
    };
    let Kind::Symbol(symbol) = &node.kind else {
        return None;
    };
    let style = &symbol.style;
    let marked = style.calligraphic || style.hat || style.tilde || symbol.primes > 0;
    let plain = !marked && symbol.superscripts.is_empty();
    let labels = symbol.subscripts.iter().map(|label| format!("_{label}"));
    plain.then(|| std::iter::once(symbol.name.clone()).chain(labels).collect())
}
