//! Bodies side by side move as each would alone.

use super::cases::cases;
use nalgebra::{Matrix3, Vector3};
use polhode::motion::{
    Batch, Dop853, FixedStep, Frame, ImplicitMidpoint, Jacobians, MoserVeselov, MotionError, Rk4,
    Scheme, Splitting, State, Stepper, System, Taylor, Torque, jacobian,
};
use proptest::prelude::*;

fn laws() -> [Torque; 4] {
    let v = Vector3::new(0.3, -0.5, 0.2);
    [
        Torque::None,
        Torque::Damping { coefficient: 0.1 },
        Torque::Gravity {
            weight: 3.0,
            arm: v,
        },
        Torque::Sinusoid {
            frame: Frame::Space,
            amplitude: v,
            angular_frequency: 3.0,
            phase: 0.4,
        },
    ]
}

fn states(count: usize) -> Vec<State<f64>> {
    (0..count)
        .map(|i| {
            let x = i as f64;
            State::new([1.0, 0.1 * x, -0.3, 0.02 * x], [1.0, 0.3 * x, -0.7]).expect("a state")
        })
        .collect()
}

fn tensor() -> Matrix3<f64> {
    Matrix3::new(2.0, -0.3, 0.2, -0.3, 2.5, 0.4, 0.2, 0.4, 3.0)
}

/// Twenty steps of each body in a batch and alone.
fn assert_as_alone<S: Scheme<Torque> + Sync>(scheme: &S, inertia: Matrix3<f64>, law: Torque) {
    let states = states(11);
    let mut batch = Batch::sharing(inertia, states.iter().copied()).expect("a body");
    batch.advance(scheme, law, 0.02, 20).expect("finite");
    let system = System::new(inertia, law).expect("a body");
    for (start, end) in states.iter().zip(batch.states()) {
        let mut alone = *start;
        for n in 0..20 {
            alone = scheme.step(&system, 0.02 * f64::from(n), &alone, 0.02);
        }
        assert_eq!(alone, end, "{law:?}");
    }
}

#[test]
fn every_step_is_the_same_to_the_bit() {
    for law in laws() {
        for inertia in [
            tensor(),
            Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0)),
        ] {
            assert_as_alone(&Rk4, inertia, law);
            assert_as_alone(&Dop853, inertia, law);
            assert_as_alone(&Splitting::FOURTH, inertia, law);
            assert_as_alone(&Taylor::of_order(8), inertia, law);
            assert_as_alone(&ImplicitMidpoint, inertia, law);
            assert_as_alone(&MoserVeselov::FOURTH, inertia, law);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(30) })]

    #[test]
    fn bodies_of_their_own_tensors_and_their_jacobians_are_as_alone(
        members in prop::collection::vec(cases(), 1..20),
    ) {
        let law = members[0].torque;
        let bodies = members.iter().map(|c| (c.inertia, c.state));
        let mut batch = Batch::of_bodies(bodies).expect("bodies");
        let mut all = Jacobians::<15>::new();
        batch.step_with_jacobian(&Rk4, law, 0.05, &mut all).expect("finite");
        for (i, case) in members.iter().enumerate() {
            let system = System::over(case.inertia, law, Vector3::zeros());
            let alone = Rk4.step_with_jacobian::<15>(&system, 0.0, &case.state, 0.05);
            let found = all.of_body(i).expect("a body");
            // Alone, a body along its principal axes has shorter sums than beside others that are not.
            if case.inertia == Matrix3::from_diagonal(&case.inertia.diagonal()) {
                prop_assert!((found - alone.matrix).amax() < 1e-13 * (1.0 + alone.matrix.amax()));
                continue;
            }
            prop_assert_eq!(batch.state(i), Some(alone.state));
            prop_assert_eq!(found, alone.matrix);
        }
        prop_assert!(batch.state(members.len()).is_none());
        prop_assert!(all.of_body(members.len()).is_none());
    }
}

#[test]
fn other_schemes_have_jacobians_in_a_batch_too() {
    let states = states(9);
    for law in laws() {
        let system = System::new(tensor(), law).expect("a body");
        let mut batch = Batch::sharing(tensor(), states.iter().copied()).expect("a body");
        let mut all = Jacobians::<15>::new();
        batch
            .step_with_jacobian(&Splitting::SECOND, law, 0.1, &mut all)
            .expect("finite");
        for (i, start) in states.iter().enumerate() {
            let alone =
                jacobian::by_dual_numbers::<15, _, _>(&Splitting::SECOND, &system, 0.0, start, 0.1);
            let apart = all.of_body(i).expect("a body") - alone.matrix;
            assert!(apart.amax() < 1e-13);
        }
    }
}

/// With the feature `parallel` more blocks than one thread takes at a time.
#[test]
fn many_bodies_are_as_alone_on_all_threads() {
    // The fastest of them turns by a third of a radian.
    const STEP: f64 = 5e-4;
    let law = Torque::Damping { coefficient: 0.1 };
    let (system, states) = (System::new(tensor(), law).expect("a body"), states(2_003));
    let mut batch = Batch::sharing(tensor(), states.iter().copied()).expect("a body");
    let mut all = Jacobians::<15>::new();
    batch
        .step_with_jacobian(&Rk4, law, STEP, &mut all)
        .expect("finite");
    batch.advance(&Rk4, law, STEP, 5).expect("finite");
    for (i, start) in states.iter().enumerate() {
        let first = Rk4.step_with_jacobian::<15>(&system, 0.0, start, STEP);
        assert_eq!(all.of_body(i), Some(first.matrix));
        let mut alone = first.state;
        for n in 1..6 {
            alone = Rk4.step(&system, STEP * f64::from(n), &alone, STEP);
        }
        assert_eq!(batch.state(i), Some(alone), "{i}");
    }
}

