//! The scalars that motion runs on.

use crate::motion::sines::sines;
use crate::scalar::{Jet, Real};
use num_dual::{Dual, Dual2, DualNum, DualVec, HyperDual};

/// A [`Real`] that is copied freely and can be had from a double: doubles, singles, dual numbers, jets.
pub trait Number: Real + Copy {
    /// The number without its derivatives.
    type Value: Number<Value = Self::Value>;

    /// The highest order of derivatives that it carries.
    const DERIVATIVES: usize;

    /// The number `value`, constant in every direction.
    fn of(value: f64) -> Self;

    /// This number times a constant one, which has no derivatives to multiply by.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    fn scaled(self, factor: f64) -> Self {
        self * Self::of(factor)
    }

    /// The value, its derivatives left behind.
    fn real(&self) -> Self::Value;

    /// The number of a value, constant in every direction.
    fn constant(value: Self::Value) -> Self;

    /// |value|.
    fn magnitude(&self) -> f64;

    /// The sines of three angles, in radians. Of doubles they are had side by side.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    fn sines(angles: [Self; 3]) -> [Self; 3] {
        let [a, b, c] = angles;
        [a.sin_cos().0, b.sin_cos().0, c.sin_cos().0]
    }
}

/// A real number: no derivative to keep, and itself its value.
macro_rules! real {
    ($($real:ty),*) => {$(
        impl Number for $real {
            type Value = Self;
            const DERIVATIVES: usize = 0;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn real(&self) -> Self {
                *self
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn constant(value: Self) -> Self {
                value
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn magnitude(&self) -> f64 {
                self.abs().into()
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn of(value: f64) -> Self {
                value as Self
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn sines(angles: [Self; 3]) -> [Self; 3] {
                let [a, b, c] = angles;
                let [a, b, c] = sines([a.into(), b.into(), c.into()]);
                [a as Self, b as Self, c as Self]
            }
        }
    )*};
}

real!(f64, f32);

impl<T: Number, const N: usize> Number for Jet<T, N> {
    type Value = <T as Number>::Value;
    const DERIVATIVES: usize = T::DERIVATIVES + 1;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn real(&self) -> <T as Number>::Value {
        self.value.real()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: <T as Number>::Value) -> Self {
        Self::constant(T::constant(value))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn magnitude(&self) -> f64 {
        self.value.magnitude()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(value: f64) -> Self {
        Self::constant(T::of(value))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn scaled(self, factor: f64) -> Self {
        Self {
            value: self.value.scaled(factor),
            partials: self.partials.map(|partial| partial.scaled(factor)),
        }
    }
}

macro_rules! number_by_real_part {
    ($([$($generics:tt)*] $scalar:ty, $order:literal;)*) => {$(
        impl<T: Number + DualNum, $($generics)*> Number for $scalar
        where
            Self: Real + Copy + DualNum<InnerDual = T>,
        {
            type Value = <T as Number>::Value;
            const DERIVATIVES: usize = T::DERIVATIVES + $order;

            #[inline]
            fn of(value: f64) -> Self {
                Self::from_re(T::of(value))
            }

            #[inline]
            fn real(&self) -> <T as Number>::Value {
                self.re.real()
            }

            #[inline]
            fn constant(value: <T as Number>::Value) -> Self {
                Self::from_re(T::constant(value))
            }

            #[inline]
            fn magnitude(&self) -> f64 {
                self.re.magnitude()
            }
        }
    )*};
}

number_by_real_part! {
    [] Dual<T>, 1;
    [] Dual2<T>, 2;
    [] HyperDual<T>, 2;
    [const N: usize] DualVec<T, nalgebra::Const<N>>, 1;
}
