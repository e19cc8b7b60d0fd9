//! Index letters of a line: those that stand for each axis in turn, and those that are summed over.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::standing::chains::Link;
use crate::verify::term::indices::{axis_letters, with_number};
use crate::verify::term::letters::{At, Letters, spell};
use std::collections::{BTreeMap, BTreeSet};

/// The letters that a line holds for each of: all of them, or with the convention of sums those that stand alone in a
/// term.
pub(crate) fn free_letters(letters: &Letters, at: &At, sides: &[&Node]) -> Vec<String> {
    let mut free: Vec<String> = vec![];
    if letters.indices.is_empty() {
        return free;
    }
    for side in sides {
        for term in terms(side) {
            for (letter, times) in axis_letters(letters, at, term) {
                if (!letters.customs.sums_at(at) || times == 1) && !free.contains(&letter) {
                    free.push(letter);
                }
            }
        }
    }
    free
}

fn terms(node: &Node) -> Vec<&Node> {
    match &node.kind {
        Kind::Sum(terms) => terms.iter().map(|t| &t.node).collect(),
        Kind::Negate(inner) => terms(inner),
        _ => vec![node],
    }
}

/// Every way to give each letter an axis.
pub(crate) fn assignments(free: &[String]) -> Vec<BTreeMap<String, usize>> {
    let mut all = vec![BTreeMap::new()];
    for letter in free.iter().take(4) {
        all = all
            .into_iter()
            .flat_map(|known| {
                (0..3).map(move |axis| {
                    let mut next = known.clone();
                    next.insert(letter.clone(), axis);
                    next
                })
            })
            .collect();
    }
    all
}

/// Whether one side is a matrix by its entries between brackets, `(a_{ij})`, and the other has no index.
pub(crate) fn by_entries(letters: &Letters, at: &At, link: &Link<'_>) -> bool {
    let indexed = |side: &Node| !free_letters(letters, at, &[side]).is_empty();
    let bracketed = |side: &Node| matches!(side.kind, Kind::Group(..)) && indexed(side);
    bracketed(&link.left) && !indexed(&link.right) || bracketed(&link.right) && !indexed(&link.left)
}

/// Letters of custom for the axes 1, 2, 3, one behind the other.
const CUSTOMARY: [&str; 3] = ["i", "j", "k"];

/// The ways to read `i`, `j` and `k` in cyclic order, where no sentence says what they number: as the numbers of letters
/// that are told with 1, 2 and 3.
pub(crate) fn cyclic_assignments(
    letters: &Letters,
    at: &At,
    sides: &[&Node],
) -> Option<Vec<BTreeMap<String, usize>>> {
    let mut numbered = BTreeSet::new();
    for side in sides {
        numbers(letters, at, side, &mut numbered)?;
    }
    let turned = |shift: usize| {
        let letters = CUSTOMARY.iter().enumerate();
        letters.map(move |(at, letter)| ((*letter).to_owned(), (at + shift) % 3))
    };
    let all = numbered.len() == CUSTOMARY.len();
    all.then(|| (0..3).map(|shift| turned(shift).collect()).collect())
}

/// Collects the letters that number others; `None` where one has another meaning, or what it numbers is not told.
fn numbers(letters: &Letters, at: &At, node: &Node, found: &mut BTreeSet<String>) -> Option<()> {
    if let Kind::Symbol(symbol) = &node.kind
        && let Some(last) = symbol.subscripts.last()
        && CUSTOMARY.contains(&last.as_str())
    {
        let told = |other: &Symbol| letters.find(&spell(other, true), &spell(other, false), at, 0);
        let one = |number: &str| told(&with_number(symbol, number)).is_some();
        let own = told(symbol).is_some() || letters.index(last, at).is_some();
        if own || !["1", "2", "3"].into_iter().all(one) {
            return None;
        }
        found.insert(last.clone());
    }
    if matches!(node.kind, Kind::IndexedSum { .. }) {
        return None;
    }
    node.children()
        .try_for_each(|child| numbers(letters, at, child, found))
}
