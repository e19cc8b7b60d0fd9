//! Factors whose order counts, written the other way round.

use crate::notation::ast::{Factor, Kind, Node, Operator};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::repair::slips::Slips;
use crate::verify::values::quantity::Shape;

impl Slips<'_> {
    pub(crate) fn swapped(&mut self, factors: &[Factor]) {
        for pair in factors.windows(2) {
            let [first, second] = [&pair[0].node, &pair[1].node];
            let counts = [first, second].map(|node| is_matrix(self.reading, node));
            let (kind, message) = match pair[1].operator {
                Operator::Cross => ("cross-order", "the factors of × are swapped"),
                Operator::Tensor => ("factor-order", "the factors are swapped"),
                Operator::Juxtaposed if counts == [true; 2] => {
                    ("factor-order", "the factors are swapped")
                }
                _ => continue,
            };
            let [a, b] = [first, second].map(|node| self.source.slice(node.span));
            let sign = self.source.slice(pair[1].sign).trim();
            let text = match sign {
                "" => format!("{b} {a}"),
                _ => format!("{b} {sign} {a}"),
            };
            self.push(first.span.to(second.span), text, kind, 11, message);
        }
    }
}

/// Whether a factor is a matrix to see, or a symbol for one.
fn is_matrix(reading: &Reading, node: &Node) -> bool {
    match &inner(node).kind {
        Kind::Matrix(_) | Kind::Transpose(_) | Kind::Skew(_) => true,
        Kind::Symbol(symbol) => {
            let quantity = reading.quantities.get(&Letter::of(symbol));
            quantity.is_some_and(|q| !matches!(q.shape(), Shape::Scalar | Shape::Vector))
        }
        Kind::TimeDerivative { operand, .. } => is_matrix(reading, operand),
        _ => false,
    }
}
