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
