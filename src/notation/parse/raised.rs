//! What signs at the upper right make of what they stand on: a cross, a vee, a square of the tensor product.

use super::script::{PRIMED, symbol_of};
use super::{DEEPEST, Parser};
use crate::notation::ast::{Factor, Function, Kind, Node, Operator};
use crate::notation::token::{Lexeme, Token};
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

impl<'t, 'a> Parser<'t, 'a> {
    /// Whether `{}` with scripts stands here and nothing behind them to which they could belong: `x_k{}^2`.
    pub(super) fn empty_base_closes(&self) -> bool {
        if self.peek() != Some(Lexeme::Open)
            || self.peek_at(1) != Some(Lexeme::Close)
            || !self.peek_at(2).is_some_and(super::line::is_script)
        {
            return false;
        }
        let mut probe = self.clone();
        probe.at += 2;
        while probe.peek().is_some_and(super::line::is_script) {
            probe.at += 1;
            let _ = probe.argument();
        }
        probe.skip_spaces();
        probe.at_end() || !probe.factor_starts()
    }

    /// What is raised on nothing in a script is raised with it, and a prime before a power is one of the letter:
    /// `\omega^{\prime 2}` is the square of ω'.
    pub(super) fn raised_on_more(&self, mut node: Node, tokens: &'t [Token<'a>]) -> Node {
        let lead = |t: &Token<'_>| !matches!(t.kind, Lexeme::Space(_));
        let at = tokens.iter().position(lead).map_or(0, |at| at + 1);
        let mut inner = self.inside(&tokens[at..]);
        if self.depth >= DEEPEST {
            return self.error("brackets nested too deeply");
        }
        if tokens[..at].last().map(|t| t.kind) == Some(Lexeme::Superscript) {
            let raised = inner.argument();
            return match inner.at_end() {
                true => self.inside(raised).superscript(node, raised),
                false => self.error("a power of a power"),
            };
        }
        match symbol_of(&mut node) {
            Some(symbol) => symbol.primes = symbol.primes.saturating_add(1),
            None => return self.error(PRIMED),
        }
        inner.superscript(node, &tokens[at..])
    }
}
