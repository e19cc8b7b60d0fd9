//! Taylor motion against thirty-digit series, and its step against Runge–Kutta.

use super::double_double::heavy_top;
use super::turning::{start, tensor};
use nalgebra::{Matrix3, Vector3};
use polhode::motion::{
    Body, FixedStep, Frame, Rk4, Scheme, State, Stepper, System, Taylor, TaylorMotion, Torque,
    jacobian,
};

fn top_error(time: f64, tolerance: f64) -> f64 {
    let (moments, omega, arm) = ([0.6, 0.8, 1.0], [1.0, -2.0, 8.0], [0.1, -0.2, 1.0]);
    let exact = heavy_top(
        moments,
        [omega[0], omega[1], omega[2], 1.0, 0.0, 0.0, 0.0],
        arm,
        time,
        (time * 100.0) as u32,
    );
    let exact = State::new(
        [3, 4, 5, 6].map(|i| exact[i].value()),
        [0, 1, 2].map(|i| exact[i].value()),
    )
    .expect("a state");
    let body = Body::new(&Matrix3::from_diagonal(&moments.into())).expect("a body");
    let law = Torque::Gravity {
        weight: 1.0,
        arm: arm.into(),
    };
    let start = State::at_rest().turning(omega.into());
    let mut motion = TaylorMotion::new(&body, law, &start, tolerance).expect("a tolerance");
    motion.advance_to(time).expect("finite");
    let apart = exact.difference(motion.state());
    apart.rows(0, 3).norm().max(apart.rows(3, 3).norm() / 8.0)
}

#[test]
fn the_heavy_top_is_right_to_rounding() {
    for (tolerance, bound) in [(1e-16, 1e-13), (1e-12, 1e-9), (1e-6, 1e-3)] {
        let found = top_error(10.0, tolerance);
        assert!(found < bound, "{found:e} at {tolerance:e}");
    }
}

fn laws() -> [Torque; 7] {
    let v = Vector3::new(0.3, -0.5, 0.2);
    [
        Torque::None,
        Torque::Constant {
            frame: Frame::Body,
            value: v,
        },
        Torque::Constant {
            frame: Frame::Space,
            value: v,
        },
        Torque::Gravity {
            weight: 3.0,
            arm: v,
        },
        Torque::Damping { coefficient: 0.1 },
        Torque::Sinusoid {
            frame: Frame::Body,
            amplitude: v,
            angular_frequency: 3.0,
            phase: 0.4,
        },
        Torque::Sinusoid {
            frame: Frame::Space,
            amplitude: v,
            angular_frequency: 3.0,
            phase: 0.4,
        },
    ]
}

/// Every law's recurrence against the law itself: a Runge–Kutta step of h leaves h⁵.
#[test]
fn each_law_has_the_recurrence_of_its_function() {
    for law in laws() {
        let system = System::new(tensor(), law).expect("a body");
        let apart = |h: f64| {
            let by_series = Taylor::of_order(20).step(&system, 0.7, &start(), h);
            by_series
                .difference(&Rk4.step(&system, 0.7, &start(), h))
                .norm()
        };
        let ratio = apart(0.08) / apart(0.04);
        assert!((28.0..36.0).contains(&ratio), "{law:?}: {ratio}");
    }
}

#[test]
fn the_order_is_the_order_asked_for() {
    for law in laws() {
        let system = System::new(tensor(), law).expect("a body");
        for order in [2, 3, 5, 8] {
            let end = |h: f64| {
                let mut run =
                    FixedStep::new(Taylor::of_order(order), system, start(), h).expect("a step");
                run.advance_to(0.8).expect("finite");
                *run.state()
            };
            let exact = Taylor::of_order(30).step(&system, 0.0, &start(), 0.8);
            let order_found =
                (exact.difference(&end(0.2)).norm() / exact.difference(&end(0.1)).norm()).log2();
            assert!(
                (order_found - order as f64).abs() < 0.7,
                "{law:?}: {order_found} for {order}"
            );
        }
    }
}

#[test]
fn principal_axes_inside_change_nothing_outside() {
    for law in laws() {
        let body = Body::new(&tensor()).expect("a body");
        let mut motion = TaylorMotion::new(&body, law, &start(), 1e-16).expect("a tolerance");
        motion.advance_to(2.0).expect("finite");
        let system = System::new(tensor(), law).expect("a body");
        let mut run = FixedStep::new(Taylor::of_order(24), system, start(), 0.1).expect("a step");
        run.advance_to(2.0).expect("finite");
        let apart = run.state().difference(motion.state()).norm();
        assert!(apart < 2e-14, "{law:?}: {apart:e}");
        let before = motion.at(1.99).expect("in the last series");
        assert!(before.difference(motion.state()).norm() > 1e-3);
    }
}

/// A step of high order and one of low order are both near the flow, and so are their derivatives.
#[test]
fn the_jacobian_of_the_series_is_that_of_the_flow() {
    for law in laws() {
        let system = System::new(tensor(), law).expect("a body");
        let apart = |h: f64| {
            let series = jacobian::by_dual_numbers::<16, _, _>(
                &Taylor::of_order(12),
                &system,
                0.3,
                &start(),
                h,
            );
            let stages = Rk4.step_with_jacobian::<16>(&system, 0.3, &start(), h);
            (series.matrix - stages.matrix).amax()
        };
        // The derivative in h has the error of order 4, all others of order 5.
        let ratio = apart(0.02) / apart(0.01);
        assert!((12.0..20.0).contains(&ratio), "{law:?}: {ratio}");
    }
}

#[test]
fn what_cannot_be_is_an_error() {
    let body = Body::new(&tensor()).expect("a body");
    for tolerance in [0.0, -1.0, f64::NAN, 1e-20, 1.0] {
        assert!(TaylorMotion::new(&body, Torque::None, &start(), tolerance).is_err());
    }
    let law = Torque::Constant {
        frame: Frame::Body,
        value: Vector3::new(f64::NAN, 0.0, 0.0),
    };
    assert!(TaylorMotion::new(&body, law, &start(), 1e-9).is_err());
    let mut motion = TaylorMotion::new(&body, Torque::None, &start(), 1e-9).expect("a motion");
    assert!(motion.advance_to(f64::NAN).is_err());
    assert!(motion.advance_to(-1.0).is_err());
    assert!(motion.step(0.0).is_err());
    let mut still =
        TaylorMotion::new(&body, Torque::None, &State::at_rest(), 1e-9).expect("a motion");
    still.advance_to(1e9).expect("rest lasts");
    assert!(still.state().difference(&State::at_rest()).norm() < 1e-15);
}
