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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_point_of_a_tilted_disc_is_on_its_rim_and_below_all_others() {
        let (sine, cosine): (f64, f64) = (0.6, 0.8);
        let (axis, upward) = (Vector3::new(sine, 0.0, cosine), Vector3::z());
        let lowest: Vector3<f64> = lowest_of_disc(&2.0, &axis, &upward) / sine;
        assert!((lowest.norm() - 2.0).abs() < 1e-12 && lowest.dot(&axis).abs() < 1e-12);
        let across = axis.cross(&lowest);
        let other = |angle: f64| lowest * angle.cos() + across * angle.sin();
        let height = |angle: f64| other(angle).dot(&upward);
        assert!((1..63).all(|k| height(0.1 * f64::from(k)) >= height(0.0)));
        assert_eq!(
            lowest_of_sphere(&2.0, &upward),
            Vector3::new(0.0, 0.0, -2.0)
        );
    }

    #[test]
    fn what_a_body_point_does_is_the_rate_of_what_it_did() {
        let omega = Vector3::new(0.3, -0.7, 1.1);
        let (alpha, place) = (Vector3::new(-0.2, 0.5, 0.4), Vector3::new(1.0, 2.0, -1.5));
        let (v, a) = (Vector3::new(0.1, 0.2, 0.3), Vector3::new(-1.0, 0.0, 2.0));
        let velocity = |t: f64| {
            // The place is carried along: its rate is ω × r.
            let carried = place + omega.cross(&place) * t;
            velocity_of_body_point(&(v + a * t), &(omega + alpha * t), &carried)
        };
        let step = 1e-6;
        let rate = (velocity(step) - velocity(-step)) / (2.0 * step);
        assert!((rate - acceleration_of_body_point(&a, &omega, &alpha, &place)).norm() < 1e-8);
    }
}
