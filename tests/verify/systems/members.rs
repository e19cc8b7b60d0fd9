//! Bodies with particles that move on them, like members, several things of one kind, and motions near another.

use super::judged;

/// A hub in whose bore beads slide.
const BEADS: &str = "N is an inertial frame, and O is a point fixed in it.
B is a frame fixed in the hub, Q a point fixed in B.
The craft consists of the hub and the particles.
$j$ numbers the particles.
$m_j$ is the mass of particle $j$.
G is the mass centre of the hub, C that of the craft.
$M$ and $m$ are the masses of the hub and of the craft.
$P_j$ is a point fixed in B.
$\\hat p_j$ is a unit vector fixed in B.
Particle $j$ lies at the distance $s_j$ from $P_j$ along $\\hat p_j$.
$\\vec g$, $\\vec a_j$ and $\\vec r_j$ are the positions of G, of $P_j$ and of particle $j$ from Q.
$\\vec c$ is the position of C from Q, $\\vec R$ that of Q from O.
$\\vec\\omega$ is the angular velocity of B relative to N.
$J$ is the inertia tensor of the hub about G, $K$ that of the craft about Q.
$\\vec F$ is the total force on the craft.
$\\vec H$ is the angular momentum of the craft about Q relative to N with velocities relative to Q.
A dot means the rate seen from N, and a prime the rate seen from B.
";

#[test]
fn particles_slide_on_a_hub() {
    let text = r"
$$ \vec r_j = \vec a_j + s_j\hat p_j $$
$$ \vec r_j'' = \ddot s_j\hat p_j $$
$$ m\vec c = M\vec g + \sum_j m_j\vec r_j $$
$$ m\vec c' = \sum_j m_j\dot s_j\hat p_j $$
$$ m\vec c' = \sum_j m_j s_j\hat p_j $$
$$ \vec F = m\ddot{\vec R} + m\ddot{\vec c} $$
$$ \vec F = m\ddot{\vec R} + M\ddot{\vec g} $$
$$ \vec H = J\vec\omega + M\vec g\times\dot{\vec g} + \sum_j m_j\vec r_j\times\dot{\vec r}_j $$
$$ \vec H = J\vec\omega + M\vec g\times\dot{\vec g} - \sum_j m_j\vec r_j\times\dot{\vec r}_j $$
$$ \vec H = K\vec\omega + \sum_j m_j\vec r_j\times\vec r_j' $$
";
    assert_eq!(judged(BEADS, text), "pppprprprp");
}

