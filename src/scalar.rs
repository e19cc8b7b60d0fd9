//! The kinds of number that the equations run on.
//!
//! A ladder of three rungs: [`Ring`] (sums and products: all that the equation of rotational motion
//! needs), [`Field`] (division as well: angular acceleration from moment) and [`Real`] (the functions
//! that rotations are written in). No equation knows which scalar it runs on, and none branches on a
//! value: that keeps dual numbers, polynomials and lanes legal.
//!
//! | scalar | rung | what it is for |
//! | --- | --- | --- |
//! | `f64`, `f32`, `num_dual::Dual`, `num_dual::DualVec` | `Real` | motion and Jacobians |
//! | `BigRational`, [`Prime`] | `Field` | exact values; the filter before a proof |
//! | [`Surd<T>`](Surd) over either | `Field` | the same where a formula has a root of a number |
//! | `Polynomial` over ℚ | `Ring` | proofs |
//! | `Fraction` of polynomials | `Field` | proofs with divisions |
//! | [`Jet<T, N>`](Jet) over any of them | as `T` | exact first derivatives |

mod jet;
mod prime;
mod surd;

pub use jet::Jet;
pub use prime::Prime;
pub use surd::Surd;

use nalgebra::{
    ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, DefaultAllocator, Dim,
    Scalar, allocator::Allocator,
};
use num_dual::{Dual, Dual2, DualNum, DualVec, HyperDual};
use num_traits::{One, Zero};
use std::ops::Neg;

/// Sums, differences and products: all that the equation of rotational motion needs.
pub trait Ring:
    Scalar + Zero + One + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + Neg<Output = Self>
{
    /// The integer `n`, by doubling, so that no scalar has to say how.
    #[inline]
    fn int(n: i32) -> Self {
        let (mut rest, mut power, mut sum) = (n.unsigned_abs(), Self::one(), Self::zero());
        while rest > 0 {
            if rest & 1 == 1 {
                sum += power.clone();
            }
            rest >>= 1;
            if rest > 0 {
                power += power.clone();
            }
        }
        if n < 0 { -sum } else { sum }
    }
}

impl<T> Ring for T where
    T: Scalar + Zero + One + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + Neg<Output = T>
{
}

/// A ring whose division undoes its product. Not implied by `/`: `i64` is no field.
pub trait Field: Ring + ClosedDivAssign {
    /// The quotient of two integers, `p / q`.
    #[inline]
    fn ratio(p: i32, q: i32) -> Self {
        Self::int(p) / Self::int(q)
    }
}

/// A field with the functions that rotations are written in.
pub trait Real: Field {
    /// The square root.
    fn sqrt(&self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(&self) -> (Self, Self);
}

impl Field for f32 {}
impl Field for f64 {}
#[cfg(feature = "verify")]
impl Field for num_rational::BigRational {}
impl<T: DualNum + Scalar> Field for Dual<T> where Self: Ring + ClosedDivAssign {}
impl<T: DualNum + Scalar> Field for Dual2<T> where Self: Ring + ClosedDivAssign {}
impl<T: DualNum + Scalar> Field for HyperDual<T> where Self: Ring + ClosedDivAssign {}
impl<T: DualNum + Scalar, D: Dim> Field for DualVec<T, D>
where
    DefaultAllocator: Allocator<D>,
    Self: Ring + ClosedDivAssign,
{
}

/// `Real` for scalars whose square root and sine num-dual already knows.
macro_rules! real_by_dual_num {
    ($([$($generics:tt)*] $scalar:ty $(, $bound:path)?;)*) => {$(
        impl<$($generics)*> Real for $scalar where Self: Field + DualNum, $(DefaultAllocator: $bound)? {
            #[inline]
            fn sqrt(&self) -> Self {
                DualNum::sqrt(self)
            }
            #[inline]
            fn sin_cos(&self) -> (Self, Self) {
                DualNum::sin_cos(self)
            }
        }
    )*};
}

real_by_dual_num! {
    [] f32;
    [] f64;
    [T: DualNum + Scalar] Dual<T>;
    [T: DualNum + Scalar] Dual2<T>;
    [T: DualNum + Scalar] HyperDual<T>;
    [T: DualNum + Scalar, D: Dim] DualVec<T, D>, Allocator<D>;
}
