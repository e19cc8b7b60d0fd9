//! What was found out of the letters of a document so far, so that it is worked out once.

use crate::algebra::Fraction;
use crate::notation::ast::{DerivativeStyle, Factor, Kind, Node, Operator, Shape as Tree, Symbol};
use crate::recent::Recent;
use crate::verify::model::system::{FrameId, System};
use crate::verify::term::at_instants::{Kept, Present};
use crate::verify::term::layered::Layered;
use crate::verify::term::letters::{Letters, Meaning};
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{AT_INSTANT, Shape, Value, Valued, beyond};
use foldhash::HashMap;
use num_traits::One;
use std::collections::BTreeSet;
use std::collections::HashMap as Map;
use std::sync::{Arc, Mutex, PoisonError};

/// No more products are kept of one document; then all of them are forgotten.
const MOST_PRODUCTS: usize = 1_000;

/// No more are kept for other documents.
const MOST_COMMON: usize = 2_000;

/// The value of a symbol or of a product, and how it was found.
#[derive(Clone, Debug)]
struct KnownValue {
    value: Value,
    frames: BTreeSet<FrameId>,
    /// Whether it hangs on what else the document writes.
    by_written: bool,
}

/// The order of a rate, and how it is written.
type Rated = (u8, DerivativeStyle);

/// Values of symbols, their rates and products, by their trees, for many documents that begin with the same variables.
#[derive(Clone, Debug)]
struct Common {
    values: Arc<Mutex<Recent<Vec<u8>, Arc<KnownValue>>>>,
    /// How many variables they begin with, and how much of everything else.
    first: usize,
    extent: [usize; 8],
}

/// What letters are, as far as it was asked for. It holds for one system.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known {
    /// Shapes of letters that lines have settled.
    pub(crate) shapes: Map<String, Shape>,
    /// Values of letters that sentences tell of, by how they are printed: one may stand for several quantities.
    values: Arc<HashMap<String, Vec<(Quantity, Valued)>>>,
    /// Values of symbols in which no letter is new, where a symbol means the same on every line; and the frames on whose
    /// axes they are.
    symbols: Layered<Symbol, Arc<KnownValue>>,
    /// The same of the rates of such symbols that are scalars, by their orders and how they are written.
    rates: Vec<(Rated, Layered<Symbol, Arc<KnownValue>>)>,
    /// The same of products of such symbols that are scalars, by their trees.
    products: HashMap<Vec<u8>, Arc<KnownValue>>,
    common: Option<Common>,
    /// Values at other instants than the present one, and integrals from there.
    pub(crate) kept: Vec<Kept>,
    /// How many dimensions space has where they were worked out.
    dimensions: usize,
    /// Whether every writing means the same wherever it stands.
    is_uniform: bool,
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
    pub(super) fn enter(&mut self, dimensions: usize, letters: &Letters) {
        self.is_uniform = letters.is_uniform();
        if self.dimensions != dimensions {
            self.values = Arc::default();
            self.forget_symbols();
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
        self.rates.clear();
        self.products.clear();
        self.common = None;
    }

    /// From here on many documents go on: what they find of products in these variables alone is kept for the others.
    pub(crate) fn share(&mut self, system: &System) {
        self.symbols.share();
        let rates = self.rates.iter_mut();
        rates.for_each(|(_, rates)| rates.share());
        self.common = Some(Common {
            values: Arc::new(Mutex::new(Recent::of(MOST_COMMON))),
            first: system.atoms.len(),
            extent: system.extent(),
        });
    }

    /// As [`Known::forget_symbols`] for another document of those that go on from the same.
    pub(crate) fn forget_what_hangs_on_writing(&mut self) {
        self.symbols.retain(|known| !known.by_written);
        self.products.retain(|_, known| !known.by_written);
        for (_, rates) in &mut self.rates {
            rates.retain(|known| !known.by_written);
        }
    }

    /// Whether something is a number, or a symbol or its rate that was found to be a scalar.
    fn is_scalar(&self, node: &Node) -> bool {
        match &node.kind {
            Kind::Number(_) => true,
            Kind::Symbol(symbol) => {
                let known = self.symbols.get(symbol);
                known.is_some_and(|known| known.value.is_scalar())
            }
            Kind::TimeDerivative {
                operand,
                frame: None,
                ..
            } => matches!(operand.kind, Kind::Symbol(_)) && self.is_scalar(operand),
            _ => false,
        }
    }

    /// Whether a node is a symbol whose value is known, with no new letter in it, and the same on every line.
    pub(crate) fn is_told(&self, node: &Node, letters: &Letters) -> bool {
        let known = |symbol| self.symbols.get(symbol).is_some() && letters.is_uniform();
        matches!(&node.kind, Kind::Symbol(symbol) if known(symbol))
    }

    /// Works out all letters that stand for quantities.
    pub(crate) fn work_out(&mut self, letters: &Letters, system: &mut System) {
        self.enter(system.dimensions(), letters);
        for letter in &letters.letters {
            if let Meaning::Quantity(quantity) = &letter.meaning
                && self.value(&letter.latex, quantity).is_none()
            {
                let value = system.letter(&letter.latex, quantity);
                self.keep(&letter.latex, quantity, &value);
            }
        }
    }

    fn keep_rate(&mut self, symbol: &Symbol, rated: Rated, known: Arc<KnownValue>) {
        let place = self.rates.iter().position(|(own, _)| *own == rated);
        let place = place.unwrap_or_else(|| {
            self.rates.push((rated, Layered::default()));
            self.rates.len() - 1
        });
        self.rates[place].1.insert(symbol.clone(), known);
    }

    pub(super) fn keep(&mut self, letter: &str, quantity: &Quantity, value: &Valued) {
        let values = Arc::make_mut(&mut self.values);
        let values = values.entry(letter.to_owned()).or_default();
        values.push((quantity.clone(), value.clone()));
    }
}

