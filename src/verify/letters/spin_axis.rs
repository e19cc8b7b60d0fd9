//! The axis that a body spins about on axes that do not spin with it: the one along which alone ω differs from the Ω of
//! the axes, `\Omega = (p, 0, r)` beside `\omega = (p, s, r)`, or `\omega = \Omega + s\,\mathbf j`.

use crate::notation::ast::{Factor, Kind, Node, Symbol, Term};
use crate::notation::document::Document;
use crate::verify::letters::usage::{axis, inner};

/// The components of a vector as they are written.
type Components = [String; 3];

/// The axis of the spin. Inertia that does not change on such axes is that of a body which is symmetric about it.
pub(crate) fn spin_axis(document: &Document) -> Option<u8> {
    let mut written: [Option<Components>; 2] = [None, None];
    for line in document.lines() {
        let [left, right] = line.sides.as_slice() else {
            continue;
        };
        let Some(place) = vector_called(left, ["Omega", "omega"]) else {
            continue;
        };
        if let Some(axis) = (place == 1).then(|| beside_frame(right)).flatten() {
            return Some(axis);
        }
        if written[place].is_none() {
            written[place] = components(document, right);
        }
    }
    let [Some(axes), Some(body)] = written else {
        return None;
    };
    let mut apart = (0..3u8).filter(|&c| axes[usize::from(c)] != body[usize::from(c)]);
    apart.next().filter(|_| apart.next().is_none())
}

fn vector_called(node: &Node, names: [&str; 2]) -> Option<usize> {
    match &inner(node).kind {
        Kind::Symbol(s) if s.style.vector && s.subscripts.is_empty() => {
            names.iter().position(|name| s.name == *name)
        }
        _ => None,
    }
}

/// The axis of the second term of `\Omega + s\,\mathbf j`.
fn beside_frame(side: &Node) -> Option<u8> {
    let Kind::Sum(terms) = &inner(side).kind else {
        return None;
    };
    let [first, second] = terms.as_slice() else {
        return None;
    };
    vector_called(&first.node, ["Omega", "Omega"])?;
    along(second).map(|(_, axis)| axis)
}

/// Each component as it stands in the source, empty where it is zero.
fn components(document: &Document, side: &Node) -> Option<Components> {
    let text = |node: &Node| {
        let text = document.source.slice(node.span).trim();
        let text = text.strip_suffix("\\,").unwrap_or(text);
        let dense: String = text.split_whitespace().collect();
        if dense == "0" { String::new() } else { dense }
    };
    let entries: Vec<&Node> = match &inner(side).kind {
        Kind::Transpose(inside) => return components(document, inside),
        Kind::Tuple(entries) => entries.iter().collect(),
        Kind::Matrix(rows) => rows.iter().flatten().collect(),
        Kind::Sum(terms) => {
            let mut found = Components::default();
            for term in terms {
                let (factors, axis) = along(term)?;
                let sign = if term.negative { "-" } else { "" };
                let factors: String = factors.iter().map(|f| text(&f.node)).collect();
                found[usize::from(axis)] = format!("{sign}{factors}");
            }
            return Some(found);
        }
        _ => return None,
    };
    let texts: Vec<String> = entries.into_iter().map(text).collect();
    texts.try_into().ok()
}

/// A term as the factors of a unit vector behind them, and its axis.
fn along(term: &Term) -> Option<(&[Factor], u8)> {
    let Kind::Product(factors) = &inner(&term.node).kind else {
        return None;
    };
    let (last, factors) = factors.split_last()?;
    match &inner(&last.node).kind {
        Kind::Symbol(symbol) => unit_axis(symbol).map(|axis| (factors, axis)),
        _ => None,
    }
}

/// The axis that a letter or a unit vector names.
pub(crate) fn axis_of(symbol: &Symbol) -> Option<u8> {
    let letter = axis(&symbol.name).filter(|_| symbol.subscripts.is_empty());
    letter.or_else(|| unit_axis(symbol))
}

pub(crate) fn unit_axis(symbol: &Symbol) -> Option<u8> {
    if !symbol.style.vector && !symbol.style.hat {
        return None;
    }
    match (symbol.name.as_str(), symbol.subscripts.as_slice()) {
        ("i", []) => Some(0),
        ("j", []) => Some(1),
        ("k", []) => Some(2),
        (name, []) => axis(name),
        (_, [index]) => axis(index),
        _ => None,
    }
}
