//! Frames and motions that are called by what they are: "the body frame", "the absolute angular velocity".

use super::{judged, verdicts};

#[test]
fn a_frame_without_a_letter_is_called_by_its_kind() {
    let lines = "$$ w = \\dot q\\,k $$\n$$ w = -\\dot q\\,k $$\n$$ p = 0 $$\n";
    for kind in ["body", "world", "orbital", "laboratory"] {
        let sentences = format!(
            "E is an inertial frame.
The hull is a rigid body.
The {kind} frame is fixed in the hull.
$i$, $j$, $k$ are the axes of the {kind} frame.
The {kind} frame turns relative to E about $k$ by the angle $q$.
$w$ is the angular velocity of the hull relative to E.
$p$, $s$, $r$ are the components of $w$ on the {kind} frame.
"
        );
        assert_eq!(verdicts(&sentences, lines).0, "prp", "{kind}");
    }
}

#[test]
fn the_euler_angles_of_the_body_frame_are_relative_to_what_is_said() {
    let sentences = "E is an inertial frame.
The body frame is fixed in the aircraft.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of the body frame relative to E in the order z, y, x.
$p$, $q$, $r$ are the components on the body frame of the angular velocity of the aircraft relative to E.
";
    let lines = "$$ p = \\dot\\phi - \\dot\\psi\\sin\\theta $$\n$$ p = \\dot\\phi + \\dot\\psi\\sin\\theta $$\n";
    assert_eq!(judged(sentences, lines), "pr");
}

#[test]
fn an_absolute_motion_is_relative_to_the_inertial_frame() {
    for motion in ["absolute", "inertial"] {
        let sentences = format!(
            "N is an inertial frame, and $k$ is its third axis.
A turns relative to N about $k$ at the rate $a$.
B turns relative to A about $k$ at the rate $b$.
A and B are frames.
$w$ is the {motion} angular velocity of B.
"
        );
        let lines = "$$ w = (a + b) k $$\n$$ w = b k $$\n";
        assert_eq!(judged(&sentences, lines), "pr", "{motion}");
    }
}

#[test]
fn unit_vectors_along_the_axes_are_the_axes() {
    let lines = "$$ w = \\dot q\\,c $$\n$$ w = \\dot q\\,a $$\n";
    for axes in [
        "$a$, $b$, $c$ are the unit vectors along the axes of B.",
        "The unit vectors $a$, $b$ and $c$ are along the axes of B.",
        "The basis vectors $a$, $b$, $c$ of B are right-handed and orthonormal.",
        "$a$, $b$ and $c$ are the unit vectors of the frame B.",
    ] {
        let sentences = format!(
            "N is an inertial frame, and B is a frame.
{axes}
B turns relative to N about $c$ by the angle $q$.
$w$ is the angular velocity of B relative to N.
"
        );
        assert_eq!(judged(&sentences, lines), "pr", "{axes}");
    }
}

#[test]
fn a_weight_whose_centre_is_at_rest_does_no_work_in_gimbals() {
    let sentences = "E is an inertial frame, and $e$ is its third axis.
The gyroscope consists of the ring and the rotor.
A is a frame fixed in the ring, and $x$ is its first axis.
A turns relative to E about $e$ by the angle $a$.
C is a frame fixed in the rotor.
C turns relative to A about $x$ by the angle $b$.
O is the common mass centre of the ring and the rotor.
O has a fixed position in E.
$J$ is the moment of inertia of the ring about $e$.
$I$, $H$, $K$ are the principal moments of the rotor about O on C.
The weight and the forces of the frictionless bearings are the only loads on the ring and the rotor.
";
    let lines = "$$ I\\ddot b = (H - K)\\dot a^2\\sin b\\cos b $$\n$$ I\\ddot b = (K - H)\\dot a^2\\sin b\\cos b $$\n";
    assert_eq!(judged(sentences, lines), "pr");
}
