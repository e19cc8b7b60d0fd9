//! Letters of a period: what is set equal to 2π√… or 2π/ω is neither an energy nor a moment.

use crate::notation::ast::{Function, Kind, Node};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::repair::lines;
use num_traits::{One, ToPrimitive};

/// Letters that may be a period, and something else in another document.
const LETTERS: &[&str] = &["T", "tau", "P"];

impl Reading {
    /// Notes the letters that lines of a document use for a period.
    pub(crate) fn note_periods(&mut self, document: &Document) {
        for line in lines(document) {
            let [left, rest @ ..] = line.sides.as_slice() else {
                continue;
            };
            if let Kind::Symbol(symbol) = &inner(left).kind
                && LETTERS.contains(&symbol.name.as_str())
                && !symbol.style.vector
                && rest.iter().any(is_time_of_a_turn)
            {
                self.periods.insert(Letter::of(symbol));
            }
        }
    }
}

/// Whether a side is `2\pi\sqrt{…}` or `2\pi/…`.
fn is_time_of_a_turn(side: &Node) -> bool {
    match &inner(side).kind {
        Kind::Product(factors) => {
            let nodes: Vec<&Node> = factors.iter().map(|factor| &factor.node).collect();
            let root = |node: &&Node| matches!(inner(node).kind, Kind::Function(Function::Sqrt, _));
            is_turn(&nodes[..nodes.len().min(2)])
                && (nodes.iter().any(root) || nodes.iter().any(|node| is_inverse(node)))
        }
        Kind::Quotient(above, _) => match &inner(above).kind {
            Kind::Product(factors) => {
                let nodes: Vec<&Node> = factors.iter().map(|factor| &factor.node).collect();
                is_turn(&nodes)
            }
            _ => false,
        },
        _ => false,
    }
}

/// Whether factors are 2 and π.
fn is_turn(factors: &[&Node]) -> bool {
    let [two, pi] = factors else { return false };
    let two = matches!(&inner(two).kind, Kind::Number(n) if n.value.to_f64() == Some(2.0));
    two && matches!(&inner(pi).kind, Kind::Symbol(s) if s.name == "pi" && s.subscripts.is_empty())
}

/// Whether a factor is one over something.
fn is_inverse(node: &Node) -> bool {
    matches!(&inner(node).kind, Kind::Quotient(above, _) if matches!(&above.kind, Kind::Number(n) if n.value.is_one()))
}