#[test]
fn lengths_of_members_stand_under_sums() {
    let sentences = "N is an inertial frame with the axes x, y, z.
O is a point fixed in N and in the body.
The body consists of $n$ particles, numbered by $k$.
$m_k$ is the mass of particle $k$.
$\\vec r_k$ is the position of particle $k$ from O, and $r_k$ its magnitude.
$\\vec\\omega$ is the angular velocity of the body relative to N.
$\\vec J$ is the angular momentum of the body about O relative to N.
";
    let text = r"
$$ \vec J = \sum_k m_k[r_k^2\vec\omega - (\vec r_k\cdot\vec\omega)\vec r_k] $$
$$ \vec J = \sum_k m_k[r_k^2\vec\omega + (\vec r_k\cdot\vec\omega)\vec r_k] $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn entries_are_told_by_indices() {
    let sentences = "N is an inertial frame with the axes x, y, z.
O is a point fixed in N and in the body.
$\\hat I$ is the inertia tensor of the body about O in components on N, with the entries $I_{\\alpha\\beta}$.
$\\alpha$ and $\\beta$ number the axes of N.
$\\omega$ is the angular velocity of the body relative to N.
$\\omega_x$, $\\omega_y$, $\\omega_z$ are the components of $\\omega$ on N.
$J$ is the angular momentum of the body about O relative to N.
$J_x$, $J_y$, $J_z$ are the components of $J$ on N.
Products of inertia are entries.
";
    let text = r"
$$ J_\alpha = \sum_\beta I_{\alpha\beta}\omega_\beta $$
$$ J_x = I_{xx}\omega_x + I_{xy}\omega_y + I_{xz}\omega_z $$
$$ J_x = I_{xx}\omega_x - I_{xy}\omega_y + I_{xz}\omega_z $$
$$ I_{\alpha\beta} = I_{\beta\alpha} $$
";
    assert_eq!(judged(sentences, text), "pprp");
}

#[test]
fn a_body_without_a_frame_has_an_inertia_all_the_same() {
    let sentences = "C is the mass centre of the wheel.
$J$ is the inertia tensor of the wheel about C.
$L$ is the total moment on the wheel about C.
";
    let text = r"
$$ L = 0 $$
$$ J = 2J $$
";
    assert_eq!(judged(sentences, text), "rr");
}

#[test]
fn one_point_may_be_the_mass_centre_of_several_bodies() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the bus.
The craft consists of the bus and the wheel.
G is the mass centre of the bus and also of the wheel.
$n$ is a unit vector fixed in B.
Relative to B the wheel turns about $n$ at the rate $\\Omega$.
$H$ is the angular momentum of the craft about G relative to N.
$L$ is the total moment on the craft about G.
A dot means the rate seen from N.
";
    let text = r"
$$ \dot H = L $$
$$ \dot H = 2L $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// The spin of a free body near a principal axis.
const NEAR: &str = "N is an inertial frame.
B is a frame fixed in the body.
The axes of B are principal axes of the body.
G is the mass centre of the body.
No moment acts on the body about G.
$A$, $D$, $C$ are the principal moments of the body about G on B.
$\\omega$ is the angular velocity of the body relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\omega$ on B.
$\\nu$ is the reference value of $\\omega$, and $\\epsilon$ its small disturbance.
$\\nu_1$, $\\nu_2$, $\\nu_3$ are the components of $\\nu$ on B, $\\epsilon_1$, $\\epsilon_2$, $\\epsilon_3$ those of $\\epsilon$.
The reference values obey the equations of motion.
$\\nu_2 = 0$.
$\\nu_3 = 0$.
Lines 3 to 7 hold to first order in $\\epsilon_1$, $\\epsilon_2$, $\\epsilon_3$.
";

#[test]
fn disturbances_obey_the_linear_equations() {
    let text = r"
$$ \omega = \nu + \epsilon $$
$$ \dot\epsilon_1 = 0 $$
$$ D\dot\epsilon_2 = (C - A)\nu_1\epsilon_3 $$
$$ D\dot\epsilon_2 = (A - C)\nu_1\epsilon_3 $$
$$ C\dot\epsilon_3 = (A - D)\nu_1\epsilon_2 $$
$$ D C\ddot\epsilon_2 = (C - A)(A - D)\nu_1^2\epsilon_2 $$
";
    assert_eq!(judged(NEAR, text), "ppprpp");
}

#[test]
fn its_disturbance_is_that_of_the_letter_and_not_of_its_reference_value() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$\\omega$ is the angular velocity of the body relative to N.
$\\nu$ is the reference value of $\\omega$, and $\\epsilon$ its small disturbance, with the components $a$, $b$, $c$ on B.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\omega$ on B, $\\nu_1$, $\\nu_2$, $\\nu_3$ those of $\\nu$.
";
    let text = r"
$$ \omega = \nu + \epsilon $$
$$ \omega_2 = \nu_2 + b $$
$$ \omega_2 = \nu_2 + a $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_frame_may_be_called_by_its_kind() {
    let sentences = "The lab frame is an inertial frame.
The body frame is a frame fixed in the body.
O is a point fixed in the lab frame and in the body frame.
$\\omega$ is the angular velocity of the body relative to the lab frame.
$u$ is a vector fixed in the body frame.
$v$ is the rate of $u$ seen from the lab frame.
";
    let text = r"
$$ v = \omega\times u $$
$$ v = u\times\omega $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn matrices_and_positions_are_told_for_any_frames_and_points() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
C is a frame that is turned relative to B.
O is a point fixed in N.
P is a point fixed in B.
Q is a point fixed in B.
$R_{XY}$ takes components on Y to components on X, for any frames X and Y.
$\\vec r_{XY}$ is the position of Y from X, for any points X and Y.
";
    let text = r"
$$ R_{NC} = R_{NB}R_{BC} $$
$$ R_{NC} = R_{BC}R_{NB} $$
$$ R_{CB} = R_{BC}^T $$
$$ \vec r_{OQ} = \vec r_{OP} + \vec r_{PQ} $$
$$ \vec r_{OQ} = \vec r_{OP} - \vec r_{PQ} $$
";
    assert_eq!(judged(sentences, text), "prppr");
}

#[test]
fn sums_begin_where_the_document_begins_them_and_a_dotted_label_is_another_one() {
    let sentences = "N is an inertial frame.
The body consists of particles.
$i$ numbers the particles.
B is a frame fixed in the body.
O is a point fixed in N and in B.
$\\vec r_i$ is the position of particle $i$ from O.
$m_i$ is the mass of particle $i$.
$\\vec p$ is the momentum of the body relative to N.
$\\hat n_s$ is a unit vector fixed in B.
A dot means the rate seen from N.
A prime means the rate seen from B.
";
    let text = r"
$$ \vec p = \sum_{i=1}^n m_i\dot{\vec r}_i $$
$$ \sum_{i=1}^n m_i\dot{\vec r}_i = \vec p $$
$$ \vec p = \sum_{i=-1}^n m_i\dot{\vec r}_i $$
$$ \hat n_s' = 0 $$
$$ \hat n_{\dot s}' = 0 $$
";
    assert_eq!(judged(sentences, text), "ppupu");
}

#[test]
fn members_are_placed_along_unit_vectors_of_their_own() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the hub.
O is a point fixed in B.
The craft consists of the hub and the particles.
$j$ numbers the particles.
$P_j$ is a point fixed in B.
$\\hat p_j$ is a unit vector fixed in B.
Particle $j$ is placed from $P_j$ by $\\rho_j\\hat p_j$.
$m_j$ is the mass of particle $j$.
$m$ is the mass of the craft.
C is the mass centre of the craft.
$\\vec c$ is the position of C from O.
A prime means the rate seen from B.
";
    let text = r"
$$ \vec c' = \frac1m\sum_j m_j\dot\rho_j\hat p_j $$
$$ \vec c' = \sum_j m_j\dot\rho_j\hat p_j $$
$$ \vec c'' = \frac1m\sum_j m_j\ddot\rho_j\hat p_j $$
";
    assert_eq!(judged(sentences, text), "prp");
}
