//! The symbols that a document writes.

use std::cell::RefCell;
use std::collections::BTreeSet;

/// The symbols that a document writes, spelled, and those of which it writes a rate. It keeps in mind what was asked: two
/// documents that answer it alike are read alike.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct WrittenSymbols {
    written: BTreeSet<String>,
    /// Those that a sentence writes in two ways.
    of_sentences: BTreeSet<String>,
    asked: RefCell<BTreeSet<String>>,
}

impl WrittenSymbols {
    pub(crate) fn new(written: BTreeSet<String>) -> Self {
        Self {
            written,
            ..Self::default()
        }
    }

    /// Whether the document, or a sentence that keeps it apart, writes a symbol.
    pub(crate) fn has(&self, symbol: &str) -> bool {
        if !self.asked.borrow().contains(symbol) {
            self.asked.borrow_mut().insert(symbol.to_owned());
        }
        self.written.contains(symbol) || self.of_sentences.contains(symbol)
    }

    /// The symbols of another document stand beside these.
    pub(crate) fn extend(&mut self, other: BTreeSet<String>) {
        self.written.extend(other);
    }

    /// The symbols of another document take the place of these.
    pub(crate) fn replace(&mut self, other: BTreeSet<String>) {
        self.written = other;
    }

    pub(super) fn keep_apart(&mut self, symbols: impl Iterator<Item = String>) {
        self.of_sentences.extend(symbols);
    }

    /// Whether a document that writes other symbols answers alike what was asked so far.
    pub(crate) fn answers_as(&self, other: &BTreeSet<String>) -> bool {
        let asked = self.asked.borrow();
        let mut asked = asked.iter();
        asked.all(|symbol| self.written.contains(symbol) == other.contains(symbol))
    }
}
