//! How much work a document can make, told from its text alone: the same on every machine, and before anything is decided.

use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::notation::document::{Document, Row};
use std::collections::HashMap;

/// The terms that all lines of a submission together may have when their products are multiplied out. A line of a
/// derivation has a hundred at most.
const MOST_TERMS: u64 = 60_000;

/// The longest line, in bytes.
const LONGEST_LINE: u32 = 4_000;

/// A submission of more lines is left to a person.
const MOST_LINES: usize = 400;

/// How many times the terms under a root count: each root is a letter more, and roots in each other multiply.
const TERMS_OF_ROOT: u64 = 4;

/// How many terms the letters have that a student defines, one by the other.
type Defined<'d> = HashMap<&'d Symbol, u64>;

/// What of documents is too large to be marked; none where they are not. Letters that the key knows are not put in.
pub(super) fn excess(documents: &[Document], is_known: impl Fn(&Node) -> bool) -> Option<String> {
    let rows = documents.iter().flat_map(Document::rows);
    let rows: Vec<&Row> = rows
        .filter(|row| !matches!(row, Row::Expression(_)))
        .collect();
    if rows.len() > MOST_LINES {
        return Some(format!("it has more than {MOST_LINES} lines"));
    }
    let lines = rows.into_iter().filter_map(|row| match row {
        Row::Line(line) => Some(line),
        _ => None,
    });
    let (mut all, mut defined) = (0u64, Defined::new());
    for line in lines {
        if line.span.end - line.span.start > LONGEST_LINE {
            return Some(format!(
                "a line of it has more than {LONGEST_LINE} characters"
            ));
        }
        let own: Vec<u64> = line
            .sides
            .iter()
            .map(|side| terms(side, &defined))
            .collect();
        all = own.iter().copied().fold(all, u64::saturating_add);
        if let [left, ..] = line.sides.as_slice()
            && let Kind::Symbol(letter) = &left.kind
            && !line.continues
            && !is_known(left)
        {
            let most = own.iter().skip(1).copied().max();
            defined.insert(letter, most.unwrap_or(1));
        }
    }
    (all > MOST_TERMS).then(|| {
        format!("its products have more than {MOST_TERMS} terms when they are multiplied out")
    })
}

/// How many terms a tree has when its products are multiplied out.
fn terms(node: &Node, defined: &Defined<'_>) -> u64 {
    let children = || node.children().map(|child| terms(child, defined));
    match &node.kind {
        Kind::Symbol(letter) => defined.get(letter).copied().unwrap_or(1),
        Kind::Function(Function::Sqrt, inside) => {
            terms(inside, defined).saturating_mul(TERMS_OF_ROOT)
        }
        Kind::Product(_) => children().fold(1, u64::saturating_mul),
        Kind::Power(base, exponent) => power(terms(base, defined), exponent),
        Kind::TimeDerivative { operand, order, .. } => {
            (0..*order).fold(terms(operand, defined), |terms, _| terms.saturating_mul(3))
        }
        Kind::Quotient(over, under) => terms(over, defined).saturating_mul(terms(under, defined)),
        _ => children().fold(0, u64::saturating_add).max(1),
    }
}

/// The terms of a power of a sum: n of k letters are C(n + k − 1, n).
fn power(base: u64, exponent: &Node) -> u64 {
    let exponent = match &exponent.kind {
        Kind::Number(number) => number.value.to_string().parse().unwrap_or(1),
        Kind::Quotient(..) => return base.saturating_mul(TERMS_OF_ROOT),
        _ => return base.saturating_add(terms(exponent, &Defined::new())),
    };
    if base <= 1 {
        return 1;
    }
    if base > MOST_TERMS {
        return base;
    }
    let mut terms = 1u64;
    for n in 1..=exponent.min(MOST_TERMS) {
        terms = terms.saturating_mul(base + n - 1) / n;
        if terms > MOST_TERMS {
            break;
        }
    }
    terms
}
