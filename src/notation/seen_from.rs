//! Labels under a dotted vector that say where its rate is seen from: `\dot{\mathbf L}_{rel} + \Omega\times\mathbf L`.

use crate::notation::ast::{DerivativeStyle, FrameLabel, Kind, Line, Node, Operator, Symbol};
use crate::notation::document::{Document, Item, Row};

/// Words for axes that turn, and the initial of two of them.
const TURNING: &[&str] = &[
    "rel", "relative", "rot", "rotating", "mov", "moving", "turning", "local", "r",
];

/// Takes such a label for that of the rate where the vector without it stands behind a × of the same line, and with it
/// stands nowhere undotted.
pub(super) fn labels_under_dots(document: &mut Document) {
    let labelled = |text: &str| TURNING.iter().any(|word| text.contains(word));
    if !document.source.text.contains("_{") || !labelled(&document.source.text) {
        return;
    }
    let mut undotted = vec![];
    for line in lines(&mut document.items) {
        for side in &line.sides {
            note_undotted(side, &mut undotted);
        }
    }
    for line in lines(&mut document.items) {
        let mut crossed = vec![];
        for side in &line.sides {
            note_crossed(side, &mut crossed);
        }
        for side in &mut line.sides {
            move_label(side, &crossed, &undotted);
        }
    }
}

fn lines(items: &mut [Item]) -> impl Iterator<Item = &mut Line> {
    let rows = items.iter_mut().filter_map(|item| match item {
        Item::Formula(formula) => Some(&mut formula.rows),
        _ => None,
    });
    rows.flatten().filter_map(|row| match row {
        Row::Line(line) => Some(line),
        _ => None,
    })
}

/// The symbols that stand with such a label and without a dot.
fn note_undotted(node: &Node, found: &mut Vec<Symbol>) {
    match &node.kind {
        Kind::Symbol(symbol) if label_of(symbol).is_some() => found.push(symbol.clone()),
        Kind::TimeDerivative { operand, .. } if matches!(operand.kind, Kind::Symbol(_)) => {}
        _ => node
            .children()
            .for_each(|child| note_undotted(child, found)),
    }
}

/// The symbols right behind a ×.
fn note_crossed(node: &Node, found: &mut Vec<Symbol>) {
    if let Kind::Product(factors) = &node.kind {
        let crossed = factors.iter().filter(|f| f.operator == Operator::Cross);
        found.extend(crossed.filter_map(|factor| match &factor.node.kind {
            Kind::Symbol(symbol) => Some(symbol.clone()),
            _ => None,
        }));
    }
    node.children().for_each(|child| note_crossed(child, found));
}

fn label_of(symbol: &Symbol) -> Option<&String> {
    match symbol.subscripts.as_slice() {
        [label] if symbol.style.vector && TURNING.contains(&label.trim()) => Some(label),
        _ => None,
    }
}

fn move_label(node: &mut Node, crossed: &[Symbol], undotted: &[Symbol]) {
    let span = node.span;
    if let Kind::TimeDerivative {
        operand,
        style: DerivativeStyle::Dots,
        frame: frame @ None,
        ..
    } = &mut node.kind
        && let Kind::Symbol(symbol) = &mut operand.kind
        && let Some(text) = label_of(symbol).cloned()
    {
        let bare = Symbol {
            subscripts: vec![],
            ..symbol.clone()
        };
        if crossed.contains(&bare) && !undotted.contains(symbol) {
            *symbol = bare;
            *frame = Some(FrameLabel { text, span });
        }
        return;
    }
    for child in node.children_mut() {
        move_label(child, crossed, undotted);
    }
}
