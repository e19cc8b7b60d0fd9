//! Index letters of a line: those that stand for each axis in turn, and those that are summed over.

use crate::notation::ast::{Kind, Node};
use crate::verify::term::indices::axis_letters;
use crate::verify::term::letters::{At, Letters};
use std::collections::BTreeMap;

/// The letters that a line holds for each of: all of them, or with the convention of sums those that stand alone in a
/// term.
pub(crate) fn free_letters(letters: &Letters, at: &At, sides: &[&Node]) -> Vec<String> {
    let mut free: Vec<String> = vec![];
    for side in sides {
        for term in terms(side) {
            for (letter, times) in axis_letters(letters, at, term) {
                if (!letters.summed || times == 1) && !free.contains(&letter) {
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
