//! The closed form of a spin about a fixed axis, against the motion that is integrated.

use nalgebra::{Matrix3, Vector3};
use polhode::motion::{Body, Frame, State, Stepper, TaylorMotion, Torque};
use polhode::scene::{Member, Spin};

fn member(moments: [f64; 3], omega: [f64; 3], torque: Torque) -> Member {
    let tensor = Matrix3::from_diagonal(&moments.into());
    Member {
        body: Body::new(&tensor).expect("a body"),
        start: State::new([1.0, 0.0, 0.0, 0.0], omega).expect("a state"),
        torque,
    }
}

fn sinusoid(frame: Frame, w: f64) -> Torque {
    Torque::Sinusoid {
        frame,
        amplitude: Vector3::new(0.0, 0.3, 0.0),
        angular_frequency: w,
        phase: 0.7,
    }
}

#[test]
fn closed_forms_are_the_motion_that_is_integrated() {
    let spin = [0.0, 1.3, 0.0];
    let constant = |frame| Torque::Constant {
        frame,
        value: Vector3::new(0.0, -0.4, 0.0),
    };
    let cases = [
        member([2.0, 3.0, 4.0], spin, Torque::Damping { coefficient: 0.5 }),
        member(
            [3.0, 3.0, 3.0],
            [0.3, -1.0, 2.0],
            Torque::Damping { coefficient: 0.5 },
        ),
        member([2.0, 3.0, 4.0], spin, constant(Frame::Body)),
        member([2.0, 3.0, 4.0], [0.0; 3], constant(Frame::Space)),
        member([2.0, 3.0, 4.0], spin, sinusoid(Frame::Body, 2.0)),
        member([2.0, 3.0, 4.0], spin, sinusoid(Frame::Space, -0.05)),
        member([2.0, 3.0, 4.0], spin, sinusoid(Frame::Body, 0.0)),
    ];
    for member in cases {
        let spin = Spin::new(&member).expect("planar motion");
        let mut motion =
            TaylorMotion::new(&member.body, member.torque, &member.start, 1e-15).expect("a motion");
        for time in [0.0, 0.4, 3.0, 7.0] {
            motion.advance_to(time).expect("finite");
            let off = spin.at(time).difference(motion.state()).amax();
            assert!(off < 1e-13, "{member:?} at {time}: {off:e}");
        }
    }
}

#[test]
fn what_leaves_its_axis_is_no_spin() {
    let tilted = member([2.0, 3.0, 4.0], [0.0, 1.0, 1e-300], Torque::None);
    assert!(Spin::new(&tilted).is_none());
    let across = Torque::Constant {
        frame: Frame::Body,
        value: Vector3::x(),
    };
    assert!(Spin::new(&member([2.0, 3.0, 4.0], [0.0, 1.0, 0.0], across)).is_none());
    let hanging = Torque::Gravity {
        weight: 1.0,
        arm: Vector3::new(0.0, 0.0, -1.0),
    };
    let sleeping = Spin::new(&member([2.0, 3.0, 4.0], [0.0; 3], hanging));
    assert!(sleeping.is_some_and(|spin| spin.is_rest()));
}
