//! What belongs to what: mass centres to bodies, axes to shapes, ends to rods, potentials to loads. Each was misread once.

use super::verdicts;

#[test]
fn what_belongs_to_a_body_is_told_of_the_body() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body, and G is its mass centre.
$p$, $q$, $r$ are the components of the angular velocity of the body relative to N on B.
$A$, $D$, $C$ are the principal moments of the body about G on B.
$0$, $0$ and $M$ are the components of the moment on the body about G on B.
";
    let text = r"
$$ C\dot r = M+(A-D)p q $$
$$ D\dot q = (C-A) r p $$
$$ D\dot q = (A-C) r p $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body, and its mass centre is G.
$L$ is the angular momentum of the body about G relative to N.
$I$ is the inertia tensor of the body about G.
$\\omega$ is the angular velocity of the body relative to N.
";
    let text = r"
$$ L = I\omega $$
";
    assert_eq!(verdicts(sentences, text).0, "p");
    let sentences = "\
N is an inertial frame.
The hub and the wheel are rigid bodies of mass $m$.
$p$ is the momentum of the hub and the wheel relative to N.
$u$ and $v$ are the velocities of the mass centres of the hub and the wheel relative to N.
";
    let text = r"
$$ p = m(u+v) $$
$$ p = m(u-v) $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_letter_that_stands_twice_makes_entries_equal() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
$(0,q,q)^T$ is the angular velocity of B relative to N in components on B.
$\\omega$ is the angular velocity of B relative to N.
";
    let text = r"
$$ \omega\cdot\omega = 2q^2 $$
$$ \omega\cdot\omega = q^2 $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
$\\omega = (\\omega_1,\\omega_2,\\omega_3)^T$ is the angular velocity of B relative to N in components on B.
$(A,A,C)$ are the principal moments of the body about its mass centre G on B.
No moment acts on the body about G.
";
    let text = r"
$$ \dot\omega_3 = 0 $$
$$ A\dot\omega_1 = (A-C)\omega_2\omega_3 $$
$$ A\dot\omega_1 = (C-A)\omega_2\omega_3 $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
}

