//! The Jacobian of a step against differences of the step itself.

use super::cases::{Case, cases, tamed};
use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};
use polhode::motion::{
    Dop853, Frame, ImplicitMidpoint, MoserVeselov, Quaternion, Rk4, Scheme, Splitting, State,
    System, Taylor, Torque, TorqueLaw, jacobian,
};
use proptest::prelude::*;

/// The step with its inputs moved by `amount` along column `column`.
fn moved<S: Scheme<Torque>>(scheme: &S, case: &Case, column: usize, amount: f64) -> State<f64> {
    let (mut inertia, mut added, mut step) = (case.inertia, Vector3::zeros(), case.step);
    let mut tangent = Vector6::zeros();
    match column {
        0..6 => tangent[column] = amount,
        6..9 => added[column - 6] = amount,
        9..12 => inertia[(column - 9, column - 9)] += amount,
        12..15 => {
            let (r, c) = [(0, 1), (0, 2), (1, 2)][column - 12];
            inertia[(r, c)] += amount;
            inertia[(c, r)] += amount;
        }
        _ => step += amount,
    }
    let system = System::over(inertia, case.torque, added);
    scheme.step(&system, case.time, &case.state.perturbed(&tangent), step)
}

/// The central difference of one column over ±`width`.
fn difference<S: Scheme<Torque>>(
    scheme: &S,
    case: &Case,
    column: usize,
    width: f64,
) -> Vector6<f64> {
    let base = moved(scheme, case, column, 0.0);
    let side = |amount| base.difference(&moved(scheme, case, column, amount));
    (side(width) - side(-width)) / (2.0 * width)
}

/// One extrapolation of the central difference leaves an error of fourth order in the width: halving the
/// width has to divide what is left by about 16, unless rounding (a few 1e-16 over the width) is reached.
fn assert_matches<S: Scheme<Torque>>(scheme: &S, case: &Case, exact: &SMatrix<f64, 6, 16>) {
    let least = case.inertia.symmetric_eigenvalues().min();
    let end = moved(scheme, case, 0, 0.0).angular_velocity;
    let speed = 1.0 + end.amax() + case.state.angular_velocity.amax();
    for column in 0..16 {
        let exact = exact.column(column);
        // Torque and inertia act over the smallest moment.
        let width = match column {
            6..15 => 4e-3 * least,
            15 => 4e-3_f64.min(0.1 * case.step),
            _ => 4e-3,
        };
        let [coarse, middle, fine] =
            [1.0, 0.5, 0.25].map(|w| difference(scheme, case, column, w * width));
        let first = ((middle * 4.0 - coarse) / 3.0 - exact).amax();
        let second = ((fine * 4.0 - middle) / 3.0 - exact).amax();
        let scale = 1.0 + exact.amax();
        // A double times the condition of the tensor, which the inverse and the gyroscopic term cost.
        let loss = 1e-15 * case.inertia.trace() / least;
        let rounding = loss * speed / (0.25 * width);
        assert!(
            second < first / 8.0 || second < 2.0 * rounding + 1e-13 * scale,
            "column {column}, fourth order: {first:e} then {second:e}, rounding {rounding:e}"
        );
        assert!(
            second < 1e-4 * scale + rounding,
            "column {column}: {second:e} of {scale:e}"
        );
    }
}

