//! Fractions of polynomials: numerator and denominator, equal by cross products.

use crate::algebra::{Monomial, Polynomial, Rational, Variable};
use crate::scalar::Field;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// More products of terms are not worked out for one sum, product or quotient of fractions.
const MOST_PRODUCTS: usize = 40_000;

/// A fraction of polynomials. The denominator has leading coefficient one, and shares no monomial with the numerator.
///
/// A division by zero gives a fraction whose denominator is zero, and so does a result that grows beyond what is worked
/// out; [`Fraction::is_valid`] tells. What is worked out with such a fraction is one again.
#[derive(Clone, Debug)]
pub struct Fraction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl Fraction {
    /// Numerator over denominator; `None` where the denominator is zero.
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Option<Self> {
        (!denominator.is_zero()).then(|| Self::simplified(numerator, denominator))
    }

    /// The quotient of two integers.
    pub fn from_ratio(p: i64, q: i64) -> Self {
        Self::from(Polynomial::constant(Rational::from((p, q))))
    }

    /// The numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Whether nothing was divided by zero, and nothing grew beyond what is worked out.
    pub fn is_valid(&self) -> bool {
        !self.denominator.is_zero()
    }

    /// Whether there is no denominator.
    pub fn is_polynomial(&self) -> bool {
        self.denominator.is_constant().is_some_and(|d| !d.is_zero())
    }

    /// The number that it is, if it is one.
    pub fn to_rational(&self) -> Option<Rational> {
        if self.is_polynomial() {
            self.numerator.is_constant()
        } else {
            None
        }
    }

    /// The variable that it is, if it is one.
    pub fn as_variable(&self) -> Option<Variable> {
        let [(monomial, coefficient)] = self.numerator.terms() else {
            return None;
        };
        match monomial.powers().as_slice() {
            [(variable, 1)] if coefficient.is_one() && self.is_polynomial() => Some(*variable),
            _ => None,
        }
    }

    /// The variables that occur, ascending.
    pub fn variables(&self) -> Vec<Variable> {
        let mut found = self.numerator.variables();
        if self.is_polynomial() {
            return found;
        }
        found.extend(self.denominator.variables());
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The partial derivative in a variable, every other held fixed.
    pub fn partial(&self, variable: Variable) -> Self {
        let top = Self::from(self.numerator.partial(variable));
        let whole = Self::from(self.denominator.clone());
        if self.is_polynomial() {
            return top / whole;
        }
        (top - self.clone() * Self::from(self.denominator.partial(variable))) / whole
    }

    /// What is no fraction: 1/0.
    pub fn none() -> Self {
        Self {
            numerator: Polynomial::one(),
            denominator: Polynomial::zero(),
        }
    }

    /// A numerator over a denominator, each if it was worked out.
    fn bounded(numerator: Option<Polynomial>, denominator: Option<Polynomial>) -> Self {
        match (numerator, denominator) {
            (Some(numerator), Some(denominator)) => Self::simplified(numerator, denominator),
            _ => Self::none(),
        }
    }

    fn simplified(numerator: Polynomial, denominator: Polynomial) -> Self {
        if denominator.is_zero() {
            return Self::none();
        }
        if numerator.is_zero() {
            return Self::zero();
        }
        let (mut top, mut bottom) = (numerator, denominator);
        if bottom.is_constant().is_none() {
            let common = top.common_monomial().gcd(&bottom.common_monomial());
            if common.degree() > 0 {
                (top, bottom) = (top.divided_by(&common), bottom.divided_by(&common));
            }
            if bottom.len() > 1
                && let Some(whole) = top.exact_quotient(&bottom)
            {
                (top, bottom) = (whole, Polynomial::one());
            }
        }
        let lead = bottom.leading_coefficient();
        if !lead.is_one() {
            let inverse = Rational::one() / lead;
            top = top.times_term(&Monomial::one(), &inverse);
            bottom = bottom.times_term(&Monomial::one(), &inverse);
        }
        Self {
            numerator: top,
            denominator: bottom,
        }
    }

    fn sum(self, other: Self, negative: bool) -> Self {
        let joined = |a: Polynomial, b: Polynomial| if negative { a - b } else { a + b };
        if self.is_one_below() && other.is_one_below() {
            return Self {
                numerator: joined(self.numerator, other.numerator),
                denominator: self.denominator,
            };
        }
        if !self.is_valid() || !other.is_valid() {
            return Self::none();
        }
        if self.denominator == other.denominator {
            return Self::simplified(joined(self.numerator, other.numerator), self.denominator);
        }
        // One denominator often is a multiple of the other; the smaller one is then brought up.
        if let Some(factor) = other.denominator.exact_quotient(&self.denominator) {
            let top = within(&self.numerator, &factor);
            let top = top.map(|top| joined(top, other.numerator));
            return Self::bounded(top, Some(other.denominator));
        }
        if let Some(factor) = self.denominator.exact_quotient(&other.denominator) {
            let top = within(&other.numerator, &factor);
            let top = top.map(|top| joined(self.numerator, top));
            return Self::bounded(top, Some(self.denominator));
        }
        let left = within(&self.numerator, &other.denominator);
        let right = within(&other.numerator, &self.denominator);
        let top = left.zip(right).map(|(left, right)| joined(left, right));
        Self::bounded(top, within(&self.denominator, &other.denominator))
    }

    fn is_one_below(&self) -> bool {
        self.denominator.len() == 1 && self.denominator.is_constant().is_some_and(|c| c.is_one())
    }
}

/// The product, where it is not too large.
fn within(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    a.product_within(b, MOST_PRODUCTS)
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Self {
            numerator,
            denominator: Polynomial::one(),
        }
    }
}

