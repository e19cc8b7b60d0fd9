//! The linear spring between two points.

use crate::scalar::Field;
use nalgebra::Vector3;

/// The force `−k (1 − L/d) r` in N of a spring of stiffness k in N/m and natural length L in m on its end at r from the other
/// one, where d = |r| in m is its length, which must not be zero.
///
/// A field has no root: the length comes with the way.
#[inline]
pub fn spring_force<T: Field>(
    stiffness: &T,
    natural_length: &T,
    way: &Vector3<T>,
    length: &T,
) -> Vector3<T> {
    let strained = T::one() - natural_length.clone() / length.clone();
    -way * (stiffness.clone() * strained)
}

/// The potential energy `½ k (d − L)²` in J of a spring of length d, zero where it has its natural length L.
#[inline]
pub fn spring_energy<T: Field>(stiffness: &T, natural_length: &T, length: &T) -> T {
    let elongation = length.clone() - natural_length.clone();
    T::ratio(1, 2) * stiffness.clone() * elongation.clone() * elongation
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::{DualNum, DualVec64};

    #[test]
    fn the_force_is_the_gradient_of_the_energy_downhill() {
        let (stiffness, natural, at) = (3.0, 1.25, Vector3::new(0.4, -1.1, 2.0));
        let force = spring_force(&stiffness, &natural, &at, &at.norm());
        let energy = |way: Vector3<DualVec64<nalgebra::Const<3>>>| {
            let length = way.dot(&way).sqrt();
            let [stiffness, natural] = [stiffness, natural].map(DualVec64::from);
            spring_energy(&stiffness, &natural, &length)
        };
        let (_, gradient) = num_dual::gradient(energy, &at);
        assert!((force + gradient).norm() < 1e-12);
        // Stretched it pulls back, compressed it pushes.
        assert!(force.dot(&at) < 0.0);
        assert!(spring_force(&stiffness, &4.0, &at, &at.norm()).dot(&at) > 0.0);
    }
}
