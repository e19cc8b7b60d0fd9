//! The scalars that motion runs on.

use crate::scalar::{Jet, Real};
use num_dual::{Dual, Dual2, DualNum, DualVec, HyperDual};

/// A [`Real`] that is copied freely and can be had from a double: doubles, singles, dual numbers, jets.
pub trait Number: Real + Copy {
    /// The number `value`, constant in every direction.
    fn of(value: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
}

impl Number for f32 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value as Self
    }
}

impl<T: Number, const N: usize> Number for Jet<T, N> {
    #[inline]
    fn of(value: f64) -> Self {
        Self::constant(T::of(value))
    }
}

macro_rules! number_by_real_part {
    ($([$($generics:tt)*] $scalar:ty;)*) => {$(
        impl<T: Number + DualNum, $($generics)*> Number for $scalar
        where
            Self: Real + Copy + DualNum<InnerDual = T>,
        {
            #[inline]
            fn of(value: f64) -> Self {
                Self::from_re(T::of(value))
            }
        }
    )*};
}

number_by_real_part! {
    [] Dual<T>;
    [] Dual2<T>;
    [] HyperDual<T>;
    [const N: usize] DualVec<T, nalgebra::Const<N>>;
}
