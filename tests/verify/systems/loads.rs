//! Forces at points, blows, and the forces that a turning frame adds.

use super::{judged, verdicts};

/// Mahony, Kumar and Corke, Multirotor aerial vehicles, IEEE Robotics & Automation Magazine 19 (2012), equations 1 and 4,
/// with arms along the axes and z up.
#[test]
fn a_quadrotor_with_thrusts_at_points() {
    let sentences = "N is an inertial frame.
$Z$ is the upward vertical.
B is a frame fixed in the drone.
x, y, z are the axes of B.
$\\vec i$, $\\vec j$, $\\vec k$ are the axes of B.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to N in the order z, y, x.
The drone is a rigid body of mass $m$.
G is the mass centre of the drone.
P1 lies at the distance $l$ from G along $\\vec i$.
P2 lies at the distance $l$ from G along $\\vec j$.
P3 lies at the distance $-l$ from G along $\\vec i$.
P4 lies at the distance $-l$ from G along $\\vec j$.
The thrust $f_1$ acts at P1 along $\\vec k$.
The thrust $f_2$ acts at P2 along $\\vec k$.
The thrust $f_3$ acts at P3 along $\\vec k$.
The thrust $f_4$ acts at P4 along $\\vec k$.
The moment $q$ acts on the drone along $\\vec k$.
$g$ is the acceleration of gravity.
The weight, the thrusts $f_1$, $f_2$, $f_3$ and $f_4$ and the moment $q$ are the only loads on the drone.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\vec\\omega$ on B.
$A$, $B$, $C$ are the principal moments of the drone about G on B.
$\\vec a$ is the acceleration of G relative to N.
$\\vec M$ is the moment of $f_2$ about G.
";
    let text = r"
$$ A\dot\omega_1 = (B - C)\omega_2\omega_3 + l(f_2 - f_4) $$
$$ B\dot\omega_2 = (C - A)\omega_3\omega_1 + l(f_3 - f_1) $$
$$ C\dot\omega_3 = (A - B)\omega_1\omega_2 + q $$
$$ A\dot\omega_1 = (B - C)\omega_2\omega_3 + l(f_4 - f_2) $$
$$ B\dot\omega_2 = (A - C)\omega_3\omega_1 + l(f_3 - f_1) $$
$$ m\,\vec a\cdot\vec k = f_1 + f_2 + f_3 + f_4 - m g\cos\theta\cos\phi $$
$$ m\,\vec a\cdot\vec k = f_1 + f_2 + f_3 + f_4 - m g\sin\theta\cos\phi $$
$$ \vec M = l f_2\,\vec i $$
$$ \vec M = -l f_2\,\vec i $$
";
    assert_eq!(judged(sentences, text), "ppprrprpr");
}

/// Lamb, Dynamics, 1923, article 68: a rod that hangs from one end turns about it under a blow; one at two thirds of its
/// length is not felt at the support.
#[test]
fn a_blow_on_a_rod_at_rest() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the rod.
$\\vec i$, $\\vec j$, $\\vec k$ are the axes of B.
B turns relative to N about z by the angle $\\alpha$.
O is a point fixed in N and in B.
The rod is a rigid body of mass $m$.
G is the mass centre of the rod.
G lies at the distance $a$ from O along $\\vec i$.
P lies at the distance $b$ from O along $\\vec i$.
$A$, $B$, $C$ are the principal moments of the rod about G on B.
The impulse $J$ acts at P along $\\vec j$.
The impulse $J$ and the impulse $\\vec R$ at O are the only impulses on the rod.
The rod is at rest before the impulse.
";
    let text = r"
$$ (C + m a^2)\dot\alpha = b J $$
$$ (C + m a^2)\dot\alpha = a J $$
$$ (C + m a^2)\,\vec R = (m a b - C - m a^2) J\,\vec j $$
$$ (C + m a^2)\,\vec R = (C + m a^2 - m a b) J\,\vec j $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_blow_on_a_free_body() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
P is a point fixed in B.
$m$ is the mass of the body.
$\\mathbf I$ is the inertia tensor of the body about G.
$\\vec r$ is the position of P from G.
$\\vec v$ is the velocity of G relative to N.
$\\vec\\omega$ is the angular velocity of B relative to N.
$T$ is the kinetic energy of the body relative to N.
$\\vec u$ is the velocity of P relative to N.
The impulse $\\vec J$ acts at P.
The impulse $\\vec J$ is the only impulse on the body.
The body is at rest before the impulse.
";
    let text = r"
$$ m\vec v = \vec J $$
$$ \mathbf I\vec\omega = \vec r\times\vec J $$
$$ T = \tfrac12\vec J\cdot\vec u $$
$$ \mathbf I\vec\omega = \vec J\times\vec r $$
$$ T = \vec J\cdot\vec u $$
";
    assert_eq!(judged(sentences, text), "ppprr");
    let restless = sentences.replace("The body is at rest before the impulse.\n", "");
    assert!(!judged(&restless, text).contains(['p', 'r']));
}

const TURNING: &str = "N is an inertial frame.
A is a frame that turns relative to N.
O is a point fixed in N and in A.
$\\vec\\Omega$ is the angular velocity of A relative to N.
A prime means the rate seen from A.
";

