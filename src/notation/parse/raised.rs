//! What signs at the upper right make of what they stand on: a cross, a vee, a square of the tensor product.

use crate::notation::ast::{Factor, Function, Kind, Node, Operator};
use crate::source::Span;

/// `a^{\otimes 2}`: a ⊗ a.
pub(super) fn tensor_square(node: Node) -> Node {
    let span = node.span;
    let sign = Span {
        start: span.end,
        end: span.end,
    };
    let factor = |operator| Factor {
        operator,
        sign,
        node: node.clone(),
    };
    let factors = [Operator::Juxtaposed, Operator::Tensor].map(factor);
    Node {
        kind: Kind::Product(factors.into()),
        span,
    }
}

pub(super) fn wrap(node: Node, kind: impl FnOnce(Box<Node>) -> Kind) -> Node {
    let span = node.span;
    Node {
        kind: kind(Box::new(node)),
        span,
    }
}

/// `[a]_\times`: the skew matrix of a, the bracket being part of the mark.
pub(super) fn skew(node: Node) -> Node {
    let span = node.span;
    Node {
        kind: Kind::Skew(without_brackets(node)),
        span,
    }
}

/// `(R^T \dot R)^\vee`: the vector of a cross-product matrix.
pub(super) fn vee(node: Node) -> Node {
    let span = node.span;
    Node {
        kind: Kind::Function(Function::Vee, without_brackets(node)),
        span,
    }
}

fn without_brackets(node: Node) -> Box<Node> {
    match node.kind {
        Kind::Group(_, inner) => inner,
        kind => Box::new(Node { kind, ..node }),
    }
}