#[test]
fn the_axis_of_a_shape_is_told_by_its_frame() {
    let sentences = "\
B is a frame fixed in the cylinder.
G is the mass centre of the cylinder.
The cylinder is a uniform solid cylinder of mass $m$, radius $r$ and length $\\ell$.
The axis of the cylinder is the second axis of B.
$A$, $D$, $C$ are the principal moments of the cylinder about G on B.
";
    let text = r"
$$ D = \frac12 m r^2 $$
$$ C = \frac12 m r^2 $$
$$ A = \frac14 m r^2+\frac1{12} m\ell^2 $$
";
    assert_eq!(verdicts(sentences, text).0, "prp");
    let sentences = "\
B is a frame fixed in the rod.
G is the mass centre of the rod.
The rod is a uniform thin rod of mass $m$ and length $l$.
The axis of the rod is the second axis of B.
$A$, $D$, $C$ are the principal moments of the rod about G on B.
";
    let text = r"
$$ D = 0 $$
$$ A = 0 $$
$$ C = 0 $$
";
    assert_eq!(verdicts(sentences, text).0, "prr");
    let sentences = "\
N is an inertial frame.
The rotor is a uniform thin disc of mass $m$ and radius $r$.
The rotor turns relative to N about its axis at the rate $\\Omega$.
$T$ is the kinetic energy of rotation of the rotor relative to N.
";
    let text = r"
$$ T = \frac14 m r^2\Omega^2 $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

#[test]
fn ends_and_rods_are_told_in_several_ways() {
    let sentences = "\
A uniform rod of mass $m$ goes from O to P.
$r$ is the position of P from O.
G is the mass centre of the rod.
$s$ is the position of G from P.
";
    let text = r"
$$ s = -\frac12 r $$
$$ s = \frac12 r $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
    let sentences = "\
The rod is a uniform thin rod of mass $m$ and length $l$.
O is one end of the rod, and P is the other end.
The ball is a uniform solid ball of mass $M$ and radius $r$ with its middle at P.
C is the mass centre of the ball.
$p$ is the position of C from O.
";
    let text = r"
$$ p\cdot p = l^2 $$
";
    assert_eq!(verdicts(sentences, text).0, "p");
}

#[test]
fn directions_are_told_by_adjectives_and_verbs() {
    let sentences = "\
N is an inertial frame with the axes $X$, $Y$, $Z$.
B is a frame fixed in the body with the axes $x$, $y$, $z$.
$\\omega$ is the angular velocity of the body relative to N.
$\\omega$ is normal to $z$.
";
    let text = r"
$$ \omega\cdot z = 0 $$
$$ \omega\times z = 0 $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
    let sentences = "\
N is an inertial frame, and $z$ is the upward vertical of N.
The rod is a uniform thin rod of mass $m$ and length $l$ with the ends P and Q.
The rod is vertical.
$p$ is the position of P from Q.
";
    let text = r"
$$ p\times z = 0 $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

#[test]
fn turns_are_read_in_any_order() {
    let sentences = "\
N is an inertial frame.
The disc turns relative to the shaft about $n$ at the rate $s$.
The shaft turns relative to N about $k$ at the rate $\\Omega$.
$k$ is a unit vector fixed in N, and $n$ is a unit vector fixed in the shaft.
$s$ and $\\Omega$ are constants.
$\\alpha$ is the angular acceleration of the disc relative to N.
";
    let text = r"
$$ \alpha = \Omega s k\times n $$
";
    assert_eq!(verdicts(sentences, text).0, "p");
    let sentences = "\
N is an inertial frame.
$k$ is a unit vector fixed in N.
B turns relative to A about $n$ at the rate $s$.
A turns relative to N about $k$ at the rate $\\Omega$.
$n$ is a unit vector fixed in A.
$\\alpha$ is the angular acceleration of B relative to N.
";
    let text = r"
$$ \alpha = \Omega s k\times n+\dot\Omega k+\dot s n $$
";
    assert_eq!(verdicts(sentences, text).0, "p");
}

#[test]
fn an_energy_has_the_potential_of_every_load() {
    let sentences = "\
N is an inertial frame.
P is a particle of mass $m$, and O is a point fixed in N.
$F$ is the force on P.
$r$ is the position of P from O.
$F=-k r$
$E$ is the total energy of P relative to N.
$L$ is the Lagrangian of P.
";
    let text = r"
$$ E = \frac12 m\dot r\cdot\dot r $$
$$ L = \frac12 m\dot r\cdot\dot r $$
";
    assert_eq!(verdicts(sentences, text).0, "uu");
    let sentences = "\
N is an inertial frame.
P is a particle of mass $m$, and O is a point fixed in N.
$r$ is the position of P from O.
$V=\\frac12 k r\\cdot r$ is the potential energy of P.
$L$ is the Lagrangian of P.
";
    let text = r"
$$ L = \frac12 m\dot r\cdot\dot r-\frac12 k r\cdot r $$
$$ L = \frac12 m\dot r\cdot\dot r $$
";
    assert_eq!(verdicts(sentences, text).0, "uu");
    let sentences = "\
N is an inertial frame.
The weight is the only load on P.
P is a particle of mass $m$.
$v$ is the velocity of P relative to N.
$L$ is the Lagrangian of P.
$E$ is the total energy of P relative to N.
";
    let text = r"
$$ L = \frac12 m v\cdot v $$
$$ E = \frac12 m v\cdot v $$
";
    assert_eq!(verdicts(sentences, text).0, "uu");
    let sentences = "\
N is an inertial frame.
P is a particle of mass $m$, and O is a point fixed in N.
$r$ is the position of P from O.
$k$ is the stiffness of the spring between O and P.
$L$ is the Lagrangian of P.
";
    let text = r"
$$ L = \frac12 m\dot r\cdot\dot r $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}
