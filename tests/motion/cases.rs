//! Bodies, torques and states for the tests of a step: repeated moments, plates and needles in any axes.
#![allow(dead_code, reason = "no test takes all of it")]

use nalgebra::{Matrix3, Vector3};
use polhode::motion::{Frame, Quaternion, State, System, Torque};
use proptest::prelude::*;

#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) inertia: Matrix3<f64>,
    pub(crate) torque: Torque,
    pub(crate) state: State<f64>,
    pub(crate) time: f64,
    pub(crate) step: f64,
}

impl Case {
    pub(crate) fn system(&self) -> System<f64, Torque> {
        System::new(self.inertia, self.torque).expect("a possible body")
    }
}

/// A possible body: masses on a frame that is turned at will.
fn bodies() -> impl Strategy<Value = Matrix3<f64>> {
    let squares = prop_oneof![
        prop::array::uniform3(0.1_f64..2.0),
        Just([1.0, 1.0, 1.0]),
        Just([1.0, 1.0, 0.3]),
        Just([1e-3, 1e-3, 1.0]),
    ];
    (squares, prop::array::uniform3(-3.0_f64..3.0)).prop_map(|([a, b, c], turn)| {
        let r = Quaternion::exp(&turn.into()).matrix();
        let tensor = r * Matrix3::from_diagonal(&Vector3::new(b + c, a + c, a + b)) * r.transpose();
        (tensor + tensor.transpose()) * 0.5
    })
}

fn vectors(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

fn frames() -> impl Strategy<Value = Frame> {
    prop_oneof![Just(Frame::Body), Just(Frame::Space)]
}

fn torques() -> impl Strategy<Value = Torque> {
    prop_oneof![
        Just(Torque::None),
        (frames(), vectors(1.0)).prop_map(|(frame, value)| Torque::Constant { frame, value }),
        (0.5_f64..10.0, vectors(0.3)).prop_map(|(weight, arm)| Torque::Gravity { weight, arm }),
        (0.0_f64..0.1).prop_map(|coefficient| Torque::Damping { coefficient }),
        (frames(), vectors(1.0), 0.1_f64..3.0, -3.0_f64..3.0).prop_map(
            |(frame, amplitude, angular_frequency, phase)| Torque::Sinusoid {
                frame,
                amplitude,
                angular_frequency,
                phase
            }
        ),
    ]
}

pub(crate) fn cases() -> impl Strategy<Value = Case> {
    (
        bodies(),
        torques(),
        vectors(3.0),
        vectors(3.0),
        0.0_f64..5.0,
        0.01_f64..0.2,
    )
        .prop_map(|(inertia, torque, turn, omega, time, step)| Case {
            inertia,
            torque,
            state: State {
                attitude: Quaternion::exp(&turn),
                angular_velocity: omega,
            },
            time,
            step,
        })
}

/// The case with a step in which the body turns by less than a radian: further out a method of high order has
/// derivatives too steep for differences.
pub(crate) fn tamed(case: &Case) -> Case {
    let least = case.inertia.symmetric_eigenvalues().min();
    let torque = match case.torque {
        Torque::None | Torque::Damping { .. } => 0.0,
        Torque::Constant { value, .. } => value.norm(),
        Torque::Sinusoid { amplitude, .. } => amplitude.norm(),
        Torque::Gravity { weight, arm } => weight * arm.norm(),
    };
    let damping = match case.torque {
        Torque::Damping { coefficient } => coefficient / least,
        _ => 0.0,
    };
    // Splitting turns the body about single axes, as fast as the whole momentum would about the thinnest.
    let momentum = case.inertia * case.state.angular_velocity;
    let pace = momentum.norm() / least + (torque / least).sqrt() + damping;
    Case {
        step: case.step.min(0.7 / pace),
        ..case.clone()
    }
}
