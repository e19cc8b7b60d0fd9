//! Momentum, its rate seen from the axes, and the force and moment that change it.

use crate::mechanics::{apply, cross};
use crate::scalar::{Jet, Ring};
use nalgebra::{Matrix3, Vector3};

/// The angular momentum `L = I ω` in kg m²/s, about the point of the tensor, along its axes.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn angular_momentum<T: Ring>(inertia: &Matrix3<T>, omega: &Vector3<T>) -> Vector3<T> {
    apply(inertia, omega)
}

/// The rate `(dL/dt)_xyz` of the components of L = I ω along the axes of the tensor, in N m.
///
/// `omega_rate` and `inertia_rate` are the rates of the components along the same axes; `inertia_rate` is zero where
/// the axes are attached to the body. It is not typed in as a product rule: `L = I ω` runs on a jet in time.
#[inline]
pub fn momentum_rate<T: Ring>(
    inertia: &Matrix3<T>,
    inertia_rate: &Matrix3<T>,
    omega: &Vector3<T>,
    omega_rate: &Vector3<T>,
) -> Vector3<T> {
    let inertia = inertia.zip_map(inertia_rate, Jet::moving);
    let omega = omega.zip_map(omega_rate, Jet::moving);
    angular_momentum(&inertia, &omega).map(|l| l.rate())
}

/// Newton's law for the mass centre: `ΣF = m a_G`, in N, along any axes in which the acceleration is given.
#[inline]
pub fn force<T: Ring>(mass: &T, acceleration: &Vector3<T>) -> Vector3<T> {
    acceleration.map(|a| mass.clone() * a)
}

/// The moment about a point P that moves: `ΣM_P = (dL_P/dt)_XYZ + v_P × p`, in N m.
///
/// L_P = Σ r × m v holds the places relative to P and the velocities in space; `linear_momentum` is p = m v_G. The
/// extra term vanishes where P is fixed, where P is the mass centre, and where v_P is along v_G; elsewhere
/// `ΣM_P = dL_P/dt` is a mistake.
#[inline]
pub fn moment_about_moving_point<T: Ring>(
    momentum_rate: &Vector3<T>,
    point_velocity: &Vector3<T>,
    linear_momentum: &Vector3<T>,
) -> Vector3<T> {
    momentum_rate + cross(point_velocity, linear_momentum)
}
