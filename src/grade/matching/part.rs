//! One component of a line, and how much it has in common with another.

use crate::algebra::{Fraction, Monomial, Variable};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Two lines with the same head are attempts at one if they share this part of their terms.
const ALIKE_WITH_HEAD: f64 = 0.25;

/// The same for lines of which one has no head, or another.
const ALIKE: f64 = 0.6;

/// One component of a line: this vanishes.
#[derive(Clone, Debug)]
pub(in crate::grade) struct Part {
    pub(in crate::grade) residual: Fraction,
    /// The quantity that the line says something of: a side that is one variable.
    pub(in crate::grade) head: Option<Variable>,
    /// The period or the frequency that it speaks of: any line on that is an attempt at any other.
    pub(super) pace: Option<Variable>,
    pub(super) terms: BTreeSet<Monomial>,
    pub(super) variables: Vec<Variable>,
    /// Its number among those of the key.
    pub(super) number: Option<usize>,
}

impl Part {
    pub(super) fn new(residual: Fraction, head: Option<Variable>) -> Self {
        let terms = residual.numerator().terms().iter();
        let terms = terms.map(|(monomial, _)| monomial.clone()).collect();
        Self {
            variables: residual.variables(),
            residual,
            head,
            pace: None,
            terms,
            number: None,
        }
    }

    /// Whether it is more than what is known anyway.
    pub(in crate::grade) fn says_something(&self) -> bool {
        !self.residual.is_zero()
    }

    pub(in crate::grade) fn terms(&self) -> &BTreeSet<Monomial> {
        &self.terms
    }

    /// Whether two say the same up to a number.
    pub(in crate::grade) fn is_multiple_of(&self, other: &Self) -> bool {
        let (own, theirs) = (self.residual.numerator(), other.residual.numerator());
        let (Some((_, a)), Some((_, b))) = (own.terms().first(), theirs.terms().first()) else {
            return false;
        };
        self.terms == other.terms && own.scaled(b) == theirs.scaled(a)
    }

    pub(in crate::grade) fn has(&self, variable: Variable) -> bool {
        self.variables.contains(&variable)
    }

    pub(in crate::grade) fn shares_variable(&self, other: &Self) -> bool {
        self.variables.iter().any(|v| other.variables.contains(v))
    }

    /// How much two have in common, from 0 to 1, if one may be an attempt at the other.
    pub(in crate::grade) fn likeness(&self, other: &Self) -> Option<f64> {
        let [fewest, most] = [usize::min, usize::max]
            .map(|chosen| chosen(self.terms.len(), other.terms.len()).max(1) as f64);
        let same_head = self.head.is_some() && self.head == other.head;
        let same_pace = self.pace.is_some() && self.pace == other.pace;
        let least = match (same_pace, same_head) {
            (true, _) => 0.0,
            (false, true) => ALIKE_WITH_HEAD,
            (false, false) => ALIKE,
        };
        // They share no more terms than the shorter one has.
        if fewest / most < least {
            return None;
        }
        let common = self.terms.intersection(&other.terms).count() as f64;
        (common / most >= least).then_some(common / most)
    }
}
