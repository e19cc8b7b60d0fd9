//! The sign convention for products of inertia, found from the document.

use crate::mechanics::Products;
use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes, inner, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::Convention;

/// What decides where nothing in the document does.
pub(crate) const UNDECIDED: &str = "default";

/// The sign convention: front matter, an integral or a written matrix of the document, or the default.
pub(crate) fn convention(document: &Document, reading: &Reading) -> (Products, Convention) {
    let named = |entries: bool, decided_by| {
        let (products, name) = if entries {
            (Products::Entries, "entries")
        } else {
            (Products::Integrals, "integrals")
        };
        (products, Convention { name, decided_by })
    };
    if let Some(products) = document.front_matter.products.as_deref() {
        return named(products == "entries", "front matter");
    }
    if reading.summed.is_some() {
        return named(true, "the sums over indices");
    }
    let lines = || {
        document
            .items
            .iter()
            .filter_map(|item| match item {
                Item::Formula(formula) => Some(formula.rows.iter()),
                _ => None,
            })
            .flatten()
            .filter_map(|row| match row {
                Row::Line(line) => Some(line),
                _ => None,
            })
    };
    if let Some(entries) = lines().find_map(|line| integral_convention(line, reading)) {
        return named(entries, "an integral of the document");
    }
    let integrals: Vec<(Letter, bool)> = lines().filter_map(named_integral).collect();
    if let Some(entries) = lines().find_map(|line| by_other_letter(line, &integrals, reading)) {
        return named(entries, "an integral of the document");
    }
    match lines()
        .flat_map(|line| &line.sides)
        .find_map(|side| matrix_convention(side, reading))
    {
        Some(entries) => named(entries, "a matrix of the document"),
        None if reading.products_as_entries => named(true, "the signs in most lines"),
        None => named(false, UNDECIDED),
    }
}

/// `I_xy = ∫ xy dm` says integrals, `I_xy = −∫ xy dm` entries.
fn integral_convention(line: &Line, reading: &Reading) -> Option<bool> {
    let [left, right, ..] = line.sides.as_slice() else {
        return None;
    };
    let product = symbols(left).into_iter().any(|s| is_product(s, reading));
    match &right.kind {
        Kind::Integral { integrand, .. } if product => Some(signed(integrand).0),
        // Σ m x y over particles.
        Kind::IndexedSum { .. } if product => Some(false),
        Kind::Negate(inside)
            if product
                && matches!(inside.kind, Kind::Integral { .. } | Kind::IndexedSum { .. }) =>
        {
            Some(true)
        }
        _ => None,
    }
}

/// The letter of `P_xy = ∫ xy dm`, and whether a sign stands before the integral.
fn named_integral(line: &Line) -> Option<(Letter, bool)> {
    let [left, right, ..] = line.sides.as_slice() else {
        return None;
    };
    let Kind::Symbol(symbol) = &inner(left).kind else {
        return None;
    };
    let (negative, inside) = signed(right);
    let integral = matches!(inside.kind, Kind::Integral { .. });
    (integral && across(symbol)).then(|| (Letter::of(symbol), negative))
}

/// `I_xy = −P_xy` for a P that is an integral says entries, `I_xy = P_xy` integrals.
fn by_other_letter(line: &Line, integrals: &[(Letter, bool)], reading: &Reading) -> Option<bool> {
    let [left, right, ..] = line.sides.as_slice() else {
        return None;
    };
    let (negative, inside) = signed(right);
    let (Kind::Symbol(own), Kind::Symbol(other)) = (&inner(left).kind, &inner(inside).kind) else {
        return None;
    };
    let same = is_product(own, reading) && own.subscripts == other.subscripts;
    let (_, turned) = integrals
        .iter()
        .find(|(l, _)| same && *l == Letter::of(other))?;
    Some(negative != *turned)
}

/// A node without the sign before it, and whether there is one.
pub(crate) fn signed(node: &Node) -> (bool, &Node) {
    match &node.kind {
        Kind::Negate(inside) => (true, inside),
        _ => (false, node),
    }
}

/// A written inertia matrix: its entries off the diagonal show their sign. The most of them decide, as one may have slipped.
fn matrix_convention(node: &Node, reading: &Reading) -> Option<bool> {
    if let Kind::Matrix(rows) = &node.kind
        && matches!(rows.len(), 2 | 3)
        && rows.iter().all(|row| row.len() == rows.len())
    {
        let (mut plain, mut negated) = (0, 0);
        for (r, row) in rows.iter().enumerate() {
            for (_, entry) in row.iter().enumerate().filter(|(c, _)| *c != r) {
                match &entry.kind {
                    Kind::Symbol(symbol) if is_product(symbol, reading) => plain += 1,
                    Kind::Negate(inside) => {
                        let product =
                            matches!(&inside.kind, Kind::Symbol(s) if is_product(s, reading));
                        negated += usize::from(product);
                    }
                    _ => {}
                }
            }
        }
        if plain != negated {
            return Some(plain > negated);
        }
    }
    node.children()
        .find_map(|child| matrix_convention(child, reading))
}

fn is_product(symbol: &Symbol, reading: &Reading) -> bool {
    reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Inertia) && across(symbol)
}

/// Whether a symbol has the indices of two axes.
fn across(symbol: &Symbol) -> bool {
    let mut pairs = symbol.subscripts.iter().filter_map(|s| axes(s));
    pairs.any(|(r, c)| r != c)
}
