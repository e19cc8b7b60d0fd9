//! Polynomials that remember how they came about, and the meter that bounds the work on them.

use crate::algebra::{Polynomial, Rational, Variable};
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// How much work a search may do. It is counted, not timed: the same question ends in the same way everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Terms of any one product.
    pub terms: usize,
    /// Divisions and substitutions in all.
    pub reductions: usize,
}

impl Default for Budget {
    /// Enough for the lines of a lecture, and less than a second of work.
    fn default() -> Self {
        Self {
            terms: 20_000,
            reductions: 2_000,
        }
    }
}

/// The work that is left.
#[derive(Debug)]
pub(super) struct Meter {
    terms: usize,
    left: usize,
}

/// The budget did not suffice.
#[derive(Debug)]
pub(super) struct Exhausted;

impl Meter {
    pub(super) fn new(budget: Budget) -> Self {
        Self {
            terms: budget.terms,
            left: budget.reductions,
        }
    }

    /// Counts one reduction.
    pub(super) fn step(&mut self) -> Result<(), Exhausted> {
        self.left = self.left.checked_sub(1).ok_or(Exhausted)?;
        Ok(())
    }

    pub(super) fn product(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Exhausted> {
        a.product_within(b, self.terms).ok_or(Exhausted)
    }

    fn size(&self, p: Polynomial) -> Result<Polynomial, Exhausted> {
        if p.len() > self.terms {
            Err(Exhausted)
        } else {
            Ok(p)
        }
    }
}

/// A polynomial as a sum of cofactors times generators: value = Σ cofactorᵢ · generatorᵢ.
#[derive(Clone, Debug)]
pub(super) struct Combination {
    pub(super) value: Polynomial,
    /// By the index of the generator; no zero among them.
    pub(super) cofactors: BTreeMap<usize, Polynomial>,
}

impl Combination {
    /// The generator of an index.
    pub(super) fn generator(index: usize, value: Polynomial) -> Self {
        Self {
            value,
            cofactors: BTreeMap::from([(index, Polynomial::one())]),
        }
    }

    /// The same, with leading coefficient one.
    pub(super) fn monic(self) -> Self {
        let lead = self.value.leading_coefficient();
        if lead.is_zero() || lead.is_one() {
            return self;
        }
        self.scaled(&(Rational::one() / lead))
    }

    fn scaled(self, factor: &Rational) -> Self {
        let cofactors = self
            .cofactors
            .into_iter()
            .map(|(i, c)| (i, c.scaled(factor)))
            .collect();
        Self {
            value: self.value.scaled(factor),
            cofactors,
        }
    }

    /// multiplier · self − quotient · other, whose value the caller knows.
    fn less(
        &self,
        multiplier: &Polynomial,
        quotient: &Polynomial,
        other: &Self,
        value: Polynomial,
        meter: &Meter,
    ) -> Result<Self, Exhausted> {
        let mut cofactors = BTreeMap::new();
        for (&index, cofactor) in &self.cofactors {
            cofactors.insert(index, meter.product(multiplier, cofactor)?);
        }
        for (&index, cofactor) in &other.cofactors {
            let product = meter.product(quotient, cofactor)?;
            let entry: &mut Polynomial = cofactors.entry(index).or_default();
            *entry = meter.size(std::mem::take(entry) - product)?;
        }
        cofactors.retain(|_, cofactor| !cofactor.is_zero());
        Ok(Self {
            value: meter.size(value)?,
            cofactors,
        })
    }

    /// self − quotient · other.
    pub(super) fn reduced(
        &self,
        quotient: &Polynomial,
        other: &Self,
        meter: &mut Meter,
    ) -> Result<Self, Exhausted> {
        meter.step()?;
        let value = self.value.clone() - meter.product(quotient, &other.value)?;
        self.less(&Polynomial::one(), quotient, other, value, meter)
    }

    /// Takes a variable out by an element that is linear in it.
    pub(super) fn without(&self, solved: &Solved, meter: &mut Meter) -> Result<Self, Exhausted> {
        let degree = self.value.degree_in(solved.variable);
        if degree == 0 {
            return Ok(self.clone());
        }
        meter.step()?;
        // A bound on what the division would make, before it is made.
        let growth = solved.numerator.len().max(solved.denominator.len()).max(1);
        let size = (0..degree).try_fold(self.value.len(), |size, _| size.checked_mul(growth));
        if size.is_none_or(|size| size > meter.terms) {
            return Err(Exhausted);
        }
        let division =
            self.value
                .pseudo_division(solved.variable, &solved.numerator, &solved.denominator);
        self.less(
            &division.multiplier,
            &division.quotient,
            &solved.element,
            division.remainder,
            meter,
        )
    }
}

/// An element d·v − n, read as v = n/d.
#[derive(Debug)]
pub(super) struct Solved {
    pub(super) variable: Variable,
    pub(super) element: Combination,
    numerator: Polynomial,
    denominator: Polynomial,
}

impl Solved {
    /// Reads an element as a value for a variable in which it is linear.
    pub(super) fn new(element: Combination, variable: Variable) -> Self {
        let slope = element.value.coefficient_of(variable, 1);
        let element = match slope.is_constant() {
            Some(number) if !number.is_zero() => element.scaled(&(Rational::one() / number)),
            _ => element,
        };
        let denominator = element.value.coefficient_of(variable, 1);
        let numerator = -element.value.coefficient_of(variable, 0);
        Self {
            variable,
            element,
            numerator,
            denominator,
        }
    }
}
