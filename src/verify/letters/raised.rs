//! Symbols under a power.

use crate::notation::ast::{Kind, Node, Symbol};

/// A symbol, with a mark on it or without, that stands under a power, and the exponent.
pub(crate) fn raised(node: &Node) -> Option<(&Symbol, &Node)> {
    let Kind::Power(base, exponent) = &node.kind else {
        return None;
    };
    let base = match &base.kind {
        Kind::TimeDerivative { operand, .. } | Kind::Skew(operand) => operand,
        _ => base,
    };
    match &base.kind {
        Kind::Symbol(symbol) => Some((symbol, exponent)),
        _ => None,
    }
}
