//! Systems that change from one part of a document to another, and what frames and points may have in common.

use super::judged;

#[test]
fn a_frame_may_turn_otherwise_on_other_lines() {
    let sentences = "N is an inertial frame.
$\\vec k$ is the third axis of N.
B is a frame fixed in the body.
On lines 2 and 3 B turns relative to N about z by the angle $\\theta$.
On lines 4 and 5 B turns relative to N about z by the angle $\\phi$.
$\\vec\\omega$ is the angular velocity of B relative to N.
";
    let text = r"
$$ \vec\omega = \dot\theta\vec k $$
$$ \vec\omega = 2\dot\theta\vec k $$
$$ \vec\omega = \dot\phi\vec k $$
$$ \vec\omega = 2\dot\phi\vec k $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_distance_of_which_a_rate_is_written_changes() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N about z by the angle $\\theta$.
$\\vec e$, $\\vec f$, $\\vec h$ are the axes of A.
O is a point fixed in N.
P is a particle.
P lies at the distance $r$ from O along $\\vec e$.
$\\vec v$ is the velocity of P relative to N.
";
    let moving = r"
$$ \vec v = \dot r\vec e + r\dot\theta\vec f $$
$$ \vec v = r\dot\theta\vec f $$
";
    assert_eq!(judged(sentences, moving), "pr");
    let fixed = r"
$$ \vec v = r\dot\theta\vec f $$
";
    assert_eq!(judged(sentences, fixed), "p");
}

