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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::{inertia_of_points, relative_acceleration};

    #[test]
    fn the_moments_are_those_of_the_forces_on_the_points() {
        // Four points about their mass centre.
        let points = [
            (2, Vector3::new(1, -2, 3)),
            (2, Vector3::new(-1, 2, -3)),
            (1, Vector3::new(4, 0, 1)),
            (1, Vector3::new(-4, 0, -1)),
        ];
        let (turn, change) = (Vector3::new(3, -1, 2), Vector3::new(0, 5, -4));
        let spin = Vector3::new(-2, 7, 1);
        let inertia = inertia_of_points(&points);
        let mut sums = [Vector3::zeros(); 3];
        for (mass, place) in points {
            let rate = spin.cross(&place);
            let terms = relative_acceleration(&Vector3::zeros(), &rate, &place, &turn, &change);
            let forces = [terms.coriolis, terms.centripetal, terms.euler];
            for (sum, force) in sums.iter_mut().zip(forces) {
                *sum -= place.cross(&force) * mass;
            }
        }
        assert_eq!(coriolis_moment(&inertia, &turn, &spin), sums[0]);
        assert_eq!(centrifugal_moment(&inertia, &turn), sums[1]);
        assert_eq!(euler_moment(&inertia, &change), sums[2]);
    }
}
