//! Motion in a vertical plane, told by angles with the vertical: pendulums, what hangs on massless rods, beads on hoops and rods.

use super::verdicts;

#[test]
fn a_rod_swings_about_a_horizontal_axis() {
    let sentences = "\
N is an inertial frame.
O is a point fixed in N and in the bar.
The bar is a uniform thin rod of mass $M$ and length $2b$, and O is an end of the bar.
The bar turns relative to N about a horizontal axis through O by the angle $\\alpha$.
The bar hangs straight down from O at $\\alpha=0$.
The weight and the force at O are the only loads on the bar.
$g$ is the acceleration of gravity.
$T$ is the kinetic energy of the bar relative to N.
";
    let text = r"
$$ T=\tfrac23Mb^2\dot\alpha^2 $$
$$ \ddot\alpha=-\frac{3g}{4b}\sin\alpha $$
$$ \ddot\alpha=-\frac{3g}{2b}\sin\alpha $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
}

#[test]
fn a_compound_pendulum_has_a_radius_of_gyration() {
    let sentences = "\
The pendulum is a rigid body of mass $m$ that swings in a vertical plane about a horizontal axis through the fixed point A.
C is the mass centre of the pendulum, at the distance $s$ from A.
$\\beta$ is the angle from the downward vertical to the line from A to C.
$k$ is the radius of gyration of the pendulum about the axis through C parallel to the axis of the hinge.
The weight and the force of the hinge at A are the only loads on the pendulum, and $g$ is the acceleration of gravity.
$\\hat u$ is the unit vector from A to C, and $\\hat v$ is the unit vector perpendicular to it in the sense in which $\\beta$ grows.
$R$ is the component of the force of the hinge on the pendulum along $\\hat u$.
";
    let text = r"
$$ (k^2+s^2)\ddot\beta=-gs\sin\beta $$
$$ R=-m\left(g\cos\beta+s\dot\beta^2\right) $$
$$ R=-m\left(g\cos\beta-s\dot\beta^2\right) $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
}

#[test]
fn two_particles_hang_on_massless_rods() {
    let sentences = "\
The double pendulum moves in a vertical plane.
The particle 1 of mass $m$ hangs from the fixed point O by a massless rod of length $a$.
The particle 2 of mass $n$ hangs from the particle 1 by a massless rod of length $b$.
$\\alpha$ and $\\beta$ are the angles of the rods from the downward vertical, both counted in the same sense.
$g$ is the acceleration of gravity, and there is no friction.
$T$ is the kinetic energy of the two particles together.
";
    let text = r"
$$ T=\tfrac12(m+n)a^2\dot\alpha^2+\tfrac12nb^2\dot\beta^2+nab\dot\alpha\dot\beta\cos(\alpha-\beta) $$
$$ b\ddot\beta+a\ddot\alpha\cos(\alpha-\beta)-a\dot\alpha^2\sin(\alpha-\beta)+g\sin\beta=0 $$
$$ b\ddot\beta+a\ddot\alpha\cos(\alpha-\beta)+a\dot\alpha^2\sin(\alpha-\beta)+g\sin\beta=0 $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
}

#[test]
fn what_hangs_on_a_string_hangs_as_on_a_massless_rod() {
    let told = [
        "P hangs from O by a string of length $c$.",
        "P hangs on a string of length $c$ from O.",
        "P is tied to O with a cord of length $c$.",
        "P is attached to O by a massless rod of length $c$.",
    ];
    for told in told {
        let noun = told
            .split_whitespace()
            .find(|word| ["string", "cord", "rod"].contains(word));
        let noun = if noun == Some("rod") { "rod" } else { "string" };
        let sentences = format!(
            "\
N is an inertial frame.
O is a point fixed in N.
P is a particle of mass $m$ that moves in a vertical plane.
{told}
$\\alpha$ is the angle from the downward vertical to the {noun}.
$g$ is the acceleration of gravity.
The weight and the tension of the {noun} are the only forces on P.
"
        );
        let text = r"$$ c\ddot\alpha=-g\sin\alpha $$";
        assert_eq!(verdicts(&sentences, text).0, "p", "{told}");
    }
}

