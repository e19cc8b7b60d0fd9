//! Angles that are told by others: their sines and cosines are those of what tells them.

use crate::algebra::{Fraction, Variable, compose_by};
use crate::verify::model::atoms::Atoms;

impl Atoms {
    /// Whether a variable stands in an angle whose sine is a variable.
    pub(crate) fn has_sines(&self, variable: Variable) -> bool {
        self.angles()
            .any(|angle| angle.variables().contains(&variable))
    }

    /// What the sines and cosines come to that a variable stands in, with a value for it; without those that would have more
    /// terms.
    pub(crate) fn sines_by(
        &mut self,
        variable: Variable,
        value: &Fraction,
        most_terms: usize,
    ) -> Vec<(Variable, Fraction)> {
        let mut angles: Vec<Fraction> = vec![];
        for angle in self.angles() {
            if angle.variables().contains(&variable) && !angles.contains(angle) {
                angles.push(angle.clone());
            }
        }
        let told = angles.into_iter().filter_map(|angle| {
            let image = |of| (of == variable).then_some(value);
            let above = compose_by(angle.numerator(), image, most_terms).ok()?;
            let equal = above / Fraction::from(angle.denominator().clone());
            let (own, told) = (self.cosine_sine(&angle)?, self.cosine_sine(&equal)?);
            Some([(own.0, told.0), (own.1, told.1)])
        });
        let told: Vec<_> = told.flatten().collect();
        let kernels = told.into_iter();
        kernels
            .filter_map(|(kernel, value)| Some((kernel.as_variable()?, value)))
            .collect()
    }

    /// The angles whose sines and cosines are variables, each for both.
    fn angles(&self) -> impl Iterator<Item = &Fraction> {
        (0..self.len() as Variable).filter_map(|kernel| self.angle_of(kernel))
    }
}
