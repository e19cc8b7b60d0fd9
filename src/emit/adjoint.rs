//! Derivatives of what was recorded, backwards through the operations.

use crate::emit::graph::{Operation, Symbol};
use crate::motion::Number;
use crate::scalar::Real;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// The derivatives in `inputs` of a sum of symbols, each times its weight, recorded behind them.
///
/// What `is_held` says of is taken for a constant.
pub(super) fn pull_back(
    weighted: impl IntoIterator<Item = (Symbol, Symbol)>,
    inputs: &[Symbol],
    is_held: impl Fn(Operation) -> bool,
) -> Vec<Symbol> {
    // The last operation is taken first: then all that depends on a symbol has been met when its turn comes.
    let mut waiting = BTreeMap::new();
    for (symbol, weight) in weighted {
        add(&mut waiting, symbol, weight);
    }
    let mut found = BTreeMap::new();
    while let Some((symbol, weight)) = waiting.pop_last() {
        let operation = symbol.operation();
        if inputs.contains(&symbol) {
            found.insert(symbol, weight);
        }
        if !is_held(operation) {
            for (operand, partial) in partials(symbol, operation) {
                add(&mut waiting, operand, partial * weight);
            }
        }
    }
    let derivative = |input: &Symbol| found.get(input).copied().unwrap_or_else(Symbol::zero);
    inputs.iter().map(derivative).collect()
}

fn add(weights: &mut BTreeMap<Symbol, Symbol>, symbol: Symbol, weight: Symbol) {
    let sum = weights.entry(symbol).or_insert_with(Symbol::zero);
    *sum += weight;
}

/// The operands of an operation and its derivatives in them.
fn partials(value: Symbol, operation: Operation) -> Vec<(Symbol, Symbol)> {
    let one = Symbol::one();
    match operation {
        Operation::Input(_) | Operation::Constant(_) => vec![],
        Operation::Negative(a) => vec![(a, -one)],
        Operation::Sum(a, b) => vec![(a, one), (b, one)],
        Operation::Difference(a, b) => vec![(a, one), (b, -one)],
        Operation::Product(a, b) => vec![(a, b), (b, a)],
        Operation::Quotient(a, b) => vec![(a, one / b), (b, -(value / b))],
        Operation::Root(a) => vec![(a, Symbol::of(0.5) / value)],
        Operation::Sine(a) => vec![(a, a.sin_cos().1)],
        Operation::Cosine(a) => vec![(a, -a.sin_cos().0)],
    }
}
