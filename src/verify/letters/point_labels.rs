//! Labels of points on symbols of inertia: `I_{xx}^O`, `J_{Gxy}`, `(I_{zz})_C`, `\bar I`.

use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::{axes, axis, inner};
use std::collections::BTreeSet;

/// The mark of a tensor about the mass centre under a bar: `\bar I`.
pub(crate) const BAR: &str = "¯";
/// Letters of the inertia.
const INERTIA: &[&str] = &["I", "J", "Theta", "Θ"];
pub(crate) const COORDINATES: [&str; 3] = ["x", "y", "z"];
/// The indices of the components.
pub(crate) const ENTRIES: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

/// The part of the inertia that a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// All of it, with the mark of a vector or a tensor, or without.
    Whole(bool),
    /// A component: xx, yy, zz, xy, xz, yz.
    Entry(u8),
}

/// Puts marks where they tell what they mean here: the label behind brackets on the symbol in them, `(I_{xx})_O` being
/// I_xx about O; the bars of `\bar x, \bar y, \bar z`, which make no vectors; and the bar of a mean `\bar\omega` beside
/// the `\omega_{n+1}` behind a step.
pub(crate) fn note_marks(document: &mut Document) {
    let all = every_symbol(document);
    let barred = |name: &&str| all.iter().any(|s| s.name == *name && s.style.bar);
    let barred = COORDINATES.iter().all(barred);
    let steps = |s: &&Symbol| s.subscripts.iter().any(|label| label.contains('+'));
    let stepped: BTreeSet<String> = all
        .iter()
        .copied()
        .filter(steps)
        .map(|s| s.name.clone())
        .collect();
    for node in formulas_mut(document) {
        unbracketed(node);
        mark_traced(node);
        node.change_symbols(&mut |symbol| {
            let coordinate = COORDINATES.contains(&symbol.name.as_str()) && symbol.style.bar;
            let mean = symbol.style.bar && stepped.contains(&symbol.name);
            if barred && coordinate || mean {
                symbol.style.bar = false;
                symbol.subscripts.push("bar".to_owned());
            }
        });
    }
}

/// Whether a label stands under or over a symbol.
pub(crate) fn bears(symbol: &Symbol, label: &str) -> bool {
    let mut all = symbol.subscripts.iter().chain(&symbol.superscripts);
    all.any(|text| text.trim_matches(['(', ')']) == label)
}

/// The label of the point that a symbol of inertia has, and its place in the tensor; `None` for other letters.
pub(crate) fn about(symbol: &Symbol) -> Option<(String, Place)> {
    if !INERTIA.contains(&symbol.name.as_str()) || symbol.primes > 0 {
        return None;
    }
    let mut label = String::new();
    if symbol.style.bar {
        label.push_str(BAR);
    }
    let mut place = Place::Whole(symbol.style.vector && !symbol.style.bar || symbol.style.tensor);
    let written = symbol.subscripts.iter().chain(&symbol.superscripts);
    let pieces = written.flat_map(|text| text.trim_matches(['(', ')']).split([',', ' ']));
    for piece in pieces
        .map(|piece| piece.trim_matches('\''))
        .filter(|p| !p.is_empty())
    {
        let split = piece
            .len()
            .checked_sub(2)
            .and_then(|at| piece.split_at_checked(at));
        if let Some(index) = axis(piece) {
            place = Place::Entry(index);
        } else if let Some(pair) = axes(piece) {
            place = Place::Entry(component(pair));
        } else if let Some((point, pair)) =
            split.and_then(|(point, pair)| Some((point, axes(pair)?)))
        {
            label.push_str(point);
            place = Place::Entry(component(pair));
        } else if let Some((point, index)) = of_one_axis(piece) {
            label.push_str(point);
            place = Place::Entry(index);
        } else {
            label.push_str(piece);
        }
    }
    Some((label, place))
}

/// `Gx`: the moment about the axis x through G.
fn of_one_axis(piece: &str) -> Option<(&str, u8)> {
    let (point, index) = piece.split_at_checked(piece.len().checked_sub(1)?)?;
    let point = Some(point).filter(|p| p.len() == 1 && p.starts_with(char::is_uppercase))?;
    let lettered = matches!(index, "x" | "y" | "z");
    axis(index).filter(|_| lettered).map(|axis| (point, axis))
}

fn component((row, column): (u8, u8)) -> u8 {
    match (row.min(column), row.max(column)) {
        (0, 1) => 3,
        (0, 2) => 4,
        (1, 2) => 5,
        (row, _) => row,
    }
}

fn unbracketed(node: &mut Node) {
    if let Kind::InFrame(inside, label) = &node.kind
        && let Kind::Symbol(symbol) = &inner(inside).kind
        && INERTIA.contains(&symbol.name.as_str())
        && label.text.chars().next().is_some_and(char::is_alphabetic)
        && axis(&label.text).is_none()
    {
        let mut symbol = symbol.clone();
        symbol.subscripts.push(label.text.clone());
        node.kind = Kind::Symbol(symbol);
    }
    node.children_mut().into_iter().for_each(unbracketed);
}

/// What has a trace or a determinant is a tensor, not the moment about one axis: `\operatorname{tr} I^O`.
fn mark_traced(node: &mut Node) {
    if let Kind::Function(Function::Trace | Function::Det, argument) = &mut node.kind
        && let Kind::Symbol(symbol) = &mut argument.kind
        && matches!(about(symbol), Some((label, Place::Whole(false))) if !label.is_empty())
    {
        symbol.style.tensor = true;
    }
    node.children_mut().into_iter().for_each(mark_traced);
}

pub(crate) fn formulas_mut(document: &mut Document) -> impl Iterator<Item = &mut Node> {
    let rows = document.items.iter_mut().filter_map(|item| match item {
        Item::Formula(formula) => Some(&mut formula.rows),
        _ => None,
    });
    rows.flatten().flat_map(|row| match row {
        Row::Line(line) => line.sides.iter_mut().collect(),
        Row::Expression(node) => vec![node],
        Row::Unreadable { .. } => vec![],
    })
}
