//! The symbols that a document writes.

use crate::recent::Digest;
use crate::source::Span;
use foldhash::HashMap;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What stands among the symbols where a rate on axes that turn is written, with a d that is marked or a δ.
pub(crate) const TURNING_RATE: &str = "d'/dt";

/// What stands among the symbols where a symmetric matrix has letters with two labels off its diagonal as they are, and where
/// all of them have a minus: by the one, products of inertia are entries, by the other, integrals.
pub(crate) const PRODUCTS_AS_ENTRIES: &str = "products:=entries";
pub(crate) const PRODUCTS_AS_INTEGRALS: &str = "products:=-entries";

/// What stands among the symbols where a line says by `:=` or `=:` what a letter is.
pub(crate) fn defined(letter: &str) -> String {
    format!("{letter} :=")
}

/// What a document writes. All who go through it share it.
pub(crate) type Written = Arc<Writing>;

/// The symbols that a document writes, spelled, and its lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Writing {
    pub(crate) symbols: BTreeSet<String>,
    /// What lines of two sides are looked for by, each by its bytes; none where a macro makes several of the same bytes.
    pub(crate) trees: HashMap<Span, Option<Digest>>,
    /// Up to where sums run over an index, as the document writes it first.
    pub(crate) bounds: BTreeMap<String, String>,
}

/// The symbols that a document writes, spelled, and those of which it writes a rate. It keeps in mind what was asked: two
/// documents that answer it alike are read alike.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct WrittenSymbols {
    written: Written,
    /// Those that a sentence writes in two ways.
    of_sentences: BTreeSet<String>,
    asked: RefCell<BTreeSet<String>>,
    /// The shapes that were asked for, each with what fits it.
    shapes: RefCell<Vec<(String, Vec<char>)>>,
    times: Times,
}

/// How often something was asked; no part of what is written.
#[derive(Clone, Debug, Default)]
struct Times(Cell<usize>);

impl PartialEq for Times {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl WrittenSymbols {
    pub(crate) fn new(written: Written) -> Self {
        Self {
            written,
            ..Self::default()
        }
    }

    /// Whether the document, or a sentence that keeps it apart, writes a symbol.
    pub(crate) fn has(&self, symbol: &str) -> bool {
        self.note_asked();
        if !self.asked.borrow().contains(symbol) {
            self.asked.borrow_mut().insert(symbol.to_owned());
        }
        self.written.symbols.contains(symbol) || self.of_sentences.contains(symbol)
    }

    /// What stands for a character in symbols like one: `A` for `X` where `R_AB` is written and `R_XY` is asked for.
    pub(crate) fn like(&self, shape: &str, wild: &[char]) -> BTreeSet<(char, char)> {
        self.note_asked();
        let asked = (shape.to_owned(), wild.to_vec());
        if !self.shapes.borrow().contains(&asked) {
            self.shapes.borrow_mut().push(asked);
        }
        like(&self.written.symbols, shape, wild)
    }

    /// How often something was asked so far.
    pub(crate) fn times_asked(&self) -> usize {
        self.times.0.get()
    }

    /// Something is known by what was asked.
    pub(crate) fn note_asked(&self) {
        self.times.0.set(self.times.0.get() + 1);
    }

    /// The symbols that the document writes, as they are looked for.
    pub(crate) fn digest(&self) -> Digest {
        Digest::of(&self.written.symbols)
    }

    /// Up to where sums run over an index.
    pub(crate) fn bounds(&self) -> &BTreeMap<String, String> {
        &self.written.bounds
    }

    /// What a line of the document is looked for by, if it has two sides.
    pub(crate) fn tree(&self, line: Span) -> Option<Digest> {
        self.written.trees.get(&line).copied().flatten()
    }

    /// The symbols of another document take the place of these.
    pub(crate) fn replace(&mut self, other: Written) {
        self.written = other;
    }

    pub(super) fn keep_apart(&mut self, symbols: impl Iterator<Item = String>) {
        self.of_sentences.extend(symbols);
    }

    /// Whether a document that writes other symbols answers alike what was asked so far.
    pub(crate) fn answers_as(&self, other: &Writing) -> bool {
        let (own, other) = (&self.written.symbols, &other.symbols);
        let asked = self.asked.borrow();
        let mut asked = asked.iter();
        let shapes = self.shapes.borrow();
        asked.all(|symbol| own.contains(symbol) == other.contains(symbol))
            && shapes
                .iter()
                .all(|(shape, wild)| like(own, shape, wild) == like(other, shape, wild))
    }
}

fn like(written: &BTreeSet<String>, shape: &str, wild: &[char]) -> BTreeSet<(char, char)> {
    let fits = |symbol: &&String| {
        let same = |(s, c): (char, char)| s == c || (wild.contains(&s) && c.is_uppercase());
        symbol.chars().count() == shape.chars().count()
            && shape.chars().zip(symbol.chars()).all(same)
    };
    let pairs = |symbol: &String| -> Vec<(char, char)> {
        let pairs = shape.chars().zip(symbol.chars());
        pairs.filter(|(s, _)| wild.contains(s)).collect()
    };
    written.iter().filter(fits).flat_map(pairs).collect()
}
