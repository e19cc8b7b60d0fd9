//! Exact rational numbers: two machine words while they fit, big integers when they do not.

use crate::scalar::{Field, Prime};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::fmt;
use std::num::NonZeroU64;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A rational number in lowest terms with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Form);

/// A number that fits machine words is always kept in them, so that equal numbers have equal forms. A denominator that is
/// never zero leaves room for the mark of the other form, and a number is two words long.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    Small(i64, NonZeroU64),
    Big(Box<BigRational>),
}

const ONE: NonZeroU64 = NonZeroU64::MIN;

/// No larger numbers are looked for whose squares divide another.
const LARGEST_ROOT: i64 = 100;

impl Rational {
    /// `numerator / denominator`; zero over a zero denominator, as no other number is nearer.
    fn small(numerator: i64, denominator: i64) -> Self {
        if denominator == 1 {
            return Self(Form::Small(numerator, ONE));
        }
        Self::reduced(i128::from(numerator), i128::from(denominator))
    }

    fn reduced(numerator: i128, denominator: i128) -> Self {
        if denominator == 0 {
            return Self::zero();
        }
        let divisor = numerator.gcd(&denominator) * denominator.signum();
        let (n, d) = (numerator / divisor, denominator / divisor);
        match (i64::try_from(n), u64::try_from(d).map(NonZeroU64::new)) {
            (Ok(n), Ok(Some(d))) => Self(Form::Small(n, d)),
            _ => Self(Form::Big(Box::new(BigRational::new_raw(
                n.into(),
                d.into(),
            )))),
        }
    }

    /// The same number as a pair of big integers.
    pub fn to_big(&self) -> BigRational {
        match &self.0 {
            Form::Small(n, d) => BigRational::new_raw((*n).into(), d.get().into()),
            Form::Big(big) => (**big).clone(),
        }
    }

    /// The residue in the prime field; `None` where the denominator vanishes there.
    pub fn to_prime(&self) -> Option<Prime> {
        let (n, d) = match &self.0 {
            Form::Small(n, d) => {
                let size = Prime::new(n.unsigned_abs());
                (if *n < 0 { -size } else { size }, Prime::new(d.get()))
            }
            Form::Big(big) => {
                let modulus = BigInt::from(Prime::MODULUS);
                let residue = |n: &BigInt| Prime::new(n.mod_floor(&modulus).to_u64().unwrap_or(0));
                (residue(big.numer()), residue(big.denom()))
            }
        };
        if d.is_one() {
            Some(n)
        } else {
            d.inverse().map(|inverse| n * inverse)
        }
    }

    /// The integer that it is, if it is one and fits.
    pub fn to_integer(&self) -> Option<i64> {
        match self.0 {
            Form::Small(n, ONE) => Some(n),
            _ => None,
        }
    }

    /// Whether it lies below zero.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Form::Small(n, _) => *n < 0,
            Form::Big(big) => big.is_negative(),
        }
    }

    /// The number without its sign.
    pub fn abs(&self) -> Self {
        if self.is_negative() {
            -self.clone()
        } else {
            self.clone()
        }
    }

    /// The greatest number of which both are integer multiples: gcd of the numerators over lcm of the denominators.
    pub fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return self.abs() + other.abs();
        }
        if self.is_one() && other.to_integer().is_some() {
            return Self::one();
        }
        let (a, b) = (self.to_big(), other.to_big());
        Self::from(BigRational::new(
            a.numer().gcd(b.numer()),
            a.denom().lcm(b.denom()),
        ))
    }

    /// The root of the square of a rational number; `None` for any other.
    pub fn exact_sqrt(&self) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        let big = self.to_big();
        let (n, d) = (big.numer().sqrt(), big.denom().sqrt());
        (&n * &n == *big.numer() && &d * &d == *big.denom())
            .then(|| Self::from(BigRational::new(n, d)))
    }

    /// A positive number as the square of one times a whole number that no small square divides: 3/8 is (1/4)² · 6. `None`
    /// where it is zero or long.
    pub fn without_square(&self) -> Option<(Self, i64)> {
        let Form::Small(n, d) = self.0 else {
            return None;
        };
        let d = i64::try_from(d.get()).ok()?;
        let mut whole = n.checked_mul(d).filter(|whole| *whole > 0)?;
        let mut root = 1_i64;
        let squares = (2..=LARGEST_ROOT).map(|root| (root, root * root));
        for (factor, square) in squares {
            while whole % square == 0 {
                (whole, root) = (whole / square, root * factor);
            }
        }
        let rest = Self::from(whole);
        if let Some(more) = rest.exact_sqrt() {
            return Some((more * Self::from((root, d)), 1));
        }
        Some((Self::from((root, d)), whole))
    }

    /// The sum.
    #[inline]
    pub(super) fn plus(&self, other: &Self) -> Self {
        if let (Form::Small(a, ONE), Form::Small(c, ONE)) = (&self.0, &other.0)
            && let Some(sum) = a.checked_add(*c)
        {
            return Self(Form::Small(sum, ONE));
        }
        let small = |[a, b, c, d]: [i128; 4]| {
            let numerator = a.checked_mul(d)?.checked_add(c.checked_mul(b)?)?;
            Some((numerator, b.checked_mul(d)?))
        };
        self.joined(other, small, |a, b| a + b)
    }

    /// The product.
    #[inline]
    pub(super) fn times(&self, other: &Self) -> Self {
        if let (Form::Small(a, ONE), Form::Small(c, ONE)) = (&self.0, &other.0)
            && let Some(product) = a.checked_mul(*c)
        {
            return Self(Form::Small(product, ONE));
        }
        let small = |[a, b, c, d]: [i128; 4]| Some((a.checked_mul(c)?, b.checked_mul(d)?));
        self.joined(other, small, |a, b| a * b)
    }

    /// Turns the sign.
    #[inline]
    pub(super) fn negate(&mut self) {
        match &mut self.0 {
            Form::Small(n, _) if *n != i64::MIN => *n = -*n,
            _ => self.negate_big(),
        }
    }

    #[cold]
    fn negate_big(&mut self) {
        *self = Self::from(-self.to_big());
    }

    /// An operation on numerators and denominators a/b and c/d, by machine words where they do. Whole numbers have come
    /// through before, in line.
    #[inline(never)]
    fn joined(
        &self,
        other: &Self,
        small: impl Fn([i128; 4]) -> Option<(i128, i128)>,
        big: impl Fn(BigRational, BigRational) -> BigRational,
    ) -> Self {
        if let (Form::Small(a, b), Form::Small(c, d)) = (&self.0, &other.0)
            && let words = [(*a).into(), b.get().into(), (*c).into(), d.get().into()]
            && let Some((numerator, denominator)) = small(words)
        {
            return Self::reduced(numerator, denominator);
        }
        Self::from(big(self.to_big(), other.to_big()))
    }
}

