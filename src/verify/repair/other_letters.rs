//! Another letter in the place of a vector, or of a component that a false line is not linear in.

use crate::notation::ast::{Kind, Line, Node};
use crate::verify::check::Checker;
use crate::verify::correction::edit::Edit;
use crate::verify::letters::frame::Frame;
use crate::verify::repair::wanted::Wanted;

/// Letters that are tried in one place.
const LETTERS: usize = 8;

impl Checker<'_> {
    /// Edits of one letter each.
    pub(crate) fn other_letters(&mut self, line: &Line, wanted: Option<&Wanted<'_>>) -> Vec<Edit> {
        let mut met = vec![];
        line.sides.iter().for_each(|side| symbols(side, &mut met));
        let mut edits = vec![];
        let vectors = self.vector_letters();
        for node in met {
            let text = self.document.source.slice(node.span).trim();
            if vectors.iter().any(|vector| vector == text) {
                let others = vectors.iter().filter(|other| *other != text);
                edits.extend(others.map(|other| replaced(node, text, other)));
                continue;
            }
            let Some(wanted) = wanted.filter(|wanted| !wanted.covers(node.span)) else {
                continue;
            };
            let Some(word) = wanted.words.iter().find(|word| word.text == text) else {
                continue;
            };
            let others = wanted.words.iter().filter(|other| word.has_sibling(other));
            edits.extend(
                others
                    .take(LETTERS)
                    .map(|other| replaced(node, text, &other.text)),
            );
        }
        edits
    }

    /// The symbols that the document writes for whole vectors.
    fn vector_letters(&mut self) -> Vec<String> {
        let document = self.document;
        let mut met = vec![];
        document
            .lines()
            .flat_map(|l| &l.sides)
            .for_each(|side| symbols(side, &mut met));
        let mut texts: Vec<String> = vec![];
        for node in met {
            let text = document.source.slice(node.span).trim();
            if texts.len() >= LETTERS || texts.iter().any(|t| t == text) {
                continue;
            }
            let value = self.lowering(Frame::Moving).value(node);
            if value.is_ok_and(|value| value.entries.len() == 3) {
                texts.push(text.to_owned());
            }
        }
        texts
    }
}

fn replaced(node: &Node, text: &str, other: &str) -> Edit {
    Edit {
        span: node.span,
        text: other.to_owned(),
        kind: "symbol",
        message: format!("{text} should be {other}"),
        cost: 16,
    }
}

fn symbols<'n>(node: &'n Node, met: &mut Vec<&'n Node>) {
    // The sign of a resultant belongs to its letter alone.
    if matches!(&node.kind, Kind::Symbol(symbol) if !symbol.resultant) {
        met.push(node);
    }
    node.children().for_each(|child| symbols(child, met));
}