#[test]
fn two_frames_may_have_an_axis_in_common() {
    let sentences = "N is an inertial frame.
A and B are frames that turn relative to N.
$\\vec a$, $\\vec b$, $\\vec h$ are the axes of A.
$\\vec c$, $\\vec d$, $\\vec h$ are the axes of B.
A turns relative to N about $\\vec h$ by the angle $\\alpha$.
B turns relative to N about $\\vec h$ by the angle $\\beta$.
$\\vec\\omega$ is the angular velocity of B relative to A.
";
    let text = r"
$$ \vec\omega = (\dot\beta - \dot\alpha)\vec h $$
$$ \vec\omega = (\dot\beta + \dot\alpha)\vec h $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_command_that_ends_with_its_frame_says_nothing_of_other_rates() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N.
$\\vec u$ is a vector fixed in A.
$\\vec\\omega$ is the angular velocity of A relative to N.
$\\ddtA$ is the rate seen from A.
$\\frac{d}{dt}$ is the rate seen from N.
";
    let text = r"$$\newcommand{\ddtA}{\frac{{}^{A}d}{dt}}$$
$$ \ddtA\vec u = 0 $$
$$ \frac{d\vec u}{dt} = \vec\omega\times\vec u $$
$$ \frac{d\vec u}{dt} = \vec u\times\vec\omega $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn what_is_built_in_one_part_is_told_of_no_other() {
    let sentences = "N is an inertial frame.
x, y, z are the axes of N.
z is the upward vertical.
O is a point fixed in N.
$g$ is the acceleration of gravity.
On lines 1 to 4 the rod is a uniform thin rod of mass $M$ and length $h$.
D is a frame fixed in the rod.
p, q, r are the axes of D.
H is the mass centre of the rod.
O is a point fixed in D.
H lies at the distance $\\frac{h}{2}$ from O along $-r$.
The rod lies along r with its middle at H.
On lines 1 to 4 D turns relative to N about y by the angle $\\theta$.
The weight and the force at O are the only loads on the rod.
On lines 1 to 4 $J$ is the moment of inertia of the rod about the axis through O along q.
On lines 5 to 9 the ball is a uniform solid sphere of mass $M$ and radius $a$.
S is a frame fixed in the ball.
K is the mass centre of the ball.
On lines 5 to 9 S turns relative to N about y by the angle $\\theta$.
On lines 5 to 9 $J$ is the moment of inertia of the ball about the axis through K along y.
";
    let text = r"
$$ J\ddot\theta = -Mg\tfrac h2\sin\theta $$
$$ J = \tfrac13 Mh^2 $$
$$ J = \tfrac25 Ma^2 $$
$$ J = \tfrac25 Ma^2 $$
$$ J = \tfrac13 Mh^2 $$
";
    assert_eq!(judged(sentences, text), "ppupu");
}

#[test]
fn what_turns_in_one_part_lies_freely_before_it_and_what_is_given_there_holds_in_it() {
    let sentences = r"N is an inertial frame.
A is a frame that turns relative to N about $c$ at the constant rate $n$.
$a$, $b$, $c$ are the axes of A.
B is a frame fixed in the satellite.
$u$, $v$, $w$ are the axes of B.
G is the mass centre of the satellite.
E is a point fixed in N.
$a$ is the unit vector from E to G.
The axes of B are principal axes of the satellite.
$\mathbf J$ is the inertia tensor of the satellite about G.
$J_1$, $J_2$, $J_3$ are the principal moments of the satellite about G on B.
$\mathbf M$ is the total moment on the satellite about G.
$M_1$, $M_2$, $M_3$ are the components of $\mathbf M$ on B.
$a_1$, $a_2$, $a_3$ are the components of $a$ on B.
Line 2 is given.
From line 5 on B turns relative to A about $c$ by the angle $\theta$.
";
    let text = r"
$$ \mathbf M = 3n^2 a\times(\mathbf J\cdot a) $$
$$ M_3 = 3n^2(J_2-J_1)a_1a_2 $$
$$ a_3 = 0 $$
$$ a_3 = 0 $$
$$ J_3\ddot\theta = -3n^2(J_2-J_1)\sin\theta\cos\theta $$
$$ J_3\ddot\theta = 3n^2(J_2-J_1)\sin\theta\cos\theta $$
";
    assert_eq!(judged(sentences, text), "aprppr");
}

/// Where the last part of a whole lies is told by the mass centres of the whole and of the others: the tensor about a point
/// that is fixed stays the same, also beside that about another point.
#[test]
fn the_last_part_lies_where_the_whole_says() {
    let sentences = r"
R is an inertial frame.
K is a frame fixed in the hull.
The probe consists of the hull and the flywheels.
Q is the mass centre of the probe.
Q is a point fixed in K.
D is the mass centre of the hull.
$w$ is the angular velocity of K relative to R.
$J$ is the inertia tensor of the hull about D.
$I$ is the inertia tensor of the hull about Q.
$h$ is the angular momentum of the flywheels about Q relative to R with velocities relative to Q.
$H$ is the angular momentum of the hull about Q relative to R with velocities relative to Q.
$M$ is the total moment on the probe about Q.
$u$ is the rate of $h$ seen from K.
A vector or tensor without a label has components on K.
A dot means the rate seen from K.
";
    let text = r"
$$ H=I w $$
$$ H=J w $$
$$ \dot I=0 $$
$$ M=u+I\dot w+w\times(H+h) $$
$$ M=u+I\dot w-w\times(H+h) $$
$$ M=u+J\dot w+w\times(H+h) $$
";
    assert_eq!(judged(sentences, text), "prpprr");
}

const TWO_ON_A_ROD: &str = r"N is an inertial frame.
B is a frame fixed in the rod.
$u$, $v$, $w$ are the axes of B.
B turns relative to N about $w$ by the angle $q$.
O is the mass centre of the rod.
O is fixed in N.
$J$ is the moment of inertia of the rod about $w$.
P is placed from O by $l u$.
Q is placed from O by $-l u$.
$T$ is the kinetic energy of the mechanism relative to N.
";

const ENERGIES: &str = r"
$$ T=\left(\frac12 J+c l^2\right)\dot q^2 $$
$$ T=\left(\frac12 J+\frac12 c l^2\right)\dot q^2 $$
";

#[test]
fn things_of_one_noun_are_meant_by_its_plural() {
    let sentences = format!(
        "{TWO_ON_A_ROD}P is a collar.\nQ is a collar.\nEach collar is a particle of mass $c$.\nThe mechanism consists of the rod and the collars.\n"
    );
    assert_eq!(judged(&sentences, ENERGIES), "pr");
}
