//! What is a choice of axes changes nothing but the numbers.

use super::turning::{start, tensor};
use nalgebra::Vector3;
use polhode::motion::{
    Body, Dop853, FreeBody, FreeMotion, ImplicitMidpoint, MoserVeselov, Quaternion, Rk4, Scheme,
    Splitting, State, Stepper, System, Taylor, Torque,
};

fn laws() -> [Torque; 3] {
    let arm = Vector3::new(0.1, -0.2, 0.5);
    [
        Torque::None,
        Torque::Gravity { weight: 3.0, arm },
        Torque::Damping { coefficient: 0.3 },
    ]
}

const STEP: f64 = 0.2;
/// Rounding of a step of some hundred operations on numbers up to 5.
const ROUNDING: f64 = 2e-14;

/// Other axes in the body.
fn in_other_axes<S: Scheme<Torque>>(scheme: &S, law: Torque) -> f64 {
    let turn = Quaternion::exp(&Vector3::new(-0.3, 0.8, 1.1));
    let axes = turn.matrix();
    let seen = |state: &State<f64>| State {
        attitude: state.attitude * turn,
        angular_velocity: axes.tr_mul(&state.angular_velocity),
    };
    let turned = axes.tr_mul(&tensor()) * axes;
    let system = System::new(tensor(), law).expect("a body");
    let other = System::new((turned + turned.transpose()) * 0.5, law.along(&axes));
    let end = scheme.step(&system, 0.0, &start(), STEP);
    let there = scheme.step(&other.expect("the same body"), 0.0, &seen(&start()), STEP);
    seen(&end).difference(&there).amax()
}

/// Another heading in space, about the vertical that gravity leaves.
fn with_another_heading<S: Scheme<Torque>>(scheme: &S, law: Torque) -> f64 {
    let turn = Quaternion::exp(&Vector3::new(0.0, 0.0, 2.1));
    let seen = |state: &State<f64>| State {
        attitude: turn * state.attitude,
        ..*state
    };
    let system = System::new(tensor(), law).expect("a body");
    let end = scheme.step(&system, 0.0, &start(), STEP);
    let there = scheme.step(&system, 0.0, &seen(&start()), STEP);
    seen(&end).difference(&there).amax()
}

fn assert_objective<S: Scheme<Torque>>(scheme: &S) {
    for law in laws() {
        let (axes, heading) = (
            in_other_axes(scheme, law),
            with_another_heading(scheme, law),
        );
        assert!(axes < ROUNDING, "{law:?}: {axes:e} in other axes");
        assert!(
            heading < ROUNDING,
            "{law:?}: {heading:e} with another heading"
        );
    }
}

#[test]
fn a_step_does_not_depend_on_the_axes() {
    assert_objective(&Rk4);
    assert_objective(&Dop853);
    assert_objective(&Taylor::of_order(12));
    assert_objective(&ImplicitMidpoint);
    assert_objective(&MoserVeselov::FOURTH);
    // It splits the motion along the axes of the body, but knows none in space.
    for law in laws() {
        let heading = with_another_heading(&Splitting::FOURTH, law);
        assert!(heading < ROUNDING, "{law:?}: {heading:e}");
    }
}

#[test]
fn the_free_body_is_a_motion_like_the_others() {
    let body = Body::new(&tensor()).expect("a body");
    let (exact, mut motion) = (
        FreeBody::new(&body, &start()),
        FreeMotion::new(&body, &start()),
    );
    for n in 1..=5 {
        motion.step(0.7).expect("onward");
        let time = 0.7 * f64::from(n);
        let there = exact.at(time).expect("finite");
        assert!(motion.state().difference(&there).amax() < 1e-13, "{time}");
    }
    let before = motion.at(motion.time() - 0.3).expect("in the last step");
    let there = exact.at(motion.time() - 0.3).expect("finite");
    assert!(before.difference(&there).amax() < 1e-15);
    assert!(motion.at(0.1).is_err() && motion.advance_to(0.1).is_err());
    assert!(motion.step(f64::NAN).is_err() && motion.step(0.0).is_err());
}
