//! The rate of a vector seen from axes that turn, once and twice, in the plane and in space.

use crate::mechanics::{apply, attitude_rate, cross};
use crate::scalar::{Jet, Ring};
use nalgebra::{Matrix3, Vector2, Vector3};

/// The transport theorem `(dQ/dt)_XYZ = (dQ/dt)_xyz + Ω × Q`, along the turning axes xyz.
///
/// `rate` is the rate of the components of Q along xyz, and Ω the angular velocity of xyz in rad/s.
/// [`transport_derived`] shows that it is true.
#[inline]
pub fn transport<T: Ring>(
    rate: &Vector3<T>,
    frame_rate: &Vector3<T>,
    vector: &Vector3<T>,
) -> Vector3<T> {
    rate + cross(frame_rate, vector)
}

/// The left side of the transport theorem from first principles: `Rᵀ d(R Q)/dt` with `Ṙ = R [Ω]×`.
///
/// `attitude` takes components along xyz to components along XYZ; the product is differentiated by a jet in time.
/// For a rotation matrix R it equals [`transport`], for every Q; that is the theorem.
pub fn transport_derived<T: Ring>(
    attitude: &Matrix3<T>,
    rate: &Vector3<T>,
    frame_rate: &Vector3<T>,
    vector: &Vector3<T>,
) -> Vector3<T> {
    let turning = attitude.zip_map(&attitude_rate(attitude, frame_rate), Jet::moving);
    let moving = vector.zip_map(rate, Jet::moving);
    let in_space = apply(&turning, &moving).map(|q| q.rate());
    apply(&attitude.transpose(), &in_space)
}

/// The second rate in space by the theorem applied to itself, along the turning axes:
/// `(d²Q/dt²)_XYZ = Q̈ + 2 Ω × Q̇ + Ω̇ × Q + Ω × (Ω × Q)`.
///
/// It is not typed in so: the theorem runs on jets in time, then once more on what came out. The single terms are in
/// [`relative_acceleration`].
pub fn transport_twice<T: Ring>(
    second_rate: &Vector3<T>,
    rate: &Vector3<T>,
    vector: &Vector3<T>,
    frame_rate: &Vector3<T>,
    frame_acceleration: &Vector3<T>,
) -> Vector3<T> {
    let first = transport(
        &rate.zip_map(second_rate, Jet::moving),
        &frame_rate.zip_map(frame_acceleration, Jet::moving),
        &vector.zip_map(rate, Jet::moving),
    );
    transport(
        &first.map(|q| q.rate()),
        frame_rate,
        &first.map(|q| q.value),
    )
}

/// The terms of the second rate in space, by their names.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativeAcceleration<T> {
    /// `Q̈`, as the turning axes see it.
    pub relative: Vector3<T>,
    /// Coriolis: `2 Ω × Q̇`.
    pub coriolis: Vector3<T>,
    /// Euler: `Ω̇ × Q`.
    pub euler: Vector3<T>,
    /// Centripetal: `Ω × (Ω × Q)`.
    pub centripetal: Vector3<T>,
}

/// The four terms whose sum is [`transport_twice`], of the same arguments.
pub fn relative_acceleration<T: Ring>(
    second_rate: &Vector3<T>,
    rate: &Vector3<T>,
    vector: &Vector3<T>,
    frame_rate: &Vector3<T>,
    frame_acceleration: &Vector3<T>,
) -> RelativeAcceleration<T> {
    let half = cross(frame_rate, rate);
    RelativeAcceleration {
        relative: second_rate.clone(),
        coriolis: &half + &half,
        euler: cross(frame_acceleration, vector),
        centripetal: cross(frame_rate, &cross(frame_rate, vector)),
    }
}

/// The velocity of a point P seen from turning axes whose origin O moves: `v_P = v_O + (ṙ)_xyz + Ω × r`, in m/s.
///
/// `place` is r from O to P and `rate` its rate along xyz; all components along xyz.
#[inline]
pub fn velocity_in_moving_frame<T: Ring>(
    origin_velocity: &Vector3<T>,
    rate: &Vector3<T>,
    frame_rate: &Vector3<T>,
    place: &Vector3<T>,
) -> Vector3<T> {
    origin_velocity + transport(rate, frame_rate, place)
}

/// [`transport`] in the plane: Ω is a number, and `Ω × Q = Ω (−Q_y, Q_x)`.
#[inline]
pub fn transport_in_plane<T: Ring>(
    rate: &Vector2<T>,
    frame_rate: &T,
    vector: &Vector2<T>,
) -> Vector2<T> {
    let turned = Vector2::new(-vector[1].clone(), vector[0].clone());
    rate + turned * frame_rate.clone()
}

/// [`velocity_in_moving_frame`] in the plane: `v_P = v_O + (ṙ)_xy + Ω × r`.
#[inline]
pub fn velocity_in_moving_plane<T: Ring>(
    origin_velocity: &Vector2<T>,
    rate: &Vector2<T>,
    frame_rate: &T,
    place: &Vector2<T>,
) -> Vector2<T> {
    origin_velocity + transport_in_plane(rate, frame_rate, place)
}
