//! An angular velocity that turns the attitude matrix from the left, `\dot R = [\omega]_\times R`: in a document that says
//! nothing of its axes, and never writes it with the body's tensor, it stands on the axes that R leads to.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::words::book::has_any;

/// Words that put it on the body.
const ON_BODY: &[&str] = &["body rate", "body angular velocity", "body-fixed angular"];

/// Whether the lines show it, for the letter of the matrix.
pub(crate) fn turns_from_left(document: &Document, matrix: &Letter) -> bool {
    let mut found = false;
    for line in document.lines() {
        let met: Vec<&Symbol> = line.sides.iter().flat_map(symbols).collect();
        let rate = |s: &&Symbol| s.name == "omega";
        let tensor = |s: &&Symbol| matches!(s.name.as_str(), "I" | "J") && s.subscripts.is_empty();
        if met.iter().any(rate) && met.iter().any(tensor) {
            return false;
        }
        match line.sides.as_slice() {
            [left, right] if is_rate(left, matrix) => match order(right, matrix) {
                Some(from_left) => found = from_left,
                None => return false,
            },
            _ => {}
        }
        if !found && line.sides.iter().any(|side| is_rate(side, matrix)) {
            return false;
        }
    }
    found && !has_any(&document.source.text.to_lowercase(), ON_BODY)
}

/// `\dot R`.
fn is_rate(side: &Node, matrix: &Letter) -> bool {
    match &inner(side).kind {
        Kind::TimeDerivative {
            operand, order: 1, ..
        } => is_matrix(operand, matrix),
        _ => false,
    }
}

fn is_matrix(node: &Node, matrix: &Letter) -> bool {
    matches!(&inner(node).kind, Kind::Symbol(s) if Letter::of(s) == *matrix && s.subscripts.is_empty())
}

/// Whether ω stands on the left of R in a product of its matrix and R.
fn order(side: &Node, matrix: &Letter) -> Option<bool> {
    let Kind::Product(factors) = &inner(side).kind else {
        return None;
    };
    let [first, second] = factors.as_slice() else {
        return None;
    };
    let skew = |node: &Node| matches!(&node.kind, Kind::Skew(inside) if symbols(inside).iter().all(|s| s.name == "omega"));
    if skew(&first.node) && is_matrix(&second.node, matrix) {
        return Some(true);
    }
    (is_matrix(&first.node, matrix) && skew(&second.node)).then_some(false)
}
