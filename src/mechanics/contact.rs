//! Where a round body touches a plane, and how the points of a rigid body move.

use crate::mechanics::cross;
use crate::scalar::Ring;
use nalgebra::Vector3;

/// The velocity `v + ω × r` in m/s of the point of a rigid body that is at `place` r in m from one with velocity v.
///
/// A body rolls without slipping where this is the velocity of the plane. It is not the velocity of the place at which
/// the two touch: that place moves over the body.
#[inline]
pub fn velocity_of_body_point<T: Ring>(
    velocity: &Vector3<T>,
    omega: &Vector3<T>,
    place: &Vector3<T>,
) -> Vector3<T> {
    velocity + cross(omega, place)
}

/// The acceleration `a + α × r + ω × (ω × r)` in m/s² of the point of a rigid body at `place` r from one with a.
#[inline]
pub fn acceleration_of_body_point<T: Ring>(
    acceleration: &Vector3<T>,
    omega: &Vector3<T>,
    alpha: &Vector3<T>,
    place: &Vector3<T>,
) -> Vector3<T> {
    acceleration + cross(alpha, place) + cross(omega, &cross(omega, place))
}

/// The way `−r n` in m from the centre of a sphere of radius r to its lowest point, n the upward unit vector.
#[inline]
pub fn lowest_of_sphere<T: Ring>(radius: &T, upward: &Vector3<T>) -> Vector3<T> {
    -upward * radius.clone()
}

/// The way in m from the centre of a thin disc to the lowest point of its rim, times the sine of the angle between the
/// axis d and the upward unit vector n: `−r (n − (n·d) d)`.
///
/// The steepest line of the disc has the direction n − (n·d) d, of length `√(1 − (n·d)²)`; a disc that lies flat has
/// no lowest point.
#[inline]
pub fn lowest_of_disc<T: Ring>(radius: &T, axis: &Vector3<T>, upward: &Vector3<T>) -> Vector3<T> {
    (axis * upward.dot(axis) - upward) * radius.clone()
}
