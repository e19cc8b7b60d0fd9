//! What is small: products of it are dropped, where an author takes a line to an order.

use crate::algebra::{Monomial, Polynomial, Rational, Variable};
use crate::verify::model::atoms::{Atoms, Nature};
use num_traits::{One, Zero};

/// Variables of which only so many powers count, those of their rates among them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Small {
    variables: Vec<Variable>,
    /// The order up to which products count: the first, or the second.
    order: u32,
}

impl Small {
    pub(crate) fn new(mut variables: Vec<Variable>, order: u32) -> Self {
        variables.sort_unstable();
        variables.dedup();
        Self { variables, order }
    }

    /// All that is small by two sentences, to the higher of their orders.
    pub(crate) fn and(self, other: &Self) -> Self {
        Self::new(
            [self.variables, other.variables.clone()].concat(),
            self.order.max(other.order),
        )
    }

    pub(crate) fn variables(&self) -> &[Variable] {
        &self.variables
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.variables.is_empty()
    }

    /// The same to second order, of what is taken to first order.
    pub(crate) fn to_second_order(&self) -> Option<Self> {
        let first = !self.is_empty() && self.order == 1;
        first.then(|| Self::new(self.variables.clone(), 2))
    }

    /// The premise that says so.
    pub(crate) fn premise(&self) -> &'static str {
        match self.order {
            2 => "to second order",
            _ => "to first order",
        }
    }

    /// Whether a variable is small: one of these, or a rate of one.
    fn holds(&self, atoms: &Atoms, variable: Variable) -> bool {
        let mut at = Some(variable);
        while let Some(variable) = at {
            if self.variables.contains(&variable) {
                return true;
            }
            at = atoms.atom(variable).rate_of;
        }
        false
    }

    /// Whether a variable is small, or the sine or cosine of an angle that is.
    pub(crate) fn speaks_of(&self, atoms: &Atoms, variable: Variable) -> bool {
        let own = Polynomial::variable(variable);
        self.holds(atoms, variable) || !self.kernels(atoms, &own).is_empty()
    }

    /// The terms of a polynomial with one factor that is small.
    pub(crate) fn linear_part(&self, atoms: &Atoms, of: &Polynomial) -> Polynomial {
        let value = self.truncated(atoms, of);
        let mut linear = Polynomial::zero();
        for (monomial, coefficient) in value.terms() {
            let mut factors = monomial.factors();
            if factors.any(|(variable, _)| self.holds(atoms, variable)) {
                linear += Polynomial::term(monomial.clone(), coefficient.clone());
            }
        }
        linear
    }

    /// Whether a polynomial vanishes with what is small.
    pub(crate) fn is_factor(&self, atoms: &Atoms, of: &Polynomial) -> bool {
        let mut terms = of.terms().iter();
        let small = |(monomial, _): &(Monomial, _)| {
            let mut factors = monomial.factors();
            factors.any(|(variable, _)| self.holds(atoms, variable))
        };
        !self.is_empty() && terms.all(small)
    }

    /// Whether a polynomial vanishes with what is small, the sines of small angles among that.
    pub(crate) fn vanishes(&self, atoms: &Atoms, of: &Polynomial) -> bool {
        let mut value = of.clone();
        for (variable, kernel) in self.kernels(atoms, of) {
            value = value.substitute(variable, &kernel);
        }
        self.is_factor(atoms, &value)
    }

    /// The sines and cosines of small angles in a polynomial, with what they are to this order.
    pub(crate) fn kernels(&self, atoms: &Atoms, of: &Polynomial) -> Vec<(Variable, Polynomial)> {
        let half = Rational::from((1, 2));
        let value = |variable: Variable| {
            let (angle, sine) = match &atoms.atom(variable).nature {
                Nature::Sine(angle) => (angle, true),
                Nature::Cosine(angle) => (angle, false),
                _ => return None,
            };
            let angle = angle.is_polynomial().then(|| angle.numerator().clone());
            let angle = angle.filter(|angle| self.is_factor(atoms, angle))?;
            let value = match (sine, self.order) {
                (true, _) => angle,
                (false, 2) => {
                    let square = angle.clone() * angle;
                    Polynomial::one() - square * Polynomial::constant(half.clone())
                }
                (false, _) => Polynomial::one(),
            };
            Some((variable, value))
        };
        of.variables().into_iter().filter_map(value).collect()
    }

    /// Products of more small variables than count, with what they are multiplied by in a polynomial.
    pub(crate) fn dropped(&self, atoms: &Atoms, of: &Polynomial) -> Vec<(Polynomial, Polynomial)> {
        let mut found: Vec<(Monomial, Polynomial)> = vec![];
        for (monomial, coefficient) in of.terms() {
            let (mut product, mut left) = (vec![], self.order + 1);
            for (variable, power) in monomial.factors() {
                if left > 0 && self.holds(atoms, variable) {
                    let power = power.min(left);
                    product.push((variable, power));
                    left -= power;
                }
            }
            if left > 0 || self.is_empty() {
                continue;
            }
            let product = Monomial::from_powers(product);
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

    /// A polynomial to this order.
    pub(crate) fn truncated(&self, atoms: &Atoms, of: &Polynomial) -> Polynomial {
        let mut value = of.clone();
        for (variable, kernel) in self.kernels(atoms, of) {
            value = value.substitute(variable, &kernel);
        }
        for (product, cofactor) in self.dropped(atoms, &value) {
            value -= product * cofactor;
        }
        value
    }
}
