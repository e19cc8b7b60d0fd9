//! What is small: products of it are dropped, where an author takes a line to first order.

use crate::algebra::{Monomial, Polynomial, Variable};
use crate::verify::model::atoms::{Atoms, Nature};
use num_traits::One;

/// Variables of which only the first order counts, and their rates.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Small(Vec<Variable>);

impl Small {
    pub(crate) fn new(mut variables: Vec<Variable>) -> Self {
        variables.sort_unstable();
        variables.dedup();
        Self(variables)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a variable is small: one of these, or a rate of one.
    fn holds(&self, atoms: &Atoms, variable: Variable) -> bool {
        let mut at = Some(variable);
        while let Some(variable) = at {
            if self.0.contains(&variable) {
                return true;
            }
            at = atoms.atom(variable).rate_of;
        }
        false
    }

    /// The sines and cosines of small angles in a polynomial, with what they are to first order.
    pub(crate) fn kernels(&self, atoms: &Atoms, of: &Polynomial) -> Vec<(Variable, Polynomial)> {
        let small = |angle: &crate::algebra::Fraction| {
            let variables = angle.variables();
            angle.is_polynomial() && variables.iter().any(|&v| self.holds(atoms, v))
        };
        let first = |variable: Variable| match &atoms.atom(variable).nature {
            Nature::Sine(angle) if small(angle) => Some((variable, angle.numerator().clone())),
            Nature::Cosine(angle) if small(angle) => Some((variable, Polynomial::one())),
            _ => None,
        };
        of.variables().into_iter().filter_map(first).collect()
    }

    /// Products of two small variables with what they are multiplied by in a polynomial.
    pub(crate) fn second_order(
        &self,
        atoms: &Atoms,
        of: &Polynomial,
    ) -> Vec<(Polynomial, Polynomial)> {
        let mut found: Vec<(Monomial, Polynomial)> = vec![];
        for (monomial, coefficient) in of.terms() {
            let mut pair = vec![];
            for (variable, power) in monomial.factors() {
                if self.holds(atoms, variable) {
                    pair.extend(std::iter::repeat_n(variable, power as usize));
                }
            }
            let [first, second, ..] = pair[..] else {
                continue;
            };
            let product = match first == second {
                true => Monomial::from_powers([(first, 2)]),
                false => Monomial::from_powers([(first, 1), (second, 1)]),
            };
            let Some(rest) = monomial.quotient(&product) else {
                continue;
            };
            let term = Polynomial::term(rest, coefficient.clone());
            match found.iter_mut().find(|(p, _)| *p == product) {
                Some((_, sum)) => *sum += term,
                None => found.push((product, term)),
            }
        }
        let whole = |(product, cofactor)| (Polynomial::term(product, One::one()), cofactor);
        found.into_iter().map(whole).collect()
    }

    /// A polynomial to first order.
    pub(crate) fn truncated(&self, atoms: &Atoms, of: &Polynomial) -> Polynomial {
        let mut value = of.clone();
        for (variable, first) in self.kernels(atoms, of) {
            value = value.substitute(variable, &first);
        }
        for (product, cofactor) in self.second_order(atoms, &value) {
            value -= product * cofactor;
        }
        value
    }
}
