//! Periods and frequencies of small oscillations: what the equations of motion come to where a letter is zero.

use super::judged;

const PENDULUM: &str = r"
N is an inertial frame.
x, y, z are the axes of N.
x points vertically downwards.
B is a frame fixed in the body.
O is a point fixed in N and in B.
B turns relative to N about z by the angle $\theta$.
G is the mass centre of the body.
G lies at the distance $l$ from O along the first axis of B.
$m$ is the mass of the body.
$J$ is the moment of inertia of the body about the axis through O along z.
$g$ is the acceleration of gravity.
The weight and the force at O are the only loads on the body.
";

#[test]
fn the_frequency_of_small_oscillations_is_told_by_the_equations_of_motion() {
    let sentences = format!(
        "{PENDULUM}$\\omega$ is the angular frequency of the small oscillations of $\\theta$.\n$T$ is the period of the small oscillations of $\\theta$.\n"
    );
    let text = r"
$$ J\ddot\theta=-m g l\sin\theta $$
$$ \omega^2=\frac{m g l}{J} $$
$$ \omega^2=\frac{m g l}{2J} $$
$$ T=2\pi\sqrt{\frac{J}{m g l}} $$
$$ T=2\pi\sqrt{\frac{m g l}{J}} $$
";
    assert_eq!(judged(&sentences, text), "pprpr");
}

#[test]
fn what_does_not_rest_at_zero_does_not_oscillate_about_it() {
    let sentences = format!(
        "{}$\\omega$ is the angular frequency of the small oscillations of $\\theta$.\n",
        PENDULUM.replace(
            "x points vertically downwards",
            "y points vertically downwards"
        )
    );
    let text = r"
$$ \omega^2=\frac{m g l}{J} $$
$$ \omega=0 $$
";
    assert_eq!(judged(&sentences, text), "uu");
}

/// A line of the motion that is disturbed does not say that there are no disturbances.
#[test]
fn the_undisturbed_motion_leaves_disturbances_free() {
    let sentences = r"
N is an inertial frame.
K is a frame fixed in the top.
D is the mass centre of the top.
$w$ is the angular velocity of K relative to N.
$w_1$, $w_2$, $w_3$ are the components of $w$ on K.
$w_{01}$, $w_{02}$, $w_{03}$ are the reference values of $w_1$, $w_2$, $w_3$, and $a_1$, $a_2$, $a_3$ their small disturbances.
$A$, $A$, $C$ are the principal moments of the top about D on K.
No moment acts on the top about D.
Line 2 is given.
";
    let text = r"
$$ w_1=w_{01} $$
$$ C a_1=2 C a_1 $$
$$ a_1=0 $$
";
    assert_eq!(judged(sentences, text), "arr");
}
