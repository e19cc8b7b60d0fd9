//! Rounded multiples of a symbol: `\omega = \sqrt{1.8}\,n \approx 1.34\,n`, which is decided as a line in numbers over n.

use crate::notation::ast::{Factor, Kind, Node, Operator};
use crate::verify::letters::usage::inner;
use crate::verify::lines::decimals::holds_decimals;

/// The sides of a line over the symbols that the decimal number on the last one multiplies.
pub(crate) fn over_common_symbols(sides: &[Node]) -> Option<Vec<Node>> {
    let (number, symbols) = multiple(sides.last()?)?;
    if !holds_decimals(&number) {
        return None;
    }
    let ratio = |side: &Node| Node {
        kind: Kind::Quotient(Box::new(side.clone()), Box::new(symbols.clone())),
        span: side.span,
    };
    let before = sides[..sides.len() - 1].iter().map(ratio);
    Some(before.chain([number]).collect())
}

/// A number, and the product of symbols that it multiplies.
fn multiple(side: &Node) -> Option<(Node, Node)> {
    let Kind::Product(factors) = &inner(side).kind else {
        return None;
    };
    let (number, symbols) = factors.split_first()?;
    let plain = |factor: &Factor| {
        is_made_of_symbols(&factor.node)
            && matches!(factor.operator, Operator::Juxtaposed | Operator::Dot)
    };
    if !matches!(number.node.kind, Kind::Number(_)) || !symbols.iter().all(plain) {
        return None;
    }
    let product = Node {
        kind: Kind::Product(symbols.to_vec()),
        span: side.span,
    };
    Some((number.node.clone(), product))
}

/// Whether a node is a product, quotient or power of symbols and whole numbers.
fn is_made_of_symbols(node: &Node) -> bool {
    match &node.kind {
        Kind::Symbol(_) | Kind::Number(_) => !holds_decimals(node),
        Kind::Product(_) | Kind::Quotient(..) | Kind::Power(..) | Kind::Group(..) => {
            node.children().all(is_made_of_symbols)
        }
        _ => false,
    }
}