fn match_differences<S: Scheme<Torque>>(scheme: &S, case: &Case) {
    let step = scheme.step_with_jacobian::<16>(&case.system(), case.time, &case.state, case.step);
    assert_matches(scheme, case, &step.matrix);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(40) })]

    #[test]
    fn the_step_of_every_other_method_matches_differences(case in cases()) {
        let case = tamed(&case);
        match_differences(&Dop853, &case);
        match_differences(&Taylor::of_order(9), &case);
        match_differences(&Splitting::FOURTH, &case);
        match_differences(&ImplicitMidpoint, &case);
        match_differences(&MoserVeselov::SECOND, &case);
        match_differences(&MoserVeselov::FOURTH, &case);
        match_differences(&MoserVeselov::EIGHTH, &case);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn the_dual_step_of_runge_kutta_matches_differences(case in cases()) {
        let step = jacobian::by_dual_numbers::<16, _, _>(
            &Rk4, &case.system(), case.time, &case.state, case.step);
        assert_matches(&Rk4, &case, &step.matrix);
    }

    #[test]
    fn the_fast_step_of_runge_kutta_is_the_dual_one_to_rounding(case in cases()) {
        let system = case.system();
        let fast = Rk4.step_with_jacobian::<16>(&system, case.time, &case.state, case.step);
        let dual = jacobian::by_dual_numbers::<16, _, _>(&Rk4, &system, case.time, &case.state, case.step);
        let least = case.inertia.symmetric_eigenvalues().min();
        // Rounding times the condition of the tensor, once for the moment and once for its derivative.
        let loss = 1e-14 * (case.inertia.trace() / least).powi(2);
        for column in 0..16 {
            let scale = 1.0 + dual.matrix.column(column).amax();
            let apart = (fast.matrix.column(column) - dual.matrix.column(column)).amax();
            prop_assert!(apart < loss * scale, "column {}: {:e} of {:e}", column, apart, scale);
        }
        let speed = 1.0 + dual.state.angular_velocity.norm();
        prop_assert!(fast.state.difference(&dual.state).norm() < loss * speed);
    }

    #[test]
    fn fewer_columns_are_the_same_columns(case in cases()) {
        let system = case.system();
        let all = Rk4.step_with_jacobian::<16>(&system, case.time, &case.state, case.step);
        let most = Rk4.step_with_jacobian::<15>(&system, case.time, &case.state, case.step);
        let some = Rk4.step_with_jacobian::<9>(&system, case.time, &case.state, case.step);
        let state = Rk4.step_with_jacobian::<6>(&system, case.time, &case.state, case.step);
        prop_assert_eq!(all.matrix.fixed_columns::<15>(0).into_owned(), most.matrix);
        prop_assert_eq!(all.matrix.fixed_columns::<9>(0).into_owned(), some.matrix);
        prop_assert_eq!(all.matrix.fixed_columns::<6>(0).into_owned(), state.matrix);
        prop_assert_eq!(all.state, state.state);
    }
}

#[test]
fn a_step_of_no_length_has_derivatives() {
    let state = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
    let slanted = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
    for inertia in [slanted, Matrix3::from_diagonal(&slanted.diagonal())] {
        let law = Torque::Damping { coefficient: 0.1 };
        let system = System::new(inertia, law).expect("a body");
        let fast = Rk4.step_with_jacobian::<16>(&system, 0.0, &state, 0.0);
        let dual = jacobian::by_dual_numbers::<16, _, _>(&Rk4, &system, 0.0, &state, 0.0);
        assert!((fast.matrix - dual.matrix).amax() < 1e-14);
        assert!(fast.state.difference(&state).amax() < 1e-15);
    }
}

#[test]
fn the_added_torque_of_a_law_in_space_axes_is_its_own_value() {
    let value = Vector3::new(0.3, -0.2, 0.9);
    let state = State {
        attitude: Quaternion::exp(&Vector3::new(0.3, 1.0, -2.0)),
        angular_velocity: Vector3::new(1.0, 2.0, 3.0),
    };
    let law = Torque::Constant {
        frame: Frame::Space,
        value,
    };
    let none = Torque::Constant {
        frame: Frame::Space,
        value: Vector3::zeros(),
    };
    let inertia = Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0));
    let by_law = System::over(inertia, law, Vector3::zeros()).torque(0.0, &state);
    let by_addition = System::over(inertia, none, value).torque(0.0, &state);
    assert!((by_law - by_addition).norm() < 1e-15);
    assert_eq!(TorqueLaw::<f64>::added_in(&law), Frame::Space);
}
