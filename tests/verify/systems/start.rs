//! What is kept from the beginning of a motion.

use super::judged;

pub(super) const PENDULUM: &str = "N is an inertial frame.
$Z$ is the upward vertical.
B turns relative to N about x by the angle $\\theta$.
$\\vec i$, $\\vec j$, $\\vec k$ are the axes of B.
B is a frame fixed in the pendulum.
The pendulum is a rigid body of mass $m$.
O is a point fixed in N and in B.
G is the mass centre of the pendulum.
G lies at the distance $-a$ from O along $\\vec k$.
$A$, $D$, $C$ are the principal moments of the pendulum about O on B.
$g$ is the acceleration of gravity.
The weight and the force at O are the only loads on the pendulum.
";

#[test]
fn energy_is_kept_from_the_start() {
    let sentences = format!("{PENDULUM}Line 2 holds at $t = 0$.\n");
    let text = r"
$$ \theta = \frac\pi2, \quad \dot\theta = 0 $$
$$ A\dot\theta^2 = 2 m g a\cos\theta $$
$$ A\dot\theta^2 = m g a\cos\theta $$
$$ A\dot\theta^2 = 2 m g a\sin\theta $$
$$ A\ddot\theta = -m g a\sin\theta $$
";
    assert_eq!(judged(&sentences, text), "aapurp");
}

#[test]
fn what_lines_about_two_instants_say_is_not_put_together() {
    let sentences = format!("{PENDULUM}Line 2 holds at $t = 0$.\nLine 3 holds at $t = T$.\n");
    let text = r"
$$ \theta = \frac\pi2 $$
$$ \dot\theta = 0 $$
$$ A\dot\theta^2 = 2 m g a\cos\theta $$
";
    assert_eq!(judged(&sentences, text), "aau");
}

/// The tripos question on a top that rises to the vertical: its two momenta are kept.
#[test]
fn momenta_are_kept_from_the_start() {
    let sentences = "N is an inertial frame.
$Z$ is the upward vertical.
E turns relative to N about Z by the angle $\\phi$.
A turns relative to E about y by the angle $\\theta$.
$\\vec e$, $\\vec f$, $\\vec n$ are the axes of A.
O is a point fixed in N.
P is a particle of mass $m$.
P lies at the distance $-l$ from O along $\\vec n$.
$g$ is the acceleration of gravity.
The weight and the force $\\vec S$ at O are the only loads on P.
$\\omega$ is constant.
Line 2 holds at $t = 0$.
";
    let text = r"
$$ \theta = \frac\pi6, \quad \dot\theta = 0, \quad \dot\phi = \omega $$
$$ \dot\phi\sin^2\theta = \frac14\omega $$
$$ \dot\phi\sin\theta = \frac14\omega $$
";
    assert_eq!(judged(sentences, text), "aaapr");
}
