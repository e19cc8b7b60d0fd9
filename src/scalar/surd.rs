//! Numbers a + b√d: exact values where a formula has a root of a number in it.

use crate::scalar::Field;
use num_traits::{One, Zero};
use std::fmt;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number a + b√d over a field. Two with different d have no sum of this form; what they make is no number any more,
/// as [`Surd::is_number`] tells.
#[derive(Clone, Debug, PartialEq)]
pub struct Surd<T> {
    /// a.
    pub whole: T,
    /// b.
    pub part: T,
    /// d, which is no square; zero where b is zero.
    pub radicand: T,
    /// Whether two with different d were put together on the way.
    mixed: bool,
}

impl<T: Field> Surd<T> {
    /// A number of the field itself.
    pub fn from_field(whole: T) -> Self {
        Self::new(whole, T::zero(), T::zero())
    }

    /// The number a + b√d.
    pub fn new(whole: T, part: T, radicand: T) -> Self {
        let radicand = match part.is_zero() {
            true => T::zero(),
            false => radicand,
        };
        Self {
            whole,
            part,
            radicand,
            mixed: false,
        }
    }

    /// Whether it was made of numbers with one d.
    pub fn is_number(&self) -> bool {
        !self.mixed
    }

    /// a² − b² d.
    pub fn norm(&self) -> T {
        self.whole.clone() * self.whole.clone()
            - self.part.clone() * self.part.clone() * self.radicand.clone()
    }

    /// What is made of two, by their common d.
    fn joined(&self, other: &Self, parts: impl FnOnce(&T) -> (T, T)) -> Self {
        let radicand = match self.part.is_zero() {
            true => &other.radicand,
            false => &self.radicand,
        };
        let apart = !self.part.is_zero() && !other.part.is_zero();
        let mixed = self.mixed || other.mixed || apart && self.radicand != other.radicand;
        let (whole, part) = parts(radicand);
        Self {
            mixed,
            ..Self::new(whole, part, radicand.clone())
        }
    }
}

impl<T: Field> Add for Surd<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.joined(&other, |_| {
            let whole = self.whole.clone() + other.whole.clone();
            (whole, self.part.clone() + other.part.clone())
        })
    }
}

impl<T: Field> Neg for Surd<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            whole: -self.whole,
            part: -self.part,
            ..self
        }
    }
}

impl<T: Field> Sub for Surd<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Field> Mul for Surd<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.joined(&other, |radicand| {
            let [a, b, c, d] =
                [&self.whole, &self.part, &other.whole, &other.part].map(|part| part.clone());
            let whole = a.clone() * c.clone() + b.clone() * d.clone() * radicand.clone();
            (whole, a * d + b * c)
        })
    }
}

impl<T: Field> Div for Surd<T> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let norm = other.norm();
        let zero = norm.is_zero();
        let conjugate = Self {
            part: -other.part.clone(),
            ..other
        };
        let product = self * conjugate;
        match zero {
            // Only of what is no number is the norm zero, but for zero itself.
            true => Self {
                mixed: true,
                ..product
            },
            false => Self {
                whole: product.whole / norm.clone(),
                part: product.part / norm,
                ..product
            },
        }
    }
}

macro_rules! assign {
    ($($name:ident $function:ident $operator:tt),*) => {$(
        impl<T: Field> $name for Surd<T> {
            fn $function(&mut self, other: Self) {
                *self = self.clone() $operator other;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl<T: Field> Zero for Surd<T> {
    fn zero() -> Self {
        Self::from_field(T::zero())
    }
    fn is_zero(&self) -> bool {
        self.whole.is_zero() && self.part.is_zero()
    }
}

impl<T: Field> One for Surd<T> {
    fn one() -> Self {
        Self::from_field(T::one())
    }
}

impl<T: Field> Field for Surd<T> {}

impl<T: Field + fmt::Display> fmt::Display for Surd<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            whole,
            part,
            radicand,
            ..
        } = self;
        match (whole.is_zero(), part.is_zero()) {
            (_, true) => write!(f, "{whole}"),
            (true, false) => write!(f, "{part} √{radicand}"),
            (false, false) => write!(f, "{whole} + {part} √{radicand}"),
        }
    }
}
