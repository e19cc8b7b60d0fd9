//! How the document writes each component, so that what is said about a line is said in its letters.

use crate::notation::ast::{Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::named_axes::written;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::symbols;
use crate::verify::values::atoms::Atoms;
use crate::verify::values::symbol::{Meaning, latex_name, meaning};

/// Notes the first spelling of every component that stands in a formula.
pub(super) fn spell(document: &Document, reading: &Reading, atoms: &mut Atoms) {
    let numbers = reading.usage.subscripts.values().flatten();
    let (mut digits, mut axes) = (0, 0);
    for subscript in numbers {
        digits += usize::from(matches!(subscript.as_str(), "1" | "2" | "3"));
        axes += usize::from(matches!(subscript.as_str(), "x" | "y" | "z"));
    }
    atoms.numbered = digits > axes;
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &formula.rows {
            let nodes: Vec<&Node> = match row {
                Row::Line(line) => line.sides.iter().collect(),
                Row::Expression(node) => vec![node],
                Row::Unreadable { .. } => vec![],
            };
            for symbol in nodes.into_iter().flat_map(symbols) {
                if let Meaning::Component(entity, component) = meaning(symbol, reading, atoms) {
                    atoms.spell(entity, component, || latex(symbol, reading));
                }
            }
        }
    }
}

/// A symbol in LaTeX, marks of a vector left off.
fn latex(symbol: &Symbol, reading: &Reading) -> String {
    let mut text = latex_name(&symbol.name);
    if symbol.style.calligraphic {
        text = format!("\\mathcal{{{text}}}");
    }
    if symbol.style.hat {
        text = format!("\\hat{{{text}}}");
    }
    if symbol.variation {
        text = format!("\\delta {text}");
    }
    let index = symbol.subscripts.join(",");
    let index = match &reading.axis_labels {
        Some(labels) => written(&index, labels),
        None => index,
    };
    match index.chars().count() {
        0 => {}
        1 => text.push_str(&format!("_{index}")),
        _ => text.push_str(&format!("_{{{index}}}")),
    }
    text
}
