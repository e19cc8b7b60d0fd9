//! How the attitude of a body turns with its angular velocity, as a matrix and as a quaternion.
//!
//! Quaternions are columns `[w, x, y, z]`, scalar first, and take body components to space components.

use crate::mechanics::{product, skew};
use crate::scalar::{Field, Ring};
use nalgebra::{Matrix3, Vector3, Vector4};

/// The rate of the attitude matrix, `Ṙ = R [ω]×`, in rad/s, for ω along the body axes and R from body to space.
#[inline]
pub fn attitude_rate<T: Ring>(attitude: &Matrix3<T>, omega: &Vector3<T>) -> Matrix3<T> {
    product(attitude, &skew(omega))
}

/// Hamilton's product `p q`, `[w, x, y, z]`: `p q` turns first by q, then by p.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn quaternion_product<T: Ring>(p: &Vector4<T>, q: &Vector4<T>) -> Vector4<T> {
    let term = |i: usize, j: usize| p[i].clone() * q[j].clone();
    Vector4::new(
        term(0, 0) - term(1, 1) - term(2, 2) - term(3, 3),
        term(0, 1) + term(1, 0) + term(2, 3) - term(3, 2),
        term(0, 2) - term(1, 3) + term(2, 0) + term(3, 1),
        term(0, 3) + term(1, 2) - term(2, 1) + term(3, 0),
    )
}

/// The conjugate `[w, −x, −y, −z]`, the inverse of a unit quaternion.
#[inline]
pub fn quaternion_conjugate<T: Ring>(q: &Vector4<T>) -> Vector4<T> {
    Vector4::from_fn(|i, _| if i == 0 { q[0].clone() } else { -q[i].clone() })
}

/// The rate of the attitude quaternion, `q̇ = ½ q ω` with ω along the body axes as the quaternion `[0, ω]`.
#[inline]
pub fn quaternion_rate<T: Field>(q: &Vector4<T>, omega: &Vector3<T>) -> Vector4<T> {
    let pure = omega.clone().insert_row(0, T::zero());
    quaternion_product(q, &pure).map(|r| r * T::ratio(1, 2))
}

/// The matrix of `v ↦ q v q*`: the rotation matrix times |q|², so that no division is needed.
///
/// It is a rotation for a unit quaternion. Over an exact field, divide by |q|² to have exact rotations.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn rotation<T: Ring>(q: &Vector4<T>) -> Matrix3<T> {
    let square = |i: usize| q[i].clone() * q[i].clone();
    let twice = |i: usize, j: usize| {
        let term = q[i].clone() * q[j].clone();
        term.clone() + term
    };
    Matrix3::new(
        square(0) + square(1) - square(2) - square(3),
        twice(1, 2) - twice(0, 3),
        twice(1, 3) + twice(0, 2),
        twice(1, 2) + twice(0, 3),
        square(0) - square(1) + square(2) - square(3),
        twice(2, 3) - twice(0, 1),
        twice(1, 3) - twice(0, 2),
        twice(2, 3) + twice(0, 1),
        square(0) - square(1) - square(2) + square(3),
    )
}