impl Lowering<'_> {
    /// Whether every writing has the same value wherever it stands.
    fn means_the_same(&self) -> bool {
        self.known.is_uniform
            && self.present == Present::Untold
            && self.axes.is_empty()
            && self.occurrences.besides.is_empty()
    }

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
        if !self.means_the_same() {
            return self.new_symbol(symbol);
        }
        if let Some(known) = self.known.symbols.get(symbol) {
            let value = known.value.clone();
            self.frames_seen.extend(&known.frames);
            self.note(known.by_written);
            return Ok(value);
        }
        let tree = || Tree::of_symbol(symbol);
        let (value, known) = self.common_or_by_itself(tree, |own| own.new_symbol(symbol));
        if let Some(known) = known {
            self.known.symbols.insert(symbol.clone(), known);
        }
        value
    }

    /// The rate of a symbol, which is found so; one that is a scalar and the same on every line is worked out once.
    pub(super) fn rate_of_symbol(
        &mut self,
        symbol: &Symbol,
        rated: Rated,
        find: impl FnOnce(&mut Self) -> Valued,
    ) -> Valued {
        if !self.means_the_same() {
            return find(self);
        }
        let mut rates = self.known.rates.iter();
        let rates = rates.find(|(own, _)| *own == rated);
        if let Some(known) = rates.and_then(|(_, rates)| rates.get(symbol)) {
            let value = known.value.clone();
            self.frames_seen.extend(&known.frames);
            self.note(known.by_written);
            return Ok(value);
        }
        let tree = || Tree::of_rate(symbol, rated.0, rated.1);
        let (value, known) = self.common_or_by_itself(tree, find);
        if let Some(known) = known.filter(|known| known.value.is_scalar()) {
            self.known.keep_rate(symbol, rated, known);
        }
        value
    }

    /// The value of a product; one of scalars that are the same on every line is worked out once.
    pub(super) fn product_of(&mut self, node: &Node, factors: &[Factor]) -> Valued {
        let mut tree = Tree::default();
        if !self.means_the_same() || tree.tree(node).is_none() {
            return self.product(factors);
        }
        let tree = tree.as_bytes();
        if let Some(known) = self.in_common(tree) {
            self.frames_seen.extend(&known.frames);
            return Ok(known.value.clone());
        }
        if !factors.iter().all(|f| self.known.is_scalar(&f.node)) {
            return self.product(factors);
        }
        if let Some(known) = self.known.products.get(tree) {
            let value = known.value.clone();
            self.frames_seen.extend(&known.frames);
            self.note(known.by_written);
            return Ok(value);
        }
        let before = self.system.atoms.len();
        let (value, known) = self.by_itself(|own| own.product_of_scalars(factors));
        if let Some(known) = known {
            if self.system.atoms.len() == before {
                self.keep_in_common(tree, &known);
            }
            let products = &mut self.known.products;
            if products.len() >= MOST_PRODUCTS {
                products.clear();
            }
            products.insert(tree.to_vec(), known);
        }
        value
    }

    /// The value of a product of scalars that stand side by side, none of which means something together with another.
    fn product_of_scalars(&mut self, factors: &[Factor]) -> Valued {
        let is_plain = !self.letters.has_phrases()
            && !self.letters.customs.sums_at(self.at)
            && factors.iter().all(|f| f.operator == Operator::Juxtaposed);
        let Some((last, before)) = factors.split_last().filter(|_| is_plain) else {
            return self.product(factors);
        };
        let before: Result<Vec<Value>, _> = before.iter().map(|f| self.value(&f.node)).collect();
        let (before, mut product) = (before?, self.value(&last.node)?);
        for left in before.iter().rev() {
            product = product.scaled(left.entries.first().unwrap_or(&Fraction::one()));
        }
        Ok(product)
    }

    /// The value of a symbol or of its rate, as another document had it or by itself, and how it is kept. Scalars are kept
    /// for other documents too.
    fn common_or_by_itself(
        &mut self,
        tree: impl FnOnce() -> Tree,
        find: impl FnOnce(&mut Self) -> Valued,
    ) -> (Valued, Option<Arc<KnownValue>>) {
        if self.known.common.is_none() {
            return self.by_itself(find);
        }
        let tree = tree();
        if let Some(known) = self.in_common(tree.as_bytes()) {
            self.frames_seen.extend(&known.frames);
            return (Ok(known.value.clone()), Some(known));
        }
        let before = self.system.atoms.len();
        let (value, known) = self.by_itself(find);
        let same = self.system.atoms.len() == before;
        let scalar = known.as_ref().filter(|known| known.value.is_scalar());
        if let Some(known) = scalar.filter(|_| same) {
            self.keep_in_common(tree.as_bytes(), known);
        }
        (value, known)
    }

    /// The value of a symbol, a rate or a product that another document had.
    fn in_common(&self, tree: &[u8]) -> Option<Arc<KnownValue>> {
        let common = self.known.common.as_ref()?;
        let values = common.values.lock();
        // Nothing in it is ever half done.
        let mut values = values.unwrap_or_else(PoisonError::into_inner);
        values.get(tree)
    }

    /// Keeps the value of a symbol, a rate or a product for other documents, if it is the same in each.
    fn keep_in_common(&self, tree: &[u8], known: &Arc<KnownValue>) {
        let Some(common) = &self.known.common else {
            return;
        };
        let mut variables = known.value.entries.iter().flat_map(Fraction::variables);
        let is_same = variables.all(|variable| (variable as usize) < common.first)
            && !known.by_written
            && self.system.extent() == common.extent;
        if is_same {
            let values = common.values.lock();
            let mut values = values.unwrap_or_else(PoisonError::into_inner);
            values.insert(tree.to_vec(), known.clone(), 1);
        }
    }

    /// What is known of something hangs on what else the document writes.
    fn note(&self, by_written: bool) {
        if by_written {
            self.letters.written.note_asked();
        }
    }

    /// What something is worth whatever stands before it, and how that is kept if no letter in it is new.
    fn by_itself(
        &mut self,
        value: impl FnOnce(&mut Self) -> Valued,
    ) -> (Valued, Option<Arc<KnownValue>>) {
        let written = &self.letters.written;
        let asked = written.times_asked();
        let unknown = std::mem::take(&mut self.unknown);
        let frames = std::mem::take(&mut self.frames_seen);
        let value = value(self);
        let known = value.as_ref().ok().filter(|_| self.unknown.is_empty());
        let known = known.map(|value| {
            Arc::new(KnownValue {
                value: value.clone(),
                frames: self.frames_seen.clone(),
                by_written: written.times_asked() != asked,
            })
        });
        self.unknown.extend(unknown);
        self.frames_seen.extend(frames);
        (value, known)
    }
}
