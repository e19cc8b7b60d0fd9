//! Primes that are derivatives in time: `I_1 ω_1' = (I_2 − I_3) ω_2 ω_3`.

use crate::notation::ast::{DerivativeStyle, Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Item};
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::usage::{axis, symbols};
use crate::verify::words::book::has_any;

/// Writes dots for the primes of a document whose words or equations say that they are rates.
pub(crate) fn dots_for_primes(document: &mut Document) {
    if !said(document) && !shown(document) {
        return;
    }
    formulas_mut(document).for_each(dotted);
}

/// "A prime is the derivative in time."
fn said(document: &Document) -> bool {
    document.items.iter().any(|item| {
        let Item::Prose { text, .. } = item else {
            return false;
        };
        let text = text.to_lowercase();
        text.split(['.', ';']).any(|clause| {
            let speaks = |words: &[&str]| has_any(clause, words);
            clause.contains("prime")
                && speaks(&["derivative", "differentiat", "d/dt", "rate"])
                && speaks(&["time", "d/dt"])
        })
    })
}

/// Whether no other mark of a rate is met, and Euler's equations stand there with primes.
fn shown(document: &Document) -> bool {
    let mut sides = document.lines().flat_map(|line| &line.sides);
    !sides.any(has_rate) && document.lines().any(is_eulers)
}

fn has_rate(node: &Node) -> bool {
    matches!(node.kind, Kind::TimeDerivative { .. }) || node.children().any(has_rate)
}

/// A component with a prime beside the other two without.
fn is_eulers(line: &Line) -> bool {
    let all: Vec<&Symbol> = line.sides.iter().flat_map(symbols).collect();
    let place = |s: &Symbol| s.subscripts.iter().find_map(|index| axis(index));
    all.iter().any(|primed| {
        let rate = matches!(primed.name.as_str(), "omega" | "w") && primed.primes == 1;
        let other = |at: u8| {
            all.iter()
                .any(|s| s.name == primed.name && s.primes == 0 && place(s) == Some(at))
        };
        let Some(own) = place(primed).filter(|_| rate) else {
            return false;
        };
        !other(own) && (0..3).filter(|&at| at != own).all(other)
    })
}

fn dotted(node: &mut Node) {
    if let Kind::Symbol(symbol) = &mut node.kind {
        let order = std::mem::take(&mut symbol.primes);
        if order > 0 {
            node.kind = Kind::TimeDerivative {
                operand: Box::new(node.clone()),
                order,
                style: DerivativeStyle::Dots,
                frame: None,
            };
        }
        return;
    }
    node.children_mut().into_iter().for_each(dotted);
}