impl From<i64> for Rational {
    fn from(n: i64) -> Self {
        Self(Form::Small(n, ONE))
    }
}

impl From<(i64, i64)> for Rational {
    fn from((n, d): (i64, i64)) -> Self {
        Self::small(n, d)
    }
}

impl From<BigRational> for Rational {
    fn from(big: BigRational) -> Self {
        match (
            big.numer().to_i64(),
            big.denom().to_u64().map(NonZeroU64::new),
        ) {
            (Some(n), Some(Some(d))) => Self(Form::Small(n, d)),
            _ => Self(Form::Big(Box::new(big))),
        }
    }
}

impl Add for Rational {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.plus(&other)
    }
}

impl Mul for Rational {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.times(&other)
    }
}

impl Div for Rational {
    type Output = Self;
    /// The quotient; zero where the divisor is zero. Who may meet one asks first.
    fn div(self, other: Self) -> Self {
        if other.is_zero() {
            return Self::zero();
        }
        let small = |[a, b, c, d]: [i128; 4]| Some((a.checked_mul(d)?, b.checked_mul(c)?));
        self.joined(&other, small, |a, b| a / b)
    }
}

impl Neg for Rational {
    type Output = Self;
    #[inline]
    fn neg(mut self) -> Self {
        self.negate();
        self
    }
}

impl Sub for Rational {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl AddAssign for Rational {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        if let (Form::Small(a, ONE), Form::Small(c, ONE)) = (&mut self.0, &other.0)
            && let Some(sum) = a.checked_add(*c)
        {
            *a = sum;
        } else {
            *self = self.plus(&other);
        }
    }
}

impl SubAssign for Rational {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self += -other;
    }
}

impl MulAssign<&Self> for Rational {
    #[inline]
    fn mul_assign(&mut self, other: &Self) {
        if let (Form::Small(a, ONE), Form::Small(c, ONE)) = (&mut self.0, &other.0)
            && let Some(product) = a.checked_mul(*c)
        {
            *a = product;
        } else {
            *self = self.times(other);
        }
    }
}

impl MulAssign for Rational {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self *= &other;
    }
}

impl DivAssign for Rational {
    fn div_assign(&mut self, other: Self) {
        *self = self.clone() / other;
    }
}

impl Zero for Rational {
    #[inline]
    fn zero() -> Self {
        Self(Form::Small(0, ONE))
    }
    #[inline]
    fn is_zero(&self) -> bool {
        matches!(self.0, Form::Small(0, _))
    }
}

impl One for Rational {
    #[inline]
    fn one() -> Self {
        Self(Form::Small(1, ONE))
    }
}

impl Field for Rational {}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Small(a, b), Form::Small(c, d)) => {
                (i128::from(*a) * i128::from(d.get())).cmp(&(i128::from(*c) * i128::from(b.get())))
            }
            _ => self.to_big().cmp(&other.to_big()),
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Form::Small(n, ONE) => write!(f, "{n}"),
            Form::Small(n, d) => write!(f, "{n}/{d}"),
            Form::Big(big) => write!(f, "{big}"),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
