//! The parts of a sentence in other orders, and what hangs on several things, each on its own.

use super::{judged, verdicts};

const TURN: &str = "N is an inertial frame.
$e_1$, $e_2$, $e_3$ are the axes of N.
B is a frame, and $b_1$, $b_2$, $b_3$ are its axes.
$w$ is the angular velocity of B relative to N.
";

const TURN_LINES: &str = "$$ w = \\dot q e_3 $$\n$$ w = -\\dot q e_3 $$\n$$ b_1 = \\cos q\\,e_1 + \\sin q\\,e_2 $$\n$$ b_1 = \\cos q\\,e_1 - \\sin q\\,e_2 $$\n";

#[test]
fn a_turn_is_told_in_any_order_of_its_parts() {
    for turn in [
        "B turns relative to N about $e_3$ by the angle $q$.",
        "B is rotated with respect to N through the angle $q$ about $e_3$.",
        "Relative to N, B rotates about $e_3$ by $q$.",
        "The angle by which B turns relative to N about $e_3$ is $q$.",
        "$q$ is the angle through which B is rotated about $e_3$ relative to N.",
        "The angle of rotation of B relative to N about $e_3$ is $q$.",
        "B is obtained from N by a rotation about $e_3$ through the angle $q$.",
        "B results from N by a rotation through $q$ about $e_3$.",
        "A rotation about $e_3$ by the angle $q$ takes N to B.",
        "B turns about the axis $e_3$ with respect to N by $q$, and $q$ is positive.",
    ] {
        assert_eq!(
            judged(&format!("{TURN}{turn}\n"), TURN_LINES),
            "prpr",
            "{turn}"
        );
    }
}

#[test]
fn a_rate_is_told_in_any_order_of_its_parts() {
    let lines = "$$ w = s e_3 $$\n$$ w = s e_1 $$\n$$ \\dot s = 0 $$\n";
    for (turn, verdict) in [
        (
            "Relative to N, B spins about $e_3$ with the angular speed $s$.",
            "prr",
        ),
        (
            "The spin rate of B relative to N about $e_3$ is $s$.",
            "prr",
        ),
        (
            "The constant rate at which B turns about $e_3$ relative to N is $s$.",
            "prp",
        ),
        (
            "B turns about $e_3$ relative to N at the rate $s$, which is constant.",
            "prp",
        ),
        ("The angular velocity of B relative to N is $s e_3$.", "prr"),
    ] {
        let sentences = format!("{TURN}{turn}\n");
        assert_eq!(verdicts(&sentences, lines).0, verdict, "{turn}");
    }
}

#[test]
fn forces_at_several_points_act_each_at_its_own() {
    let sentences = "E is an inertial frame.
B is a frame fixed in the beam, and $b_1$, $b_2$, $b_3$ are its axes.
G is the mass centre of the beam.
P lies at the distance $d$ from G along $b_1$.
Q lies at the distance $d$ from G along $-b_1$.
$\\vec f$ and $\\vec h$ are the forces on the beam at P and Q.
$\\vec M$ is the total moment on the beam about G.
The forces $\\vec f$ and $\\vec h$ are the only loads on the beam.
";
    let lines = "$$ \\vec M = d\\,b_1\\times(\\vec f - \\vec h) $$\n$$ \\vec M = d\\,b_1\\times(\\vec f + \\vec h) $$\n";
    assert_eq!(judged(sentences, lines), "pr");
}