impl PartialEq for Fraction {
    /// Equality of values; a fraction that is none equals nothing, nor does one that is too large to tell.
    fn eq(&self, other: &Self) -> bool {
        if !self.is_valid() || !other.is_valid() {
            return false;
        }
        if self.denominator == other.denominator {
            return self.numerator == other.numerator;
        }
        let left = within(&self.numerator, &other.denominator);
        let right = within(&other.numerator, &self.denominator);
        left.zip(right).is_some_and(|(left, right)| left == right)
    }
}

impl Add for Fraction {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.sum(other, false)
    }
}

impl Sub for Fraction {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.sum(other, true)
    }
}

impl Neg for Fraction {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            numerator: -self.numerator,
            denominator: self.denominator,
        }
    }
}

impl Mul for Fraction {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_one_below() && other.is_one_below() {
            let (own, theirs) = (self.numerator, other.numerator);
            return match own.len().saturating_mul(theirs.len()) <= MOST_PRODUCTS {
                true => Self::from(own * theirs),
                false => Self::none(),
            };
        }
        if !self.is_valid() || !other.is_valid() {
            return Self::none();
        }
        Self::bounded(
            within(&self.numerator, &other.numerator),
            within(&self.denominator, &other.denominator),
        )
    }
}

impl Div for Fraction {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if !self.is_valid() || !other.is_valid() {
            return Self::none();
        }
        if other.is_one_below() && other.numerator.is_one() {
            return self;
        }
        Self::bounded(
            within(&self.numerator, &other.denominator),
            within(&self.denominator, &other.numerator),
        )
    }
}

macro_rules! assigning {
    ($($name:ident $method:ident $by:tt)*) => {$(
        impl $name for Fraction {
            fn $method(&mut self, other: Self) {
                let left = std::mem::replace(self, Self::zero());
                *self = left $by other;
            }
        }
    )*};
}
assigning! { AddAssign add_assign + SubAssign sub_assign - MulAssign mul_assign * DivAssign div_assign / }

impl Zero for Fraction {
    fn zero() -> Self {
        Self::from(Polynomial::zero())
    }
    fn is_zero(&self) -> bool {
        self.numerator.is_zero() && self.is_valid()
    }
}

impl One for Fraction {
    fn one() -> Self {
        Self::from(Polynomial::one())
    }
}

impl Field for Fraction {}
