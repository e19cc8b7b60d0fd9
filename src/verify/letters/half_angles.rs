//! Whether a document writes sines of halves of angles: only then are sin θ and cos θ made of those.

use crate::notation::ast::{Function, Kind, Node};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::inner;

/// Whether a fraction stands in the argument of a circular function anywhere.
pub(crate) fn writes_half_angles(document: &Document) -> bool {
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(formula),
        _ => None,
    });
    let mut rows = formulas.flat_map(|formula| &formula.rows);
    rows.any(|row| match row {
        Row::Line(line) => line.sides.iter().any(has_fraction_of_angle),
        Row::Expression(node) => has_fraction_of_angle(node),
        Row::Unreadable { .. } => false,
    })
}

fn has_fraction_of_angle(node: &Node) -> bool {
    let circular = |function: &Function| {
        use Function::{Cos, Cot, Csc, Sec, Sin, Tan};
        matches!(function, Sin | Cos | Tan | Cot | Sec | Csc)
    };
    match &inner(node).kind {
        Kind::Function(function, argument) if circular(function) => has_fraction(argument),
        _ => node.children().into_iter().any(has_fraction_of_angle),
    }
}

fn has_fraction(node: &Node) -> bool {
    let own = match &node.kind {
        Kind::Quotient(..) => true,
        Kind::Number(number) => !number.value.is_integer(),
        _ => false,
    };
    own || node.children().into_iter().any(has_fraction)
}
