//! Bounds on numbers: what a fraction of π, roots, sines and their like lies between.

use crate::algebra::proof::{Kernel, Ratio};
use crate::algebra::{Interval, Polynomial, Rational, Variable};
use num_traits::Zero;
use std::collections::BTreeMap;

/// Functions inside functions beyond this are not gone into.
const DEEPEST: u32 = 12;
/// Powers beyond this are not multiplied out.
const HIGHEST_POWER: u32 = 64;

/// lower ≤ value ≤ upper, for a value whose variables all stand for functions of numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bound {
    /// What lies between.
    pub value: Ratio,
    /// The lower end.
    pub lower: Rational,
    /// The upper end.
    pub upper: Rational,
}

impl Bound {
    /// Whether it is so: an interval that holds the value lies between the ends.
    pub(super) fn holds(&self, kernels: &BTreeMap<Variable, Kernel>) -> bool {
        enclosure(&self.value, kernels)
            .is_some_and(|interval| interval.within(&self.lower, &self.upper))
    }
}

/// An interval that holds the value of a ratio; `None` where a variable stands for no number, or a function has no
/// value.
pub fn enclosure(ratio: &Ratio, kernels: &BTreeMap<Variable, Kernel>) -> Option<Interval> {
    within_depth(ratio, kernels, DEEPEST)
}

fn within_depth(
    ratio: &Ratio,
    kernels: &BTreeMap<Variable, Kernel>,
    depth: u32,
) -> Option<Interval> {
    let depth = depth.checked_sub(1)?;
    let mut variables = ratio.numerator.variables();
    variables.extend(ratio.denominator.variables());
    variables.sort_unstable();
    variables.dedup();
    let value = |v| Some((v, function(kernels.get(&v)?, kernels, depth)?));
    let values: BTreeMap<Variable, Interval> =
        variables.into_iter().map(value).collect::<Option<_>>()?;
    let top = polynomial(&ratio.numerator, &values)?;
    let bottom = polynomial(&ratio.denominator, &values)?;
    Some(top.times(&bottom.inverse()?))
}

fn polynomial(polynomial: &Polynomial, values: &BTreeMap<Variable, Interval>) -> Option<Interval> {
    let mut sum = Interval::from(&Rational::zero());
    for (monomial, coefficient) in polynomial.terms() {
        let mut term = Interval::from(coefficient);
        for (variable, exponent) in monomial.powers() {
            if exponent > HIGHEST_POWER {
                return None;
            }
            term = term.times(&values.get(&variable)?.power(exponent));
        }
        sum = sum.plus(&term);
    }
    Some(sum)
}

fn function(kernel: &Kernel, kernels: &BTreeMap<Variable, Kernel>, depth: u32) -> Option<Interval> {
    if kernel.function == "pi" {
        return Some(Interval::pi());
    }
    let argument = within_depth(&kernel.argument, kernels, depth)?;
    match kernel.function {
        "sqrt" => argument.square_root(),
        "sin" => Some(argument.sine_cosine()?.0),
        "cos" => Some(argument.sine_cosine()?.1),
        "exp" => argument.exponential(),
        "ln" => argument.logarithm(),
        _ => None,
    }
}
