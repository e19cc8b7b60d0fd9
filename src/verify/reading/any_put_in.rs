//! Things put in the place of the names for which a sentence speaks of any.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::notation::print;
use crate::verify::language::indexed_lists::letter_and_index;
use crate::verify::language::statement::{Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::names::node_of;

/// What is the same as something else, whatever the things in its labels are.
const SHORTHAND: &str = "shorthand";

/// A statement with things in the place of the names for which it speaks of any.
pub(super) fn with_things(
    statement: &Statement,
    any: &[String],
    chosen: &[Term],
) -> Option<Statement> {
    let pairs: Vec<(&str, &Term)> = any.iter().map(String::as_str).zip(chosen).collect();
    let told = |slots: &[(Slot, Term)]| -> Option<Vec<(Slot, Term)>> {
        // Vectors and angles stay what they are: "for any frame X and any vector `$v$`".
        let letter = |term: &Term| {
            let index = letter_and_index(term).map(|(_, index)| index);
            matches!(term, Term::Formula(_)) && index.is_none_or(|index| !any.contains(&index))
        };
        let others = slots
            .iter()
            .filter(|(slot, term)| *slot != Slot::ForAny || letter(term));
        others
            .map(|(slot, term)| Some((*slot, with_names(term, &pairs)?)))
            .collect()
    };
    let subjects = |terms: &[Term]| -> Option<Vec<Term>> {
        terms.iter().map(|term| with_names(term, &pairs)).collect()
    };
    Some(match statement {
        Statement::Is { subjects: s, what } if what.head == SHORTHAND => Statement::Same {
            subjects: subjects(s)?,
            others: told(&what.slots)?
                .into_iter()
                .map(|(_, term)| term)
                .collect(),
        },
        Statement::Is { subjects: s, what } => Statement::Is {
            subjects: subjects(s)?,
            what: NounPhrase {
                slots: told(&what.slots)?,
                ..what.clone()
            },
        },
        Statement::Does {
            subjects: s,
            verb,
            slots,
        } => Statement::Does {
            subjects: subjects(s)?,
            verb,
            slots: told(slots)?,
        },
        _ => return None,
    })
}

fn with_names(term: &Term, pairs: &[(&str, &Term)]) -> Option<Term> {
    Some(match term {
        Term::Name(name) => {
            let chosen = pairs.iter().find(|(any, _)| any == name);
            chosen.map_or_else(|| term.clone(), |(_, thing)| (*thing).clone())
        }
        Term::Formula(formula) => {
            let mut node = node_of(formula)?.clone();
            let labels: Option<Vec<(&str, String)>> = pairs
                .iter()
                .map(|(any, thing)| Some((*any, label(thing)?)))
                .collect();
            relabel(&mut node, &labels?);
            Term::Formula(Formula {
                source: print::latex(&node),
                row: Row::Expression(node),
            })
        }
        Term::Phrase(phrase) => {
            let slots = phrase.slots.iter();
            let slots = slots.map(|(slot, term)| Some((*slot, with_names(term, pairs)?)));
            Term::Phrase(Box::new(NounPhrase {
                slots: slots.collect::<Option<_>>()?,
                ..(**phrase).clone()
            }))
        }
        other => other.clone(),
    })
}

/// A thing as it stands in a label.
fn label(thing: &Term) -> Option<String> {
    match thing {
        Term::Name(name) => Some(name.clone()),
        Term::Formula(formula) => match &node_of(formula)?.kind {
            Kind::Symbol(symbol) => {
                Some(symbol.name.clone() + &symbol.subscripts.concat() + &primes(symbol.primes))
            }
            _ => None,
        },
        _ => None,
    }
}

fn primes(count: u8) -> String {
    "'".repeat(usize::from(count))
}

/// Puts names in the place of others in the labels of a formula.
fn relabel(node: &mut Node, labels: &[(&str, String)]) {
    let put = |text: &mut String| {
        // Indices by Greek letters stand side by side as words: "betaalpha".
        if labels.iter().any(|(any, _)| any.chars().count() > 1) {
            *text = in_words(text, labels);
            return;
        }
        let alone = text.chars().count() == 1;
        let characters = text.chars().map(|c| {
            // An index is a label of its own, and no letter of a word.
            let stands = alone || !c.is_lowercase();
            let found = labels.iter().find(|(any, _)| stands && any.chars().eq([c]));
            found.map_or_else(|| c.to_string(), |(_, name)| name.clone())
        });
        *text = characters.collect();
    };
    match &mut node.kind {
        // A Greek letter at the upper right is read as an exponent where nothing is told of it.
        Kind::Power(_, exponent) => {
            if let Kind::Symbol(symbol) = &mut exponent.kind
                && let Some((_, name)) = labels.iter().find(|(any, _)| *any == symbol.name)
            {
                symbol.name.clone_from(name);
            }
        }
        Kind::Symbol(symbol) => {
            symbol.subscripts.iter_mut().for_each(put);
            symbol.superscripts.iter_mut().for_each(put);
        }
        Kind::InFrame(_, frame) => put(&mut frame.text),
        _ => {}
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| relabel(child, labels));
}

/// A label with names in the place of the words of others, the longest first.
fn in_words(text: &str, labels: &[(&str, String)]) -> String {
    let mut put = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let fitting = labels.iter().filter(|(any, _)| rest.starts_with(any));
        let (length, name) = match fitting.max_by_key(|(any, _)| any.len()) {
            Some((any, name)) => (any.len(), name.as_str()),
            None => (first.len_utf8(), &rest[..first.len_utf8()]),
        };
        put.push_str(name);
        rest = &rest[length..];
    }
    put
}
