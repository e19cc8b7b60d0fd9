//! Letters with the mark of a vector that are matrices by their use: the K of `-\mathbf K\boldsymbol\omega`.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::{Letter, axis, inner, undotted};
use std::collections::BTreeSet;

/// What lines show of capital letters with the mark of a vector.
#[derive(Default)]
struct Seen {
    /// Those that stand right before a vector, with nothing between.
    applied: BTreeSet<Letter>,
    /// Those that stand anywhere else.
    otherwise: BTreeSet<Letter>,
}

/// The capital letters that every line applies to a vector: of two vectors nobody writes the product so.
pub(crate) fn applied(document: &Document) -> BTreeSet<Letter> {
    let mut seen = Seen::default();
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &formula.rows {
            if let Row::Line(line) = row {
                line.sides.iter().for_each(|side| seen.node(side, false));
            }
        }
    }
    seen.applied
        .retain(|letter| !seen.otherwise.contains(letter));
    seen.applied
}

impl Seen {
    fn node(&mut self, node: &Node, applied: bool) {
        match &node.kind {
            Kind::Symbol(symbol) if is_capital(symbol) => {
                let met = match applied {
                    true => &mut self.applied,
                    false => &mut self.otherwise,
                };
                met.insert(Letter::of(symbol));
            }
            Kind::Product(factors) => {
                for (at, factor) in factors.iter().enumerate() {
                    let next = factors.get(at + 1);
                    let next = next.filter(|next| next.operator == Operator::Juxtaposed);
                    self.node(&factor.node, next.is_some_and(|next| is_vector(&next.node)));
                }
            }
            // The transpose of a matrix is applied as well.
            Kind::Transpose(inside) => self.node(inside, applied),
            _ => node.children().for_each(|child| self.node(child, false)),
        }
    }
}

fn is_capital(symbol: &Symbol) -> bool {
    let capital = symbol.name.chars().all(|c| c.is_ascii_uppercase());
    let component = symbol.subscripts.iter().any(|s| axis(s).is_some());
    symbol.style.vector && !symbol.style.hat && capital && !component
}

/// A vector in a small letter, whatever dots are over it.
fn is_vector(node: &Node) -> bool {
    matches!(&inner(undotted(node)).kind, Kind::Symbol(s) if s.style.vector && !is_capital(s))
}
