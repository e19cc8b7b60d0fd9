//! Intervals that are sure to hold a real number: π, roots, sines and their like between two binary fractions.
//!
//! Every operation rounds outwards, so what is computed always lies inside. The series are Taylor's, with the first
//! term left out as the bound on the rest where signs alternate and terms shrink, and a geometric bound elsewhere.

use crate::algebra::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::sync::OnceLock;

/// Binary digits after the point: some seventy decimal ones.
const BITS: usize = 256;
/// Terms of a series; each is at least twice smaller than the one before.
const TERMS: u32 = 300;
/// Beyond this size an argument of a sine or an exponential is not looked at.
const LARGEST_ARGUMENT: i64 = 4_000;

/// All numbers from `low` to `high`, in units of 2^−256.
///
/// ```
/// use polhode::algebra::{Interval, Rational};
/// let pi = Interval::pi();
/// assert!(pi.within(&Rational::from((314, 100)), &Rational::from((315, 100))));
/// let two = Interval::from(&Rational::from(2));
/// let root = two.square_root().expect("not negative");
/// assert!(root.within(&Rational::from((14142, 10000)), &Rational::from((14143, 10000))));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    low: BigInt,
    high: BigInt,
}

impl From<&Rational> for Interval {
    fn from(value: &Rational) -> Self {
        let big = value.to_big();
        let scaled = big.numer() << BITS;
        Self {
            low: scaled.div_floor(big.denom()),
            high: Integer::div_ceil(&scaled, big.denom()),
        }
    }
}

