//! A number that records what is done with it.
//!
//! A [`Symbol`] is the place of an operation in the recording of its thread. Each operation is recorded once, so that what an
//! equation writes twice is one symbol; what is known, a zero, a one, a number, is worked out at once and not recorded.

use crate::motion::Number;
use crate::scalar::{Field, Real};
use num_traits::{One, Zero};
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The place of an operation in the recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Symbol(usize);

/// What a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    /// Input number `n`.
    Input(usize),
    /// A number, by its bits.
    Constant(u64),
    Negative(Symbol),
    Sum(Symbol, Symbol),
    Difference(Symbol, Symbol),
    Product(Symbol, Symbol),
    Quotient(Symbol, Symbol),
    Root(Symbol),
    Sine(Symbol),
    Cosine(Symbol),
}

/// Operations, each behind those that it takes.
#[derive(Debug, Default)]
pub(super) struct Graph {
    operations: Vec<Operation>,
    places: HashMap<Operation, Symbol>,
}

thread_local! {
    /// Numbers are copied and made out of nothing (`zero()`), so that they can't carry the recording with them.
    static RECORDING: RefCell<Graph> = RefCell::default();
}

/// The operations that `work` does on symbols, and what it returns. No symbol means anything outside.
pub(super) fn record<R>(work: impl FnOnce() -> R) -> (Graph, R) {
    RECORDING.set(Graph::default());
    let result = work();
    (RECORDING.take(), result)
}

impl Graph {
    fn symbol(&mut self, operation: Operation) -> Symbol {
        let next = Symbol(self.operations.len());
        let place = *self.places.entry(operation).or_insert(next);
        if place == next {
            self.operations.push(operation);
        }
        place
    }

    /// What a symbol is.
    pub(super) fn operation(&self, symbol: Symbol) -> Operation {
        self.operations[symbol.0]
    }
}

impl Operation {
    /// The symbols that it takes.
    pub(super) fn operands(self) -> impl DoubleEndedIterator<Item = Symbol> {
        let (first, second) = match self {
            Self::Input(_) | Self::Constant(_) => (None, None),
            Self::Negative(a) | Self::Root(a) | Self::Sine(a) | Self::Cosine(a) => (Some(a), None),
            Self::Sum(a, b)
            | Self::Difference(a, b)
            | Self::Product(a, b)
            | Self::Quotient(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }
}

impl Symbol {
    /// Input number `n`.
    pub(super) fn input(n: usize) -> Self {
        Self::of_operation(Operation::Input(n))
    }

    /// What it is; only while it is recorded.
    pub(super) fn operation(self) -> Operation {
        RECORDING.with_borrow(|graph| graph.operation(self))
    }

    fn of_operation(operation: Operation) -> Self {
        RECORDING.with_borrow_mut(|graph| graph.symbol(operation))
    }

    fn number(self) -> Option<f64> {
        match self.operation() {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// The operation on operands of which the order does not matter: the one in which they were written first.
    fn commuting(a: Self, b: Self, operation: impl Fn(Self, Self) -> Operation) -> Self {
        RECORDING.with_borrow_mut(|graph| match graph.places.get(&operation(b, a)) {
            Some(place) => *place,
            None => graph.symbol(operation(a, b)),
        })
    }

    fn function(self, value: fn(f64) -> f64, operation: fn(Self) -> Operation) -> Self {
        match self.number() {
            Some(number) => Self::of(value(number)),
            None => Self::of_operation(operation(self)),
        }
    }
}

impl Zero for Symbol {
    fn zero() -> Self {
        Self::of(0.0)
    }

    fn is_zero(&self) -> bool {
        self.number() == Some(0.0)
    }
}

impl One for Symbol {
    fn one() -> Self {
        Self::of(1.0)
    }
}

impl Neg for Symbol {
    type Output = Self;

    fn neg(self) -> Self {
        match self.operation() {
            Operation::Constant(bits) => Self::of(-f64::from_bits(bits)),
            Operation::Negative(inner) => inner,
            Operation::Difference(a, b) => b - a,
            _ => Self::of_operation(Operation::Negative(self)),
        }
    }
}

impl Add for Symbol {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        match (self.number(), other.number()) {
            (Some(a), Some(b)) => return Self::of(a + b),
            _ if self.is_zero() => return other,
            _ if other.is_zero() => return self,
            _ => {}
        }
        match (self.operation(), other.operation()) {
            (_, Operation::Negative(b)) => self - b,
            (Operation::Negative(a), _) => other - a,
            _ => Self::commuting(self, other, Operation::Sum),
        }
    }
}

impl Sub for Symbol {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        match (self.number(), other.number()) {
            (Some(a), Some(b)) => return Self::of(a - b),
            _ if self == other => return Self::zero(),
            _ if self.is_zero() => return -other,
            _ if other.is_zero() => return self,
            _ => {}
        }
        match (self.operation(), other.operation()) {
            (_, Operation::Negative(b)) => self + b,
            (Operation::Negative(a), _) => -(a + other),
            _ => Self::of_operation(Operation::Difference(self, other)),
        }
    }
}

impl Mul for Symbol {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if other.number().is_some() && self.number().is_none() {
            return other * self;
        }
        match (self.number(), self.operation(), other.operation()) {
            (Some(a), _, Operation::Constant(b)) => Self::of(a * f64::from_bits(b)),
            (Some(_), ..) if self.is_zero() => self,
            (Some(_), ..) if self.is_one() => other,
            // Numbers without a sign: then what differs by it alone is one product.
            (Some(a), ..) if a < 0.0 => -(-self * other),
            (Some(_), _, Operation::Negative(b)) => -(self * b),
            (Some(_), _, Operation::Product(b, c)) if b.number().is_some() => self * b * c,
            // A number stands first.
            (Some(_), ..) => Self::of_operation(Operation::Product(self, other)),
            (None, Operation::Negative(a), _) => -(a * other),
            (None, _, Operation::Negative(b)) => -(self * b),
            _ => Self::commuting(self, other, Operation::Product),
        }
    }
}

impl Div for Symbol {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        match other.number() {
            Some(divisor) => self * Self::of(1.0 / divisor),
            None if self.is_zero() => self,
            None => Self::of_operation(Operation::Quotient(self, other)),
        }
    }
}

/// `a += b` and its like by `a + b`.
macro_rules! assign {
    ($($assign:ident $by:ident $operator:tt),*) => {$(
        impl $assign for Symbol {
            fn $by(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Field for Symbol {}

impl Real for Symbol {
    fn sqrt(&self) -> Self {
        self.function(f64::sqrt, Operation::Root)
    }

    fn sin_cos(&self) -> (Self, Self) {
        (
            self.function(f64::sin, Operation::Sine),
            self.function(f64::cos, Operation::Cosine),
        )
    }
}

impl Number for Symbol {
    type Value = Self;
    const DERIVATIVES: usize = 0;

    fn of(value: f64) -> Self {
        // −0 is 0 here: no sign of a zero is recorded.
        Self::of_operation(Operation::Constant((value + 0.0).to_bits()))
    }

    fn real(&self) -> Self {
        *self
    }

    fn constant(value: Self) -> Self {
        value
    }

    /// Only that of a number is known.
    fn magnitude(&self) -> f64 {
        self.number().map_or(f64::NAN, f64::abs)
    }
}
