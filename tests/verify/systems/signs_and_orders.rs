//! Signs that are left open, and terms that are left away.

use super::{judged, verdicts};

const TOP: &str = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$A$, $B$, $C$ are the principal moments of the body about G on B.
$p$, $q$, $r$ are the components of the angular velocity of B relative to N on B.
No moment acts on the body about G.
";

#[test]
fn one_of_the_two_signs_is_meant() {
    let sentences = "$a$, $b$ and $c$ are constant.
$a x^2 + b x + c = 0$.
$\\pm$ means one of the two signs.
";
    let text = r"
$$ x = \frac{-b\pm\sqrt{b^2-4ac}}{2a} $$
$$ x = \frac{-b\pm\sqrt{b^2+4ac}}{2a} $$
$$ x = \frac{b\pm\sqrt{b^2-4ac}}{2a} $$
";
    let verdicts = judged(sentences, text);
    assert!(
        verdicts.starts_with('p') && !verdicts[1..].contains('p'),
        "{verdicts}"
    );
}

#[test]
fn where_a_remainder_stands_the_first_order_is_meant() {
    for said in [
        "$O(\\epsilon^2)$ means terms of second order in $u$, $v$ and $w$.",
        "$O(\\epsilon^2)$ is a sum of terms of second order in $u$, $v$, $w$.",
        "$O(\\epsilon^2)$ stands for terms of second and higher order in $u$, $v$, $w$.",
    ] {
        let sentences = format!(
            "{TOP}$0$, $0$ and $n$ are the reference values of $p$, $q$ and $r$, and $u$, $v$ and $w$ their small disturbances.
$n$ is constant.
{said}\n"
        );
        let text = r"
$$ A\dot u = (B-C)nv + O(\epsilon^2) $$
$$ A\dot u = (C-B)nv + O(\epsilon^2) $$
$$ A\dot u = (B-C)nv $$
";
        let verdicts = judged(&sentences, text);
        assert!(
            verdicts.starts_with("pr") && !verdicts.ends_with('p'),
            "{said}: {verdicts}"
        );
    }
}

#[test]
fn what_moves_and_has_no_reference_value_is_disturbed_as_well() {
    let sentences = r"E is an inertial frame.
B is a frame fixed in the aircraft.
S is the mass centre of the aircraft.
x, y, z are the axes of B.
$P$, $Q$, $R$ are the components on B of the angular velocity of B relative to E.
$\Psi$, $\Theta$, $\Phi$ are the Euler angles of B relative to E in the order z, y, x.
$A$, $B_1$, $C$ are the principal moments of the aircraft about S on B.
$M$ is the component 2 on B of the total moment on the aircraft about S.
$P_0$, $Q_0$, $R_0$ are the reference values of $P$, $Q$, $R$, and $p$, $q$, $r$ their small disturbances.
$P_0=0$, $Q_0=0$ and $R_0=0$.
The reference values obey the equations of motion.
";
    let text = r"
$$ M = B_1\dot Q + (A-C)PR $$
$$ M = B_1\dot Q - (A-C)PR $$
$$ \dot\Phi = 0 $$
";
    assert_eq!(judged(sentences, text), "puu");
}

#[test]
fn several_conditions_of_one_thing_are_no_lines_that_hold() {
    let sentences = r"
N is an inertial frame.
P is a particle of mass $m$.
O is a point fixed in N.
$w$ is the speed of P relative to N.
$a$ is the frequency of the oscillations of $q$ at $c=0$ and $w=0$.
";
    let text = r"
$$ w = 0 $$
";
    assert_ne!(verdicts(sentences, text).0, "p");
}

#[test]
fn sides_of_second_order_are_compared_to_second_order() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
The axes of B are principal axes of the body.
No moment acts on the body about G.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.
$w$ is the angular velocity of B relative to N.
$p$, $q$, $r$ are the components of $w$ on B.
$p$ and $q$ are small.
Lines 1 to 9 hold to first order in $p$, $q$.
";
    let text = r"
$$ I_3\dot r = (I_1-I_2) p q \approx 0 $$
$$ I_3\dot r = (I_1+I_2) p q \approx 0 $$
$$ I_3\dot r = 0 $$
";
    assert_eq!(judged(sentences, text), "pup");
}
