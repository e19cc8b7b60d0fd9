//! Sums, products and powers.

use super::terms::Term;
use crate::algebra::{Monomial, Polynomial, Rational};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Products of terms up to which all are sorted at once, which is faster than sums of ordered ones.
const FEW_PRODUCTS: usize = 256;

impl Polynomial {
    /// The product with one term.
    pub fn times_term(&self, monomial: &Monomial, coefficient: &Rational) -> Self {
        if coefficient.is_zero() {
            return Self::zero();
        }
        let mut product = self.clone();
        product.terms.multiply(monomial, coefficient);
        product
    }

    /// The product, unless it could have more than `most` terms before like terms are collected.
    pub fn product_within(&self, other: &Self, most: usize) -> Option<Self> {
        (self.len().saturating_mul(other.len()) <= most).then(|| self.clone() * other.clone())
    }

    /// The sum of products of pairs.
    pub fn sum_of_products(pairs: &[(&Self, &Self)]) -> Self {
        let size = |(a, b): &(&Self, &Self)| a.len().saturating_mul(b.len());
        let size = pairs.iter().map(size).fold(0, usize::saturating_add);
        if size > FEW_PRODUCTS {
            let products = pairs.iter().map(|&(a, b)| a.clone() * b.clone());
            return products.fold(Self::zero(), |sum, product| sum + product);
        }
        let mut terms = Vec::with_capacity(size);
        for (a, b) in pairs {
            for (m, c) in a.terms() {
                terms.extend(b.terms().iter().map(|(n, d)| (m.times(n), c.times(d))));
            }
        }
        Self::from_terms(terms)
    }

    /// A power, by the binomial theorem with one more term at a time. In (t + r)ⁿ the summands with tⁿ, tⁿ⁻¹ r, … come
    /// in falling order where t leads, so that the work is about as large as the powers of r are long.
    pub fn pow(&self, exponent: u32) -> Self {
        let Some((first, rest)) = self.terms().split_first() else {
            return if exponent == 0 {
                Self::one()
            } else {
                Self::zero()
            };
        };
        let Some((last, between)) = rest.split_last() else {
            return powers_of(first, exponent).swap_remove(exponent as usize);
        };
        let rows = binomials(exponent);
        let mut powers = powers_of(last, exponent);
        for term in between.iter().rev() {
            let of_term = powers_of(term, exponent);
            powers = (0..=exponent as usize)
                .map(|n| expanded(&of_term, &powers, &rows[n]))
                .collect();
        }
        expanded(
            &powers_of(first, exponent),
            &powers,
            &rows[exponent as usize],
        )
    }
}

/// (t + r)ⁿ from the powers of both and the row of binomial coefficients.
fn expanded(of_term: &[Polynomial], of_rest: &[Polynomial], row: &[Rational]) -> Polynomial {
    let exponent = row.len() - 1;
    let mut sum = Polynomial::zero();
    for (k, binomial) in row.iter().enumerate() {
        for (monomial, coefficient) in of_term[exponent - k].terms() {
            sum += of_rest[k].times_term(monomial, &coefficient.times(binomial));
        }
    }
    sum
}

/// The powers of one term, from zero up to an exponent.
fn powers_of((monomial, coefficient): &Term, exponent: u32) -> Vec<Polynomial> {
    let next = |last: &Polynomial| Some(last.times_term(monomial, coefficient));
    let powers = std::iter::successors(Some(Polynomial::one()), next);
    powers.take(exponent as usize + 1).collect()
}

/// The rows of Pascal's triangle up to an exponent.
fn binomials(exponent: u32) -> Vec<Vec<Rational>> {
    let next = |row: &Vec<Rational>| {
        let between = row.windows(2).map(|pair| pair[0].clone() + pair[1].clone());
        let edge = || std::iter::once(Rational::one());
        Some(edge().chain(between).chain(edge()).collect())
    };
    let rows = std::iter::successors(Some(vec![Rational::one()]), next);
    rows.take(exponent as usize + 1).collect()
}

impl Add for Polynomial {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            terms: self.terms.plus(other.terms),
        }
    }
}

impl Sub for Polynomial {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Polynomial {
    type Output = Self;
    #[inline]
    fn neg(mut self) -> Self {
        self.terms.negate();
        self
    }
}

impl Mul for Polynomial {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            terms: self.terms.times(other.terms),
        }
    }
}

macro_rules! assigning {
    ($($name:ident $method:ident $by:tt)*) => {$(
        impl $name for Polynomial {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = std::mem::take(self) $by other;
            }
        }
    )*};
}
assigning! { AddAssign add_assign + SubAssign sub_assign - MulAssign mul_assign * }

impl Zero for Polynomial {
    fn zero() -> Self {
        Self::default()
    }
    fn is_zero(&self) -> bool {
        self.is_empty()
    }
}

impl One for Polynomial {
    fn one() -> Self {
        Self::constant(Rational::one())
    }
}
