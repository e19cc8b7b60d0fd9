//! The prime field of 2⁶¹ − 1 elements: exact, a word wide, and quick.
//!
//! Two polynomials that differ agree at a random point of this field with a probability of at most
//! degree / 2⁶¹ (Schwartz 1980, Zippel 1979): the filter that sees false lines before a proof is tried.

use crate::scalar::Field;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// An integer modulo the Mersenne prime 2⁶¹ − 1, always reduced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Prime(u64);

impl Prime {
    /// The number of elements.
    pub const MODULUS: u64 = (1 << 61) - 1;

    /// The residue of `n`.
    #[inline]
    pub fn new(n: u64) -> Self {
        Self(n % Self::MODULUS)
    }

    /// The residue as an integer in `0 .. MODULUS`.
    #[inline]
    pub fn residue(self) -> u64 {
        self.0
    }

    /// `self` to the power `exponent`, by squaring.
    pub fn pow(self, mut exponent: u64) -> Self {
        let (mut base, mut product) = (self, Self::one());
        while exponent > 0 {
            if exponent & 1 == 1 {
                product *= base;
            }
            base *= base;
            exponent >>= 1;
        }
        product
    }

    /// The inverse, or `None` of zero.
    pub fn inverse(self) -> Option<Self> {
        // Fermat: a^(p−2) is the inverse of a.
        (self.0 != 0).then(|| self.pow(Self::MODULUS - 2))
    }
}

/// Brings a number below 2⁶² under the modulus.
#[inline]
fn reduced(n: u64) -> u64 {
    if n >= Prime::MODULUS {
        n - Prime::MODULUS
    } else {
        n
    }
}

impl Add for Prime {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(reduced(self.0 + other.0))
    }
}

impl Sub for Prime {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(reduced(self.0 + (Self::MODULUS - other.0)))
    }
}

impl Neg for Prime {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(reduced(Self::MODULUS - self.0))
    }
}

impl Mul for Prime {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        // 2⁶¹ ≡ 1, so the high bits of the product are added to the low ones.
        let product = u128::from(self.0) * u128::from(other.0);
        let low = (product as u64) & Self::MODULUS;
        let high = (product >> 61) as u64;
        Self(reduced(low + high))
    }
}

impl Div for Prime {
    type Output = Self;
    /// The quotient; a division by zero gives zero, as there is no other element to give. Who may meet
    /// a zero divisor asks [`Prime::inverse`].
    #[inline]
    fn div(self, other: Self) -> Self {
        other.inverse().map_or(Self(0), |inverse| self * inverse)
    }
}

macro_rules! assigning {
    ($($name:ident $method:ident $by:tt)*) => {$(
        impl $name for Prime {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $by other;
            }
        }
    )*};
}
assigning! { AddAssign add_assign + SubAssign sub_assign - MulAssign mul_assign * DivAssign div_assign / }

impl Zero for Prime {
    #[inline]
    fn zero() -> Self {
        Self(0)
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.0 == 0
    }
}

impl One for Prime {
    #[inline]
    fn one() -> Self {
        Self(1)
    }
}

impl Field for Prime {}
