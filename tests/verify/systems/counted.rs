//! Things that are counted, axes that follow from symmetry, and letters that parts of a document tell.

use super::judged;

#[test]
fn crossed_rods_have_particles_at_their_ends() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the cross.
x, y, z are the axes of B.
The cross consists of two thin uniform rods and four particles.
The rods lie along the axes x and y of B with their middles at G.
The rods are uniform thin rods of mass $M$ and of the lengths $a$ and $b$, respectively.
The particles have equal masses and lie at the ends of the rods.
$m$ is the mass of particle 1.
G is the mass centre of the cross.
$I$ is the inertia tensor of the cross about G in components on B.
";
    let text = r"
$$ I_{12} = 0 $$
$$ I_{11} = \tfrac{1}{12} M b^2 + \tfrac{1}{2} m b^2 $$
$$ I_{11} = \tfrac{1}{12} M a^2 + \tfrac{1}{2} m a^2 $$
$$ I_{33} = I_{11} + I_{22} $$
$$ I_{33} = I_{11} - I_{22} $$
";
    assert_eq!(judged(sentences, text), "pprpr");
}

#[test]
fn masses_that_are_equal_are_the_same() {
    let sentences = "P and Q are particles.
P and Q have equal masses.
$m$ and $M$ are the masses of P and Q.
";
    assert_eq!(judged(sentences, "\n$$ m = M $$\n\n$$ m = 2 M $$\n"), "pr");
}

