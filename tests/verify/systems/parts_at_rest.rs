//! Parts of bodies that turn as one or that carry a frame, rods that hang in them, and axes about which wheels turn.

use super::judged;

const FLYWHEEL: &str = "N is an inertial frame.
The flywheel consists of the plate.
A is a frame fixed in the flywheel.
$i$, $j$, $k$ are the axes of A.
A turns relative to N about $k$ at the constant rate $w$.
C is a point fixed in N and in A.
The plate is a uniform thin disc of mass $m$ and radius $r$.
C is the mass centre of the plate.
$n$ is the unit vector along the axis of the plate.
$T$ is the kinetic energy of the flywheel relative to N.
$h$ is the angular momentum of the flywheel about C relative to N.
";

const LINES: &str = r"
$$ T = \frac{1}{8} m r^2 w^2 (1 + \cos^2\beta) $$

$$ T = \frac{1}{8} m r^2 w^2 (1 + \sin^2\beta) $$

$$ h\cdot j = 0 $$

$$ h\cdot i = \frac{1}{4} m r^2 w \sin\beta\cos\beta $$

$$ h\cdot i = -\frac{1}{4} m r^2 w \sin\beta\cos\beta $$
";

#[test]
fn the_part_of_a_body_that_carries_a_frame_is_at_rest_in_it() {
    for axis in [
        "$n = \\sin\\beta\\, i + \\cos\\beta\\, k$.",
        "$\\sin\\beta$, $0$ and $\\cos\\beta$ are the components of $n$ on A.",
        "$n$ is obtained from $k$ by a rotation about $j$ through the angle $\\beta$.",
    ] {
        let said = format!("{FLYWHEEL}{axis}\n");
        assert_eq!(judged(&said, LINES), "prppr", "{axis}");
    }
}

#[test]
fn a_unit_vector_turns_about_an_axis_with_its_sense() {
    for (axis, wanted) in [
        (
            "$n$ is obtained from $i$ by a rotation about $k$ through the angle $\\beta$.",
            "prr",
        ),
        (
            "$n$ is obtained from $j$ by a rotation about $k$ through the angle $\\beta$.",
            "rpr",
        ),
        (
            "$n$ is obtained from $i$ by a rotation about $-k$ through the angle $\\beta$.",
            "rrp",
        ),
    ] {
        let said = format!(
            "N is an inertial frame.
$i$, $j$, $k$ are the axes of N.
$n$ is a unit vector.
{axis}
"
        );
        let text = r"
$$ n = \cos\beta\, i + \sin\beta\, j $$

$$ n = \cos\beta\, j - \sin\beta\, i $$

$$ n = \cos\beta\, i - \sin\beta\, j $$
";
        assert_eq!(judged(&said, text), wanted, "{axis}");
    }
}

const SWING: &str = "$i$, $j$, $k$ are the axes of the inertial frame N.
$j$ is the upward vertical.
O is a point fixed in N and in the pendulum.
The pendulum consists of a rod and a disc.
The rod is a uniform thin rod of mass $m$ and length $l$.
The disc is a uniform thin disc of mass $M$ and radius $r$.
The rod extends from O to S, the mass centre of the disc.
The axis of the disc is along $k$.
The pendulum turns relative to N about the axis through O along $k$ by the angle $q$.
$I$ is the moment of inertia of the pendulum about the axis through O along $k$.
$v$ is the velocity of S relative to N.
";

const SWUNG: &str = r"
$$ I = \frac{1}{3} m l^2 + \frac{1}{2} M r^2 + M l^2 $$

$$ I = \frac{1}{3} m l^2 + \frac{1}{4} M r^2 + M l^2 $$

$$ v = l\dot q (\cos q\, i + \sin q\, j) $$

$$ v = l\dot q (\cos q\, i - \sin q\, j) $$
";

#[test]
fn a_rod_that_hangs_in_what_turns_is_told_by_its_place_at_zero() {
    for zero in [
        "S lies below O at $q=0$.",
        "S is directly below O at $q=0$.",
        "The rod points downward at $q=0$.",
        "The pendulum hangs vertically down at $q=0$.",
        "$q=0$ when S is vertically below O.",
        "The angle $q$ is measured from the position in which S is vertically below O.",
    ] {
        let said = format!("{SWING}{zero}\n");
        assert_eq!(judged(&said, SWUNG), "prpr", "{zero}");
    }
    let said = format!("{SWING}S is vertically above O at $q=0$.\n");
    assert_eq!(judged(&said, SWUNG), "prrr");
}

#[test]
fn the_energy_of_a_weight_and_of_a_spring_that_turns_a_body_back() {
    let said = format!(
        "{SWING}S lies below O at $q=0$.
The spring exerts on the pendulum the moment $-b q$ along $k$, where $b$ is constant.
The weight, the force of the hinge at O and the moment of the spring are the only loads on the pendulum.
$U$ is the potential energy of the weight and of the spring, and it is zero at $q=0$.
$g$ is the acceleration of gravity.
"
    );
    let text = r"
$$ U = (\frac{m}{2} + M) g l (1 - \cos q) + \frac{1}{2} b q^2 $$

$$ U = (\frac{m}{2} + M) g l (1 - \cos q) + b q^2 $$

$$ U = -(\frac{m}{2} + M) g l \cos q + \frac{1}{2} b q^2 $$
";
    assert_eq!(judged(&said, text), "prr");
}

#[test]
fn each_wheel_is_round_about_the_axis_about_which_it_turns() {
    let said = "N is an inertial frame.
B is a frame fixed in the hub.
$i$, $j$, $k$ are the axes of B.
The probe consists of the hub and the rotor.
The rotor turns relative to B about $k$ at the rate $s$.
The rotor is symmetric about its axis of rotation.
The mass centre of the rotor is fixed in B.
G is the mass centre of the probe.
$a$, $b$, $c$ are the principal moments of the probe about G on B.
$J$ is the moment of inertia of the rotor about its axis of rotation.
$u$, $v$, $w$ are the components of the angular velocity of B relative to N on B.
$h$ is the angular momentum of the probe about G relative to N.
";
    let text = r"
$$ h = a u\, i + b v\, j + (c w + J s)\, k $$

$$ h = a u\, i + b v\, j + c w\, k $$
";
    assert_eq!(judged(said, text), "pr");
}

#[test]
fn the_axes_of_a_frame_are_no_frames_and_a_moment_acts_on_two_bodies() {
    let said = "N is an inertial frame.
$i$, $j$, $k$ are the axes of N.
The axes of A, a frame fixed in the lever, are $a$, $b$ and $k$.
O is a point fixed in N and in the lever.
A turns relative to N about $k$ by the angle $q$.
P is placed from O by $l a$.
P is fixed in the lever.
$v$ is the velocity of P relative to N.
";
    let text = r"
$$ v = l\dot q\, b $$

$$ v = -l\dot q\, b $$
";
    assert_eq!(judged(said, text), "pr");
}

#[test]
fn a_distance_that_is_called_e_is_no_base_of_powers() {
    let said = "N is an inertial frame.
$i$, $j$, $k$ are the axes of A.
A is a frame fixed in the cam.
A turns relative to N about $k$ at the rate $w$.
O is a point fixed in N and in A.
G lies at the distance $e$ from O along $i$.
G is the mass centre of the cam.
$m$ is the mass of the cam.
$C$ is the moment of inertia of the cam about the axis through G along $k$.
$I$ is the moment of inertia of the cam about the axis through O along $k$.
";
    let text = r"
$$ I = C + m e^2 $$

$$ I = C - m e^2 $$
";
    assert_eq!(judged(said, text), "pr");
}
