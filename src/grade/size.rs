//! How much work a document can make, told from its text alone: the same on every machine, and before anything is decided.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Document, Item, Row};

/// The terms that all lines of a submission together may have when their products are multiplied out. A line of a
/// derivation has a hundred at most.
const MOST_TERMS: u64 = 60_000;

/// The longest line, in bytes.
const LONGEST_LINE: u32 = 4_000;

/// A submission of more lines is left to a person.
const MOST_LINES: usize = 400;

/// What of documents is too large to be marked; none where they are not.
pub(super) fn excess(documents: &[Document]) -> Option<String> {
    let items = documents.iter().flat_map(|document| &document.items);
    let formulas = items.filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    let rows = formulas.flatten();
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
    let mut all = 0u64;
    for line in lines {
        if line.span.end - line.span.start > LONGEST_LINE {
            return Some(format!(
                "a line of it has more than {LONGEST_LINE} characters"
            ));
        }
        let own = line.sides.iter().map(terms);
        all = all.saturating_add(own.fold(0, u64::saturating_add));
    }
    (all > MOST_TERMS).then(|| {
        format!("its products have more than {MOST_TERMS} terms when they are multiplied out")
    })
}

/// How many terms a tree has when its products are multiplied out.
fn terms(node: &Node) -> u64 {
    let children = || node.children().map(terms);
    match &node.kind {
        Kind::Product(_) => children().fold(1, u64::saturating_mul),
        Kind::Power(base, exponent) => power(terms(base), exponent),
        Kind::TimeDerivative { operand, order, .. } => {
            (0..*order).fold(terms(operand), |terms, _| terms.saturating_mul(3))
        }
        Kind::Quotient(over, under) => terms(over).saturating_mul(terms(under)),
        _ => children().fold(0, u64::saturating_add).max(1),
    }
}

/// The terms of a power of a sum: n of k letters are C(n + k − 1, n).
fn power(base: u64, exponent: &Node) -> u64 {
    let exponent = match &exponent.kind {
        Kind::Number(number) => number.value.to_string().parse().unwrap_or(1),
        _ => return base.saturating_add(terms(exponent)),
    };
    if base <= 1 {
        return 1;
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
