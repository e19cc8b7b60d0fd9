//! The symbols that a document could write: those that it writes, and each with another index or another dot.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Row};
use crate::notation::reread;
use crate::verify::check::Checker;
use crate::verify::correction::edit::{dotted, other_axis, replaced_index, undotted};
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axis};
use crate::verify::values::atoms::Entity;
use crate::verify::values::symbol::Meaning;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// Symbols that are kept at most.
const WORDS: usize = 200;

/// A symbol as the document writes it.
pub(crate) struct Word {
    pub(crate) text: String,
    pub(crate) value: Fraction,
    letter: Letter,
    subscripts: Vec<String>,
    order: u8,
    /// What it is a component of.
    of: Option<Entity>,
}

impl Checker<'_> {
    /// What could stand in a line: its own symbols first, then the document's, then their neighbours.
    pub(crate) fn vocabulary(&mut self, line: &Line) -> Vec<Word> {
        let document = self.document;
        let mut texts: Vec<String> = vec![];
        let mut seen = BTreeSet::new();
        let own = line.sides.iter().map(|side| written(document, side));
        let of_document = self.written.get_or_init(|| written_in(document));
        for side in own.chain(of_document.iter().cloned()) {
            if texts.len() >= WORDS {
                break;
            }
            let new = side
                .into_iter()
                .filter(|text| seen.insert((*text).to_owned()));
            texts.extend(new.map(str::to_owned));
        }
        // A letter that is a component by itself has its siblings in other letters.
        for letter in self.reading.components.keys().filter(|l| !l.calligraphic) {
            if seen.insert(letter.name.clone()) {
                texts.push(letter.name.clone());
            }
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
        let document = self.document;
        let known = self.words.entry(text.clone());
        let node = known
            .or_insert_with(|| expression(document, &text))
            .clone()?;
        let (symbol, order) = symbol(&node)?;
        let value = self.lowering(Frame::Moving).scalar(&node)?;
        // Nobody writes ṫ for 1.
        if order > 0 && value.to_rational().is_some() {
            return None;
        }
        let of = match self.meaning_of(symbol) {
            Meaning::Component(entity, _) => Some(entity),
            _ => None,
        };
        Some(Word {
            value,
            letter: Letter::of(symbol),
            subscripts: symbol.subscripts.clone(),
            order,
            of,
            text,
        })
    }
}

impl Word {
    /// Whether another word differs from it in the letter alone.
    pub(crate) fn has_sibling(&self, other: &Self) -> bool {
        let same = self.subscripts == other.subscripts && self.order == other.order;
        same && !self.subscripts.is_empty() && self.letter != other.letter
    }

    /// Whether it is a number beside the motion: the mass, a length.
    pub(crate) fn is_parameter(&self) -> bool {
        self.order == 0 && self.subscripts.is_empty() && self.of.is_none()
    }
}

/// The symbols of the sides of a document's lines, those of a side that none before it has; no more than are kept.
fn written_in(document: &Document) -> Vec<Vec<&str>> {
    let mut seen = BTreeSet::new();
    let mut found = vec![];
    for side in document.lines().flat_map(|l| &l.sides) {
        if seen.len() >= WORDS {
            break;
        }
        let mut texts = written(document, side);
        texts.retain(|text| seen.insert(*text));
        found.push(texts);
    }
    found.retain(|texts| !texts.is_empty());
    found
}

/// The symbols of a side, as they are written.
fn written<'d>(document: &'d Document, side: &Node) -> Vec<&'d str> {
    let mut texts = vec![];
    atoms(side, &mut |node| {
        let text = document.source.slice(node.span).trim();
        texts.extend((!text.is_empty()).then_some(text));
    });
    texts
}

/// The expression that a text holds.
pub(crate) fn expression(document: &Document, text: &str) -> Option<Node> {
    let rows = reread(document, &format!("{text} = 0"));
    match rows.as_slice() {
        [Row::Line(line)] => line.sides.first().cloned(),
        _ => None,
    }
}

/// The symbols of a tree, under their dots.
fn atoms<'a>(node: &'a Node, look: &mut impl FnMut(&'a Node)) {
    if symbol(node).is_some() {
        look(node);
        return;
    }
    node.children().for_each(|child| atoms(child, look));
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
pub(crate) fn difference(written: &Word, wanted: &Word) -> Option<(&'static str, u32)> {
    let same_letter = written.letter == wanted.letter;
    let same_index = written.subscripts == wanted.subscripts;
    let siblings = same_letter || (written.of.is_some() && written.of == wanted.of);
    match (same_letter && same_index, written.order.cmp(&wanted.order)) {
        (true, Ordering::Less) => Some(("missing-dot", 10)),
        (true, Ordering::Greater) => Some(("extra-dot", 13)),
        (true, Ordering::Equal) => None,
        (false, Ordering::Equal) if siblings => Some(("index", 12)),
        (false, Ordering::Equal) => Some(("symbol", 16)),
        (false, _) => None,
    }
}
