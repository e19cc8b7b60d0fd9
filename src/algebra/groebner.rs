//! Gröbner bases whose elements remember their cofactors (Buchberger 1965).
//!
//! Cox, Little, O'Shea, *Ideals, Varieties, and Algorithms*, chapter 2, has the algorithm and its two criteria;
//! here it has a budget, and it stops as soon as the target is zero.

use super::combination::{Combination, Exhausted, Meter};
use crate::algebra::{Monomial, Polynomial};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// A basis that grows while the target is reduced by it.
pub(super) struct Basis {
    elements: Vec<Combination>,
    /// Pairs to look at, the lowest common multiple of their leading monomials first.
    pairs: BTreeSet<(Monomial, usize, usize)>,
}

impl Basis {
    pub(super) fn new(generators: Vec<Combination>) -> Self {
        let mut basis = Self {
            elements: vec![],
            pairs: BTreeSet::new(),
        };
        for generator in generators {
            basis.insert(generator);
        }
        basis
    }

    fn insert(&mut self, element: Combination) {
        let element = element.monic();
        let Some(lead) = lead(&element).cloned() else {
            return;
        };
        let new = self.elements.len();
        for (old, other) in self.elements.iter().enumerate() {
            let Some(other) = self::lead(other) else {
                continue;
            };
            // Coprime leading monomials give nothing new (Buchberger's first criterion).
            if other.gcd(&lead).degree() > 0 {
                self.pairs.insert((other.lcm(&lead), old, new));
            }
        }
        self.elements.push(element);
    }

    /// The element that is a nonzero number, if there is one: then nothing satisfies the generators.
    pub(super) fn unit(&self) -> Option<&Combination> {
        let is_unit = |e: &&Combination| e.value.is_constant().is_some_and(|c| !c.is_zero());
        self.elements.iter().find(is_unit)
    }

    /// Reduces the target, growing the basis until the target is zero or the basis complete.
    pub(super) fn reduce(
        &mut self,
        target: &mut Combination,
        meter: &mut Meter,
    ) -> Result<(), Exhausted> {
        self.divide(target, meter)?;
        while !target.value.is_zero() && self.unit().is_none() {
            let Some((lcm, i, j)) = self.pairs.pop_first() else {
                break;
            };
            let mut pair = self.difference(&lcm, i, j, meter)?;
            self.divide(&mut pair, meter)?;
            if !pair.value.is_zero() {
                self.insert(pair);
                self.divide(target, meter)?;
            }
        }
        Ok(())
    }

    /// The difference of two elements brought to one leading monomial.
    fn difference(
        &self,
        lcm: &Monomial,
        i: usize,
        j: usize,
        meter: &mut Meter,
    ) -> Result<Combination, Exhausted> {
        let up = |at: usize| {
            let factor = lead(&self.elements[at]).and_then(|lead| lcm.quotient(lead));
            Polynomial::term(factor.unwrap_or_else(Monomial::one), One::one())
        };
        let nothing = Combination {
            value: Polynomial::zero(),
            cofactors: Default::default(),
        };
        let raised = nothing.reduced(&-up(i), &self.elements[i], meter)?;
        raised.reduced(&up(j), &self.elements[j], meter)
    }

    /// Takes out every term that a leading monomial divides.
    fn divide(&self, target: &mut Combination, meter: &mut Meter) -> Result<(), Exhausted> {
        while let Some((quotient, by)) = self.divisible(&target.value) {
            *target = target.reduced(&quotient, by, meter)?;
        }
        Ok(())
    }

    fn divisible(&self, value: &Polynomial) -> Option<(Polynomial, &Combination)> {
        value.terms().iter().find_map(|(monomial, coefficient)| {
            self.elements.iter().find_map(|element| {
                let quotient = monomial.quotient(lead(element)?)?;
                Some((Polynomial::term(quotient, coefficient.clone()), element))
            })
        })
    }
}

fn lead(element: &Combination) -> Option<&Monomial> {
    element.value.terms().first().map(|(monomial, _)| monomial)
}
