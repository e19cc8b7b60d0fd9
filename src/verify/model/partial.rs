//! Partial derivatives, with everything put in that laws tell.

use crate::algebra::{Fraction, Polynomial, Variable, compose};
use crate::verify::model::atoms::{Nature, fraction, whole};
use crate::verify::model::system::System;
use num_traits::Zero;
use std::collections::HashMap;

impl System {
    /// A fraction with everything put in that laws tell.
    pub(crate) fn expanded(&self, of: &Fraction) -> Fraction {
        let mut value = of.clone();
        for _ in 0..64 {
            let mut images: HashMap<Variable, Fraction> = HashMap::new();
            for variable in value.variables() {
                if let Some(law) = &self.atoms.atom(variable).law {
                    images.insert(variable, law.value.clone());
                }
            }
            if images.is_empty() {
                break;
            }
            let put = |p: &Polynomial| compose(p, &images, 20_000).ok();
            match (put(value.numerator()), put(value.denominator())) {
                (Some(top), Some(bottom)) => value = top / bottom,
                _ => break,
            }
        }
        value
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
                _ => continue,
            };
            if !slope.is_zero() {
                sum += of.partial(kernel) * slope;
            }
        }
        sum
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