impl Interval {
    fn integer(value: i64) -> Self {
        Self::from(&Rational::from(value))
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            low: &self.low + &other.low,
            high: &self.high + &other.high,
        }
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        Self {
            low: -&self.high,
            high: -&self.low,
        }
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let ends = [
            &self.low * &other.low,
            &self.low * &other.high,
            &self.high * &other.low,
            &self.high * &other.high,
        ];
        let [mut low, mut high] = [ends[0].clone(), ends[0].clone()];
        for end in &ends[1..] {
            low = low.min(end.clone());
            high = high.max(end.clone());
        }
        let unit = BigInt::one() << BITS;
        Self {
            low: low.div_floor(&unit),
            high: Integer::div_ceil(&high, &unit),
        }
    }

    /// One over it; `None` where zero is inside.
    pub fn inverse(&self) -> Option<Self> {
        if !self.low.is_positive() && !self.high.is_negative() {
            return None;
        }
        let unit = BigInt::one() << (2 * BITS);
        Some(Self {
            low: unit.div_floor(&self.high),
            high: Integer::div_ceil(&unit, &self.low),
        })
    }

    /// The power with a whole exponent; an even one is never negative.
    pub fn power(&self, exponent: u32) -> Self {
        let mut product = Self::integer(1);
        for _ in 0..exponent {
            product = product.times(self);
        }
        if exponent.is_multiple_of(2) && product.low.is_negative() {
            product.low = BigInt::zero();
        }
        product
    }

    /// The square root; `None` where a negative number is inside.
    pub fn square_root(&self) -> Option<Self> {
        if self.low.is_negative() {
            return None;
        }
        Some(Self {
            low: (&self.low << BITS).sqrt(),
            high: (&self.high << BITS).sqrt() + 1,
        })
    }

    /// π, by Machin's formula 16 arctan(1/5) − 4 arctan(1/239).
    pub fn pi() -> Self {
        static PI: OnceLock<Interval> = OnceLock::new();
        let arctangent = |n: i64| {
            let z = Self::from(&Rational::from((1, n)));
            let square = z.times(&z).negated();
            series(&z, &square, |k| Rational::from((1, 2 * i64::from(k) + 1)))
        };
        let of = |factor: i64, n: i64| Self::integer(factor).times(&arctangent(n));
        PI.get_or_init(|| of(16, 5).minus(&of(4, 239))).clone()
    }

    /// Sine and cosine; `None` for arguments beyond some thousands.
    pub fn sine_cosine(&self) -> Option<(Self, Self)> {
        self.moderate()?;
        let quarter = Self::pi().times(&Self::from(&Rational::from((1, 2))));
        let turns = (&self.low + &self.high).div_floor(&(&quarter.low + &quarter.high));
        // The nearest quarter turn from below leaves an angle from zero to a little more than π/2.
        let turns = turns.to_i64()?;
        let angle = self.minus(&Self::integer(turns).times(&quarter));
        if (&angle.high - &angle.low) >> BITS != BigInt::zero() {
            let all = Self::integer(-1).joined(&Self::integer(1));
            return Some((all.clone(), all));
        }
        let square = angle.times(&angle).negated();
        let sine = factorial_series(&angle, &square, |k| (2 * k + 2) * (2 * k + 3));
        let cosine = factorial_series(&Self::integer(1), &square, |k| (2 * k + 1) * (2 * k + 2));
        Some(match turns.rem_euclid(4) {
            0 => (sine, cosine),
            1 => (cosine, sine.negated()),
            2 => (sine.negated(), cosine.negated()),
            _ => (cosine.negated(), sine),
        })
    }

    /// e to its power; `None` for arguments beyond some hundreds.
    pub fn exponential(&self) -> Option<Self> {
        self.moderate()?;
        let halvings = 16;
        let small = Self {
            low: &self.low >> halvings,
            high: (&self.high >> halvings) + 1,
        };
        let mut value = factorial_series(&Self::integer(1), &small, |k| k + 1);
        for _ in 0..halvings {
            if value.high.bits() > 8 * BITS as u64 {
                return None;
            }
            value = value.times(&value);
        }
        Some(value)
    }

    /// The natural logarithm, 2 artanh((m − 1)/(m + 1)) + k ln 2; `None` where zero or less is inside.
    pub fn logarithm(&self) -> Option<Self> {
        if !self.low.is_positive() {
            return None;
        }
        let shift = self.low.bits() as i64 - BITS as i64;
        let scale = if shift >= 0 {
            Rational::from(BigRational::new(BigInt::one(), BigInt::one() << shift))
        } else {
            Rational::from(BigRational::from_integer(BigInt::one() << -shift))
        };
        let mantissa = self.times(&Self::from(&scale));
        let two = Self::artanh_ratio(&Self::integer(2))?;
        let shift = Self::integer(shift).times(&two);
        Some(Self::artanh_ratio(&mantissa)?.plus(&shift))
    }

    /// ln m = 2 artanh((m − 1)/(m + 1)), for m from a half to two.
    fn artanh_ratio(m: &Self) -> Option<Self> {
        let one = Self::integer(1);
        let z = m.minus(&one).times(&m.plus(&one).inverse()?);
        if (&z.low.abs().max(z.high.abs()) << 1) > (BigInt::one() << BITS) {
            return None;
        }
        let sum = series(&z, &z.times(&z), |k| {
            Rational::from((2, 2 * i64::from(k) + 1))
        });
        Some(sum)
    }

    fn moderate(&self) -> Option<()> {
        let limit = BigInt::from(LARGEST_ARGUMENT) << BITS;
        (self.low > -limit.clone() && self.high < limit).then_some(())
    }

    /// The smallest interval around both.
    pub fn joined(&self, other: &Self) -> Self {
        Self {
            low: self.low.clone().min(other.low.clone()),
            high: self.high.clone().max(other.high.clone()),
        }
    }

    /// Whether all of it lies from `lower` to `upper`.
    pub fn within(&self, lower: &Rational, upper: &Rational) -> bool {
        let (lower, upper) = (lower.to_big(), upper.to_big());
        &self.low * lower.denom() >= lower.numer() << BITS
            && &self.high * upper.denom() <= upper.numer() << BITS
    }

    /// Whether none of it lies from `lower` to `upper`.
    pub fn apart(&self, lower: &Rational, upper: &Rational) -> bool {
        let (lower, upper) = (lower.to_big(), upper.to_big());
        &self.high * lower.denom() < lower.numer() << BITS
            || &self.low * upper.denom() > upper.numer() << BITS
    }

    /// Whether every number in it is above zero.
    pub fn is_positive(&self) -> bool {
        self.low.is_positive()
    }

    /// Whether every number in it is below zero.
    pub fn is_negative(&self) -> bool {
        self.high.is_negative()
    }

    /// Whether it is as good as zero.
    fn is_tiny(&self) -> bool {
        self.low.bits() < 5 && self.high.bits() < 5
    }

    /// With room for what is left of a series: it is smaller than the last term taken, twice over.
    fn widened(self, last: &Self) -> Self {
        let rest = last.low.abs().max(last.high.abs()) * 2 + 2;
        Self {
            low: self.low - &rest,
            high: self.high + rest,
        }
    }

    /// The ends, exactly.
    pub fn ends(&self) -> (Rational, Rational) {
        let end = |n: &BigInt| Rational::from(BigRational::new(n.clone(), BigInt::one() << BITS));
        (end(&self.low), end(&self.high))
    }

    /// A number in it, rounded, to be shown.
    pub fn middle(&self) -> f64 {
        let sum = BigRational::new(&self.low + &self.high, BigInt::one() << (BITS + 1));
        sum.to_f64().unwrap_or(f64::NAN)
    }
}

/// Σ coefficient(k) · first · ratio^k, where from some term on each is at least twice smaller than the one before.
fn series(
    first: &Interval,
    ratio: &Interval,
    mut coefficient: impl FnMut(u32) -> Rational,
) -> Interval {
    let mut power = first.clone();
    let mut sum = Interval::integer(0);
    let mut term = sum.clone();
    for k in 0..TERMS {
        term = power.times(&Interval::from(&coefficient(k)));
        sum = sum.plus(&term);
        power = power.times(ratio);
        if k > 8 && term.is_tiny() {
            break;
        }
    }
    sum.widened(&term)
}

/// Σ of terms of which each is the one before times the ratio over a divisor; from some term on each is at least twice
/// smaller than the one before.
fn factorial_series(first: &Interval, ratio: &Interval, divisor: impl Fn(i64) -> i64) -> Interval {
    let mut term = first.clone();
    let mut sum = first.clone();
    for k in 0..i64::from(TERMS) {
        let over = Interval::from(&Rational::from((1, divisor(k))));
        term = term.times(ratio).times(&over);
        sum = sum.plus(&term);
        if k > 8 && term.is_tiny() {
            break;
        }
    }
    sum.widened(&term)
}
