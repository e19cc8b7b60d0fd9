//! Kinetic energy of rotation and the power of a moment.

use crate::mechanics::inertia::quadratic;
use crate::scalar::{Field, Ring};
use nalgebra::{Matrix3, Vector3};

/// The kinetic energy of rotation `T = ½ ω · I ω` in J, about the mass centre or a fixed point, along any axes.
#[inline]
pub fn kinetic_energy<T: Field>(inertia: &Matrix3<T>, omega: &Vector3<T>) -> T {
    T::ratio(1, 2) * vis_viva(inertia, omega)
}

/// Twice the kinetic energy, `2 T = ω · I ω` in J: the form that needs no division.
#[inline]
pub fn vis_viva<T: Ring>(inertia: &Matrix3<T>, omega: &Vector3<T>) -> T {
    quadratic(inertia, omega)
}

/// The power of a moment, `M · ω` in W; it is the rate of the kinetic energy.
#[inline]
pub fn power<T: Ring>(moment: &Vector3<T>, omega: &Vector3<T>) -> T {
    moment.dot(omega)
}
