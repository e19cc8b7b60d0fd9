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
        let base = match &factor.node.kind {
            Kind::Power(base, _) => base,
            _ => &factor.node,
        };
        matches!(base.kind, Kind::Symbol(_))
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
