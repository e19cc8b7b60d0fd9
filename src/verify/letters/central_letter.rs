//! A letter of its own for the tensor about the mass centre, `I_{xx} = J_{xx} + m(b^2 + c^2)`: it is read as the bar of the
//! other, `\bar I_{xx}`, which the parallel-axis theorem knows.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Item};
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::{axes, inner, symbols};
use crate::verify::words::book::{has_any, lowered};

/// Letters of tensors of inertia.
const TENSORS: &[&str] = &["I", "J", "K", "Theta", "C"];
/// Names of the mass centre.
const CENTRE: &[&str] = &[
    "mass centre",
    "mass center",
    "centre of mass",
    "center of mass",
    "centroid",
];

/// Writes the bar of the one letter for the other, in a document that speaks of the mass centre.
pub(crate) fn bar_central_letter(document: &mut Document) {
    let speaks = document.items.iter().any(|item| match item {
        Item::Prose { text, .. } => has_any(&lowered(text), CENTRE),
        _ => false,
    });
    let Some((whole, central)) = document.lines().find_map(shifted).filter(|_| speaks) else {
        return;
    };
    let bars = |s: &&Symbol| s.style.bar && (s.name == whole || s.name == central);
    let labelled = |s: &&Symbol| s.name == central && !s.superscripts.is_empty();
    let met = every_symbol(document);
    if met.iter().any(|s| bars(s) || labelled(s)) {
        return;
    }
    for node in formulas_mut(document) {
        node.change_symbols(&mut |symbol| {
            if symbol.name == central {
                symbol.name.clone_from(&whole);
                symbol.style.bar = true;
            }
        });
    }
}

/// The letters of an entry and of the same one about the mass centre, of a line that adds what has a mass in it.
fn shifted(line: &Line) -> Option<(String, String)> {
    let [left, right] = line.sides.as_slice() else {
        return None;
    };
    let whole = entry(left)?;
    let Kind::Sum(terms) = &inner(right).kind else {
        return None;
    };
    let mut own = terms.iter().filter(|term| !term.negative);
    let central =
        own.find_map(|term| entry(&term.node).filter(|s| s.subscripts == whole.subscripts))?;
    let mass = |s: &&Symbol| matches!(s.name.as_str(), "m" | "M");
    let heavy = terms
        .iter()
        .any(|term| symbols(&term.node).iter().any(mass));
    (heavy && central.name != whole.name).then(|| (whole.name.clone(), central.name.clone()))
}

fn entry(node: &Node) -> Option<&Symbol> {
    let Kind::Symbol(symbol) = &inner(node).kind else {
        return None;
    };
    let tensor = TENSORS.contains(&symbol.name.as_str()) && symbol.superscripts.is_empty();
    let double = matches!(symbol.subscripts.as_slice(), [only] if axes(only).is_some());
    (tensor && double).then_some(symbol)
}
