//! Putting values in for variables, and the division with remainder that shows where they went.

use crate::algebra::{Polynomial, Rational, Variable};
use num_traits::{One, Zero};

/// A pseudo-division by `d·v − n`: dᵏ·p = quotient·(d·v − n) + remainder, and `v` is gone from the remainder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PseudoDivision {
    /// The quotient.
    pub quotient: Polynomial,
    /// The remainder: dᵏ·p with n/d put in for v.
    pub remainder: Polynomial,
    /// dᵏ, with k the degree of p in v.
    pub multiplier: Polynomial,
}

impl Polynomial {
    /// The polynomial with `value` put in for a variable.
    ///
    /// ```
    /// use polhode::algebra::Polynomial;
    /// let [x, y] = [0, 1].map(Polynomial::variable);
    /// assert_eq!((x.clone() * x).substitute(0, &y), y.clone() * y);
    /// ```
    pub fn substitute(&self, variable: Variable, value: &Self) -> Self {
        self.substitute_fraction(variable, value, &Self::one()).0
    }

    /// The polynomial with `numerator / denominator` put in for a variable, times the power of the denominator that
    /// clears it; and the exponent of that power, the degree in the variable.
    pub fn substitute_fraction(
        &self,
        variable: Variable,
        numerator: &Self,
        denominator: &Self,
    ) -> (Self, u32) {
        let degree = self.degree_in(variable);
        // Horner's rule from the highest coefficient, each lower one brought up by the denominator so far.
        let (mut sum, mut power) = (Self::zero(), Self::one());
        for exponent in (0..=degree).rev() {
            let coefficient = self.coefficient_of(variable, exponent);
            sum = sum * numerator.clone() + coefficient * power.clone();
            if exponent > 0 {
                power *= denominator.clone();
            }
        }
        (sum, degree)
    }

    /// Divides by `d·v − n`, given d and n, neither of which holds `v`.
    pub fn pseudo_division(&self, variable: Variable, n: &Self, d: &Self) -> PseudoDivision {
        let degree = self.degree_in(variable);
        if degree == 1 {
            let (slope, rest) = self.slope_and_rest(variable);
            let rest = if d.is_one() { rest } else { rest * d.clone() };
            return PseudoDivision {
                remainder: slope.clone() * n.clone() + rest,
                quotient: slope,
                multiplier: d.clone(),
            };
        }
        // dᵏ·aᵢ·vⁱ = aᵢ·dᵏ⁻ⁱ·(d·v)ⁱ, and (d·v)ⁱ − nⁱ = (d·v − n)·Σ (d·v)ʲ·nⁱ⁻¹⁻ʲ, summed by Horner's rule.
        let scaled = Self::variable(variable) * d.clone();
        let (mut quotient, mut remainder) = (Self::zero(), Self::zero());
        let mut multiplier = Self::one();
        for exponent in (0..=degree).rev() {
            let coefficient = self.coefficient_of(variable, exponent);
            quotient = quotient * scaled.clone() + remainder.clone();
            remainder = remainder * n.clone() + coefficient * multiplier.clone();
            if exponent > 0 {
                multiplier *= d.clone();
            }
        }
        PseudoDivision {
            quotient,
            remainder,
            multiplier,
        }
    }

    /// The greatest rational number that leaves integer coefficients without a common divisor, with the sign of
    /// the leading coefficient; zero of zero.
    pub fn content(&self) -> Rational {
        let gcd = |a: Rational, (_, c): &(_, Rational)| a.gcd(c);
        let content = self.terms().iter().fold(Rational::zero(), gcd);
        if self.leading_coefficient().is_negative() {
            -content
        } else {
            content
        }
    }

    /// The polynomial over its content: integer coefficients without a common divisor, the leading one positive.
    pub fn primitive_part(&self) -> Self {
        let content = self.content();
        if content.is_zero() {
            return Self::zero();
        }
        self.scaled(&(Rational::one() / content))
    }

    /// The product with a number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        self.times_term(&crate::algebra::Monomial::one(), factor)
    }
}
