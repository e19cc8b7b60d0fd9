//! Loads that a noun names without a letter.

use super::judged;

#[test]
fn loads_are_called_by_their_nouns() {
    let sentences = "E is an inertial frame, and B is a frame fixed in the aircraft.
C is the mass centre of the aircraft.
x, y, z are the axes of B.
Z is the downward vertical, and X, Y, Z are the axes of E.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to E in the order z, y, x.
$u$, $v$, $w$ are the components on B of the velocity of C relative to E.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to E.
The aircraft has the mass $m$, and $g$ is the acceleration of gravity.
The weight, the thrust and the aerodynamic force are the only loads on the aircraft.
$T_x$, $T_y$, $T_z$ are the components of the thrust on B.
$A_x$, $A_y$, $A_z$ are the components of the aerodynamic force on B.
$l$, $n$ and $o$ are the components on B of the moment of the thrust about C.
$L$, $M$ and $N$ are the components on B of the moment of the aerodynamic force about C.
$K$ is the component x on B of the total moment on the aircraft about C.
";
    let text = r"
$$ m(\dot u + q w - r v) = T_x + A_x - m g \sin\theta $$
$$ m(\dot u + q w - r v) = T_x + A_x + m g \sin\theta $$
$$ m(\dot v + r u - p w) = T_y + A_y + m g \cos\theta\sin\phi $$
$$ m(\dot v + r u - p w) = T_y - A_y + m g \cos\theta\sin\phi $$
$$ K = l + L $$
$$ K = l - L $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

#[test]
fn the_only_forces_leave_the_moment_open() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the drone.
G is the mass centre of the drone.
x, y, z are the axes of B.
Z is the upward vertical, and X, Y, Z are the axes of N.
The mass of the drone is $m$, and $g$ is the acceleration of gravity.
$\\mathbf{F}$ is the thrust.
The weight and $\\mathbf{F}$ are the only forces on the drone.
$\\mathbf{a}$ is the acceleration of G relative to N.
$\\mathbf{k}$ is the unit vector along Z.
$\\mathbf{M}$ is the total moment on the drone about G.
";
    let text = r"
$$ m \mathbf{a} = \mathbf{F} - m g \mathbf{k} $$
$$ m \mathbf{a} = \mathbf{F} + m g \mathbf{k} $$
$$ \mathbf{M} = 0 $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn a_thrust_may_be_a_size() {
    let sentences = "N is an inertial frame.
G is the mass centre of the rocket.
The mass of the rocket is $m$.
$T$ is the thrust.
The thrust is the only load on the rocket.
$a$ is the magnitude of the acceleration of G relative to N.
";
    assert_eq!(judged(sentences, "$$ m a = T $$\n$$ m a = -T $$\n"), "uu");
}
