//! A step of a body as a function of numbers, for the tests to take derivatives of.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use polhode::jacobian::Slot;
use polhode::mechanics::InertiaParameters;
use polhode::motion::{Number, Quaternion, Rk4, Scheme, State, System, Torque};

pub(super) const STEP: f64 = 0.1;

pub(super) fn inertia() -> Matrix3<f64> {
    Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0)
}

pub(super) fn start() -> State<f64> {
    State {
        attitude: Quaternion::exp(&Vector3::new(0.4, -1.1, 0.7)),
        angular_velocity: Vector3::new(3.0, 0.5, -0.9),
    }
}

/// Gravity, so that the step depends on the attitude.
pub(super) fn law() -> Torque {
    Torque::Gravity {
        weight: 9.81,
        arm: Vector3::new(0.05, -0.1, 0.3),
    }
}

pub(super) fn end() -> State<f64> {
    let system = System::over(inertia(), law(), Vector3::zeros());
    Rk4.step(&system, 0.0, &start(), STEP)
}

/// (θ', ω') of a step by (θ, ω, torque, inertia, dt).
pub(super) fn step<T: Number>(x: &SVector<T, 16>) -> SVector<T, 6> {
    let vector = |first: usize| Vector3::from_fn(|i, _| x[first + i]);
    let half = vector(0) * T::of(0.5);
    let turn = Quaternion {
        w: T::one() - half.dot(&half) * T::of(0.5),
        v: half,
    };
    let state = State {
        attitude: Quaternion::new(start().attitude.components().map(T::of)) * turn,
        angular_velocity: vector(3),
    };
    let places = [[9, 12, 13], [12, 10, 14], [13, 14, 11]];
    let tensor = Matrix3::from_fn(|r, c| x[places[r][c]]);
    let system = System::over(tensor, law(), vector(6));
    let reached = Rk4.step(&system, T::of(0.0), &state, x[15]);
    let before = Quaternion::new(end().attitude.conjugate().components().map(T::of));
    let theta = (before * reached.attitude).v * T::of(2.0);
    let omega = reached.angular_velocity;
    SVector::from([theta.x, theta.y, theta.z, omega.x, omega.y, omega.z])
}

pub(super) fn at() -> SVector<f64, 16> {
    let (omega, tensor) = (start().angular_velocity, inertia());
    SVector::from([
        0.0,
        0.0,
        0.0,
        omega.x,
        omega.y,
        omega.z,
        0.0,
        0.0,
        0.0,
        tensor[(0, 0)],
        tensor[(1, 1)],
        tensor[(2, 2)],
        tensor[(0, 1)],
        tensor[(0, 2)],
        tensor[(1, 2)],
        STEP,
    ])
}

pub(super) fn right() -> SMatrix<f64, 6, 16> {
    let system = System::over(inertia(), law(), Vector3::zeros());
    let step = Rk4.step_with_jacobian::<16>(&system, 0.0, &start(), STEP);
    step.matrix
}

pub(super) fn rows() -> [Slot; 2] {
    let attitude = end().attitude;
    [
        Slot::turn("θ′", &attitude),
        Slot::vector_in_body("ω′", &attitude),
    ]
}

pub(super) fn columns() -> [Slot; 5] {
    let attitude = start().attitude;
    [
        Slot::turn("θ", &attitude),
        Slot::vector_in_body("ω", &attitude),
        Slot::vector_in_body("τ", &attitude),
        Slot::inertia("I", InertiaParameters::MuJoCo),
        Slot::scalar("dt"),
    ]
}

/// (q', ω') of a step of a free body by (q, ω), the quaternion as four numbers.
pub(super) fn quaternion_step<T: Number>(x: &SVector<T, 7>) -> SVector<T, 7> {
    let state = State {
        attitude: Quaternion::new([x[0], x[1], x[2], x[3]]),
        angular_velocity: Vector3::new(x[4], x[5], x[6]),
    };
    let system = System::over(
        inertia().map(T::of),
        law(),
        Vector3::from_element(T::of(0.0)),
    );
    let reached = Rk4.step(&system, T::of(0.0), &state, T::of(STEP));
    let ([w, x, y, z], omega) = (reached.attitude.components(), reached.angular_velocity);
    SVector::from([w, x, y, z, omega.x, omega.y, omega.z])
}
