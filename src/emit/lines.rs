//! Which of the recorded operations have a line and a name of their own.

use crate::emit::Precision;
use crate::emit::graph::{Operation, Symbol};
use crate::emit::routine::{Argument, Routine};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Operations that a line may have before one of its parts gets a line of its own.
const LENGTH: usize = 8;

/// The operations that outputs need, in the order in which they are done.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    pub(super) routine: &'a Routine,
    used: BTreeSet<Symbol>,
    /// What is used twice, or is long, by its number.
    named: BTreeMap<Symbol, usize>,
}

/// How many operations of each kind a piece of code does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Sums and differences.
    pub additions: usize,
    /// Products.
    pub multiplications: usize,
    /// Quotients.
    pub divisions: usize,
    /// Changes of sign.
    pub negations: usize,
    /// Square roots.
    pub roots: usize,
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.additions, "addition"),
            (self.multiplications, "multiplication"),
            (self.divisions, "division"),
            (self.negations, "change of sign"),
            (self.roots, "square root"),
        ];
        let told = |(count, what): &(usize, &str)| match (count, *what) {
            (1, what) => format!("1 {what}"),
            (count, "change of sign") => format!("{count} changes of sign"),
            (count, what) => format!("{count} {what}s"),
        };
        let done = counts.iter().filter(|(count, _)| *count > 0);
        let listed: Vec<_> = done.map(told).collect();
        match listed.is_empty() {
            true => f.write_str("no operation"),
            false => f.write_str(&listed.join(", ")),
        }
    }
}

impl<'a> Lines<'a> {
    pub(super) fn new(routine: &'a Routine) -> Self {
        let uses = uses(routine);
        let (mut named, mut lengths) = (BTreeMap::new(), BTreeMap::<Symbol, usize>::new());
        for (symbol, uses) in &uses {
            let operation = routine.graph.operation(*symbol);
            if matches!(operation, Operation::Input(_) | Operation::Constant(_)) {
                continue;
            }
            let inside = operation.operands().filter_map(|o| lengths.get(&o));
            let length = 1 + inside.sum::<usize>();
            if *uses > 1 || length > LENGTH {
                named.insert(*symbol, named.len());
            } else {
                lengths.insert(*symbol, length);
            }
        }
        let used = uses.into_keys().collect();
        Self {
            routine,
            used,
            named,
        }
    }

    /// The operations that have a name, by their number, in the order in which they are done.
    pub(super) fn named(&self) -> impl Iterator<Item = (usize, Symbol)> {
        self.named.iter().map(|(symbol, number)| (*number, *symbol))
    }

    /// The number of an operation that has a name.
    pub(super) fn number_of(&self, symbol: Symbol) -> Option<usize> {
        self.named.get(&symbol).copied()
    }

    /// What a symbol is.
    pub(super) fn operation(&self, symbol: Symbol) -> Operation {
        self.routine.graph.operation(symbol)
    }

    /// The arguments, and for each of their numbers whether it is used.
    pub(super) fn arguments(&self) -> impl Iterator<Item = (&'a Argument, Vec<bool>)> {
        let inputs = self.used.iter().filter_map(|s| match self.operation(*s) {
            Operation::Input(input) => Some(input),
            _ => None,
        });
        let inputs: BTreeSet<_> = inputs.collect();
        let mut first = 0;
        self.routine.arguments.iter().map(move |argument| {
            let places = first..first + argument.letters.len();
            first = places.end;
            (
                argument,
                places.map(|place| inputs.contains(&place)).collect(),
            )
        })
    }

    /// Whether every number that stands in the code can be written in a precision: finite, and not lost to zero.
    pub(super) fn fit(&self, precision: Precision) -> bool {
        let fits = |number: f64| match precision {
            Precision::Double => number.is_finite(),
            Precision::Single => number == 0.0 || (number as f32).is_normal(),
        };
        let operations = self.used.iter().map(|symbol| self.operation(*symbol));
        let mut numbers = operations.filter_map(|operation| match operation {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        });
        numbers.all(fits)
    }

    /// How many operations are done.
    pub(super) fn operations(&self) -> Operations {
        let mut count = Operations::default();
        for symbol in &self.used {
            match self.operation(*symbol) {
                Operation::Sum(..) | Operation::Difference(..) => count.additions += 1,
                Operation::Product(..) => count.multiplications += 1,
                Operation::Quotient(..) => count.divisions += 1,
                Operation::Negative(_) => count.negations += 1,
                Operation::Root(_) => count.roots += 1,
                _ => {}
            }
        }
        count
    }
}

/// How often each operation is used that outputs need.
fn uses(routine: &Routine) -> BTreeMap<Symbol, usize> {
    let mut uses = BTreeMap::<Symbol, usize>::new();
    for entry in routine.outputs.iter().flat_map(|output| &output.entries) {
        *uses.entry(*entry).or_default() += 1;
    }
    // Operands stand before what takes them: the last one that waits has all its uses counted.
    let mut waiting: BTreeSet<_> = uses.keys().copied().collect();
    while let Some(symbol) = waiting.pop_last() {
        for operand in routine.graph.operation(symbol).operands() {
            *uses.entry(operand).or_default() += 1;
            waiting.insert(operand);
        }
    }
    uses
}
