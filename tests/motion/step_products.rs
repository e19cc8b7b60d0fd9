//! Products of the Jacobian with one vector, and second derivatives of a step.

use super::cases::{self, cases};
use nalgebra::{Matrix3, SVector, Vector3, Vector6};
use num_dual::{Dual64, HyperDual64};
use polhode::motion::{
    Number, Quaternion, Rk4, Scheme, Splitting, State, System, Taylor, Torque, TorqueLaw, jacobian,
};
use proptest::prelude::*;

fn assert_products<S: Scheme<Torque>>(
    scheme: &S,
    case: &cases::Case,
    direction: &SVector<f64, 16>,
    covector: &Vector6<f64>,
) {
    let system = case.system();
    let whole =
        jacobian::by_dual_numbers::<16, _, _>(scheme, &system, case.time, &case.state, case.step);
    let least = case.inertia.symmetric_eigenvalues().min();
    // Rounding times the condition of the tensor, once for the moment and once for its derivative.
    let loss = 1e-14 * (case.inertia.trace() / least).powi(2) * (1.0 + whole.matrix.amax());
    let (state, along) = scheme.jvp(&system, case.time, &case.state, case.step, direction);
    assert!((whole.matrix * direction - along).amax() < loss);
    assert!(whole.state.difference(&state).amax() < loss);
    let (state, back) = scheme.vjp::<16>(&system, case.time, &case.state, case.step, covector);
    assert!((whole.matrix.tr_mul(covector) - back).amax() < loss);
    assert!(whole.state.difference(&state).amax() < loss);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn products_are_those_of_the_matrix(
        case in cases(),
        direction in prop::array::uniform16(-1.0_f64..1.0),
        covector in prop::array::uniform6(-1.0_f64..1.0),
    ) {
        let (direction, covector) = (direction.into(), covector.into());
        assert_products(&Rk4, &case, &direction, &covector);
        assert_products(&Taylor::of_order(8), &case, &direction, &covector);
        let case = cases::tamed(&case);
        assert_products(&Splitting::SECOND, &case, &direction, &covector);
    }
}

/// How far the body has turned from where it should be, after a step from rest at an angular velocity and under a
/// torque that are to be chosen.
fn cost<T: Number>(choice: &[T; 6]) -> T
where
    Torque: TorqueLaw<T>,
{
    let tensor = Matrix3::new(2.0, -0.3, 0.2, -0.3, 2.5, 0.4, 0.2, 0.4, 3.0).map(T::of);
    let [a, b, c, x, y, z] = *choice;
    let system = System::over(
        tensor,
        Torque::Damping { coefficient: 0.4 },
        Vector3::new(x, y, z),
    );
    let start = State::at_rest().turning(Vector3::new(a, b, c));
    let end = Rk4.step(&system, T::zero(), &start, T::of(0.4));
    let goal = Quaternion::new([0.8, 0.2, -0.4, 0.4]).conjugate();
    let goal = Quaternion::new(goal.components().map(T::of));
    let apart = goal * end.attitude;
    apart.v.dot(&apart.v) + end.angular_velocity.dot(&end.angular_velocity)
}

const CHOICE: [f64; 6] = [0.7, -1.1, 0.4, 0.9, -0.2, 1.3];

fn gradient(at: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|k| {
        let seed = |i: usize| Dual64::new(at[i], if i == k { 1.0 } else { 0.0 });
        cost(&std::array::from_fn(seed)).eps
    })
}

/// Hyper-dual numbers through the same step: the Hessian against differences of the gradient, whose error falls
/// as the fourth power of the width after one extrapolation.
#[test]
fn second_derivatives_come_from_hyper_dual_numbers() {
    let on = |a: usize, b: usize| if a == b { 1.0 } else { 0.0 };
    for j in 0..6 {
        for k in 0..6 {
            let seed = |i: usize| HyperDual64::new(CHOICE[i], on(i, j), on(i, k), 0.0);
            let second = cost(&std::array::from_fn(seed)).eps1eps2;
            let mirrored = |i: usize| HyperDual64::new(CHOICE[i], on(i, k), on(i, j), 0.0);
            assert!((cost(&std::array::from_fn(mirrored)).eps1eps2 - second).abs() < 1e-15);
            let difference = |width: f64| {
                let side = |w: f64| {
                    let mut moved = CHOICE;
                    moved[j] += w;
                    gradient(&moved)[k]
                };
                (side(width) - side(-width)) / (2.0 * width)
            };
            let error = |w: f64| ((4.0 * difference(0.5 * w) - difference(w)) / 3.0 - second).abs();
            let (coarse, fine) = (error(0.2), error(0.1));
            assert!(
                fine < coarse / 12.0 || fine < 1e-11,
                "{j}, {k}: {coarse:e} {fine:e}"
            );
        }
    }
}

/// Of implicit steps too: one chord step for each order of derivative at the solution.
#[test]
fn second_derivatives_of_an_implicit_step() {
    use polhode::motion::ImplicitMidpoint;
    let tensor = Matrix3::new(2.0, -0.3, 0.2, -0.3, 2.5, 0.4, 0.2, 0.4, 3.0);
    let end = |x: HyperDual64| {
        let system = System::over(tensor.map(Number::of), Torque::None, Vector3::zeros());
        let start = State::at_rest().turning(Vector3::new(x, Number::of(-0.6), Number::of(1.4)));
        ImplicitMidpoint
            .step(&system, Number::of(0.0), &start, Number::of(0.5))
            .angular_velocity
            .y
    };
    let at = |x: f64| end(HyperDual64::new(x, 1.0, 1.0, 0.0));
    let (exact, w) = (at(1.0), 1e-2);
    let first = |w: f64| (at(1.0 + w).re - at(1.0 - w).re) / (2.0 * w);
    let second = |w: f64| (at(1.0 + w).eps1 - at(1.0 - w).eps1) / (2.0 * w);
    let extrapolated = |f: &dyn Fn(f64) -> f64| (4.0 * f(0.5 * w) - f(w)) / 3.0;
    assert!((extrapolated(&first) - exact.eps1).abs() < 1e-9);
    assert!((extrapolated(&second) - exact.eps1eps2).abs() < 1e-9);
    assert!(exact.eps1eps2.abs() > 1e-3);
}
