//! A body with products of inertia, where it starts, and the brackets that its flow keeps.
#![allow(dead_code, reason = "no test takes all of it")]

use nalgebra::{Matrix3, Matrix6, Vector3};
use polhode::motion::{Quaternion, State};

pub(crate) fn tensor() -> Matrix3<f64> {
    Matrix3::new(2.0, -0.3, 0.2, -0.3, 2.5, 0.4, 0.2, 0.4, 3.0)
}

pub(crate) fn start() -> State<f64> {
    State {
        attitude: Quaternion::exp(&Vector3::new(0.4, 1.0, -0.7)),
        angular_velocity: Vector3::new(1.0, -0.6, 1.4),
    }
}

/// How far the map from [`start`] to `end` with the derivative `tangent` in (θ, ω) is from symplectic. In (θ, m) with
/// θ' m' on the body side, the canonical form is K = [[0, 1], [−1, −[m]×]] inverted: D K⁻¹ Dᵀ = K'⁻¹ with
/// K⁻¹ = [[0, 1], [−1, [m]×]] for m' = {m, H} = m × ω.
pub(crate) fn bracket_defect(
    inertia: &Matrix3<f64>,
    tangent: Matrix6<f64>,
    end: &State<f64>,
) -> f64 {
    let mut d = tangent;
    // ω to m on either side.
    let inverse = inertia.try_inverse().expect("regular");
    let right = d.fixed_columns::<3>(3) * inverse;
    d.fixed_columns_mut::<3>(3).copy_from(&right);
    let below = inertia * d.fixed_rows::<3>(3);
    d.fixed_rows_mut::<3>(3).copy_from(&below);
    let bracket = |state: &State<f64>| {
        let m = inertia * state.angular_velocity;
        let mut k = Matrix6::zeros();
        k.fixed_view_mut::<3, 3>(0, 3)
            .copy_from(&Matrix3::identity());
        k.fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&-Matrix3::identity());
        k.fixed_view_mut::<3, 3>(3, 3).copy_from(&m.cross_matrix());
        k
    };
    (d * bracket(&start()) * d.transpose() - bracket(end)).amax()
}
