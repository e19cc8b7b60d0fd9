//! An E without a mark that stands in a sum of matrices, `\omega\omega^T - |\omega|^2 E`: the identity.

use crate::notation::ast::{Factor, Kind, Node};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};

impl Reading {
    /// Notes it, where no line says what the letter is.
    pub(crate) fn note_unit_matrices(&mut self, document: &Document) {
        let unit = Letter::plain("E");
        let written = document.lines().flat_map(|line| &line.sides).any(adds_unit);
        if written && !self.left_sides.contains(&unit) {
            self.identities.insert(unit);
        }
    }
}

/// Whether a sum has a term that ends with a dyad, a matrix or the matrix of a cross product, and one that ends with E.
fn adds_unit(side: &Node) -> bool {
    let own = match &inner(side).kind {
        Kind::Sum(terms) => {
            let ends = |of: fn(&Node) -> bool| terms.iter().any(|term| of(last(&term.node)));
            ends(is_matrix) && ends(is_bare_e)
        }
        _ => false,
    };
    own || side.children().any(adds_unit)
}

/// The last factor of a term.
fn last(term: &Node) -> &Node {
    match &inner(term).kind {
        Kind::Product(factors) => factors.last().map_or(term, |Factor { node, .. }| node),
        _ => inner(term),
    }
}

fn is_bare_e(node: &Node) -> bool {
    matches!(&node.kind, Kind::Symbol(symbol) if symbol.name == "E" && symbol.subscripts.is_empty())
}

fn is_matrix(node: &Node) -> bool {
    match &node.kind {
        Kind::Transpose(_) | Kind::Skew(_) | Kind::Matrix(_) => true,
        Kind::Power(base, _) => is_matrix(base),
        _ => false,
    }
}
