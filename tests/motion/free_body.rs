//! The exact free body against thirty-digit series, in every regime.

use super::double_double::free_motion;
use nalgebra::{Matrix3, Vector3};
use polhode::motion::{Body, FreeBody, Quaternion, State};

/// The largest error of ω (against |ω|) and of the attitude in radians.
fn error(moments: [f64; 3], omega: [f64; 3], time: f64, steps: u32) -> f64 {
    let q = [0.5, -0.5, 0.1, 0.7];
    let start = State::new(q, omega).expect("a state");
    let [w, x, y, z] = start.attitude.components();
    let exact = free_motion(
        moments,
        [omega[0], omega[1], omega[2], w, x, y, z],
        time,
        steps,
    );
    let exact = State::new(
        [3, 4, 5, 6].map(|i| exact[i].value()),
        [0, 1, 2].map(|i| exact[i].value()),
    )
    .expect("a state");
    let body = Body::new(&Matrix3::from_diagonal(&moments.into())).expect("a body");
    let found = FreeBody::new(&body, &start).at(time).expect("finite");
    let apart = exact.difference(&found);
    let size = Vector3::from(omega).amax();
    apart.rows(0, 3).norm().max(apart.rows(3, 3).norm() / size)
}

fn assert_near(moments: [f64; 3], omega: [f64; 3], time: f64, tolerance: f64) {
    let speed = Vector3::from(omega).norm();
    let steps = (time * speed * 8.0).ceil().max(4.0) as u32;
    let found = error(moments, omega, time, steps);
    assert!(
        found < tolerance,
        "{moments:?} {omega:?} t = {time}: {found:e} over {tolerance:e}"
    );
}

#[test]
fn general_motion_about_either_axis_with_every_sign() {
    for moments in [
        [0.6, 0.8, 1.0],
        [0.6, 1.0, 0.8],
        [1.0, 0.6, 0.8],
        [2.0, 3.0, 4.9],
    ] {
        for omega in [
            [3.0, 0.5, -0.9],
            [-3.0, 0.5, 0.9],
            [0.3, -0.5, 2.0],
            [0.3, 0.5, -2.0],
            [-0.3, -0.5, -2.0],
            [1.0, 2.0, 1.1],
            [-1.0, 2.0, -0.4],
        ] {
            for time in [1e-3, 0.3, 1.7, 10.0] {
                // Some tens of roundings on angles up to thirty radians.
                assert_near(moments, omega, time, 2e-14);
            }
        }
    }
}

#[test]
fn near_the_separatrix_the_error_is_that_of_the_input() {
    for tiny in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13, 1e-16] {
        for (x, z) in [(1.0, 1.0), (1.0, -2.0), (0.3, 1.0), (0.0, 1.0), (-1.0, 0.0)] {
            let omega = [tiny * x, 3.0, tiny * z];
            // A relative change of a double in the small components shifts a flip by as much in time: 1e-14 at most.
            assert_near([0.6, 0.8, 1.0], omega, 20.0, 5e-14);
        }
    }
}

#[test]
fn on_the_separatrix_and_mid_flip() {
    // There I₁ (I₂ − I₁) ω₁² = I₃ (I₃ − I₂) ω₃², as nearly as doubles say it.
    for moments in [[1.0, 2.0, 3.0], [0.75, 1.0, 1.5]] {
        let [a, b, c]: [f64; 3] = moments;
        let ratio = (c * (c - b) / (a * (b - a))).sqrt();
        for nudge in [0.0, 1e-15, -1e-15, 1e-10, -1e-10, 1e-5] {
            let omega = [ratio * (1.0 + nudge), 0.7, 1.0];
            // The distance to the separatrix is itself known to a double; six e-foldings later that is seen.
            assert_near(moments, omega, 3.0, 1e-12);
        }
    }
}

#[test]
fn nearly_equal_moments_plates_and_needles() {
    for moments in [
        [1.0, 1.0 + 1e-9, 1.0 + 3e-9],
        [1.0, 1.0 + 1e-15, 1.5],
        [1.0, 1.0, 1.5],
        [1.0, 1.5, 1.5],
        [1.0, 1.5, 1.5 + 1e-12],
        [1.0, 2.0, 3.0],
        [1e-3, 1.0, 1.0],
        [1e-6, 1.0, 1.0 + 5e-7],
        [1e-6, 1.0, 1.0 + 1e-6],
    ] {
        for omega in [[1.0, 2.0, -0.5], [-0.1, 0.2, 3.0], [2.0, 1e-3, 1e-3]] {
            assert_near(moments, omega, 5.0, 1e-13);
        }
    }
}

#[test]
fn spins_that_do_not_change() {
    let half = Quaternion::exp(&Vector3::new(0.3, 0.2, 0.9));
    for (moments, omega) in [
        ([1.0, 2.0, 2.5], [3.0, 0.0, 0.0]),
        ([1.0, 2.0, 2.5], [0.0, 3.0, 0.0]),
        ([1.0, 2.0, 2.5], [0.0, 0.0, -3.0]),
        ([2.0, 2.0, 2.0], [1.0, -2.0, 3.0]),
        ([1.0, 2.0, 2.0], [0.0, -2.0, 3.0]),
        ([2.0, 2.0, 3.0], [1.0, -2.0, 0.0]),
        ([1.0, 2.0, 2.5], [0.0, 0.0, 0.0]),
    ] {
        let body = Body::new(&Matrix3::from_diagonal(&moments.into())).expect("a body");
        let start = State {
            attitude: half,
            angular_velocity: omega.into(),
        };
        let end = FreeBody::new(&body, &start).at(2.5).expect("finite");
        assert_eq!(end.angular_velocity, start.angular_velocity);
        let exact = half * Quaternion::exp(&(Vector3::from(omega) * 2.5));
        assert!((exact.conjugate() * end.attitude).log().norm() < 1e-15);
    }
}

#[test]
fn the_scale_of_inertia_and_of_speed_does_not_matter() {
    let (moments, omega) = (Vector3::new(0.6, 0.8, 1.0), Vector3::new(1.0, 3.0, -0.9));
    let at = |size: f64, speed: f64| {
        let body = Body::new(&Matrix3::from_diagonal(&(moments * size))).expect("a body");
        let start = State::at_rest().turning(omega * speed);
        let end = FreeBody::new(&body, &start)
            .at(10.0 / speed)
            .expect("finite");
        end.turning(end.angular_velocity / speed)
    };
    let plain = at(1.0, 1.0);
    for (size, speed) in [
        (1e150, 1.0),
        (1e-150, 1.0),
        (1.0, 1e8),
        (1.0, 1e-8),
        (1e-150, 1e8),
    ] {
        assert!(
            plain.difference(&at(size, speed)).norm() < 5e-14,
            "{size} {speed}"
        );
    }
}
