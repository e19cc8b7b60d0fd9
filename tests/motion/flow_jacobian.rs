//! The Jacobian of a whole motion, and what symmetry and the invariants say of it.

use super::turning::{bracket_defect, start, tensor};
use nalgebra::{Matrix3, Matrix6, SMatrix, Vector3, Vector6};
use polhode::motion::{
    Body, Frame, FreeBody, Rk4, State, StepJacobian, Stepper, System, TaylorMotion, Torque,
    jacobian::flow,
};

fn top() -> Torque {
    Torque::Gravity {
        weight: 3.0,
        arm: Vector3::new(0.1, -0.2, 0.5),
    }
}

#[test]
fn all_ways_lead_to_one_jacobian() {
    let body = Body::new(&tensor()).expect("a body");
    let value = Vector3::new(0.4, -0.3, 0.7);
    let constant = |frame| Torque::Constant { frame, value };
    let sinusoid = |frame| Torque::Sinusoid {
        frame,
        amplitude: value,
        angular_frequency: 1.7,
        phase: 0.4,
    };
    for law in [
        Torque::None,
        top(),
        Torque::Damping { coefficient: 0.3 },
        constant(Frame::Body),
        constant(Frame::Space),
        sinusoid(Frame::Body),
        sinusoid(Frame::Space),
    ] {
        let system = System::new(tensor(), law).expect("a body");
        let series = flow::by_taylor::<16>(&body, law, &start(), 1e-15, 3.0).expect("finite");
        let stages = flow::by_dop853::<16, _>(&system, &start(), 1e-13, 3.0).expect("finite");
        assert!((series.matrix - stages.matrix).amax() < 1e-10, "{law:?}");
        assert!(series.state.difference(&stages.state).amax() < 1e-11);
        let varied = flow::by_variation::<16>(&body, law, &start(), 1e-13, 3.0).expect("finite");
        assert!((series.matrix - varied.matrix).amax() < 1e-10, "{law:?}");
        assert!(series.state.difference(&varied.state).amax() < 1e-11);
        let error = |h: f64| {
            let steps = flow::by_steps::<16, _, _>(&Rk4, &system, &start(), h, 3.0);
            (steps.expect("finite").matrix - series.matrix).amax()
        };
        let order = (error(0.02) / error(0.01)).log2();
        assert!((order - 4.0).abs() < 0.3, "{law:?}: {order}");
        let none = flow::by_taylor::<6>(&body, law, &start(), 1e-12, 0.0).expect("no time");
        assert_eq!(none.matrix, Matrix6::identity());
    }
}

/// The exact flow with one input moved, and the tangent to there from where it leads.
fn differences(body: &Body, state: &State<f64>, time: f64) -> SMatrix<f64, 6, 12> {
    let exact = |inertia: &Matrix3<f64>, state: &State<f64>| {
        let body = Body::new(inertia).expect("a body");
        FreeBody::new(&body, state).at(time).expect("finite")
    };
    let base = exact(body.inertia(), state);
    let end = |column: usize, amount: f64| {
        let (mut inertia, mut tangent) = (*body.inertia(), Vector6::zeros());
        match column {
            0..6 => tangent[column] = amount,
            6..9 => inertia[(column - 6, column - 6)] += amount,
            _ => {
                let (r, c) = [(0, 1), (0, 2), (1, 2)][column - 9];
                inertia[(r, c)] += amount;
                inertia[(c, r)] += amount;
            }
        }
        base.difference(&exact(&inertia, &state.perturbed(&tangent)))
    };
    let central = |c: usize, w: f64| (end(c, w) - end(c, -w)) / (2.0 * w);
    SMatrix::from_columns(&std::array::from_fn::<_, 12, _>(|c| {
        (central(c, 5e-5) * 4.0 - central(c, 1e-4)) / 3.0
    }))
}

