//! A number of some thirty digits.

use crate::motion::Number;
use crate::scalar::{Field, Real};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use twofloat::TwoFloat;

/// The unevaluated sum of two doubles (Dekker 1971), as a scalar that every equation of motion runs on.
///
/// ```
/// use polhode::{bench::Double, motion::Number, scalar::Real};
/// let root = Double::of(2.0).sqrt();
/// let off = root * root - Double::of(2.0);
/// assert!(off.value().abs() < 1e-30);
/// let third = Double::of(1.0) / Double::of(3.0);
/// assert!((third * Double::of(3.0) - Double::of(1.0)).value().abs() < 1e-30);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double(TwoFloat);

impl Double {
    /// The nearest double.
    pub fn value(self) -> f64 {
        self.0.hi() + self.0.lo()
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $assigned:ident $assign:ident $sign:tt;)*) => {$(
        impl $operator for Double {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $sign other.0)
            }
        }
        impl $assigned for Double {
            #[inline]
            fn $assign(&mut self, other: Self) {
                self.0 = self.0 $sign other.0;
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign +;
    Sub sub SubAssign sub_assign -;
    Mul mul MulAssign mul_assign *;
}

impl Div for Double {
    type Output = Self;
    /// By two corrections of the quotient of the leading doubles: the division of `twofloat` 0.8 keeps a double's digits.
    fn div(self, other: Self) -> Self {
        let by = other.0.hi();
        let mut quotient = TwoFloat::from(self.0.hi() / by);
        for _ in 0..2 {
            let rest = self.0 - quotient * other.0;
            quotient += rest.hi() / by;
        }
        Self(quotient)
    }
}

impl DivAssign for Double {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl Neg for Double {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Double {
    fn zero() -> Self {
        Self::of(0.0)
    }

    fn is_zero(&self) -> bool {
        self.value() == 0.0
    }
}

impl One for Double {
    fn one() -> Self {
        Self::of(1.0)
    }
}

impl Field for Double {}

impl Real for Double {
    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn sin_cos(&self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
}

impl Number for Double {
    type Value = Self;
    const DERIVATIVES: usize = 0;

    fn real(&self) -> Self {
        *self
    }

    fn constant(value: Self) -> Self {
        value
    }

    fn magnitude(&self) -> f64 {
        self.value().abs()
    }

    #[inline]
    fn of(value: f64) -> Self {
        Self(value.into())
    }
}