#[test]
fn sizes_count_in_whichever_sentence_they_stand() {
    let sentences = "N is an inertial frame.
The rod is a thin rod.
The rod is a uniform thin rod of mass $m$ and length $2\\ell$.
G is the mass centre of the rod.
x, y, z are the axes of the rod.
The rod lies along x.
$I$ is the inertia tensor of the rod about G in components on the rod.
";
    let text = r"
$$ I_{22} = \tfrac{1}{3} m \ell^2 $$
$$ I_{22} = \tfrac{1}{12} m \ell^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn frames_at_rest_in_one_body_carry_the_same_points() {
    let sentences = "N is an inertial frame.
A is a frame fixed in the body.
B is a frame fixed in the body.
O is a point fixed in N and in A.
$\\omega$ is the angular velocity of the body relative to N.
$J$ is the inertia tensor of the body about O.
$\\vec L$ is the angular momentum of the body about O relative to N.
";
    let text = r"
$$ \vec L = J \omega $$
$$ \vec L = 2 J \omega $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_is_symmetric_about_a_vector_of_another_frame_turns_about_it() {
    let sentences = "N is an inertial frame.
$\\hat z$ is the upward vertical.
A is a frame that turns relative to N about $\\hat z$.
A turns relative to N about $\\hat z$ at the constant rate $\\Omega$.
The floor is a horizontal plane fixed in N.
The wheel is a uniform thin disc of mass $m$ and radius $r$.
G is the mass centre of the wheel.
C is the point where the wheel touches the floor.
The wheel rolls on the floor at C without slipping.
O is a point fixed in N and in A.
$\\hat n$ is a unit vector fixed in A.
The angle between $\\hat n$ and $\\hat z$ is $\\pi/2$.
G lies at the distance $b$ from O along $\\hat n$.
The wheel is symmetric about $\\hat n$.
$\\omega$ is the angular velocity of the wheel relative to N along $\\hat n$.
$\\vec H$ is the angular momentum of the wheel about G relative to N.
";
    let text = r"
$$ r \omega = -b \Omega $$
$$ r \omega = b \Omega $$
$$ \vec H = \tfrac{1}{4} m r^2 \Omega \hat z - \tfrac{1}{2} m r b \Omega \hat n $$
$$ \vec H = \tfrac{1}{4} m r^2 \Omega \hat z + \tfrac{1}{2} m r b \Omega \hat n $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn axes_with_names_of_their_own_are_the_same_in_their_order_where_an_angle_is_zero() {
    let sentences = "W is an inertial frame.
X, Y, Z are the axes of W.
F turns relative to W about Z by the angle $\\psi$.
u, v, w are the axes of F.
H turns relative to F about v by the angle $\\theta$.
a, b, c are the axes of H.
B turns relative to H about a by the angle $\\phi$.
$\\omega$ is the angular velocity of B relative to W in components on B.
$p$ and $q$ are the components of $\\omega$ along the first and second axes of B.
";
    let text = r"
$$ p = \dot\phi - \dot\psi \sin\theta $$
$$ p = \dot\phi + \dot\psi \sin\theta $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_with_a_meaning_in_each_part_is_spoken_of_in_each() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the rotor.
G is the mass centre of the rotor.
O is a point fixed in B.
On line 2 $J$ is the inertia tensor of the rotor about G in components on B.
On line 4 $J$ is the inertia tensor of the rotor about O in components on B.
$a$ is the entry (1, 1) of $J$.
";
    let text = "\n$$ a = J_{11} $$\n\n$$ a = J_{11} $$\n";
    assert_eq!(judged(sentences, text), "pp");
}

#[test]
fn a_sentence_about_all_lines_may_speak_of_a_letter_of_some() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
The axes of B are principal axes of the body.
G is the mass centre of the body.
No moment acts on the body about G.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on B of the angular velocity of the body relative to N.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.
On lines 4 to 20 $n$ is the reference value of $\\omega_3$, and $\\epsilon_3$ its small disturbance.
On lines 4 to 20 $n$ is constant.
All lines hold to first order in $\\omega_1$, $\\omega_2$ and $\\epsilon_3$.
";
    let text = r"
$$ I_1 \dot\omega_1 = (I_2 - I_3) \omega_3 \omega_2 $$

$$ I_1 \dot\omega_1 = (I_2 - I_3) n \omega_2 $$

$$ I_1 \dot\omega_1 = (I_3 - I_2) n \omega_2 $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_letter_under_a_sign_for_vectors_is_one() {
    let sentences = "A wide hat means the cross-product matrix.
$a$ and $b$ are any vectors.
";
    let text = r"
$$ \widehat{a} b = a \times b $$
$$ \widehat{X}^T b = b \widehat{X}^T $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_value_at_zero_is_no_product() {
    let sentences = "N is an inertial frame.
$\\omega$ is a function of the time.
$c$ is constant.
";
    assert_eq!(judged(sentences, "\n$$ \\omega(0) = c $$\n"), "u");
}

#[test]
fn the_first_two_components_are_the_first_and_the_second() {
    let sentences = "N is an inertial frame.
$\\vec F$ is a vector.
$f$ and $g$ are the first two components of $\\vec F$ on N.
$a$, $b$, $c$ are the components of $\\vec F$ on N.
";
    let text = r"
$$ f = a $$
$$ g = b $$
$$ g = a $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn what_a_line_defines_has_no_partial_derivative_by_its_name_alone() {
    let sentences = "N is an inertial frame.
$\\alpha$ is a function of the time.
$c$ is constant.
$\\frac{\\partial}{\\partial\\alpha}$ takes functions of $\\alpha$ and $\\dot\\alpha$.
Line 2 defines $K_1$.
";
    let text = r"
$$ K_1 = c \dot\alpha^2 + c \cos\alpha $$
$$ \frac{\partial K_1}{\partial\alpha} = 0 $$
";
    assert_eq!(judged(sentences, text), "au");
}

#[test]
fn a_line_to_first_order_is_not_proved_by_dividing_by_the_sine_of_a_small_angle() {
    let sentences = "N is an inertial frame.
$\\theta$ and $x$ are functions of the time.
$a$ and $b$ are constant.
$a x \\sin\\theta = b \\theta \\sin\\theta$.
All lines hold to first order in $\\theta$ and $x$.
";
    let text = r"
$$ a x = 2 b \theta $$
";
    assert_eq!(judged(sentences, text), "r");
}

#[test]
fn to_first_order_the_squares_of_lengths_tell_nothing() {
    let sentences = "N is an inertial frame.
$\\theta$ is a function of the time.
$\\vec a$ is a vector.
$s$ is the magnitude of $\\vec a$.
All lines hold to first order in $\\theta$.
";
    let text = r"
$$ s \sin\theta = s \theta $$
$$ s \theta = 2 s \theta $$
";
    assert_eq!(judged(sentences, text), "pr");
}
