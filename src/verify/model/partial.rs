//! Partial derivatives, with everything put in that laws tell.

use crate::algebra::{Fraction, Place, Polynomial, Variable, compose, solve_linear};
use crate::verify::model::atoms::{Motion, Nature, fraction, whole};
use crate::verify::model::system::System;
use num_traits::Zero;
use std::collections::HashMap;

/// What is put together here has no more terms.
const MOST_TERMS: usize = 20_000;

impl System {
    /// A fraction with everything put in that laws tell, but for some variables that stay as they are.
    pub(crate) fn expanded(&self, of: &Fraction, kept: &[Variable]) -> Fraction {
        let mut value = of.clone();
        for _ in 0..64 {
            let mut images: HashMap<Variable, Fraction> = HashMap::new();
            for variable in value.variables().into_iter().filter(|v| !kept.contains(v)) {
                if let Some(law) = &self.atoms.atom(variable).law {
                    images.insert(variable, law.value.clone());
                }
            }
            if images.is_empty() {
                break;
            }
            let put = |p: &Polynomial| compose(p, &images, MOST_TERMS).ok();
            match (put(value.numerator()), put(value.denominator())) {
                (Some(top), Some(bottom)) => value = top / bottom,
                _ => break,
            }
        }
        value
    }

    /// A fraction as a function of some variables and of what is no rate: the rates that these tell are put in. `None`
    /// where they do not tell them all.
    pub(crate) fn in_arguments(&self, of: &Fraction, arguments: &[Variable]) -> Option<Fraction> {
        let value = self.expanded(of, arguments);
        let is_rate = |v: &Variable| self.atoms.atom(*v).place == Place::Rate;
        let is_foreign = |v: &Variable| is_rate(v) && !arguments.contains(v);
        if arguments.is_empty() || !value.variables().iter().any(is_foreign) {
            return Some(value);
        }
        let mut rates: Vec<Variable> = vec![];
        let mut equations = vec![];
        for &argument in arguments {
            let told = self.expanded(&fraction(argument), &[]);
            rates.extend(told.variables().into_iter().filter(is_foreign));
            let [top, bottom] = [told.numerator(), told.denominator()].map(Polynomial::clone);
            equations.push(top - Polynomial::variable(argument) * bottom);
        }
        rates.sort_unstable();
        rates.dedup();
        let solution = solve_linear(&equations, &rates, MOST_TERMS).ok()?;
        let below = Fraction::from(solution.determinant);
        let numerators = solution.numerators.into_iter().map(Fraction::from);
        let solved = numerators.map(|above| above / below.clone());
        let images: HashMap<Variable, Fraction> = rates.into_iter().zip(solved).collect();
        let put = |p: &Polynomial| compose(p, &images, MOST_TERMS).ok();
        let value = put(value.numerator())? / put(value.denominator())?;
        (!value.variables().iter().any(is_foreign)).then_some(value)
    }

    /// The variable that another one is only a name of.
    pub(crate) fn renamed(&self, variable: Variable) -> Variable {
        let mut renamed = variable;
        for _ in 0..64 {
            let law = self.atoms.atom(renamed).law.as_ref();
            match law.and_then(|law| law.value.as_variable()) {
                Some(other) => renamed = other,
                None => break,
            }
        }
        renamed
    }

    /// ∂f/∂x, also through the sines and roots that hold x.
    pub(crate) fn partial(&mut self, of: &Fraction, variable: Variable) -> Fraction {
        let mut sum = of.partial(variable);
        for kernel in of.variables() {
            let slope = match self.atoms.atom(kernel).nature.clone() {
                Nature::Sine(angle) => self.kernel_slope(&angle, variable, true),
                Nature::Cosine(angle) => self.kernel_slope(&angle, variable, false),
                Nature::Root(inside) | Nature::UnitPart(inside) => {
                    self.partial(&inside, variable) / (whole(2) * fraction(kernel))
                }
                _ => match self.atoms.atom(kernel).motion.clone() {
                    Motion::Rate(rate) => self.carried_slope(&rate, variable),
                    _ => continue,
                },
            };
            if !slope.is_zero() {
                sum += of.partial(kernel) * slope;
            }
        }
        sum
    }

    /// ∂w/∂x of what frames carry along: it depends on where things are alone, so this is ∂ẇ/∂ẋ.
    fn carried_slope(&self, rate: &Fraction, variable: Variable) -> Fraction {
        match self.atoms.known_rate(variable) {
            Some(speed) => self.expanded(rate, &[speed]).partial(speed),
            None => Fraction::zero(),
        }
    }

    pub(super) fn kernel_slope(
        &mut self,
        angle: &Fraction,
        variable: Variable,
        sine: bool,
    ) -> Fraction {
        let inner = angle.partial(variable);
        match self.atoms.cosine_sine(angle) {
            Some((c, s)) => inner * if sine { c } else { -s },
            None => Fraction::zero(),
        }
    }
}