#[test]
fn a_body_takes_little_memory() {
    let block = size_of::<polhode::motion::Block>();
    let tensors = 6 * size_of::<polhode::motion::Lane>();
    assert!(block + tensors <= 300 * polhode::motion::LANES);
}

#[test]
fn any_count_of_bodies_is_a_batch() {
    for count in [0, 1, 7, 8, 9] {
        let mut batch = Batch::sharing(tensor(), states(count)).expect("a body");
        batch.advance(&Rk4, Torque::None, 0.1, 3).expect("finite");
        assert_eq!(batch.states().count(), count);
        assert_eq!((batch.len(), batch.is_empty()), (count, count == 0));
        assert!((batch.time() - 0.3).abs() < 1e-15);
    }
}

/// A torque that stops being a number.
fn broken(
    when: fn(f64, &State<f64>) -> bool,
) -> impl Fn(f64, &State<f64>) -> Vector3<f64> + Copy + Send + Sync {
    move |time, state| {
        let late = when(time, state);
        Vector3::new(if late { f64::NAN } else { 0.0 }, 0.0, 0.0)
    }
}

#[test]
fn the_body_that_stops_being_finite_is_named() {
    // Not a number from t = 0.2 on, for bodies that spin fast about y.
    let law = broken(|time, state| time > 0.21 && state.angular_velocity.y.abs() > 1.4);
    let mut batch = Batch::sharing(Matrix3::identity(), states(20)).expect("a body");
    batch.advance(&Rk4, law, 0.1, 2).expect("finite so far");
    let mut longer = batch.clone();
    let error = batch.advance(&Rk4, law, 0.1, 1).expect_err("a NaN");
    let MotionError::BodyDiverged { body: 5, time } = error else {
        panic!("{error}");
    };
    assert!((time - 0.2).abs() < 1e-15);
    assert!(error.to_string().contains("body 5: the torque"));
    // Of many steps the one that failed, and of many bodies the one that failed first.
    let law = broken(|time, state| time + state.angular_velocity.y > 6.04);
    let mut steady = Batch::sharing(Matrix3::identity(), states(20)).expect("a body");
    let error = steady.advance(&Rk4, law, 0.0625, 100).expect_err("NaN");
    let MotionError::BodyDiverged { body: 19, time } = error else {
        panic!("{error}");
    };
    // 0.3 · 19 = 5.7, and the step from 0.3125 reaches past 0.34.
    assert!((time - 0.3125).abs() < 1e-15);
    assert!(longer.advance(&Rk4, Torque::None, 0.1, 3).is_ok());
}

#[test]
fn bodies_and_steps_that_cannot_be_are_told() {
    let mut lopsided = tensor();
    lopsided[(0, 2)] = 0.3;
    let error = Batch::sharing(lopsided, states(1)).expect_err("no body");
    assert!(error.to_string().contains("entries xz = 0.3 and zx = 0.2"));
    let members = [tensor(), -tensor()].map(|tensor| (tensor, State::at_rest()));
    let error = Batch::of_bodies(members).expect_err("no body");
    assert!(
        error
            .to_string()
            .starts_with("body 1: the principal moment"),
        "{error}"
    );
    let mut batch = Batch::sharing(tensor(), states(3)).expect("a body");
    let mut all = Jacobians::<15>::new();
    for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        for result in [
            batch.advance(&Rk4, Torque::None, step, 2),
            batch.step_with_jacobian(&Rk4, Torque::None, step, &mut all),
        ] {
            assert!(matches!(result, Err(MotionError::Step { .. })), "{step}");
        }
    }
    assert!(batch.time().abs() < f64::MIN_POSITIVE);
    assert_eq!(batch.state(2), states(3).last().copied());
}

#[test]
fn bodies_of_their_own_tensors_move_as_alone_to_the_bit() {
    let law = Torque::Damping { coefficient: 0.1 };
    let turned = |i: usize| tensor() * (1.0 + 0.125 * i as f64);
    let diagonal = |i: usize| Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0 + 0.1 * i as f64));
    let kinds: [&dyn Fn(usize) -> Matrix3<f64>; 2] = [&turned, &diagonal];
    for tensor_of in kinds {
        let bodies: Vec<_> = (states(11).into_iter().enumerate())
            .map(|(i, state)| (tensor_of(i), state))
            .collect();
        let mut batch = Batch::of_bodies(bodies.iter().copied()).expect("bodies");
        batch.advance(&Rk4, law, 0.02, 20).expect("finite");
        for ((tensor, start), end) in bodies.iter().zip(batch.states()) {
            let system = System::new(*tensor, law).expect("a body");
            let mut alone = *start;
            for n in 0..20 {
                alone = Rk4.step(&system, 0.02 * f64::from(n), &alone, 0.02);
            }
            assert_eq!(alone, end);
        }
    }
}

#[test]
fn a_batch_moves_as_a_run_of_fixed_steps() {
    let law = laws()[2];
    let mut batch = Batch::sharing(tensor(), states(3)).expect("a body");
    batch.advance(&Rk4, law, 0.0625, 16).expect("finite");
    let system = System::new(tensor(), law).expect("a body");
    let mut run = FixedStep::new(Rk4, system, states(3)[2], 0.0625).expect("a step");
    run.advance_to(1.0).expect("finite");
    assert_eq!(batch.state(2).as_ref(), Some(run.state()));
}
