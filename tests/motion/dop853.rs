//! DOP853 against thirty-digit series: its order, its tolerance, its dense output, and what stops it.

use super::double_double::heavy_top;
use nalgebra::{Matrix3, Vector3};
use polhode::motion::{
    Body, Dop853, Dop853Motion, FixedStep, Frame, MotionError, Quaternion, State, Stepper, System,
    Taylor, TaylorMotion, Torque,
};

const MOMENTS: [f64; 3] = [0.6, 0.8, 1.0];
const OMEGA: [f64; 3] = [1.0, -2.0, 8.0];
const ARM: [f64; 3] = [0.1, -0.2, 1.0];

fn exact_top(time: f64) -> State<f64> {
    let start = [OMEGA[0], OMEGA[1], OMEGA[2], 1.0, 0.0, 0.0, 0.0];
    let exact = heavy_top(MOMENTS, start, ARM, time, (time * 100.0).ceil() as u32);
    State::new(
        [3, 4, 5, 6].map(|i| exact[i].value()),
        [0, 1, 2].map(|i| exact[i].value()),
    )
    .expect("a state")
}

fn top() -> (System<f64, Torque>, State<f64>) {
    let law = Torque::Gravity {
        weight: 1.0,
        arm: ARM.into(),
    };
    let system = System::new(Matrix3::from_diagonal(&MOMENTS.into()), law).expect("a body");
    (system, State::at_rest().turning(OMEGA.into()))
}

fn apart(a: &State<f64>, b: &State<f64>) -> f64 {
    let apart = a.difference(b);
    apart.rows(0, 3).norm().max(apart.rows(3, 3).norm() / 8.0)
}

#[test]
fn the_step_is_of_order_eight() {
    let (system, start) = top();
    let exact = exact_top(2.0);
    let error = |h: f64| {
        let mut run = FixedStep::new(Dop853, system, start, h).expect("a step");
        run.advance_to(2.0).expect("finite");
        apart(run.state(), &exact)
    };
    let order = (error(0.1) / error(0.05)).log2();
    assert!((7.5..9.0).contains(&order), "{order}");
}

#[test]
fn the_tolerance_bounds_the_error_of_the_step_and_so_the_whole() {
    let (system, start) = top();
    let exact = exact_top(10.0);
    for tolerance in [1e-4, 1e-7, 1e-10, 1e-13] {
        let mut motion = Dop853Motion::new(system, &start, tolerance).expect("a tolerance");
        motion.advance_to(10.0).expect("finite");
        let found = apart(motion.state(), &exact);
        // Errors of the steps add up over a hundred radians, and an error of ω turns into one of the attitude.
        assert!(
            found < 300.0 * tolerance + 1e-13,
            "{found:e} at {tolerance:e}"
        );
        assert!(motion.rejected() < motion.steps() / 3 + 3);
    }
}

#[test]
fn output_between_steps_is_as_good_as_at_their_ends() {
    let (system, start) = top();
    let mut motion = Dop853Motion::new(system, &start, 1e-9).expect("a tolerance");
    let mut worst = 0.0_f64;
    for i in 1..=40 {
        let time = 0.05 * f64::from(i);
        motion.advance_to(time).expect("finite");
        worst = worst.max(apart(motion.state(), &exact_top(time)));
        let same = motion.at(time).expect("in the last step");
        assert_eq!(&same, motion.state());
    }
    assert!(worst < 1e-7, "{worst:e}");
}

#[test]
fn the_times_asked_for_do_not_change_the_motion() {
    let (system, start) = top();
    let mut once = Dop853Motion::new(system, &start, 1e-8).expect("a tolerance");
    let mut often = once.clone();
    once.advance_to(3.0).expect("finite");
    for i in 1..=300 {
        often.advance_to(0.01 * f64::from(i)).expect("finite");
    }
    assert_eq!(once.steps(), often.steps());
    assert!(apart(once.state(), often.state()) < 1e-14);
}

#[test]
fn every_law_moves_as_by_its_series() {
    let v = Vector3::new(0.3, -0.5, 0.2);
    let tensor = Matrix3::new(2.0, -0.3, 0.2, -0.3, 2.5, 0.4, 0.2, 0.4, 3.0);
    let start = State {
        attitude: Quaternion::exp(&v),
        angular_velocity: Vector3::new(1.0, -0.6, 1.4),
    };
    let sinusoid = |frame| Torque::Sinusoid {
        frame,
        amplitude: v,
        angular_frequency: 3.0,
        phase: 0.4,
    };
    let body = Body::new(&tensor).expect("a body");
    for law in [
        Torque::None,
        Torque::Damping { coefficient: 0.1 },
        Torque::Constant {
            frame: Frame::Space,
            value: v,
        },
        sinusoid(Frame::Body),
        sinusoid(Frame::Space),
    ] {
        let mut series = TaylorMotion::new(&body, law, &start, 1e-16).expect("a tolerance");
        series.advance_to(5.0).expect("finite");
        let system = System::new(tensor, law).expect("a body");
        let mut motion = Dop853Motion::new(system, &start, 1e-13).expect("a tolerance");
        motion.advance_to(5.0).expect("finite");
        assert!(apart(series.state(), motion.state()) < 1e-11, "{law:?}");
        let mut along = Dop853Motion::new(
            System::principal(&body, law),
            &body.state_along(&start),
            1e-13,
        )
        .expect("a tolerance");
        along.advance_to(5.0).expect("finite");
        assert!(apart(series.state(), &body.state_from(along.state())) < 1e-11);
    }
}