/// General motion, repeated moments, the sphere, a pure spin, rest, the separatrix: the motion is smooth in
/// the state and in the tensor everywhere, whatever its formulas are.
#[test]
fn the_exact_free_body_has_the_derivatives_of_its_values() {
    let diagonal = |x, y, z| Matrix3::from_diagonal(&Vector3::new(x, y, z));
    let middle: f64 = (3.0_f64 * 1.0 / (1.0 * 1.0)).sqrt();
    for (inertia, omega) in [
        (tensor(), [1.0, -0.6, 1.4]),
        (diagonal(1.0, 1.0, 1.5), [1.0, 0.5, -0.4]),
        (diagonal(1.0, 1.0, 1.0), [1.0, 0.5, -0.4]),
        (diagonal(1.0, 2.0, 2.5), [0.0, 1.2, 0.0]),
        (diagonal(1.0, 2.0, 2.5), [0.0, 0.0, 0.0]),
        (diagonal(1.0, 2.0, 2.5), [1e-6, 1.2, 1e-6]),
        (diagonal(1.0, 2.0, 2.8), [middle, 0.7, 1.0]),
    ] {
        let body = Body::new(&inertia).expect("a body");
        let state = start().turning(omega.into());
        let found = flow::of_free_body::<15>(&body, &state, 3.0).expect("finite");
        let exact = differences(&body, &state, 3.0);
        let columns = |first: usize, from: usize, count: usize| {
            (found.matrix.columns(first, count) - exact.columns(from, count)).amax()
        };
        let apart = columns(0, 0, 6).max(columns(9, 6, 6));
        // Rounding of 1e-15 over the width, and the width to the fourth power times the fifth derivative.
        assert!(apart < 3e-9, "{inertia}{omega:?}: {apart:e}");
    }
}

fn free(time: f64) -> (Body, StepJacobian<15>) {
    let body = Body::new(&tensor()).expect("a body");
    let found = flow::of_free_body::<15>(&body, &start(), time).expect("finite");
    (body, found)
}

/// Twice as heavy a body moves alike: Σ J ∂/∂J is 0. Twice as fast a body is where it would be at twice the time.
#[test]
fn scalings_of_tensor_and_speed_are_known() {
    let time = 4.0;
    let (body, found) = free(time);
    let i = body.inertia();
    let tensor = SMatrix::<f64, 6, 1>::from([
        i[(0, 0)],
        i[(1, 1)],
        i[(2, 2)],
        i[(0, 1)],
        i[(0, 2)],
        i[(1, 2)],
    ]);
    assert!((found.matrix.fixed_columns::<6>(9) * tensor).amax() < 2e-13);
    let system = System::new(*i, Torque::None).expect("a body");
    let faster = found.matrix.fixed_columns::<3>(3) * start().angular_velocity;
    let omega = found.state.angular_velocity;
    let rate = system.rates(time, &found.state).angular_acceleration;
    let later = Vector6::from_iterator(
        (omega * time)
            .into_iter()
            .chain(&(rate * time + omega))
            .copied(),
    );
    assert!((faster - later).amax() < 2e-13);
}

/// In (θ, L) the flow keeps the brackets {θ, L} = 1, {L, L} = [L]×.
#[test]
fn the_flow_is_symplectic() {
    let (body, found) = free(6.0);
    let tangent = found.matrix.fixed_columns::<6>(0).into();
    assert!(bracket_defect(body.inertia(), tangent, &found.state) < 1e-12);
}

#[test]
fn the_state_is_that_of_the_motion() {
    let body = Body::new(&tensor()).expect("a body");
    let found = flow::by_taylor::<9>(&body, top(), &start(), 1e-14, 5.0).expect("finite");
    let mut motion = TaylorMotion::new(&body, top(), &start(), 1e-14).expect("a tolerance");
    motion.advance_to(5.0).expect("finite");
    assert!(found.state.difference(motion.state()).amax() < 1e-12);
    assert!(flow::by_taylor::<9>(&body, top(), &start(), 1e-14, -1.0).is_err());
    assert!(flow::by_taylor::<9>(&body, top(), &start(), 0.0, 1.0).is_err());
    assert!(flow::of_free_body::<9>(&body, &start(), f64::NAN).is_err());
    let system = System::new(tensor(), top()).expect("a body");
    assert!(flow::by_steps::<9, _, _>(&Rk4, &system, &start(), 0.0, 1.0).is_err());
}
