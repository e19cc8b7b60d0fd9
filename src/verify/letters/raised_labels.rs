//! Labels that are written where a power stands: `\omega^b` on the axes of the body.
//!
//! A vector has no power but its square, so a letter over an ω is a label, and so is the same letter over others. It is put
//! where labels stand elsewhere, under the symbol.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::raised::raised;
use std::collections::BTreeSet;

/// Letters of frames; an n or a k counts steps.
const LABELS: &[&str] = &["b", "s", "e", "w", "o", "a"];

/// Puts labels that stand where powers do under their symbols.
pub(crate) fn lower_labels(document: &mut Document) {
    let mut labels = BTreeSet::new();
    document
        .lines()
        .flat_map(|line| &line.sides)
        .for_each(|side| note(side, &mut labels));
    // Where several are, what stands without one may be on any axes.
    if labels.len() == 1 {
        formulas_mut(document).for_each(|node| lower(node, &labels));
    }
}

/// Notes the labels over an ω.
fn note(node: &Node, labels: &mut BTreeSet<String>) {
    if let Some((symbol, label)) = labelled(node)
        && LABELS.contains(&label.as_str())
        && matches!(symbol.name.as_str(), "omega" | "Omega")
        && symbol.subscripts.is_empty()
    {
        labels.insert(label);
    }
    node.children().for_each(|child| note(child, labels));
}

fn lower(node: &mut Node, labels: &BTreeSet<String>) {
    if let Some((_, label)) = labelled(node).filter(|(_, label)| labels.contains(label))
        && let Kind::Power(base, _) = &mut node.kind
    {
        base.change_symbols(&mut |symbol| {
            match symbol.name.as_str() {
                "omega" | "Omega" => symbol.style.vector = true,
                "I" | "J" => symbol.style.tensor = true,
                _ => {}
            }
            symbol.subscripts.push(label.clone());
        });
        node.kind = base.kind.clone();
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| lower(child, labels));
}

/// A symbol and the letter over it.
fn labelled(node: &Node) -> Option<(&Symbol, String)> {
    let (symbol, exponent) = raised(node)?;
    Some((symbol, letter(exponent)?.to_owned()))
}

/// A lone lower-case letter of the alphabet.
fn letter(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::Symbol(symbol)
            if symbol.subscripts.is_empty()
                && symbol.superscripts.is_empty()
                && symbol.name.len() == 1
                && symbol.name.chars().all(|c| c.is_ascii_lowercase()) =>
        {
            Some(&symbol.name)
        }
        _ => None,
    }
}
