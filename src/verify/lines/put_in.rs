//! Formulas with their numbers put in: `\omega_p = v/R = 10/100 = 0.1` hands over v and R, and works out the rest.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::verdict::{Finding, Role, Verdict};
use std::slice::from_ref;

/// Symbols that one formula may get numbers for.
const MOST: usize = 12;

impl Checker<'_> {
    /// Takes the numbers that a side of a chain puts in for symbols of the side before it, where nothing says them, and
    /// checks the whole with these; `false` where none is put in.
    pub(crate) fn takes_numbers(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let mut put_in: Vec<(&Node, &Node)> = vec![];
        for pair in sides.windows(2) {
            let mut found = vec![];
            let plain = symbols(&pair[1]).is_empty() && !symbols(&pair[0]).is_empty();
            // `x = 5` puts nothing in.
            let formula = !matches!(inner(&pair[0]).kind, Kind::Symbol(_));
            if plain && formula && matched(&pair[0], &pair[1], &mut found) {
                put_in.append(&mut found);
            }
        }
        put_in.truncate(MOST);
        let mut names = vec![];
        for (symbol, number) in put_in {
            if self.is_in_numbers(from_ref(symbol)) {
                continue;
            }
            let mut data = finding.clone();
            self.accept(&[symbol.clone(), number.clone()], Role::Given, &mut data);
            // What stays without a number could be asked for one again and again.
            if data.verdict != Verdict::Accepted || !self.is_in_numbers(from_ref(symbol)) {
                let name = self.line_name(finding);
                self.theory.retain(|premise| premise.name != name);
                return false;
            }
            let text = self.document.source.slice(symbol.span).trim();
            names.push(format!("`{text}`"));
        }
        if names.is_empty() {
            return false;
        }
        self.claim(sides, finding);
        let said = format!("{} taken from the numbers put in", names.join(", "));
        finding.remarks.push(said);
        true
    }
}

/// Whether a side of numbers is a formula with a number in the place of each symbol; notes which is which.
fn matched<'n>(
    formula: &'n Node,
    numbers: &'n Node,
    found: &mut Vec<(&'n Node, &'n Node)>,
) -> bool {
    let (formula, numbers) = (bare(formula), bare(numbers));
    let mut all = |pairs: &[(&'n Node, &'n Node)]| {
        pairs
            .iter()
            .all(|(formula, numbers)| matched(formula, numbers, found))
    };
    match (&formula.kind, &numbers.kind) {
        (Kind::Symbol(_), _) if is_number_as_written(numbers) => {
            found.push((formula, numbers));
            true
        }
        (Kind::Number(a), Kind::Number(b)) => a.value == b.value,
        (Kind::Negate(a), Kind::Negate(b)) => all(&[(a, b)]),
        (Kind::Quotient(a, b), Kind::Quotient(c, d)) => all(&[(a, c), (b, d)]),
        (Kind::Power(a, b), Kind::Power(c, d)) => all(&[(a, c), (b, d)]),
        (Kind::Function(f, a), Kind::Function(g, b)) => f == g && all(&[(a, b)]),
        (Kind::Sum(a), Kind::Sum(b)) => {
            let signs = a.iter().zip(b).all(|(a, b)| a.negative == b.negative);
            let pairs: Vec<_> = a.iter().zip(b).map(|(a, b)| (&a.node, &b.node)).collect();
            a.len() == b.len() && signs && all(&pairs)
        }
        (Kind::Product(a), Kind::Product(b)) => {
            let pairs: Vec<_> = a.iter().zip(b).map(|(a, b)| (&a.node, &b.node)).collect();
            a.len() == b.len() && all(&pairs)
        }
        _ => false,
    }
}

/// A node without brackets and units.
fn bare(node: &Node) -> &Node {
    match &inner(node).kind {
        Kind::WithUnit(inside, _) => bare(inside),
        _ => inner(node),
    }
}

/// `5`, `-5`, `(5)`.
fn is_number_as_written(node: &Node) -> bool {
    match &bare(node).kind {
        Kind::Number(_) => true,
        Kind::Negate(inside) => is_number_as_written(inside),
        _ => false,
    }
}
