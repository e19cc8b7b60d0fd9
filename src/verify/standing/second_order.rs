//! A relation to first order whose sides are both of second order says nothing to first order: it is one to second order.

use crate::algebra::Fraction;
use crate::verify::facts::small::Small;
use crate::verify::standing::judge::Judge;
use num_traits::Zero;

impl Judge<'_> {
    /// Whether two sides that are equal to first order have no terms of first order, and differ in those of second order.
    pub(super) fn differs_in_second_order(
        &mut self,
        sides: &[(Fraction, Fraction)],
        small: &Small,
    ) -> bool {
        let Some(finer) = small.to_second_order() else {
            return false;
        };
        sides.iter().any(|(left, right)| {
            let difference = left.clone() - right.clone();
            let atoms = &mut self.reading.system.atoms;
            let mut normal = |side: &Fraction| self.facts.normal(atoms, side).ok();
            let all = (normal(left), normal(right), normal(&difference));
            let (Some(left), Some(right), Some(difference)) = all else {
                return false;
            };
            let beyond = |side: &Fraction| {
                !side.is_zero() && small.truncated(atoms, side.numerator()).is_zero()
            };
            let differ = !finer.truncated(atoms, difference.numerator()).is_zero();
            beyond(&left) && beyond(&right) && differ
        })
    }
}
