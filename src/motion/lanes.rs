//! Eight doubles that go through the equations side by side.

use crate::motion::Number;
use crate::scalar::{Field, Real};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// How many doubles stand side by side.
pub const LANES: usize = 8;

/// Eight doubles as one [`Number`]: each operation is done on all of them, as on one, to the bit.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Lanes, Number, Rk4, Scheme, State, System, Torque};
///
/// let inertia = Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0)).map(Lanes::of);
/// let system = System::over(inertia, Torque::None, Vector3::zeros());
/// let speeds = Lanes::new([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
/// let start = State::at_rest().turning(Vector3::new(Lanes::of(0.1), speeds, Lanes::of(0.2)));
/// let end = Rk4.step(&system, Lanes::of(0.0), &start, Lanes::of(0.01));
/// assert!(end.angular_velocity.y.to_array()[3] < 4.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Lanes([f64; LANES]);

impl Lanes {
    /// Eight values.
    #[inline(always)]
    pub fn new(values: [f64; LANES]) -> Self {
        Self(values)
    }

    /// The eight values.
    #[inline(always)]
    pub fn to_array(self) -> [f64; LANES] {
        self.0
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let mut values = self.0;
        for value in &mut values {
            *value = f(*value);
        }
        Self(values)
    }
}

macro_rules! lanewise {
    ($($operation:ident $method:ident $assign:ident $assign_method:ident;)*) => {$(
        impl $operation for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let mut values = self.0;
                for (value, other) in values.iter_mut().zip(other.0) {
                    *value = value.$method(other);
                }
                Self(values)
            }
        }

        impl $assign for Lanes {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = $operation::$method(*self, other);
            }
        }
    )*};
}

lanewise! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|value| -value)
    }
}

impl Zero for Lanes {
    #[inline(always)]
    fn zero() -> Self {
        Self([0.0; LANES])
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.0.iter().all(Zero::is_zero)
    }
}

impl One for Lanes {
    #[inline(always)]
    fn one() -> Self {
        Self([1.0; LANES])
    }
}

impl Field for Lanes {}

impl Real for Lanes {
    #[inline(always)]
    fn sqrt(&self) -> Self {
        self.each(f64::sqrt)
    }

    #[inline(always)]
    fn sin_cos(&self) -> (Self, Self) {
        (self.each(f64::sin), self.each(f64::cos))
    }
}

impl Number for Lanes {
    type Value = Self;
    const DERIVATIVES: usize = 0;

    #[inline(always)]
    fn of(value: f64) -> Self {
        Self([value; LANES])
    }

    #[inline(always)]
    fn real(&self) -> Self {
        *self
    }

    #[inline(always)]
    fn constant(value: Self) -> Self {
        value
    }

    #[inline(always)]
    fn magnitude(&self) -> f64 {
        // What is no number is the largest: `max` would drop it.
        self.0.iter().fold(0.0, |most: f64, value| {
            if value.is_nan() || most.is_nan() {
                f64::NAN
            } else {
                most.max(value.abs())
            }
        })
    }
}
