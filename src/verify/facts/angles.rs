//! Equal angles have equal sines and cosines.

use crate::algebra::{Fraction, Polynomial, Variable, compose_by};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::Atoms;

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
        let mut angles = angles_with(atoms, variable);
        let mut others = value.variables().into_iter();
        if angles.is_empty() && others.any(|other| !angles_with(atoms, other).is_empty()) {
            angles.push(Fraction::from(Polynomial::variable(variable)));
        }
        for angle in angles {
            let image = |of| (of == variable).then_some(&value);
            let Ok(above) = compose_by(angle.numerator(), image, MOST_TERMS) else {
                continue;
            };
            let equal = above / Fraction::from(angle.denominator().clone());
            let (own, told) = (atoms.cosine_sine(&angle), atoms.cosine_sine(&equal));
            let (Some(own), Some(told)) = (own, told) else {
                continue;
            };
            for (kernel, value) in [(own.0, told.0), (own.1, told.1)] {
                if let Some(kernel) = kernel.as_variable() {
                    self.tell_kernel(atoms, kernel, value, source);
                }
            }
        }
    }

    fn tell_kernel(&mut self, atoms: &Atoms, kernel: Variable, value: Fraction, source: &Source) {
        if self.rule(kernel).is_some() || value.as_variable() == Some(kernel) {
            return;
        }
        let left = Polynomial::variable(kernel) * value.denominator().clone();
        let equation = left - value.numerator().clone();
        self.tell(atoms, kernel, value, equation, source);
    }
}

/// The angles with sines of their own in which a variable stands.
fn angles_with(atoms: &Atoms, variable: Variable) -> Vec<Fraction> {
    let all = (0..atoms.len()).filter_map(|place| Variable::try_from(place).ok());
    let mut angles: Vec<Fraction> = vec![];
    for angle in all.filter_map(|kernel| atoms.angle_of(kernel)) {
        if angle.variables().contains(&variable) && !angles.contains(angle) {
            angles.push(angle.clone());
        }
    }
    angles
}
