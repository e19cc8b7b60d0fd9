//! Quaternions, their logarithms, and the derivatives of both.

use nalgebra::{Matrix3, Vector3};
use polhode::motion::{Quaternion, right_jacobian, right_jacobian_inverse};
use proptest::prelude::*;

proptest! {
    #[test]
    fn the_logarithm_undoes_the_exponential(theta in prop::array::uniform3(-1.7_f64..1.7)) {
        let theta = Vector3::from(theta);
        // |θ| < π; the rounding of a few operations on numbers up to π.
        prop_assert!((Quaternion::exp(&theta).log() - theta).norm() < 4e-15);
        let small = theta * 1e-12;
        prop_assert!((Quaternion::exp(&small).log() - small).norm() < 1e-27);
    }

    #[test]
    fn the_product_composes_rotations(a in prop::array::uniform3(-3.0_f64..3.0), b in prop::array::uniform3(-3.0_f64..3.0)) {
        let (a, b) = (Quaternion::exp(&a.into()), Quaternion::exp(&b.into()));
        prop_assert!(((a * b).matrix() - a.matrix() * b.matrix()).norm() < 1e-14);
        let back = Quaternion::of_matrix(&(a * b).matrix());
        prop_assert!((back.conjugate() * a * b).log().norm() < 1e-14);
        prop_assert!((a.matrix().transpose() - a.conjugate().matrix()).norm() < 1e-14);
    }
}

proptest! {
    #[test]
    fn both_are_derivatives_and_inverses(theta in prop::array::uniform3(-1.7_f64..1.7), power in -12_i32..1) {
        let theta = Vector3::from(theta) * 10.0_f64.powi(power);
        let (forth, back) = (right_jacobian(&theta), right_jacobian_inverse(&theta));
        prop_assert!((forth * back - Matrix3::identity()).norm() < 1e-14);
        let difference = |k: usize| {
            let moved = |h: f64| {
                let delta = Vector3::ith(k, h);
                (Quaternion::exp(&theta).conjugate() * Quaternion::exp(&(theta + delta))).log()
            };
            (moved(1e-5) - moved(-1e-5)) / 2e-5
        };
        for k in 0..3 {
            prop_assert!((difference(k) - forth.column(k)).norm() < 1e-9);
        }
    }

    /// The series and the closed form meet at one radian.
    #[test]
    fn no_seam(axis in prop::array::uniform3(-1.0_f64..1.0)) {
        let axis = Vector3::from(axis).normalize();
        let at = |angle: f64| (right_jacobian(&(axis * angle)), right_jacobian_inverse(&(axis * angle)));
        let (below, above) = (at(1.0 - 1e-15), at(1.0 + 1e-15));
        prop_assert!((below.0 - above.0).norm() < 1e-14 && (below.1 - above.1).norm() < 1e-14);
    }
}
