//! What was found out of the letters of a document so far, so that it is worked out once.

use crate::notation::ast::Symbol;
use crate::verify::model::system::{FrameId, System};
use crate::verify::term::at_instants::{Kept, Present};
use crate::verify::term::letters::{Letters, Meaning};
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{AT_INSTANT, Shape, Value, Valued, beyond};
use foldhash::HashMap;
use std::collections::BTreeSet;
use std::collections::HashMap as Map;

/// The value of a symbol, and how it was found.
#[derive(Clone, Debug)]
pub(super) struct KnownSymbol {
    value: Value,
    frames: BTreeSet<FrameId>,
    /// Whether it hangs on what else the document writes.
    by_written: bool,
}

/// What letters are, as far as it was asked for. It holds for one system.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known {
    /// Shapes of letters that lines have settled.
    pub(crate) shapes: Map<String, Shape>,
    /// Values of letters that sentences tell of, by how they are printed: one may stand for several quantities.
    values: HashMap<String, Vec<(Quantity, Valued)>>,
    /// Values of symbols in which no letter is new, where a symbol means the same on every line; and the frames on whose
    /// axes they are.
    symbols: HashMap<Symbol, KnownSymbol>,
    /// Values at other instants than the present one, and integrals from there.
    pub(crate) kept: Vec<Kept>,
    /// How many dimensions space has where they were worked out.
    dimensions: usize,
}

impl Known {
    /// Letters of these shapes, and nothing worked out.
    pub(crate) fn of(shapes: Map<String, Shape>) -> Self {
        Self {
            shapes,
            ..Self::default()
        }
    }

    /// In a space of another number of dimensions letters have other values.
    pub(super) fn enter(&mut self, dimensions: usize) {
        if self.dimensions != dimensions {
            self.values.clear();
            self.symbols.clear();
            self.dimensions = dimensions;
        }
    }

    /// The value of a letter that stands for a quantity, if it was worked out.
    pub(super) fn value(&self, letter: &str, quantity: &Quantity) -> Option<&Valued> {
        let values = self.values.get(letter)?.iter();
        let mut own = values.filter(|(known, _)| known == quantity);
        own.next().map(|(_, value)| value)
    }

    /// Forgets the values of symbols, as by what a document writes they may mean something else.
    pub(crate) fn forget_symbols(&mut self) {
        self.symbols.clear();
    }

    /// Works out all letters that stand for quantities.
    pub(crate) fn work_out(&mut self, letters: &Letters, system: &mut System) {
        self.enter(system.dimensions());
        for letter in &letters.letters {
            if let Meaning::Quantity(quantity) = &letter.meaning
                && self.value(&letter.latex, quantity).is_none()
            {
                let value = system.letter(&letter.latex, quantity);
                self.keep(&letter.latex, quantity, &value);
            }
        }
    }

    pub(super) fn keep(&mut self, letter: &str, quantity: &Quantity, value: &Valued) {
        let values = self.values.entry(letter.to_owned()).or_default();
        values.push((quantity.clone(), value.clone()));
    }
}

impl Lowering<'_> {
    /// The value of a symbol; where it is the same on every line and no letter is new, it is worked out once.
    pub(super) fn symbol(&mut self, symbol: &Symbol) -> Valued {
        if self.present != Present::Untold {
            let value = self.new_symbol(symbol)?;
            let told = self.is_on_line() && self.unknown.is_empty();
            return match told && self.stands_at_no_instant(symbol, &value) {
                true => beyond(AT_INSTANT),
                false => Ok(value),
            };
        }
        let told_apart = !self.axes.is_empty() || !self.occurrences.besides.is_empty();
        if told_apart || !self.letters.is_uniform() {
            return self.new_symbol(symbol);
        }
        let written = &self.letters.written;
        if let Some(known) = self.known.symbols.get(symbol) {
            self.frames_seen.extend(&known.frames);
            if known.by_written {
                written.note_asked();
            }
            return Ok(known.value.clone());
        }
        let asked = written.times_asked();
        let unknown = std::mem::take(&mut self.unknown);
        let frames = std::mem::take(&mut self.frames_seen);
        let value = self.new_symbol(symbol);
        if let Ok(value) = &value
            && self.unknown.is_empty()
        {
            let known = KnownSymbol {
                value: value.clone(),
                frames: self.frames_seen.clone(),
                by_written: written.times_asked() != asked,
            };
            self.known.symbols.insert(symbol.clone(), known);
        }
        self.unknown.extend(unknown);
        self.frames_seen.extend(frames);
        value
    }
}
