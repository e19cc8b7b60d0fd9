//! Sparse polynomials over ℚ, a scalar [`Ring`](crate::scalar::Ring) whose equality is mathematical equality.

use crate::algebra::{Monomial, Rational, Variable};
use crate::scalar::Field;
use num_traits::{One, Zero};
use terms::Terms;

mod arithmetic;
mod terms;

/// A polynomial: its terms, monomials descending, no coefficient zero.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Polynomial {
    terms: Terms,
}

impl Polynomial {
    /// A variable.
    pub fn variable(variable: Variable) -> Self {
        Self {
            terms: Terms::One((Monomial::of(variable), Rational::one())),
        }
    }

    /// A number.
    pub fn constant(value: Rational) -> Self {
        Self::term(Monomial::one(), value)
    }

    /// One term.
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        if coefficient.is_zero() {
            return Self::zero();
        }
        Self {
            terms: Terms::One((monomial, coefficient)),
        }
    }

    /// The sum of terms in any order.
    pub fn from_terms(mut terms: Vec<(Monomial, Rational)>) -> Self {
        terms.sort_unstable_by(|a, b| b.0.cmp(&a.0));
        let mut collected: Vec<(Monomial, Rational)> = Vec::with_capacity(terms.len());
        for (monomial, coefficient) in terms {
            match collected.last_mut() {
                Some(last) if last.0 == monomial => last.1 += coefficient,
                _ => {
                    if collected.last().is_some_and(|last| last.1.is_zero()) {
                        collected.pop();
                    }
                    collected.push((monomial, coefficient));
                }
            }
        }
        if collected.last().is_some_and(|last| last.1.is_zero()) {
            collected.pop();
        }
        Self {
            terms: collected.into(),
        }
    }

    /// The terms, the highest first.
    pub fn terms(&self) -> &[(Monomial, Rational)] {
        self.terms.as_slice()
    }

    /// Each term as its coefficient and its monomial.
    pub fn split(&self) -> Vec<(Rational, Self)> {
        let alone = |m: &Monomial| Self::term(m.clone(), Rational::one());
        self.terms()
            .iter()
            .map(|(m, c)| (c.clone(), alone(m)))
            .collect()
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms().len()
    }

    /// Whether there is no term.
    pub fn is_empty(&self) -> bool {
        self.terms().is_empty()
    }

    /// The number that it is, if it is one.
    pub fn is_constant(&self) -> Option<Rational> {
        match self.terms() {
            [] => Some(Rational::zero()),
            [(monomial, coefficient)] if monomial.degree() == 0 => Some(coefficient.clone()),
            _ => None,
        }
    }

    /// The variables that occur, ascending.
    pub fn variables(&self) -> Vec<Variable> {
        // Most documents have few variables: one bit each sorts them.
        let (mut low, mut high) = ([0u64; 2], vec![]);
        for (monomial, _) in self.terms() {
            monomial.factors().for_each(|(variable, _)| match variable {
                0..64 => low[0] |= 1 << variable,
                64..128 => low[1] |= 1 << (variable - 64),
                _ => high.push(variable),
            });
        }
        high.sort_unstable();
        high.dedup();
        let ones = low[0].count_ones() + low[1].count_ones();
        let mut found = Vec::with_capacity(ones as usize + high.len());
        for (mut bits, from) in low.into_iter().zip([0, 64]) {
            while bits != 0 {
                found.push(from + bits.trailing_zeros());
                bits &= bits - 1;
            }
        }
        found.extend(high);
        found
    }

    /// The highest power of a variable.
    pub fn degree_in(&self, variable: Variable) -> u32 {
        self.terms()
            .iter()
            .map(|(m, _)| m.exponent(variable))
            .max()
            .unwrap_or(0)
    }

    /// The coefficient of a power of a variable, a polynomial in the others.
    pub fn coefficient_of(&self, variable: Variable, power: u32) -> Self {
        let with = self
            .terms()
            .iter()
            .filter(|(m, _)| m.exponent(variable) == power);
        // One power taken out of each, so their order stays.
        let terms = with.map(|(m, c)| (m.without(variable), c.clone()));
        Self {
            terms: terms.collect(),
        }
    }

    /// A polynomial of first degree in a variable as s·v + r: s and r.
    pub(super) fn slope_and_rest(&self, variable: Variable) -> (Self, Self) {
        let (mut slope, mut rest) = (vec![], Vec::with_capacity(self.len()));
        for (monomial, coefficient) in self.terms() {
            match monomial.exponent(variable) {
                0 => rest.push((monomial.clone(), coefficient.clone())),
                _ => slope.push((monomial.without(variable), coefficient.clone())),
            }
        }
        // One power taken out of each, so their order stays.
        let polynomial = |terms: Vec<_>| Self {
            terms: terms.into(),
        };
        (polynomial(slope), polynomial(rest))
    }

    /// The partial derivative in a variable.
    pub fn partial(&self, variable: Variable) -> Self {
        let one = Monomial::of(variable);
        let slope = |(m, c): &(Monomial, Rational)| {
            let power = m.exponent(variable);
            let lower = m.quotient(&one)?;
            Some((lower, c.clone() * Rational::from(i64::from(power))))
        };
        // One power taken out of each, so their order stays.
        Self {
            terms: self.terms().iter().filter_map(slope).collect(),
        }
    }

    /// The derivation that takes each variable to its image: Σ ∂p/∂v · image(v).
    pub fn derivation(&self, mut image: impl FnMut(Variable) -> Self) -> Self {
        self.variables()
            .into_iter()
            .fold(Self::zero(), |sum, v| sum + self.partial(v) * image(v))
    }

    /// The value where each variable has the value `at` and each coefficient the value `lift`.
    pub fn evaluate<T: Field>(
        &self,
        at: impl Fn(Variable) -> T,
        lift: impl Fn(&Rational) -> T,
    ) -> T {
        let variables = self.variables();
        let mut powers: Vec<Vec<T>> = variables.iter().map(|&v| vec![T::one(), at(v)]).collect();
        let mut sum = T::zero();
        for (monomial, coefficient) in self.terms() {
            let mut product = lift(coefficient);
            for (variable, exponent) in monomial.factors() {
                let Ok(place) = variables.binary_search(&variable) else {
                    continue;
                };
                let known = &mut powers[place];
                while known.len() <= exponent as usize {
                    let next = known[known.len() - 1].clone() * known[1].clone();
                    known.push(next);
                }
                product *= known[exponent as usize].clone();
            }
            sum += product;
        }
        sum
    }

    /// The polynomial with each variable renamed.
    pub fn rename(&self, to: impl Fn(Variable) -> Variable) -> Self {
        let renamed =
            |m: &Monomial| Monomial::from_powers(m.powers().into_iter().map(|(v, e)| (to(v), e)));
        Self::from_terms(
            self.terms()
                .iter()
                .map(|(m, c)| (renamed(m), c.clone()))
                .collect(),
        )
    }

    /// The greatest monomial that divides every term.
    pub fn common_monomial(&self) -> Monomial {
        let mut monomials = self.terms().iter().map(|(m, _)| m);
        let first = monomials.next().cloned().unwrap_or_else(Monomial::one);
        monomials.fold(first, |common, m| common.gcd(m))
    }

    /// The quotient by a monomial that divides every term; terms that it does not divide are dropped.
    pub fn divided_by(&self, monomial: &Monomial) -> Self {
        let terms = self
            .terms()
            .iter()
            .filter_map(|(m, c)| Some((m.quotient(monomial)?, c.clone())));
        Self {
            terms: terms.collect(),
        }
    }

    /// The coefficient of the highest term; zero of zero.
    pub fn leading_coefficient(&self) -> Rational {
        self.terms()
            .first()
            .map_or_else(Rational::zero, |(_, c)| c.clone())
    }
}