/// Landau and Lifshitz, Mechanics, section 39.
#[test]
fn forces_on_a_particle_in_a_turning_frame() {
    let sentences = format!(
        "{TURNING}P is a particle of mass $m$.
$\\vec r$ is the position of P from O.
$\\vec v$ is the velocity of P relative to A.
$\\vec F$ is the total force on P.
$\\vec C$ is the Coriolis force on P in A.
$\\vec Z$ is the centrifugal force on P in A.
$\\vec E$ is the Euler force on P in A.
$\\vec K$ is the moment of $\\vec C$ about O.
"
    );
    let text = r"
$$ m\vec v' = \vec F + \vec C + \vec Z + \vec E $$
$$ \vec C = 2 m\,\vec v\times\vec\Omega $$
$$ \vec Z = m\,\vec\Omega\times(\vec r\times\vec\Omega) $$
$$ \vec E = m\,\vec r\times\dot{\vec\Omega} $$
$$ \vec K = \vec r\times\vec C $$
$$ \vec C = m\,\vec v\times\vec\Omega $$
$$ \vec Z = m\,\vec\Omega\times(\vec\Omega\times\vec r) $$
$$ m\vec v' = \vec F + \vec C + \vec Z - \vec E $$
";
    assert_eq!(judged(&sentences, text), "ppppprrr");
}

/// Routh, Advanced Rigid Dynamics, chapter I: what moves the body as the turning axes see it are the moments of the
/// loads and of the three forces.
#[test]
fn moments_of_these_forces_on_a_body() {
    let sentences = format!(
        "{TURNING}B is a frame fixed in the body.
G is the mass centre of the body.
$m$ is the mass of the body.
$\\mathbf I$ is the inertia tensor of the body about G.
$\\vec L$ is the angular momentum of the body about G relative to A.
$\\vec M$ is the total moment on the body about G.
$\\vec r$ is the position of G from O.
$\\vec K$ is the moment of the Coriolis force on the body in A about G.
$\\vec Z$ is the moment of the centrifugal force on the body in A about G.
$\\vec E$ is the moment of the Euler force on the body in A about G.
$\\vec S$ is the moment of the Euler force on the body in A about O.
"
    );
    let text = r"
$$ \vec L' = \vec M + \vec K + \vec Z + \vec E $$
$$ \vec Z = -\vec\Omega\times\mathbf I\vec\Omega $$
$$ \vec E = -\mathbf I\dot{\vec\Omega} $$
$$ \vec S = \vec E - m\vec r\times(\dot{\vec\Omega}\times\vec r) $$
$$ \vec L' = \vec M + \vec K - \vec Z + \vec E $$
$$ \vec Z = \vec\Omega\times\mathbf I\vec\Omega $$
";
    assert_eq!(judged(&sentences, text), "pppprr");
}

#[test]
fn sums_of_these_forces_over_particles() {
    let sentences = format!(
        "{TURNING}B is a frame fixed in the body.
The body consists of particles.
$i$ numbers the particles.
$m_i$ is the mass of particle $i$.
$\\vec r_i$ is the position of particle $i$ from O.
$\\vec C_i$ is the Coriolis force on particle $i$ in A.
$\\vec p$ is the momentum of the body relative to A.
"
    );
    let text = r"
$$ \sum_i \vec C_i = 2\vec p\times\vec\Omega $$
$$ \sum_i \vec C_i = \vec p\times\vec\Omega $$
";
    assert_eq!(judged(&sentences, text), "pr");
}

#[test]
fn what_acts_from_outside_needs_no_sentence_of_its_own() {
    let sentences = "\
N is an inertial frame whose third axis points vertically down.
B is a frame fixed in the glider.
$\\phi$ is the roll angle of B relative to N.
G is the mass centre of the glider, and $m$ is the mass of the glider.
$\\vec v$ is the velocity of G relative to N.
$\\vec F$ is the force of the air on the glider.
The force of the air and the weight are the only forces on the glider.
$\\vec g$ is the acceleration of gravity.
A dot means the rate seen from N.
";
    let text = r"
$$ m\dot{\vec v}=\vec F+m\vec g $$
$$ m\dot{\vec v}=\vec F-m\vec g $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn forces_act_at_points_that_are_only_placed() {
    let sentences = "\
N is an inertial frame.
$\\hat x$, $\\hat y$, $\\hat z$ are the axes of B, a frame fixed in the drone.
G is the mass centre of the drone.
The forces $f\\hat z$ and $h\\hat z$ act at the points $a\\hat x$ and $-a\\hat x$ from G, respectively.
These forces and the weight are the only loads on the drone.
$A$, $B_2$, $C$ are the principal moments of the drone about G on B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
";
    let text = r"
$$ B_2\dot q=(C-A)rp-a(f-h) $$
$$ B_2\dot q=(C-A)rp+a(f-h) $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn about_an_axis_only_its_component_vanishes() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the rotor with the axes x, y, z.
G is a point fixed in N, and the mass centre of the rotor.
No moment acts on the rotor about the axis through G along z.
$\\vec H$ is the angular momentum of the rotor about G relative to N.
A dot means the rate seen from N.
";
    let text = r"
$$ \dot{\vec H}\cdot\hat z=0 $$
$$ \dot{\vec H}=0 $$
";
    let got = verdicts(sentences, text).0;
    assert!(!got[1..].contains('p'), "{got}");
}

#[test]
fn all_that_acts_on_a_particle_acts_where_it_is() {
    let sentences = r"
N is an inertial frame.
P is a particle of mass $m$.
O is a point fixed in N.
$F$ is the total force on P.
$M$ is the moment of $F$ about O.
$r$ is the position of P from O.
";
    let text = r"
$$ M = r\times F $$
$$ M = F\times r $$
";
    assert_eq!(judged(sentences, text), "pr");
}
