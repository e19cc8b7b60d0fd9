//! What turning axes add to the loads on a body: Coriolis, centrifugal and Euler forces, and their moments.
//!
//! A force is −m times a term of [`relative_acceleration`](crate::mechanics::relative_acceleration) at the mass
//! centre. About the mass centre the forces on the elements of a rigid body have moments of their own, below. All
//! components are along the same axes, Ω is the angular velocity of the turning axes in rad/s, and moments are in N m.

use crate::mechanics::{apply, cross};
use crate::scalar::Ring;
use nalgebra::{Matrix3, Vector3};

/// The moment about the mass centre of the Coriolis forces on a body with the inertia I that turns at w as the axes see
/// it: `(2 I Ω − tr(I) Ω) × w`.
///
/// It is −2 ∫ ρ × (Ω × (w × ρ)) dm, where ∫ ρ ρᵀ dm = ½ tr(I) 1 − I.
#[inline]
pub fn coriolis_moment<T: Ring>(
    inertia: &Matrix3<T>,
    frame_rate: &Vector3<T>,
    relative_omega: &Vector3<T>,
) -> Vector3<T> {
    let along = apply(inertia, frame_rate);
    let twice = &along + &along - frame_rate * inertia.trace();
    cross(&twice, relative_omega)
}

/// The moment about the mass centre of the centrifugal forces on a body: `−Ω × I Ω`.
#[inline]
pub fn centrifugal_moment<T: Ring>(inertia: &Matrix3<T>, frame_rate: &Vector3<T>) -> Vector3<T> {
    -cross(frame_rate, &apply(inertia, frame_rate))
}

/// The moment about the mass centre of the Euler forces on a body: `−I Ω̇`.
#[inline]
pub fn euler_moment<T: Ring>(inertia: &Matrix3<T>, frame_acceleration: &Vector3<T>) -> Vector3<T> {
    -apply(inertia, frame_acceleration)
}
