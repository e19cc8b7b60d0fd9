//! Letters of a period: what is set equal to 2π√… or 2π/ω is neither an energy nor a moment. And of frequencies: an Ω₁
//! whose square a line gives is no rate of turning beside ω₁, ω₂, ω₃.

use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::lines::defined_squares::is_two;
use num_traits::{One, ToPrimitive};

/// Letters that may be a period, and something else in another document.
const LETTERS: &[&str] = &["T", "tau", "P"];

impl Reading {
    /// Notes the letters that lines of a document use for a period, or for frequencies.
    pub(crate) fn note_periods(&mut self, document: &Document) {
        for line in document.lines() {
            let [left, rest @ ..] = line.sides.as_slice() else {
                continue;
            };
            if let Kind::Power(base, two) = &inner(left).kind
                && let Kind::Symbol(symbol) = &inner(base).kind
                && is_two(two)
                && self.is_apart_from_rates(symbol)
            {
                self.periods.insert(Letter::of(symbol));
            }
            if let Kind::Symbol(symbol) = &inner(left).kind
                && LETTERS.contains(&symbol.name.as_str())
                && !symbol.style.vector
                && rest.iter().any(is_time_of_a_turn)
            {
                self.periods.insert(Letter::of(symbol));
            }
            // `\nu = 2\pi/T`.
            let turned = rest.iter().filter(|side| is_time_of_a_turn(side));
            let letters = turned.filter_map(below).map(Letter::of);
            let named = letters.filter(|letter| LETTERS.contains(&letter.name.as_str()));
            self.periods.extend(named);
        }
    }
}

impl Reading {
    /// Whether a symbol is an Ω with an index that never moves, beside another letter with the three rates.
    fn is_apart_from_rates(&self, symbol: &Symbol) -> bool {
        let letter = Letter::of(symbol);
        let used = self.usage.get(&letter);
        let families = [["1", "2", "3"], ["x", "y", "z"]];
        let rates = ["omega", "w"].map(Letter::plain);
        let has_all = |rate: &Letter| {
            let all = |family: &[&str; 3]| family.iter().all(|i| self.usage.has_index(rate, i));
            families.iter().any(all)
        };
        let axis = matches!(symbol.subscripts.as_slice(), [index] if axis(index).is_some());
        letter.name == "Omega"
            && axis
            && used.vector + used.bare == 0
            && !used.moving
            && rates.iter().any(has_all)
    }
}

/// The number below the line of a side.
fn below(side: &Node) -> Option<&Symbol> {
    match &inner(side).kind {
        Kind::Quotient(_, below) => match &inner(below).kind {
            Kind::Symbol(symbol) if !symbol.style.vector => Some(symbol),
            _ => None,
        },
        Kind::Product(factors) => factors.iter().find_map(|factor| below(&factor.node)),
        _ => None,
    }
}

/// Whether a side is `2\pi\sqrt{…}` or `2\pi/…`.
fn is_time_of_a_turn(side: &Node) -> bool {
    match &inner(side).kind {
        Kind::Product(factors) => {
            let nodes: Vec<&Node> = factors.iter().map(|factor| &factor.node).collect();
            let root = |node: &&Node| matches!(inner(node).kind, Kind::Function(Function::Sqrt, _));
            // `2\pi/T` is read as 2 · (π/T).
            if let [two, last] = nodes[..]
                && let Kind::Quotient(pi, _) = &inner(last).kind
            {
                return is_turn(&[two, &**pi]);
            }
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
