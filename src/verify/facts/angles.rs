//! Equal angles have equal sines and cosines.

use crate::algebra::{Polynomial, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::{Atoms, fraction};

/// Angles of more terms are not put in for another one.
const MOST_TERMS: usize = 6;

impl Facts {
    /// The sines and cosines of a variable that is told now are those of its value, where it is an angle: θ = θ₀ tells
    /// sin θ = sin θ₀.
    pub(super) fn tell_sines(&mut self, atoms: &mut Atoms, variable: Variable, source: &Source) {
        let Some(value) = self.rule(variable).map(|rule| rule.value.clone()) else {
            return;
        };
        if !value.is_polynomial() || value.numerator().len() > MOST_TERMS {
            return;
        }
        let mut others = value.variables().into_iter();
        if !atoms.has_sines(variable) && others.any(|other| atoms.has_sines(other)) {
            atoms.cosine_sine(&fraction(variable));
        }
        for (kernel, value) in atoms.sines_by(variable, &value, MOST_TERMS) {
            if self.rule(kernel).is_none() && value.as_variable() != Some(kernel) {
                let left = Polynomial::variable(kernel) * value.denominator().clone();
                let equation = left - value.numerator().clone();
                self.tell(atoms, kernel, value, equation, source);
            }
        }
    }
}
