//! Arrays that are written out: "`$(p, q, r)^T$` is the angular velocity of B" says what p, q and r are.

use super::heads::{QUATERNION, SCALAR_FIRST, SCALAR_LAST, SCALAR_PART, VECTOR_PART};
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;

/// Nouns that are said of several letters.
const LISTED: [&str; 6] = [
    "principal moments",
    "products of inertia",
    "component",
    "entry",
    "Euler angles",
    "axes",
];

/// Parts what is said of an array into what is said of its entries; "`$\omega = (p, q, r)$` is …" says it of the letter as
/// well.
pub(crate) fn tell_entries(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        // "the other entries": besides those on the diagonal.
        if what.head == "entry" && subjects.len() > 1 {
            what.adjectives.retain(|said| *said != "other");
        }
        let [Term::Formula(formula)] = subjects.as_slice() else {
            return vec![];
        };
        let Some(entries) = array_in(formula).and_then(entries_of) else {
            return vec![];
        };
        let entries = entries.iter().map(|node| Term::Formula(Formula::of(node)));
        // "`$(A, A, C)$` are the principal moments": what is said of several is said of them.
        if LISTED.contains(&what.head) {
            *subjects = entries.collect();
            return vec![];
        }
        let of_entries = Statement::Is {
            subjects: entries.collect(),
            what: component_of(what),
        };
        match letter_in(formula) {
            Some(letter) => {
                *subjects = vec![Term::Formula(letter)];
                vec![of_entries]
            }
            None => {
                *statement = of_entries;
                vec![]
            }
        }
    });
}

/// "`$q = (q_0, q_1, q_2, q_3)$` takes components on B to components on N": q does, and the others are its components. Those
/// of "`$(q_0, v)$` …, scalar first" are the scalar part and the vector part.
pub(crate) fn tell_parts(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Does {
            subjects,
            verb: "take",
            slots,
        } = statement
        else {
            return vec![];
        };
        let formula = match subjects.as_slice() {
            [subject] => written(subject),
            _ => None,
        };
        if let Some((letter, parts)) = formula.and_then(|formula| two_parts(formula, slots)) {
            return match letter {
                Some(letter) => {
                    *subjects = vec![letter];
                    parts.into()
                }
                None => {
                    let [first, second] = parts;
                    *statement = first;
                    vec![second]
                }
            };
        }
        let parts = formula
            .and_then(|formula| Some((letter_in(formula)?, array_in(formula).and_then(row_in)?)));
        let Some((letter, entries)) = parts else {
            return vec![];
        };
        let entries = entries.into_iter().map(Formula::of).map(Term::Formula);
        let entries = entries.collect();
        let letter = Term::Formula(letter);
        let of = vec![(Slot::Of, letter.clone())];
        *subjects = vec![letter];
        vec![Statement::Is {
            subjects: entries,
            what: NounPhrase::new("component", of),
        }]
    });
}

/// The scalar part and the vector part of a quaternion that is written as two, and the letter that it has besides. One
/// without a letter is that of what it takes components from, relative to what it takes them to.
fn two_parts(formula: &Formula, slots: &[(Slot, Term)]) -> Option<(Option<Term>, [Statement; 2])> {
    let row = array_in(formula).and_then(row_in)?;
    let [first, second] = row.as_slice() else {
        return None;
    };
    let said = |head: &str| {
        let mut terms = slots.iter().map(|(_, term)| term);
        terms.any(|term| matches!(term, Term::Phrase(adverb) if adverb.head == head))
    };
    let (scalar, vector) = match (said(SCALAR_FIRST), said(SCALAR_LAST)) {
        (true, false) => (first, second),
        (false, true) => (second, first),
        _ => return None,
    };
    let letter = letter_in(formula).map(Term::Formula);
    let of = match &letter {
        Some(letter) => letter.clone(),
        None => {
            let end = |wanted: Slot| slots.iter().find(|(slot, _)| *slot == wanted).cloned();
            let ends = [end(Slot::From)?.1, end(Slot::To)?.1];
            let [from, to] = ends;
            let slots = vec![(Slot::Of, from), (Slot::RelativeTo, to)];
            Term::Phrase(Box::new(NounPhrase::new(QUATERNION, slots)))
        }
    };
    let part = |node: &Node, head| Statement::Is {
        subjects: vec![Term::Formula(Formula::of(node))],
        what: NounPhrase::new(head, vec![(Slot::Of, of.clone())]),
    };
    Some((
        letter,
        [part(scalar, SCALAR_PART), part(vector, VECTOR_PART)],
    ))
}

/// A formula, and that of "the quaternion `$q$`".
fn written(term: &Term) -> Option<&Formula> {
    match term {
        Term::Formula(formula) => Some(formula),
        Term::Phrase(phrase) => match phrase.slots.as_slice() {
            [(Slot::Which, Term::Formula(formula))] => Some(formula),
            _ => None,
        },
        _ => None,
    }
}

/// "the components of the angular velocity of B on B"
fn component_of(what: &NounPhrase) -> NounPhrase {
    let (on, own) = what
        .slots
        .iter()
        .cloned()
        .partition(|(slot, _)| *slot == Slot::On);
    let of = NounPhrase {
        slots: own,
        ..what.clone()
    };
    let mut slots = vec![(Slot::Of, Term::Phrase(Box::new(of)))];
    slots.extend::<Vec<_>>(on);
    NounPhrase::new("component", slots)
}

/// The array that a formula is, or that it says its letter to be.
fn array_in(formula: &Formula) -> Option<&Node> {
    match &formula.row {
        Row::Expression(node) => Some(node),
        Row::Line(line) => line.sides.last().filter(|_| line.sides.len() == 2),
        Row::Unreadable { .. } => None,
    }
}

fn letter_in(formula: &Formula) -> Option<Formula> {
    match &formula.row {
        Row::Line(line) => line.sides.first().map(Formula::of),
        _ => None,
    }
}

/// The three entries of a row or a column.
fn entries_of(node: &Node) -> Option<Vec<&Node>> {
    row_in(node).filter(|entries| entries.len() == 3)
}

/// The entries of a row or a column.
fn row_in(node: &Node) -> Option<Vec<&Node>> {
    match &node.kind {
        Kind::Transpose(inner) | Kind::Group(_, inner) => row_in(inner),
        Kind::Tuple(entries) => Some(entries.iter().collect()),
        Kind::Matrix(rows) => {
            let one = rows.len() == 1 || rows.iter().all(|row| row.len() == 1);
            one.then(|| rows.iter().flatten().collect())
        }
        _ => None,
    }
}
