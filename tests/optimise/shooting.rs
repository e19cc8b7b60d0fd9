//! Multiple shooting.

use crate::slew::Slew;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use polhode::jacobian::check_black_box;
use polhode::motion::{Rk4, State, System, Torque};
use polhode::optimise::Nodes;

fn slew(inertia: Matrix3<f64>, limit: f64) -> Slew {
    Slew {
        system: System::new(inertia, Torque::None).expect("a body"),
        turn: Vector3::new(1.0, 1.5, -1.2),
        steps: 60,
        dt: 0.5,
        limit,
    }
}

/// A ball turns about one axis, and the angle is a cubic in time: the effort is 6 I² θ²/T³.
#[test]
fn a_ball_slews_as_the_calculus_of_variations_says() {
    let slew = slew(Matrix3::from_diagonal_element(80.0), 10.0);
    let found = slew.solve().expect("a slew");
    let exact = 6.0 * 80.0_f64.powi(2) * slew.turn.norm_squared() / 30.0_f64.powi(3);
    let effort = slew.effort(&found.nodes);
    // Torques that are constant over a step cost a part of 1/N² more.
    assert!(
        effort > exact && effort < exact * (1.0 + 4.0 / 3600.0),
        "{effort} for {exact}"
    );
}

#[test]
fn a_satellite_slews_within_its_limits_and_for_less_than_about_one_axis() {
    let inertia = Matrix3::new(60.0, 2.0, -3.0, 2.0, 80.0, 5.0, -3.0, 5.0, 100.0);
    let free = slew(inertia, 10.0).solve().expect("a slew");
    let bound = slew(inertia, 0.9);
    let found = bound.solve().expect("a slew");
    let (missed, _) = found.nodes.defects(&Rk4, &bound.system, bound.dt);
    assert!(missed.amax() < 1e-8, "{}", missed.amax());
    let largest = found
        .nodes
        .torques
        .iter()
        .map(|t| t.amax())
        .fold(0.0, f64::max);
    assert!((largest - 0.9).abs() < 1e-6, "{largest}");
    // Simulated without the nodes it arrives.
    let mut state = State::at_rest();
    for torque in &found.nodes.torques {
        use polhode::motion::Scheme;
        state = Rk4.step(&bound.system.with_torque(*torque), 0.0, &state, bound.dt);
    }
    let end = found.nodes.states[60];
    assert!(end.difference(&state).norm() < 1e-7);
    assert!((end.attitude.log() - bound.turn).norm() < 1e-9);
    // About one axis the torque is I α + ω × Iω along the cubic.
    let (whole, turn) = (30.0_f64, bound.turn);
    let about_one_axis: f64 = (0..6000)
        .map(|k| {
            let t = (f64::from(k) + 0.5) / 6000.0;
            let (omega, alpha) = (
                turn * (6.0 * t * (1.0 - t) / whole),
                turn * ((6.0 - 12.0 * t) / whole.powi(2)),
            );
            (inertia * alpha + omega.cross(&(inertia * omega))).norm_squared() / 2.0 * whole
                / 6000.0
        })
        .sum();
    let (free, bound) = (bound.effort(&free.nodes), bound.effort(&found.nodes));
    assert!(
        free < bound && free < about_one_axis,
        "{free} {bound} {about_one_axis}"
    );
}

#[test]
fn the_jacobian_of_the_defects_is_right() {
    let inertia = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
    let system = System::new(inertia, Torque::Damping { coefficient: 0.1 }).expect("a body");
    let tangent = DVector::from_fn(33, |i, _| (1.7 * i as f64).sin());
    let nodes = Nodes {
        states: vec![State::at_rest(); 4],
        torques: vec![Vector3::zeros(); 3],
    };
    let nodes = nodes.perturbed(&tangent);
    let missed = |change: &DVector<f64>| nodes.perturbed(change).defects(&Rk4, &system, 0.1).0;
    let jacobian = |_: &DVector<f64>| {
        let (_, blocks) = nodes.defects(&Rk4, &system, 0.1);
        DMatrix::from(&blocks.csc(18, nodes.dimension()))
    };
    let report = check_black_box(missed, jacobian, &DVector::zeros(33));
    assert!(report.is_right(), "{report}");
}
