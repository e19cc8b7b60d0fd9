//! The symbols that a document could write: those that it writes, and each with another index or another dot.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::edit::{dotted, other_axis, replaced_index, undotted};
use crate::verify::frame::Frame;
use crate::verify::repair::lines;
use crate::verify::usage::{Letter, axis};
use crate::verify::wanted::expression;
use std::collections::BTreeSet;

/// Symbols that are kept at most.
const WORDS: usize = 200;

/// A symbol as the document writes it.
pub(super) struct Word {
    pub(super) text: String,
    pub(super) node: Node,
    pub(super) value: Fraction,
}

impl Checker<'_> {
    /// What could stand in a line: its own symbols first, then the document's, then their neighbours.
    pub(super) fn vocabulary(&mut self, line: &Line) -> Vec<Word> {
        let document = self.document;
        let mut texts: Vec<String> = vec![];
        let mut seen = BTreeSet::new();
        for side in line
            .sides
            .iter()
            .chain(lines(document).flat_map(|l| &l.sides))
        {
            if texts.len() >= WORDS {
                break;
            }
            atoms(side, &mut |node| {
                let text = document.source.slice(node.span).trim();
                if !text.is_empty() && seen.insert(text.to_owned()) {
                    texts.push(text.to_owned());
                }
            });
        }
        for at in 0..texts.len() {
            let Some(text) = texts.get(at).cloned() else {
                break;
            };
            for near in neighbours(&text) {
                if texts.len() < WORDS && seen.insert(near.clone()) {
                    texts.push(near);
                }
            }
        }
        texts
            .into_iter()
            .filter_map(|text| self.word(text))
            .collect()
    }

    fn word(&mut self, text: String) -> Option<Word> {
        let node = expression(self.document.format, &text)?;
        symbol(&node)?;
        let value = self.lowering(Frame::Moving).value(&node).ok()?;
        let [value] = value.entries.as_slice() else {
            return None;
        };
        let value = value.clone();
        Some(Word { text, node, value })
    }
}

/// The symbols of a tree, under their dots.
fn atoms<'a>(node: &'a Node, look: &mut impl FnMut(&'a Node)) {
    if symbol(node).is_some() {
        look(node);
        return;
    }
    node.children()
        .into_iter()
        .for_each(|child| atoms(child, look));
}

/// The symbol of a node and how often it is differentiated.
fn symbol(node: &Node) -> Option<(&Symbol, u8)> {
    match &node.kind {
        Kind::Symbol(symbol) => Some((symbol, 0)),
        Kind::TimeDerivative {
            operand,
            order,
            frame: None,
            ..
        } => match &operand.kind {
            Kind::Symbol(symbol) => Some((symbol, *order)),
            _ => None,
        },
        _ => None,
    }
}

/// A symbol's text with each other index, and each of these with a dot more or less.
fn neighbours(text: &str) -> Vec<String> {
    let mut all = other_indices(text);
    all.push(text.to_owned());
    let dots: Vec<String> = all
        .iter()
        .map(|text| undotted(text).unwrap_or_else(|| dotted(text)))
        .collect();
    all.extend(dots);
    all
}

fn other_indices(text: &str) -> Vec<String> {
    let Some((_, index)) = text.rsplit_once('_') else {
        return vec![];
    };
    let index: String = index
        .trim_start_matches('{')
        .chars()
        .take_while(|c| axis(&c.to_string()).is_some())
        .collect();
    let mut all = vec![];
    for (place, c) in index.chars().enumerate() {
        for to in 0..3 {
            let other = other_axis(c, to).filter(|other| *other != c);
            let new: Option<String> = other.map(|other| {
                let letters = index.chars().enumerate();
                letters
                    .map(|(i, c)| if i == place { other } else { c })
                    .collect()
            });
            all.extend(new.and_then(|new| replaced_index(text, &index, &new)));
        }
    }
    all
}

/// What one who writes one symbol for another has done, and how unlikely that is; `None` for the same symbol.
pub(super) fn difference(written: &Node, wanted: &Word) -> Option<(&'static str, u32)> {
    let ((a, m), (b, n)) = (symbol(written)?, symbol(&wanted.node)?);
    let same_letter = Letter::of(a) == Letter::of(b);
    let same_index = a.subscripts == b.subscripts;
    match (same_letter, same_index) {
        (true, true) if m < n => Some(("missing-dot", 10)),
        (true, true) if m > n => Some(("extra-dot", 13)),
        (true, true) => None,
        (true, false) if m == n => Some(("index", 12)),
        _ if m == n => Some(("symbol", 16)),
        _ => Some(("symbol", 19)),
    }
}
