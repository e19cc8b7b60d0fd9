//! What was found of a formula in one document, kept for others that are read alike.
//!
//! It holds wherever the same formula meets the same variables. Documents bring up variables of their own, in an order of
//! their own, so these are told apart; what a formula itself brings up is brought up again.

use crate::algebra::{Fraction, Polynomial};
use crate::notation::ast::{Line, Node, Shape};
use crate::recent::{Digest, Recent};
use crate::verify::model::changes::Added;
use crate::verify::model::system::System;
use crate::verify::standing::chains::Link;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// How many bytes of one kind are kept, about.
const MOST_BYTES: usize = 3 << 19;

/// What one that is looked for takes, what a value takes beside its terms, and what each term takes.
const BYTES: usize = 160;
const BYTES_OF_VALUE: usize = 600;
const BYTES_OF_TERM: usize = 60;

/// What the bytes of a line begin with.
const TREE: usize = 127;

/// Documents with variables in more orders than this are not told apart, and nothing of them is kept.
const MOST_STATES: usize = 48;

/// What is kept, for many documents.
#[derive(Debug)]
pub(crate) struct Memory<V>(Arc<Mutex<Kept<V>>>);

/// All documents that begin with the same variables have one.
impl<V> Clone for Memory<V> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<V> Default for Memory<V> {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(Kept {
            states: vec![],
            values: Recent::of(MOST_BYTES),
        })))
    }
}

#[derive(Debug)]
struct Kept<V> {
    /// The variables that documents brought up.
    states: Vec<Added>,
    values: Recent<Wording, Found<V>>,
}

/// What was found, and the state after it, where it brought up variables.
#[derive(Debug)]
struct Found<V> {
    value: Value<V>,
    then: Option<u32>,
}

impl<V> Clone for Found<V> {
    fn clone(&self) -> Self {
        Self {
            value: self.value.clone(),
            then: self.then,
        }
    }
}

/// A value, or the wording of which the same was found.
#[derive(Debug)]
enum Value<V> {
    Own(Arc<V>),
    Of(Wording),
}

impl<V> Clone for Value<V> {
    fn clone(&self) -> Self {
        match self {
            Self::Own(value) => Self::Own(value.clone()),
            Self::Of(wording) => Self::Of(*wording),
        }
    }
}

impl<V> Found<V> {
    fn own(self) -> Option<Arc<V>> {
        match self.value {
            Value::Own(value) => Some(value),
            Value::Of(_) => None,
        }
    }
}

impl<V> Memory<V> {
    fn kept(&self) -> MutexGuard<'_, Kept<V>> {
        // Nothing in it is ever half done.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A formula beside the variables that it meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Wording {
    state: u32,
    of: Digest,
}

impl Wording {
    /// The same beside something else that it hangs on.
    pub(crate) fn beside(self, other: Digest) -> Self {
        Self {
            of: Digest::of(&(self.of, other)),
            ..self
        }
    }
}

/// A formula as it is looked for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Formula<'f> {
    /// Its text, its tree and what else it hangs on.
    Tree(Vec<u8>),
    /// The trees of a link, beside what else it hangs on.
    Link(usize, Digest),
    /// What its sides are worth.
    Sides(Vec<&'f Polynomial>),
    /// Whether the first of these vanish where the others do, with their rates or without.
    Follows(usize, bool, Vec<&'f Polynomial>),
}

impl<'f> Formula<'f> {
    /// By the trees of a link, which may be known, beside what else it hangs on; `None` where its text tells more than
    /// these do.
    pub(crate) fn of_link(link: &Link<'_>, known: Option<Digest>, beside: usize) -> Option<Self> {
        let tree = known.or_else(|| tree_of(link.sides()))?;
        Some(Self::Link(beside, tree))
    }

    /// By the trees of a line, beside how it is written.
    pub(crate) fn of_line(line: &Line, text: &str) -> Option<Self> {
        let mut shape = Shape::default();
        shape.number(TREE);
        shape.text(text);
        for (relation, _) in &line.relations {
            shape.number(*relation as usize);
        }
        line.sides.iter().try_for_each(|side| shape.tree(side))?;
        Some(Self::Tree(shape.into_bytes()))
    }

    /// What it is looked for by. The bytes of a line begin as those of nothing else do.
    fn digest(&self) -> Digest {
        match self {
            Self::Tree(bytes) => Digest::of_bytes(bytes),
            _ => Digest::of(self),
        }
    }

    /// By what its sides are worth.
    pub(crate) fn of_sides(sides: &'f [(Fraction, Fraction)]) -> Self {
        let sides = sides.iter().flat_map(|(left, right)| [left, right]);
        Self::Sides(parts(sides))
    }

    /// Whether these vanish where those do.
    pub(crate) fn of_goals(goals: &'f [Fraction], from: &'f [Fraction], rates: bool) -> Self {
        Self::Follows(goals.len(), rates, parts(goals.iter().chain(from)))
    }
}

/// Two sides as they are looked for by their trees; `None` where the text tells more than these do.
pub(crate) fn tree_of(sides: [&Node; 2]) -> Option<Digest> {
    let mut shape = Shape::default();
    sides.into_iter().try_for_each(|side| shape.tree(side))?;
    Some(Digest::of_bytes(shape.as_bytes()))
}

/// What fractions are made of.
fn parts<'f>(of: impl Iterator<Item = &'f Fraction>) -> Vec<&'f Polynomial> {
    of.flat_map(|value| [value.numerator(), value.denominator()])
        .collect()
}