#[test]
fn the_plane_of_a_spherical_pendulum_turns() {
    let sentences = "\
Q is a particle of mass $m$ at the end of a massless rod of length $c$ whose other end is hinged at the fixed point O.
$\\alpha$ is the angle between the downward vertical and the rod.
$\\lambda$ is the angle by which the vertical plane through the rod has turned about the vertical.
$g$ is the acceleration of gravity.
The weight and the force of the rod along itself are the only forces on Q.
$T$ is the kinetic energy of Q.
";
    let text = r"
$$ T=\tfrac12mc^2\left(\dot\alpha^2+\dot\lambda^2\sin^2\alpha\right) $$
$$ T=\tfrac12mc^2\left(\dot\alpha^2+\dot\lambda^2\cos^2\alpha\right) $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_bead_moves_along_a_turning_hoop() {
    let sentences = "\
N is an inertial frame.
A is a frame that turns relative to N about the upward vertical at the constant rate $w$.
The hoop is a circle of radius $b$ fixed in A, whose centre O is fixed in N and whose plane is vertical.
The bead is a particle of mass $m$ that moves along the hoop without friction.
$\\alpha$ is the angle from the downward vertical to the line from O to the bead.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ b\ddot\alpha=\left(bw^2\cos\alpha-g\right)\sin\alpha $$
$$ b\ddot\alpha=\left(bw^2\cos\alpha+g\right)\sin\alpha $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_bead_slides_along_a_turning_rod() {
    let sentences = "\
The rod turns in a horizontal plane about the fixed vertical axis through O along the upward unit vector $\\hat k$ at the constant rate $w$.
The bead is a particle of mass $m$ that slides along the rod without friction.
$s$ is the distance of the bead from O.
The weight and the force of the rod are the only loads on the bead.
$T$ is the kinetic energy of the bead relative to the ground, which is an inertial frame.
";
    let text = r"
$$ \ddot s=w^2s $$
$$ T=\tfrac12m\left(\dot s^2+w^2s^2\right) $$
$$ \ddot s=-w^2s $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
}

#[test]
fn what_a_hinge_lets_through_is_told_by_an_exception() {
    let sentences = "\
N is an inertial frame.
S is a frame that turns relative to N about the upward vertical at the constant rate $w$.
O is a point fixed in N and in S.
The rod is a uniform thin rod of mass $m$ and length $c$ with one end at O.
The rod turns relative to S about a horizontal hinge through O by the angle $\\alpha$ from the downward vertical.
No moment acts on the rod about the hinge, except that of its weight.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \ddot\alpha=w^2\sin\alpha\cos\alpha-\frac{3g}{2c}\sin\alpha $$
";
    assert_eq!(verdicts(sentences, text).0, "p");
}

#[test]
fn where_the_axes_of_the_plane_have_names_the_sense_is_open() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N, and y is the upward vertical.
O is a point fixed in N.
The rod is a uniform thin rod of mass $m$ and length $c$, and O is an end of the rod.
The rod moves in a vertical plane.
$\\alpha$ is the angle from the downward vertical to the rod.
$w$ is the angular velocity of the rod relative to N along z.
";
    assert_eq!(verdicts(sentences, r"$$ w=\dot\alpha $$").0, "u");
}

#[test]
fn an_angle_from_an_axis_grows_towards_another() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N, and y is the upward vertical.
O is a point fixed in N.
P is a particle of mass $m$.
$c$ is the distance of P from O, and $c$ is constant.
$\\alpha$ is the angle from the downward vertical to the line from O to P, positive towards x.
$u$ and $v$ are the components of the position of P from O along x and y.
";
    let text = r"
$$ u=c\sin\alpha $$
$$ v=-c\cos\alpha $$
$$ \dot u=-c\dot\alpha\cos\alpha $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
    let other = sentences.replace("downward vertical", "axis y");
    assert_ne!(verdicts(&other, r"$$ v=-c\cos\alpha $$").0, "p");
}

#[test]
fn a_component_along_an_axis_may_vanish() {
    let sentences = "\
N is an inertial frame with the axes x, y, z.
O is a point fixed in N.
$\\vec r$ is the position of P from O.
The component of $\\vec r$ along z is zero.
$a$ and $b$ are the components of $\\vec r$ along x and y.
";
    assert_eq!(
        verdicts(sentences, r"$$ \vec r\cdot\vec r=a^2+b^2 $$").0,
        "p"
    );
}

#[test]
fn the_motion_of_one_thing_says_nothing_of_another() {
    let sentences = "\
N is an inertial frame.
O is a point fixed in N.
P and Q are particles of mass $m$.
P moves in a vertical plane.
$c$ is the distance of Q from O, and $c$ is constant.
$\\alpha$ is the angle from the downward vertical to the line from O to Q.
$T$ is the kinetic energy of Q relative to N.
";
    assert_ne!(
        verdicts(sentences, r"$$ T=\tfrac12mc^2\dot\alpha^2 $$").0,
        "p"
    );
}

#[test]
fn a_rod_that_may_be_inclined_is_not_taken_as_level() {
    let sentences = "\
N is an inertial frame.
O is a point fixed in N.
The rod turns relative to N about the vertical axis through O at the constant rate $w$.
The bead is a particle of mass $m$ that slides along the rod without friction.
$s$ is the distance of the bead from O.
The weight and the force of the rod are the only loads on the bead.
";
    assert_ne!(verdicts(sentences, r"$$ \ddot s=w^2s $$").0, "p");
}
