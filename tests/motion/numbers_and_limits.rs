//! Motion in single precision, and input that is no motion.

use nalgebra::{Matrix3, Vector3};
use polhode::motion::{
    Body, Dop853, FixedStep, ImplicitMidpoint, MoserVeselov, MotionError, Number, Quaternion, Rk4,
    Scheme, Splitting, State, Stepper, System, Taylor, Torque, TorqueLaw,
};

const TENSOR: Matrix3<f64> = Matrix3::new(2.0, -0.3, 0.2, -0.3, 2.5, 0.4, 0.2, 0.4, 3.0);

const TOP: Torque = Torque::Gravity {
    weight: 3.0,
    arm: Vector3::new(0.1, -0.2, 0.5),
};

/// Twenty steps over any number.
fn run<T: Number, S: Scheme<Torque>>(scheme: &S) -> State<T>
where
    Torque: TorqueLaw<T>,
{
    let system = System::over(TENSOR.map(T::of), TOP, Vector3::from_element(T::zero()));
    let omega = Vector3::new(1.0, -0.6, 1.4).map(T::of);
    let step = T::of(0.0625);
    (0..20).fold(State::at_rest().turning(omega), |state, n| {
        scheme.step(&system, T::of(0.0625 * f64::from(n)), &state, step)
    })
}

#[track_caller]
fn assert_single<S: Scheme<Torque>>(scheme: &S) {
    let (single, double) = (run::<f32, S>(scheme), run::<f64, S>(scheme));
    let single = State {
        attitude: Quaternion::new(single.attitude.components().map(f64::from)),
        angular_velocity: single.angular_velocity.map(f64::from),
    };
    // Some tens of roundings of 6e-8 a step on numbers near one, walking at random over twenty steps.
    let apart = single.difference(&double).amax();
    assert!(apart < 3e-5, "{apart:e}");
}

#[test]
fn every_step_runs_in_single_precision_to_its_rounding() {
    assert_single(&Rk4);
    assert_single(&Dop853);
    assert_single(&Taylor::of_order(8));
    assert_single(&Splitting::SECOND);
    assert_single(&Splitting::SIXTH);
    assert_single(&ImplicitMidpoint);
    assert_single(&MoserVeselov::FOURTH);
}

#[test]
fn a_tensor_of_no_body_is_told_by_number_and_rule() {
    let diagonal = |x, y, z| Matrix3::from_diagonal(&Vector3::new(x, y, z));
    let mut lopsided = TENSOR;
    lopsided[(0, 1)] = 0.7;
    for (tensor, told) in [
        (diagonal(1.0, 2.0, 3.5), "exceeds the sum"),
        (diagonal(-1.0, 2.0, 2.0), "negative"),
        (diagonal(0.0, 2.0, 2.0), "zero"),
        (diagonal(f64::NAN, 2.0, 2.0), "finite"),
        (diagonal(f64::INFINITY, 2.0, 2.0), "finite"),
        (lopsided, "not symmetric"),
    ] {
        let error = Body::new(&tensor).expect_err("no body");
        assert!(error.to_string().contains(told), "{error}");
        assert!(System::new(tensor, Torque::None).is_err());
    }
    // A plate is a body.
    assert!(Body::new(&diagonal(1.0, 2.0, 3.0)).is_ok());
}

#[test]
fn a_state_or_a_step_that_cannot_be_is_told() {
    assert_eq!(
        State::new([0.0; 4], [0.0; 3]),
        Err(MotionError::ZeroAttitude)
    );
    assert!(State::new([1.0, 0.0, 0.0, f64::NAN], [0.0; 3]).is_err());
    assert!(State::new([1.0, 0.0, 0.0, 0.0], [f64::INFINITY, 0.0, 0.0]).is_err());
    assert!(State::new([1e-200, 0.0, 0.0, 1e-200], [0.0; 3]).is_ok());
    let system = System::new(TENSOR, TOP).expect("a body");
    for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let error = FixedStep::new(Rk4, system, State::at_rest(), step).err();
        assert!(matches!(error, Some(MotionError::Step { .. })));
    }
    let mut run = FixedStep::new(Rk4, system, State::at_rest(), 1e-9).expect("a step");
    for time in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            run.advance_to(time),
            Err(MotionError::Time { .. })
        ));
    }
    // More steps than anyone waits for are refused before the first.
    assert!(matches!(
        run.advance_to(1e9),
        Err(MotionError::TooManySteps { .. })
    ));
}

#[test]
fn a_torque_that_is_no_number_stops_the_run_with_the_time() {
    let broken = |time: f64, _: &State<f64>| {
        let x = if time < 0.95 { 0.1 } else { f64::NAN };
        Vector3::new(x, 0.0, 0.0)
    };
    let system = System::new(TENSOR, broken).expect("a body");
    let mut run = FixedStep::new(Rk4, system, State::at_rest(), 0.125).expect("a step");
    match run.advance_to(2.0) {
        Err(MotionError::Diverged { time }) => assert!((time - 0.875).abs() < 1e-12, "{time}"),
        other => panic!("{other:?}"),
    }
    assert!(run.state().is_finite());
}

fn assert_ends<S: Scheme<Torque>>(scheme: S, step: f64) {
    let fast = State::at_rest().turning(Vector3::new(300.0, -200.0, 100.0));
    let system = System::new(TENSOR, Torque::None).expect("a body");
    let mut run = FixedStep::new(scheme, system, fast, step).expect("a step");
    match run.step(step) {
        Ok(()) => assert!(run.state().is_finite()),
        Err(error) => assert!(matches!(error, MotionError::Diverged { .. })),
    }
}

/// A step that turns the body by many radians is useless, and still ends: with a state, or with an error.
#[test]
fn steps_far_too_long_end() {
    for step in [1.0, 1e10, 1e300] {
        assert_ends(ImplicitMidpoint, step);
        assert_ends(MoserVeselov::FOURTH, step);
        assert_ends(Splitting::SIXTH, step);
        assert_ends(Dop853, step);
    }
}