/// The memory, as one document uses it.
#[derive(Debug)]
pub(crate) struct Recall<V> {
    memory: Memory<V>,
    /// How many variables the document began with.
    first: usize,
    /// Which variables it has, and since when.
    state: Option<u32>,
    changes: Option<u64>,
    /// How much the system had of everything else.
    extent: [usize; 8],
}

impl<V> Recall<V> {
    /// For a document that begins with this.
    pub(crate) fn new(memory: Memory<V>, system: &mut System) -> Self {
        system.atoms.watch();
        Self {
            memory,
            first: system.atoms.len(),
            state: None,
            changes: None,
            extent: system.extent(),
        }
    }

    /// Whether all variables of a value are among those that the document began with.
    pub(crate) fn is_of_beginning(&self, value: &Fraction) -> bool {
        let mut variables = value.variables().into_iter();
        variables.all(|variable| (variable as usize) < self.first)
    }

    /// A formula beside the variables that there are; `None` where there are too many others.
    pub(crate) fn wording(&mut self, system: &System, of: &Formula<'_>) -> Option<Wording> {
        let state = self.state(system)?;
        let of = of.digest();
        Some(Wording { state, of })
    }

    /// The formula of a wording beside the variables that there are now.
    pub(crate) fn anew(&mut self, system: &System, wording: Wording) -> Option<Wording> {
        let state = self.state(system)?;
        Some(Wording { state, ..wording })
    }

    /// The number of the variables that the document has; `None` where there are too many others.
    pub(crate) fn state(&mut self, system: &System) -> Option<u32> {
        let atoms = &system.atoms;
        if self.changes != Some(atoms.changes()) {
            self.changes = Some(atoms.changes());
            self.state = self.find_state(system);
        }
        self.state
    }

    fn find_state(&self, system: &System) -> Option<u32> {
        let atoms = &system.atoms;
        if !atoms.are_untouched(self.first) || system.extent() != self.extent {
            return None;
        }
        let states = &mut self.memory.kept().states;
        let known = states
            .iter()
            .position(|added| atoms.has_added(self.first, added));
        if known.is_none() && states.len() < MOST_STATES {
            states.push(atoms.added(self.first));
            return Some(states.len() as u32 - 1);
        }
        known.map(|state| state as u32)
    }

    /// What was found before; the variables that it brought up then are there afterwards.
    pub(crate) fn known(&mut self, system: &mut System, wording: Wording) -> Option<Arc<V>> {
        self.known_of(system, wording).map(|(value, _)| value)
    }

    /// The same, and the wording that it was found of.
    pub(crate) fn known_of(
        &mut self,
        system: &mut System,
        wording: Wording,
    ) -> Option<(Arc<V>, Wording)> {
        let mut kept = self.memory.kept();
        let found = kept.values.get(&wording)?;
        let (value, of) = match found.value {
            Value::Own(value) => (value, wording),
            Value::Of(other) => (kept.values.get(&other)?.own()?, other),
        };
        if let Some(then) = found.then {
            system
                .atoms
                .bring_up(self.first, &kept.states[then as usize]);
            (self.state, self.changes) = (Some(then), Some(system.atoms.changes()));
        }
        Some((value, of))
    }

    /// Keeps what was found, which has so many terms.
    pub(crate) fn keep(&mut self, system: &System, wording: Wording, found: Arc<V>, terms: usize) {
        let bytes = BYTES + BYTES_OF_VALUE + terms * BYTES_OF_TERM;
        self.keep_value(system, wording, Value::Own(found), bytes);
    }

    /// Keeps that what was found is the same as of another wording.
    pub(crate) fn keep_as(&mut self, system: &System, wording: Wording, other: Wording) {
        self.keep_value(system, wording, Value::Of(other), BYTES);
    }

    fn keep_value(&mut self, system: &System, wording: Wording, value: Value<V>, bytes: usize) {
        let Some(now) = self.state(system) else {
            return;
        };
        let then = Some(now).filter(|now| *now != wording.state);
        let values = &mut self.memory.kept().values;
        values.insert(wording, Found { value, then }, bytes);
    }
}
