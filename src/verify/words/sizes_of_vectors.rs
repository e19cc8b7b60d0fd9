//! Letters that words have for the length of a vector of the body: "the length ⟨h⟩ of the angular momentum".

use crate::notation::ast::{Kind, Symbol};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::verify::letters::usage::{Letter, Usage, inner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::lowered;
use std::collections::BTreeMap;

const SIZES: &[&str] = &["length", "magnitude", "size", "norm", "modulus"];
const VECTORS: &[(&str, Quantity)] = &[
    ("angular momentum", Quantity::Momentum),
    ("momentum vector", Quantity::Momentum),
    ("angular velocity", Quantity::AngularVelocity),
];

/// The letters, as far as none of them is a vector's too.
pub(crate) fn sizes_of_vectors(document: &Document, usage: &Usage) -> BTreeMap<Letter, Quantity> {
    let windows = document.items.windows(3);
    let named = windows.filter_map(|items| match items {
        [
            Item::Prose { text: before, .. },
            Item::Formula(formula),
            behind,
        ] => {
            let letter = letter(formula)?;
            let quantity = in_front(before, behind).or_else(|| behind_has(before))?;
            Some((letter, quantity))
        }
        _ => None,
    });
    let number = |letter: &Letter| {
        let used = usage.get(letter);
        used.vector + used.component == 0
    };
    named.filter(|(letter, _)| number(letter)).collect()
}

fn letter(formula: &Formula) -> Option<Letter> {
    let [Row::Expression(node)] = formula.rows.as_slice() else {
        return None;
    };
    match &inner(node).kind {
        Kind::Symbol(symbol) if is_bare(symbol) && !formula.display => Some(Letter::of(symbol)),
        _ => None,
    }
}

/// Whether a symbol is a letter without a mark.
pub(crate) fn is_bare(symbol: &Symbol) -> bool {
    let marked = symbol.style.vector || symbol.style.hat || symbol.style.bar || symbol.primes > 0;
    !marked && symbol.subscripts.is_empty() && symbol.superscripts.is_empty()
}

/// "The length ⟨h⟩ of the angular momentum".
fn in_front(before: &str, behind: &Item) -> Option<Quantity> {
    let Item::Prose { text: behind, .. } = behind else {
        return None;
    };
    let (before, behind) = (lowered(before), lowered(behind));
    let of = ["of the ", "of its ", "of the body's ", "of the total "];
    let rest = of
        .iter()
        .find_map(|words| behind.trim_start().strip_prefix(words))?;
    let vector = VECTORS.iter().find(|(name, _)| rest.starts_with(name))?;
    ends_with_size(&before).then_some(vector.1)
}

/// "The angular momentum has the length ⟨h⟩."
fn behind_has(before: &str) -> Option<Quantity> {
    let before = lowered(before);
    let clause = before.rsplit(['.', ';', ':', ',']).next()?;
    let (subject, rest) = clause.split_once(" has ")?;
    let vector = VECTORS
        .iter()
        .find(|(name, _)| subject.trim_end().ends_with(name))?;
    (ends_with_size(rest) && rest.split_whitespace().count() <= 3).then_some(vector.1)
}

fn ends_with_size(text: &str) -> bool {
    let last = text.split_whitespace().next_back();
    last.is_some_and(|word| SIZES.contains(&word))
}
