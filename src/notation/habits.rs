//! What a document shows as a whole of how its author writes: decimal commas, letters above that are labels, `δ/δt`.

use crate::notation::ast::{DerivativeStyle, FrameLabel, Kind, Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::notation::parse::COMMA_BETWEEN_DIGITS;
use std::collections::{BTreeMap, BTreeSet};

/// Whether a document parts decimals by a comma: it writes `2{,}5`, or `2,5` in several places, and nowhere `2.5`.
pub(super) fn decimal_commas(document: &Document) -> bool {
    let text = document.source.text.as_bytes();
    let comma = |w: &[u8]| w[1] == b',' && (w[2].is_ascii_digit() || w == b"{,}");
    if !text.windows(3).any(comma) {
        return false;
    }
    let (mut points, mut braced, mut bare) = (0, 0, 0);
    for side in sides(document) {
        each(side, &mut |node| match &node.kind {
            Kind::Number(number) if number.decimals.is_some_and(|d| d > 0) => {
                let written = document.source.slice(node.span);
                braced += usize::from(written.contains("{,}") && !written.contains('.'));
                points += usize::from(written.contains('.'));
            }
            Kind::Error(message) if message == COMMA_BETWEEN_DIGITS => {
                let behind = text.get(node.span.end as usize..).unwrap_or(&[]);
                let digits = behind.iter().take_while(|b| b.is_ascii_digit()).count();
                bare += usize::from(digits != 3);
            }
            _ => {}
        });
    }
    points == 0 && (braced > 0 || bare > 1)
}

/// The sides of all lines, and what stands alone.
fn sides(document: &Document) -> impl Iterator<Item = &Node> {
    let rows = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    rows.flatten().flat_map(|row| match row {
        Row::Line(line) => line.sides.as_slice(),
        Row::Expression(node) => std::slice::from_ref(node),
        Row::Unreadable { .. } => &[],
    })
}

fn sides_mut(items: &mut [Item]) -> impl Iterator<Item = &mut Node> {
    let rows = items.iter_mut().filter_map(|item| match item {
        Item::Formula(formula) => Some(&mut formula.rows),
        _ => None,
    });
    rows.flatten().flat_map(|row| match row {
        Row::Line(line) => line.sides.as_mut_slice(),
        Row::Expression(node) => std::slice::from_mut(node),
        Row::Unreadable { .. } => &mut [],
    })
}

/// Visits a node and all below it.
fn each<'n>(node: &'n Node, visit: &mut dyn FnMut(&'n Node)) {
    visit(node);
    node.children().for_each(|child| each(child, visit));
}

/// The symbol of a letter that nothing hangs on.
fn lone_letter(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::Symbol(symbol) if symbol.name.len() == 1 => {
            let alone = Symbol {
                name: symbol.name.clone(),
                ..Symbol::default()
            };
            (*symbol == alone).then_some(symbol.name.as_str())
        }
        _ => None,
    }
}

/// The symbol that a power is taken of, under dots or not.
fn base_of(node: &Node) -> Option<&Symbol> {
    match &node.kind {
        Kind::Symbol(symbol) => Some(symbol),
        Kind::TimeDerivative {
            operand,
            style: DerivativeStyle::Dots,
            ..
        } => base_of(operand),
        _ => None,
    }
}

/// Letters that stand for the body, the space and the world, and those that join them where they stand above the same letters.
const FRAMES: [&str; 3] = ["b", "s", "w"];
const OTHER_FRAMES: [&str; 3] = ["i", "n", "e"];

