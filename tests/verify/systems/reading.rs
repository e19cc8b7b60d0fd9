//! How sentences are read together, and how many of them a line needs.

use super::{judged, judged_in_any_order};

#[test]
fn letters_may_be_told_by_sentences_in_any_order() {
    let sentences = [
        "A is an inertial frame.",
        "B is a frame fixed in the body.",
        "$p$, $q$ and $r$ are the components of $\\vec\\omega$ on B.",
        "$\\vec\\omega$ is the same as $\\vec\\omega_{B/A}$.",
        "$\\vec\\omega_{B/A}$ is the angular velocity of B relative to A.",
        "$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to A in the order z, y, x.",
    ];
    let text = r"
$$ p = \dot\phi - \dot\psi\sin\theta $$
$$ r = \dot\psi\cos\phi\cos\theta + \dot\theta\sin\phi $$
";
    judged_in_any_order(&sentences, text, "pr");
}

#[test]
fn a_line_needs_no_letters_of_which_it_does_not_speak() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the rotor.
O is a point fixed in N and in B.
No moment acts on the rotor about O.
The axes of B are principal axes of the rotor.
$e$ is the third axis of B.
$k$ is the third axis of N.
$\\phi$, $\\theta$, $\\psi$ are the Euler angles of B relative to N in the order 3, 1, 3.
$\\sin\\theta$ is not zero.
$\\vec\\omega$ is the angular velocity of B relative to N; $\\omega$ is its magnitude.
$A$, $A$, $C$ are the principal moments of the rotor about O on B.
$\\vec L$ is the angular momentum of the rotor about O relative to N.
The angle between $\\vec\\omega$ and $e$ is $\\alpha$.
$p$ is the component of $\\vec L$ along $k$.
$q$ is the component of $\\vec L$ along $e$.
$T$ is the kinetic energy of the rotor relative to N.
";
    let text = r"
$$ p = (A\sin^2\theta + C\cos^2\theta)\dot\phi + C\dot\psi\cos\theta $$
$$ q = C(\dot\phi\cos\theta + \dot\psi) $$
$$ q = C(\dot\phi\cos\theta - \dot\psi) $$
$$ \dot q = 0 $$
$$ T = \tfrac12 A(\dot\phi^2\sin^2\theta + \dot\theta^2) + \frac{q^2}{2C} $$
$$ T = \tfrac12 A(\dot\phi^2\sin^2\theta + \dot\theta^2) + \frac{q^2}{C} $$
";
    assert_eq!(judged(sentences, text), "pprppr");
}

#[test]
fn to_second_order_squares_count_and_cubes_do_not() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N about z by the angle $\\epsilon$.
Line 2 holds to first order in $\\epsilon$.
Lines 3 to 5 hold to second order in $\\epsilon$.
";
    let text = r"
$$ \cos\epsilon = 1 $$
$$ \cos\epsilon = 1 - \frac{\epsilon^2}{2} $$
$$ \cos\epsilon = 1 $$
$$ \sin^2\epsilon\,\cos\epsilon = \epsilon^2 $$
";
    assert_eq!(judged(sentences, text), "pprp");
}

#[test]
fn what_is_small_is_no_divisor() {
    // ε x = ε y to first order says nothing of x and y to first order.
    let sentences = "N is an inertial frame.
$\\epsilon$, $u$, $x$ and $y$ are numbers.
$\\epsilon u = \\epsilon x - \\epsilon y$.
Line 2 holds to first order in $\\epsilon$.
";
    assert!(!judged(sentences, "\n$$ u\\epsilon^2 = x - y - u $$\n").starts_with('p'));
}

#[test]
fn an_index_of_axes_in_a_letter_is_told_of_each_axis() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in N and in B.
$e_1$, $e_2$, $e_3$ are the axes of B.
$i$ numbers the axes of B.
The axes of B are principal axes of the body.
$I_i$ is the moment of inertia of the body about the axis through O along $e_i$.
$\\omega_i$ is the component $i$ of the angular velocity of B relative to N.
$L_i$ is the component $i$ on B of the angular momentum of the body about O relative to N.
";
    let text = r"
$$ L_i = I_i\omega_i $$
$$ L_2 = I_2\omega_2 $$
$$ L_i = -I_i\omega_i $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn what_is_equal_where_something_does_not_vanish_may_differ() {
    let sentences = "N is an inertial frame.
$a$, $b$ and $c$ are numbers.
$c a = c b$.
";
    assert!(!judged(sentences, "\n$$ a \\neq b $$\n").starts_with('r'));
}

#[test]
fn an_order_is_assumed_where_it_may_hold_and_claimed_nowhere() {
    let sentences = "N is an inertial frame.
$a$ and $b$ are numbers.
$a$ is positive.
Lines 2, 4 and 5 are assumed.
";
    let text = r"
$$ b > a $$
$$ b > a $$
$$ a > 0 $$
$$ a^2 + b^2 < 0 $$
";
    assert_eq!(judged(sentences, text), "auau");
}

#[test]
fn a_label_at_the_upper_right_stays_one_under_a_dot() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N.
$R_{1}^{0}$ takes components on A to components on N.
$\\omega_{0,1}^{0}$ is the angular velocity of A relative to N in components on N.
$S(v)$ is the cross-product matrix of $v$, for any vector $v$.
A dot means the rate entry by entry.
$t$ is the time.
";
    let text = r"
$$ \dot{R}_{1}^{0} = S(\omega_{0,1}^{0}) R_{1}^{0} $$
$$ \dot{R}_{1}^{0}(t) = S(\omega_{0,1}^{0}) R_{1}^{0}(t) $$
$$ \dot{R}_{1}^{0} = R_{1}^{0} S(\omega_{0,1}^{0}) $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn what_is_underlined_as_a_whole_is_read() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N about z by the angle $\\varphi$.
";
    let text = r"
$$ \underline{ \sin^2\varphi + \cos^2\varphi = 1 }_\# $$
$$ \sin(90\degree) = 1 $$
$$ \sin^2\varphi + \cos^{2}\varphi^{} = 1 $$
";
    assert!(judged(sentences, text).starts_with('p'));
}

/// A name and a colon before a line may name a case, which need not hold; what holds anyway is proved.
#[test]
fn a_line_that_is_only_named_is_proved_or_left_open() {
    let said = "N is an inertial frame.
B is a frame fixed in the body, and its axes are principal axes of the body.
G is the mass centre of the body.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on B of the angular velocity of B relative to N.
$M_1$, $M_2$, $M_3$ are the components on B of the total moment on the body about G.
";
    let text = r"
First component: $M_1 = I_1\dot\omega_1 - (I_2 - I_3)\omega_2\omega_3$.

Symmetric body: $I_1 = I_2$.

Wrong sign: $M_1 = I_1\dot\omega_1 + (I_2 - I_3)\omega_2\omega_3$.
";
    assert_eq!(judged(said, text), "puu");
}
