//! Forms of sentences: clauses aside, circumstances in front, names by nouns, and what follows from the forms of names.

use super::judged;

/// Asides about the subject, about a noun behind a preposition, and two in each other.
#[test]
fn asides_are_clauses_of_their_own() {
    let sentences = "\
N is an inertial frame whose axes are $\\hat x$, $\\hat y$ and $\\hat z$.
The shaft, to which the frame S is attached, turns relative to N about $\\hat z$ by the angle $\\alpha$.
O is a point that is fixed in N and in S.
P is a point, which is placed from O by $b\\hat s$, where $\\hat s$ is the first axis of S.
$b$ is constant.
$v$ is the magnitude of the velocity of P relative to N.
";
    let text = r"
$$ v^2=b^2\dot\alpha^2 $$
$$ v^2=b\dot\alpha^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// The name of the laboratory is that of its frame in all sentences.
#[test]
fn the_laboratory_has_the_name_of_its_frame() {
    let sentences = "\
The laboratory L is an inertial frame with the axes X, Y, Z.
B is a frame fixed in the top.
B is reached from L by the Euler angles $\\alpha$, $\\beta$, $\\gamma$ in the order z, x, z.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on B of the angular velocity $\\vec w$ of the top relative to the laboratory.
";
    let text = r"
$$ \omega_3=\dot\gamma+\dot\alpha\cos\beta $$
$$ \omega_3=\dot\gamma+\dot\alpha\sin\beta $$
$$ \vec w\cdot\vec w=\omega_1^2+\omega_2^2+\omega_3^2 $$
";
    assert_eq!(judged(sentences, text), "prp");
}

/// The ends of a rod that is called by two points; a rod of another name says nothing of where it ends.
#[test]
fn a_rod_ends_at_the_points_of_its_name() {
    let sentences = "\
N is an inertial frame whose axes are $\\hat x$, $\\hat y$ and $\\hat z$.
$\\hat y$ is the upward vertical.
The rod CD is thin and uniform, has the mass $m$ and the length $b$, and is hinged at C.
C is a point fixed in N.
The rod CD turns in N about the axis through C along $\\hat z$.
The angle of the rod with the downward vertical is $\\beta$, counted positive about $\\hat z$.
G is the mass centre of the rod CD.
$r$ is the position of G from C.
$J$ is the moment of inertia of the rod about the axis through C along $\\hat z$.
";
    let text = r"
$$ r=\frac b2(\sin\beta\,\hat x-\cos\beta\,\hat y) $$
$$ r=\frac b2(\sin\beta\,\hat x+\cos\beta\,\hat y) $$
$$ J=\frac13mb^2 $$
$$ J=\frac14mb^2 $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

/// Particles that are placed by letters, and the mass centre of their system.
#[test]
fn letters_by_which_particles_are_placed_are_their_positions() {
    let sentences = "\
S is an inertial frame with the fixed point O.
The system consists of particles, which are numbered by $k$.
Particle $k$ has the mass $m_k$ and is placed from O by $\\mathbf a_k$.
G is the mass centre of the system, and its position from O is $\\mathbf c$.
$M$ is the mass of the system.
";
    let text = r"
$$ M\mathbf c=\sum_k m_k\mathbf a_k $$
$$ M\mathbf c=2\sum_k m_k\mathbf a_k $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// A vertical that is an axis of a frame fixed in the inertial one.
#[test]
fn the_vertical_is_an_axis_of_a_frame_that_is_kept() {
    let sentences = "\
N is an inertial frame.
E is a frame fixed in N; its third axis points downward.
B is a frame fixed in the aircraft.
$a$, $b$, $c$ are the Euler angles of B relative to E in the order z, y, x.
$X$, $Y$, $Z$ are the components on B of the weight of the aircraft.
$m$ is the mass of the aircraft.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ X=-mg\sin b $$
$$ X=mg\sin b $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// Frames of aircraft, whose axes point forward and to the right, and the plain names of the angles.
#[test]
fn axes_of_aircraft_are_named_by_where_they_point() {
    let sentences = "\
The North-East-Down frame n is regarded as inertial, with x to the north, y to the east and z down.
The body frame b of the glider has the axes u forward, v to the right and w down.
b is turned relative to n by the yaw $\\psi$ about the third axis, then by the pitch $\\theta$ about the second and at last by the roll $\\phi$ about the first axis.
$p$, $q$, $r$ are the components on b of the angular velocity of b relative to n.
";
    let text = r"
$$ p=\dot\phi-\dot\psi\sin\theta $$
$$ p=\dot\phi+\dot\psi\sin\theta $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// The first of the turns of the sentence before, and an axis that a frame carries.
#[test]
fn frames_are_turned_by_the_first_rotations() {
    let sentences = "\
N is an inertial frame.
$\\psi$, $\\theta$, $\\varphi$ are the Euler angles of the top relative to N in the order 3, 1, 3.
F is the frame that is turned relative to N by the first two of these rotations, and its axes are $e_1$, $e_2$, $e_3$.
$\\mathbf w$ is the angular velocity of F relative to N.
";
    let text = r"
$$ \mathbf w=\dot\theta e_1+\dot\psi\sin\theta e_2+\dot\psi\cos\theta e_3 $$
$$ \mathbf w=\dot\theta e_1+\dot\psi\cos\theta e_2+\dot\psi\sin\theta e_3 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// The angles and their rates, by the letters that they have.
#[test]
fn the_angles_and_their_rates_are_small() {
    let sentences = "\
N is an inertial frame, and B is a frame fixed in the body.
$\\alpha$, $\\beta$ and $\\gamma$ are the Euler angles of B relative to N in the order z, y, x.
The angles and their rates are small, and all lines hold to first order in them.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
";
    let text = r"
$$ p=\dot\gamma $$
$$ r=\dot\alpha $$
$$ q=\dot\alpha $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

/// Derivatives of the Lagrangian, the moments along axes, and quaternions by what they take.
#[test]
fn nouns_say_what_formulas_and_verbs_say() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the top, and its axes $\\hat s$, $\\hat t$ and $\\hat u$ are principal axes of the top.
The top turns relative to N about $\\hat s$ by the angle $\\varphi$.
O is a point fixed in N and in the top.
The moments of inertia of the top about O are $J$ along $\\hat s$ and $K$ along $\\hat t$ and $\\hat u$.
$T$ is the kinetic energy of the top relative to N.
$p$ is the derivative of $T$ by $\\dot\\varphi$.
";
    let text = r"
$$ T=\tfrac12J\dot\varphi^2 $$
$$ T=\tfrac12K\dot\varphi^2 $$
$$ p=J\dot\varphi $$
$$ p=2J\dot\varphi $$
";
    assert_eq!(judged(sentences, text), "prpr");
}
