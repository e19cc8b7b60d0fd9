//! Rods by where they point when an angle is zero, in many wordings, and what else is said of things that hang and roll.

use super::judged;

/// What all tellings of the pendulum share.
const PENDULUM: &str = "\
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
O is a point fixed in N.
G is the mass centre of the rod.
The rod is a uniform thin rod of mass $m$ and length $l$.
$g$ is the acceleration of gravity.
$T$ is the kinetic energy of the rod relative to N.
$V$ is the potential energy of the rod.
The potential energy is zero at O.
$I$ is the moment of inertia of the rod about the axis through O perpendicular to the plane of x and y.
The weight and the force at O are the only loads on the rod.
";

const LINES: &str = r"
$$I = m l^2/3$$

$$T = \tfrac16 m l^2\dot\theta^2$$

$$V = -m g \tfrac l2\cos\theta$$

$$I\ddot\theta = -m g \tfrac l2 \sin\theta$$

$$I\ddot\theta = m g \tfrac l2 \sin\theta$$
";

#[test]
fn a_rod_may_hang_or_point_somewhere_at_the_zero_of_its_angle() {
    let turns = "The rod turns relative to N about z by the angle $\\theta$.";
    for place in [
        "The rod hangs from O at $\\theta=0$.",
        "The rod hangs straight down from O at $\\theta=0$.",
        "O is an end of the rod.\nG lies vertically below O at $\\theta=0$.",
        "O is an end of the rod.\nThe rod hangs vertically at $\\theta=0$.",
        "O is an end of the rod.\nAt $\\theta=0$ the rod points along $-y$.",
        "The rod lies along the negative second axis of the rod from O.",
        "O is an end of the rod.\n$\\theta$ is the angle about z from the downward vertical to the rod.",
        "O and A are the ends of the rod.\n$\\theta$ is the angle about z from $-y$ to the line from O to A.",
    ] {
        let said = format!("{PENDULUM}{turns}\n{place}\n");
        assert_eq!(judged(&said, LINES), "ppppr", "{place}");
    }
}

#[test]
fn a_rod_may_reach_against_an_axis() {
    let said = "B is a frame fixed in the rod.
$i, j, k$ are the axes of B.
B turns relative to N about z by the angle $\\theta$.
The rod lies along $-j$ from O.
";
    assert_eq!(judged(&format!("{PENDULUM}{said}"), LINES), "ppppr");
}

#[test]
fn the_sense_of_an_angle_with_the_vertical_may_be_told_behind_it() {
    let said = "The rod swings in the plane of x and y.
O is the upper end of the rod.
$\\theta$ is the angle between the rod and the downward vertical, positive about z.
";
    assert_eq!(judged(&format!("{PENDULUM}{said}"), LINES), "ppppr");
}

#[test]
fn small_oscillations_without_a_letter_are_those_of_the_only_angle() {
    let text = r"
$$T_0 = 2\pi\sqrt{\frac{2l}{3g}}$$

$$T_0 = 2\pi\sqrt{\frac{l}{g}}$$
";
    for period in [
        "$T_0$ is the period of small oscillations.",
        "$T_0$ is the period of the small oscillations about $\\theta=0$.",
    ] {
        let said = "The rod turns relative to N about z by the angle $\\theta$.
The rod hangs from O at $\\theta=0$.
";
        let said = format!("{PENDULUM}{said}{period}\n");
        assert_eq!(judged(&said, text), "pr", "{period}");
    }
}

#[test]
fn an_axis_of_the_inertial_frame_that_is_that_of_a_round_body_keeps_its_direction() {
    let said = "\
N is an inertial frame.
The incline is a plane fixed in N at the angle $\\beta$ to the horizontal.
x, y, z are the axes of N.
x points down the incline.
y is the normal vector of the incline.
The cylinder is a uniform cylinder of mass $m$ and radius $r$.
z is the axis of the cylinder.
The cylinder rolls on the incline at C without slipping.
G is the mass centre of the cylinder.
$g$ is the acceleration of gravity.
$v$ is the velocity of G relative to N along x.
The weight and the force of the incline at C are the only loads on the cylinder.
";
    let text = r"
$$\dot v = \tfrac23 g\sin\beta$$

$$\dot v = \tfrac12 g\sin\beta$$
";
    assert_eq!(judged(said, text), "pr");
}
