//! ε_{ijk} and δ_{ij}: which symbols these are, and the numbers that they stand for.

use crate::notation::ast::{Factor, Kind, Node, Number, Symbol};
use num_rational::BigRational;
use num_traits::{One, Zero};

/// The axes.
pub(crate) const AXES: [&str; 3] = ["1", "2", "3"];

/// The indices of an ε or a δ.
pub(crate) fn tensor_indices(symbol: &Symbol) -> Option<Vec<char>> {
    let [text] = symbol.subscripts.as_slice() else {
        return None;
    };
    let letters: Vec<char> = text.chars().filter(|c| !matches!(c, ' ' | ',')).collect();
    let indices = letters.iter().all(char::is_ascii_lowercase) && !letters.contains(&'x');
    (indices && rank(symbol) == Some(letters.len())).then_some(letters)
}

/// The number of indices of the permutation symbol and of the unit tensor.
fn rank(symbol: &Symbol) -> Option<usize> {
    match symbol.name.as_str() {
        "epsilon" | "varepsilon" => Some(3),
        "delta" => Some(2),
        _ => None,
    }
}

/// Puts in the numbers that ε and δ are, and drops terms that vanish.
pub(crate) fn settle(node: &mut Node) {
    node.children_mut().into_iter().for_each(settle);
    let zero = |node: &Node| matches!(&node.kind, Kind::Number(n) if n.value.is_zero());
    let one = |f: &Factor| matches!(&f.node.kind, Kind::Number(n) if n.value.is_one());
    match &mut node.kind {
        Kind::Symbol(symbol) => {
            if let Some(value) = constant(symbol) {
                let number = number(value.unsigned_abs().into());
                node.kind = match value < 0 {
                    true => Kind::Negate(Box::new(Node {
                        kind: number,
                        span: node.span,
                    })),
                    false => number,
                };
            }
        }
        Kind::Negate(inside) | Kind::Group(_, inside) if zero(inside) => {
            node.kind = number(0);
        }
        Kind::Group(_, inside) if matches!(inside.kind, Kind::Negate(_)) => {
            node.kind = inside.kind.clone();
        }
        Kind::Product(factors) if factors.iter().any(|f| zero(&f.node)) => node.kind = number(0),
        Kind::Product(factors) => {
            let mut negative = false;
            for factor in factors.iter_mut() {
                if let Kind::Negate(inside) = &factor.node.kind {
                    negative = !negative;
                    factor.node = (**inside).clone();
                }
            }
            factors.retain(|f| !one(f));
            let rest = match factors.as_slice() {
                [] => number(1),
                [only] => only.node.kind.clone(),
                _ => Kind::Product(std::mem::take(factors)),
            };
            node.kind = signed(rest, negative, node);
        }
        Kind::Sum(terms) => {
            terms.retain(|term| !zero(&term.node));
            for term in terms.iter_mut() {
                if let Kind::Negate(inside) = &term.node.kind {
                    term.negative = !term.negative;
                    term.node = (**inside).clone();
                }
            }
            match terms.as_slice() {
                [] => node.kind = number(0),
                [only] => node.kind = signed(only.node.kind.clone(), only.negative, node),
                _ => {}
            }
        }
        _ => {}
    }
}

fn signed(kind: Kind, negative: bool, place: &Node) -> Kind {
    match negative {
        true => Kind::Negate(Box::new(Node {
            kind,
            span: place.span,
        })),
        false => kind,
    }
}

/// The value of an ε or a δ with numbers for indices.
fn constant(symbol: &Symbol) -> Option<i8> {
    let [text] = symbol.subscripts.as_slice() else {
        return None;
    };
    let axes: Vec<i8> = text
        .chars()
        .filter(|c| !matches!(c, ' ' | ','))
        .map(|c| AXES.iter().position(|a| a.starts_with(c)).map(|p| p as i8))
        .collect::<Option<_>>()?;
    match (rank(symbol)?, axes.as_slice()) {
        (3, &[a, b, c]) => Some((b - a) * (c - b) * (c - a) / 2),
        (2, &[a, b]) => Some(i8::from(a == b)),
        _ => None,
    }
}

fn number(value: u64) -> Kind {
    Kind::Number(Number {
        value: BigRational::from_integer(value.into()),
        decimals: None,
        exponent: 0,
    })
}
