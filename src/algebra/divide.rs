//! Exact division of polynomials, quick to see that there is none.

use crate::algebra::{Polynomial, Rational, Variable};
use crate::scalar::Prime;
use num_traits::{One, Zero};

impl Polynomial {
    /// The quotient, where the division leaves nothing.
    ///
    /// Most divisions that are tried leave something. That shows in the images in one variable modulo a prime, every
    /// other variable given a value: of a product, the image is the product of the images.
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (lead, by) = divisor.terms().first()?;
        if self.len() > 4 && divisor.len() > 1 && !may_divide(self, divisor) {
            return None;
        }
        let (mut rest, mut quotient) = (self.clone(), vec![]);
        while let Some((monomial, coefficient)) = rest.terms().first() {
            let (m, c) = (monomial.quotient(lead)?, coefficient.clone() / by.clone());
            rest -= divisor.times_term(&m, &c);
            quotient.push((m, c));
        }
        Some(Self::from_terms(quotient))
    }
}

/// Whether nothing in the images speaks against an exact division.
fn may_divide(dividend: &Polynomial, divisor: &Polynomial) -> bool {
    let highest = |v: &Variable| divisor.degree_in(*v);
    let Some(main) = divisor.variables().into_iter().max_by_key(highest) else {
        return true;
    };
    let (Some(mut rest), Some(by)) = (image(dividend, main), image(divisor, main)) else {
        return true;
    };
    let Some(inverse) = by.last().and_then(|lead| lead.inverse()) else {
        return true;
    };
    while rest.len() >= by.len() {
        let factor = rest.pop().unwrap_or_else(Prime::zero) * inverse;
        let shift = rest.len() + 1 - by.len();
        for (slot, &b) in rest[shift..].iter_mut().zip(&by) {
            *slot -= factor * b;
        }
    }
    rest.iter().all(Zero::is_zero)
}

/// The coefficients in one variable, lowest first, modulo the prime, with every other variable given a value.
fn image(polynomial: &Polynomial, main: Variable) -> Option<Vec<Prime>> {
    let mut coefficients = vec![Prime::zero(); polynomial.degree_in(main) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let mut value = Rational::to_prime(coefficient)?;
        let mut place = 0;
        for (variable, exponent) in monomial.powers() {
            if variable == main {
                place = exponent as usize;
            } else {
                value *= chosen(variable).pow(exponent.into());
            }
        }
        coefficients[place] += value;
    }
    while coefficients.len() > 1 && coefficients.last().is_some_and(Zero::is_zero) {
        coefficients.pop();
    }
    Some(coefficients)
}

/// A value for a variable that looks drawn by lot, the same on every machine (the mixing of SplitMix64).
fn chosen(variable: Variable) -> Prime {
    let mut z = u64::from(variable)
        .wrapping_add(1)
        .wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    Prime::new(z ^ (z >> 31)) + Prime::one()
}
