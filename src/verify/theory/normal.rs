//! Normal forms: a formula with every law and premise put in, down to free variables.

use crate::algebra::{Fraction, Polynomial, TooLarge, Variable, compose};
use crate::verify::theory::Theory;
use crate::verify::values::atoms::variable_fraction;
use foldhash::HashMap;
use std::collections::VecDeque;

/// Terms that a product in a normal form may have: a budget, so that every check ends.
const MOST_TERMS: usize = 6_000;
/// Rules that may lead from one to the next.
const DEEPEST: usize = 64;
/// Formulas whose normal forms are remembered: a line is looked at in many ways, one after the other.
const RECENT: usize = 64;

/// Normal forms that are known for as long as the rules stay as they are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Normals {
    variables: HashMap<Variable, Fraction>,
    recent: VecDeque<(Fraction, Fraction)>,
}

impl Normals {
    /// The normal form of a variable.
    pub(crate) fn get(&self, variable: Variable) -> Option<&Fraction> {
        self.variables.get(&variable)
    }

    /// Notes the normal form of a variable.
    pub(crate) fn insert(&mut self, variable: Variable, normal: Fraction) {
        self.variables.insert(variable, normal);
    }

    /// Forgets all.
    pub(crate) fn clear(&mut self) {
        self.variables.clear();
        self.recent.clear();
    }

    fn recall(&self, fraction: &Fraction) -> Option<Fraction> {
        let same = |(known, _): &&(Fraction, Fraction)| {
            known.numerator() == fraction.numerator()
                && known.denominator() == fraction.denominator()
        };
        self.recent.iter().rev().find(same).map(|(_, n)| n.clone())
    }

    fn remember(&mut self, fraction: &Fraction, normal: &Fraction) {
        if self.recent.len() == RECENT {
            self.recent.pop_front();
        }
        self.recent.push_back((fraction.clone(), normal.clone()));
    }
}

impl Theory {
    /// A fraction with every rule put in, down to free variables.
    pub(crate) fn normal(&mut self, fraction: &Fraction) -> Fraction {
        // On the way down a variable may count as free that is not, and a budget counts what is written.
        let whole = self.open.is_empty() && self.terms_left.is_none();
        if whole && let Some(known) = self.solution.normals.recall(fraction) {
            return known;
        }
        let numerator = self.normal_polynomial(fraction.numerator());
        let normal = if fraction.denominator().is_constant().is_some() {
            numerator / Fraction::from(fraction.denominator().clone())
        } else {
            numerator / self.normal_polynomial(fraction.denominator())
        };
        if whole && !self.exhausted {
            self.solution.normals.remember(fraction, &normal);
        }
        normal
    }

    fn normal_polynomial(&mut self, polynomial: &Polynomial) -> Fraction {
        let variables = polynomial.variables();
        let images: HashMap<Variable, Fraction> = variables
            .into_iter()
            .map(|v| (v, self.normal_variable(v)))
            .collect();
        if images
            .iter()
            .all(|(v, image)| *image == variable_fraction(*v))
        {
            return self.kernels_reduced(Fraction::from(polynomial.clone()));
        }
        match compose(polynomial, &images, MOST_TERMS) {
            Ok(value) => {
                self.spend(value.numerator().len() + value.denominator().len());
                self.kernels_reduced(value)
            }
            Err(TooLarge) => {
                self.spend(MOST_TERMS);
                self.exhausted = true;
                Fraction::from(polynomial.clone())
            }
        }
    }

    pub(super) fn spend(&mut self, terms: usize) {
        self.terms_left = self.terms_left.map(|left| left.saturating_sub(terms));
    }

    fn normal_variable(&mut self, variable: Variable) -> Fraction {
        if let Some(known) = self.solution.normals.get(variable) {
            return known.clone();
        }
        if self.open.len() > DEEPEST || self.terms_left == Some(0) {
            self.exhausted = true;
            return variable_fraction(variable);
        }
        // A rule that leads back to its own variable says nothing; the variable stays free.
        if !self.open.insert(variable) {
            return variable_fraction(variable);
        }
        let value = match self.rule(variable) {
            Some(rule) => self.normal(&rule.value),
            None => variable_fraction(variable),
        };
        self.open.remove(&variable);
        self.solution.normals.insert(variable, value.clone());
        value
    }
}
