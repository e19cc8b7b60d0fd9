//! What a sentence that nothing was made of may change, and which one tells where an angle is zero.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::verify::language::is_quantity;
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term, Touched};
use crate::verify::reading::names::{letter_of, node_of, nodes_of};
use crate::verify::reading::unused::{Touches, carries};
use crate::verify::term::letters::{letter_names, spelled};
use std::collections::BTreeSet;

/// Verbs of how something lies.
const LYING: [&str; 4] = ["hang", "point", "lie", "incline"];

/// Commands that only set how a formula looks.
const LOOKS: [&str; 12] = [
    "\\left",
    "\\right",
    "\\mathbf",
    "\\mathrm",
    "\\boldsymbol",
    "\\text",
    "\\vec",
    "\\hat",
    "\\big",
    "\\Big",
    "\\quad",
    "\\",
];

/// What a sentence that was not read may change. What a rule for a sign changes in the formulas of other sentences reaches
/// all lines.
pub(super) fn touched_by(statement: &Statement, others: &[Declaration]) -> Touches {
    let Statement::Unread { touched, .. } = statement else {
        if let Statement::Notation { sign, .. } = statement {
            return Touches::Signs(vec![sign.clone()]);
        }
        let formulas = statement.formulas().into_iter();
        if matches!(statement, Statement::Is { .. }) {
            // "The spin is constant": any letter may be that of the quantity.
            let unnamed = |term: &Term| match term {
                Term::Phrase(phrase) => is_quantity(phrase.head) && letter_of(term).is_none(),
                _ => false,
            };
            if statement.subjects().iter().any(unnamed) {
                return Touches::Everything;
            }
            let subjects = statement.subjects().iter().filter_map(letter_of);
            return Touches::Written(subjects.flat_map(nodes_of).map(spelled).collect());
        }
        return Touches::Letters {
            names: formulas.flat_map(nodes_of).flat_map(letter_names).collect(),
            wholes: vec![],
            anew: true,
        };
    };
    match touched {
        Touched::Letters { formulas, anew } => {
            let each: Option<Vec<BTreeSet<String>>> = formulas.iter().map(letters_in).collect();
            each.map_or_else(
                || by_words(formulas),
                |each| {
                    // A letter alone has no parts that could tell what it is.
                    let wholes = formulas.iter().filter_map(node_of);
                    let wholes = wholes.filter(|node| !is_bare(node));
                    Touches::Letters {
                        names: each.into_iter().flatten().collect(),
                        wholes: wholes.map(spelled).collect(),
                        anew: *anew,
                    }
                },
            )
        }
        Touched::Written(formulas) => {
            Touches::Written(formulas.iter().flat_map(nodes_of).map(spelled).collect())
        }
        Touched::Signs(signs) => {
            let holding = others.iter().filter_map(|other| match &other.statement {
                Statement::Holds(formula) => Some(formula),
                _ => None,
            });
            let mut sides = holding.flat_map(nodes_of);
            match sides.any(|side| signs.iter().any(|sign| carries(side, sign))) {
                true => Touches::Everything,
                false => Touches::Signs(signs.clone()),
            }
        }
        Touched::Words(words) => Touches::Words(words.clone()),
        Touched::WrittenSigns(signs) => Touches::WrittenSigns(signs.clone()),
        Touched::Everything => Touches::Everything,
    }
}

/// Formulas of which one is not read may change what carries a word of them.
fn by_words(formulas: &[Formula]) -> Touches {
    let words = formulas
        .iter()
        .flat_map(|formula| words_of(&formula.source));
    let words: Vec<String> = words.collect();
    match words.is_empty() {
        true => Touches::Everything,
        false => Touches::Words(words),
    }
}

/// The letters, words and commands of a formula, without those that only set how it looks.
fn words_of(source: &str) -> Vec<String> {
    let mut words = vec![];
    let mut rest = source;
    while let Some(start) = rest.find(|c: char| c.is_alphabetic() || c == '\\') {
        let behind = &rest[start..];
        let own = behind.chars().skip(1).take_while(|c| c.is_alphabetic());
        let first = behind.chars().next().map_or(0, char::len_utf8);
        let end = first + own.map(char::len_utf8).sum::<usize>();
        words.push(behind[..end].to_owned());
        rest = &behind[end..];
    }
    words.retain(|word| !LOOKS.contains(&word.as_str()));
    words
}

/// Whether a formula is a letter without labels and marks.
fn is_bare(node: &Node) -> bool {
    match &node.kind {
        Kind::Symbol(symbol) => {
            let scripts = symbol.subscripts.len() + symbol.superscripts.len();
            scripts == 0 && symbol.primes == 0 && !symbol.style.tilde && !symbol.style.hat
        }
        _ => false,
    }
}

/// Whether it tells what nothing else does: how something lies where an angle is zero, between what an angle is, how something
/// is measured, or that letters are not what they are by custom. That one is not constant, or not small, only adds.
pub(super) fn tells_anew(statement: &Statement) -> bool {
    let (verb, slots) = match statement {
        Statement::Does { verb, slots, .. } => (verb, slots),
        Statement::Is { what, .. } => {
            return what.head == "angle" && !what.slots.is_empty()
                || what.head == "measured"
                || what.is("not") && !["constant", "small", "zero"].contains(&what.head);
        }
        _ => return false,
    };
    let of_time = |formula: &Formula| letters_in(formula).is_none_or(|all| all.contains("t"));
    let at = |(_, term): &(Slot, Term)| match term {
        Term::Formula(formula) => term.is_condition() && !of_time(formula),
        _ => false,
    };
    LYING.contains(verb) && slots.iter().any(at)
}

fn letters_in(formula: &Formula) -> Option<BTreeSet<String>> {
    let readable = !matches!(formula.row, Row::Unreadable { .. });
    readable.then(|| nodes_of(formula).iter().flat_map(letter_names).collect())
}
