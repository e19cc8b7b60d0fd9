//! First derivatives over any ring, where num-dual's floating-point numbers cannot go.

#![expect(
    clippy::suspicious_arithmetic_impl,
    reason = "the product and quotient rules are sums of products"
)]

use crate::scalar::{Field, Real, Ring};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value and its partial derivatives in `N` directions.
///
/// With one direction, time, it is a motion: `Jet { value: ω, partials: [ω̇] }`. The derivative
/// (dL/dt)_body is had by running L = I ω on it. Jets nest: `Jet<Jet<T, N>, N>` has second derivatives.
///
/// ```
/// use polhode::scalar::Jet;
/// let t = Jet::<f64, 1> { value: 3.0, partials: [1.0] };
/// assert_eq!((t * t * t).partials, [27.0]); // d(t³)/dt = 3t²
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<T, const N: usize> {
    /// The value.
    pub value: T,
    /// Its derivatives, one a direction.
    pub partials: [T; N],
}

impl<T: Ring, const N: usize> Jet<T, N> {
    /// A value that does not depend on any direction.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn constant(value: T) -> Self {
        Self::with(value, |_| T::zero())
    }

    /// The variable of direction `direction`, at `value`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn variable(value: T, direction: usize) -> Self {
        Self::with(value, |i| if i == direction { T::one() } else { T::zero() })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with(value: T, partial: impl FnMut(usize) -> T) -> Self {
        Self {
            value,
            partials: std::array::from_fn(partial),
        }
    }
}

impl<T: Ring> Jet<T, 1> {
    /// A quantity and its rate.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn moving(value: T, rate: T) -> Self {
        Self {
            value,
            partials: [rate],
        }
    }

    /// The derivative in the single direction.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rate(&self) -> T {
        self.partials[0].clone()
    }
}

impl<T: Ring, const N: usize> Add for Jet<T, N> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(self, other: Self) -> Self {
        let (p, q) = (self.partials, other.partials);
        Self::with(self.value + other.value, |i| p[i].clone() + q[i].clone())
    }
}

impl<T: Ring, const N: usize> Sub for Jet<T, N> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sub(self, other: Self) -> Self {
        let (p, q) = (self.partials, other.partials);
        Self::with(self.value - other.value, |i| p[i].clone() - q[i].clone())
    }
}

impl<T: Ring, const N: usize> Neg for Jet<T, N> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            partials: self.partials.map(|p| -p),
        }
    }
}

impl<T: Ring, const N: usize> Mul for Jet<T, N> {
    type Output = Self;
    /// (ab)' = a'b + ab'.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul(self, other: Self) -> Self {
        let (a, p, b, q) = (self.value, self.partials, other.value, other.partials);
        Self::with(a.clone() * b.clone(), |i| {
            p[i].clone() * b.clone() + a.clone() * q[i].clone()
        })
    }
}

impl<T: Field, const N: usize> Div for Jet<T, N> {
    type Output = Self;
    /// (a/b)' = (a' − (a/b) b') / b.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn div(self, other: Self) -> Self {
        let (p, b, q) = (self.partials, other.value, other.partials);
        let quotient = self.value / b.clone();
        Self::with(quotient.clone(), |i| {
            (p[i].clone() - quotient.clone() * q[i].clone()) / b.clone()
        })
    }
}

macro_rules! assigning {
    ($($name:ident $method:ident $by:tt $bound:ident)*) => {$(
        impl<T: $bound, const N: usize> $name for Jet<T, N> {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(&mut self, other: Self) {
                *self = self.clone() $by other;
            }
        }
    )*};
}
assigning! { AddAssign add_assign + Ring SubAssign sub_assign - Ring MulAssign mul_assign * Ring DivAssign div_assign / Field }

impl<T: Ring, const N: usize> Zero for Jet<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn zero() -> Self {
        Self::constant(T::zero())
    }
    /// Zero with all its derivatives: a jet whose value alone vanishes is not zero.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.partials.iter().all(T::is_zero)
    }
}

impl<T: Ring, const N: usize> One for Jet<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn one() -> Self {
        Self::constant(T::one())
    }
}

impl<T: Field, const N: usize> Field for Jet<T, N> {}

impl<T: Real, const N: usize> Real for Jet<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        let twice = root.clone() + root.clone();
        Self::with(root, |i| self.partials[i].clone() / twice.clone())
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        let rate = |i: usize| self.partials[i].clone();
        (
            Self::with(sin.clone(), |i| cos.clone() * rate(i)),
            Self::with(cos.clone(), |i| -(sin.clone() * rate(i))),
        )
    }
}