/// Along principal axes the moment differences are formed first: the gyroscopic term of a needle is exact.
#[test]
fn a_needle_keeps_its_digits_along_principal_axes() {
    let body = Body::new(&Matrix3::from_diagonal(&Vector3::new(
        1e-6,
        1.0,
        1.0 + 5e-7,
    )));
    let body = body.expect("a needle");
    let start = State::at_rest().turning(Vector3::new(2.0, 1.0, -0.5));
    let system = System::principal(&body, Torque::None);
    let mut motion = Dop853Motion::new(system, &start, 1e-14).expect("a tolerance");
    motion.advance_to(5.0).expect("finite");
    let run = Taylor::of_order(30);
    let mut series = FixedStep::new(run, system, start, 0.1).expect("a step");
    series.advance_to(5.0).expect("finite");
    assert!(apart(motion.state(), series.state()) < 2e-13);
}

#[test]
fn rest_lasts_and_a_torque_that_sets_in_is_seen() {
    let (system, _) = top();
    let still = System::new(*system.inertia(), Torque::None).expect("a body");
    let mut rest = Dop853Motion::new(still, &State::at_rest(), 1e-9).expect("a tolerance");
    rest.advance_to(1e9).expect("rest lasts");
    assert_eq!(rest.state(), &State::at_rest());
    let pulse = |time: f64, _: &State<f64>| {
        let on = if (3.0..3.5).contains(&time) { 1.0 } else { 0.0 };
        Vector3::new(0.0, 0.0, on)
    };
    let system = System::new(*system.inertia(), pulse).expect("a body");
    let mut motion = Dop853Motion::new(system, &State::at_rest(), 1e-9)
        .and_then(|m| m.with_longest_step(0.1))
        .expect("a motion");
    motion.advance_to(10.0).expect("finite");
    assert!((motion.state().angular_velocity.z - 0.5).abs() < 1e-7);
}

#[test]
fn what_cannot_be_is_an_error() {
    let (system, start) = top();
    for tolerance in [0.0, -1.0, f64::NAN, 1e-20, 1.0] {
        assert!(Dop853Motion::new(system, &start, tolerance).is_err());
    }
    let mut motion = Dop853Motion::new(system, &start, 1e-9).expect("a motion");
    for time in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(motion.advance_to(time).is_err());
    }
    assert!(motion.step(0.0).is_err());
    assert!(motion.at(1.0).is_err());
    assert!(motion.clone().with_longest_step(f64::NAN).is_err());
    let broken = |time: f64, _: &State<f64>| {
        let x = if time < 1.0 { 0.1 } else { f64::NAN };
        Vector3::new(x, 0.0, 0.0)
    };
    let system = System::new(*system.inertia(), broken).expect("a body");
    let mut motion = Dop853Motion::new(system, &start, 1e-9).expect("a motion");
    motion.advance_to(0.5).expect("finite so far");
    let before = *motion.state();
    match motion.advance_to(2.0) {
        Err(MotionError::Diverged { time }) => assert!((0.99..=1.0).contains(&time), "{time}"),
        other => panic!("{other:?}"),
    }
    assert_eq!(motion.state(), &before);
    assert!((motion.time() - 0.5).abs() < f64::EPSILON);
}

/// ω' = ω² reaches infinity at t = 1.
#[test]
fn a_motion_that_runs_away_ends_with_the_time() {
    let faster = |_: f64, s: &State<f64>| s.angular_velocity * s.angular_velocity.norm();
    let system = System::new(Matrix3::identity(), faster).expect("a body");
    let start = State::at_rest().turning(Vector3::new(0.0, 1.0, 0.0));
    let mut motion = Dop853Motion::new(system, &start, 1e-9).expect("a motion");
    match motion.advance_to(2.0) {
        Err(MotionError::Diverged { time }) => assert!((time - 1.0).abs() < 1e-6, "{time}"),
        other => panic!("{other:?}"),
    }
    assert!(motion.steps() < 1000);
}
