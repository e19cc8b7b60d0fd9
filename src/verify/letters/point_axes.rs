//! Axes that the text names by their origin too: "about ⟨Gz⟩", "the axis ⟨Ox⟩".

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::inner;

/// Letters of points.
const ORIGINS: &[&str] = &["G", "O", "C", "A", "P"];
const AXES: &[&str] = &["x", "y", "z"];

/// Writes the axis alone for the two letters, where they stand between words.
pub(crate) fn name_axes_alone(document: &mut Document) {
    for item in &mut document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        if let ([Row::Expression(node)], false) = (formula.rows.as_mut_slice(), formula.display)
            && let Some(axis) = axis_of(node)
        {
            node.kind = Kind::Symbol(Symbol {
                name: axis.to_owned(),
                ..Symbol::default()
            });
        }
    }
}

fn axis_of(node: &Node) -> Option<&'static str> {
    let Kind::Product(factors) = &inner(node).kind else {
        return None;
    };
    let [origin, axis] = factors.as_slice() else {
        return None;
    };
    let letter = |node: &Node, letters: &[&'static str]| match &node.kind {
        Kind::Symbol(symbol) if symbol.subscripts.is_empty() && symbol.primes == 0 => letters
            .iter()
            .copied()
            .find(|letter| *letter == symbol.name),
        _ => None,
    };
    letter(&origin.node, ORIGINS)?;
    letter(&axis.node, AXES)
}