/// `ω^b` and `L^b`: a letter that stands above several others and nowhere else is the label of a frame and no power.
pub(super) fn labels_above(document: &mut Document) {
    if !document.source.text.contains('^') {
        return;
    }
    let mut below: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    let (mut uses, mut powers) = (
        BTreeMap::<&str, usize>::new(),
        BTreeMap::<&str, usize>::new(),
    );
    for side in sides(document) {
        each(side, &mut |node| match &node.kind {
            Kind::Power(base, exponent) => {
                if let (Some(base), Some(letter)) = (base_of(base), lone_letter(exponent)) {
                    below.entry(letter).or_default().insert(&base.name);
                    *powers.entry(letter).or_default() += 1;
                }
            }
            Kind::Symbol(symbol) => {
                *uses.entry(&symbol.name).or_default() += 1;
                for label in symbol.superscripts.iter().filter(|label| label.len() == 1) {
                    below.entry(label).or_default().insert(&symbol.name);
                }
            }
            _ => {}
        });
    }
    let only_above = |letter: &&str| {
        let all = uses.get(*letter).copied().unwrap_or(0);
        all == powers.get(*letter).copied().unwrap_or(0)
    };
    let met = |letter: &&str| below.contains_key(*letter) && only_above(letter);
    let frames: Vec<&str> = FRAMES.into_iter().filter(met).collect();
    let bases: BTreeSet<_> = frames.iter().flat_map(|f| &below[f]).collect();
    if frames.is_empty() || frames.len() + bases.len() < 3 {
        return;
    }
    let shares = |letter: &&str| below[letter].iter().any(|base| bases.contains(base));
    let others = OTHER_FRAMES.into_iter().filter(met).filter(shares);
    let labels: Vec<&str> = frames.into_iter().chain(others).collect();
    for side in sides_mut(&mut document.items) {
        label_powers(side, &labels);
    }
}

fn label_powers(node: &mut Node, labels: &[&str]) {
    for child in node.children_mut() {
        label_powers(child, labels);
    }
    if let Kind::Power(base, exponent) = &mut node.kind
        && let Some(letter) = lone_letter(exponent).filter(|letter| labels.contains(letter))
        && let Some(symbol) = crate::notation::parse::symbol_of(base)
    {
        symbol.superscripts.push(letter.to_owned());
        node.kind = base.kind.clone();
    }
}

/// A symbol behind a δ.
fn varied(node: &Node) -> Option<&Symbol> {
    match &node.kind {
        Kind::Symbol(symbol) if symbol.variation => Some(symbol),
        _ => None,
    }
}

/// Whether a rate is written with δ: `\frac{\delta L}{\delta t}`.
fn is_rate_of_deltas(node: &Node) -> bool {
    matches!(&node.kind, Kind::TimeDerivative { frame: Some(label), .. } if label.text == FrameLabel::DELTA)
}

/// `\frac{\delta L}{\delta t}` is a rate where no `\delta L` stands alone; beside `\frac{dL}{dt}` it is the rate on axes that
/// turn.
pub(super) fn rates_in_deltas(document: &mut Document) {
    let source = &document.source.text;
    if !source.contains("delta") && !source.contains('δ') {
        return;
    }
    let (mut rates, mut variations, mut total) = (0, 0, false);
    for side in sides(document) {
        each(side, &mut |node| {
            rates += usize::from(is_rate_of_deltas(node));
            variations += usize::from(varied(node).is_some());
            total |= matches!(
                &node.kind,
                Kind::TimeDerivative {
                    style: DerivativeStyle::Leibniz,
                    frame: None,
                    ..
                }
            );
        });
    }
    if rates == 0 || variations > 0 {
        return;
    }
    for side in sides_mut(&mut document.items) {
        label_rates_of_deltas(side, total);
    }
}

fn label_rates_of_deltas(node: &mut Node, total: bool) {
    for child in node.children_mut() {
        label_rates_of_deltas(child, total);
    }
    let of_deltas = is_rate_of_deltas(node);
    match &mut node.kind {
        Kind::TimeDerivative { operand, frame, .. } if of_deltas => {
            let component =
                matches!(&operand.kind, Kind::Symbol(symbol) if !symbol.subscripts.is_empty());
            *frame = (total && !component).then(|| FrameLabel::new(FrameLabel::TURNING, node.span));
        }
        Kind::InFrame(inner, label) => {
            if let Kind::Group(_, rate) = &mut inner.kind
                && let Kind::TimeDerivative { frame, .. } = &mut rate.kind
            {
                *frame = Some(label.clone());
                node.kind = rate.kind.clone();
            }
        }
        _ => {}
    }
}
