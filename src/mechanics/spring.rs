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

    #[test]
    fn the_force_is_the_slope_of_the_energy_downhill() {
        let (stiffness, natural, at) = (3.0_f64, 1.25_f64, Vector3::new(0.4_f64, -1.1, 2.0));
        let force = spring_force(&stiffness, &natural, &at, &at.norm());
        let energy = |way: Vector3<f64>| spring_energy(&stiffness, &natural, &way.norm());
        let step = 1e-5;
        for axis in 0..3 {
            let mut way = Vector3::zeros();
            way[axis] = step;
            let slope = (energy(at + way) - energy(at - way)) / (2.0 * step);
            assert!((force[axis] + slope).abs() < 1e-8);
        }
    }

    #[test]
    fn stretched_it_pulls_back_and_compressed_it_pushes() {
        let at = Vector3::new(0.0_f64, 3.0, 4.0);
        let force = |natural: f64| spring_force(&2.0, &natural, &at, &5.0);
        assert!((force(4.0) + at * 0.4).norm() < 1e-12);
        assert!((force(6.0) - at * 0.4).norm() < 1e-12);
    }
}
