//! Whether a formula writes a thing, or is a way to write things.

use super::statement::Formula;
use crate::notation::ast::{Kind as Tree, Node, Operator};
use crate::notation::document::Row;

/// Whether a formula writes one thing, and is no way to write things: letters and numbers, and what is made of them.
pub(super) fn is_of_one_thing(formula: &Formula) -> bool {
    matches!(&formula.row, Row::Expression(node) if is_made_of_letters(node))
}

pub(super) fn is_letter(formula: &Formula) -> bool {
    matches!(&formula.row, Row::Expression(node) if matches!(node.kind, Tree::Symbol(_)))
}

fn is_made_of_letters(node: &Node) -> bool {
    let own = match &node.kind {
        Tree::Product(factors) => factors.iter().all(|f| f.operator == Operator::Juxtaposed),
        Tree::TimeDerivative { .. } | Tree::Derivative { .. } | Tree::Skew(_) | Tree::Error(_) => {
            false
        }
        Tree::Function(..) | Tree::Integral { .. } | Tree::IndexedSum { .. } => false,
        _ => true,
    };
    own && node.children().all(is_made_of_letters)
}
