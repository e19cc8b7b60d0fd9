//! Values at instants, what the motion keeps from there, and lines that hold at one instant alone.

use super::judged;
use super::start::PENDULUM;

const FALLING: &str = "N is an inertial frame.
z is the upward vertical.
P is a particle of mass $m$.
P moves along z.
The weight is the only load on P.
$g$ is the acceleration of gravity.
$v$ is the velocity of P relative to N along z.
$t$ is the time.
";

#[test]
fn what_changes_evenly_does_so_from_its_value_at_the_start() {
    let text = r"
$$ v = v_0 - g t $$
$$ v = v_0 + g t $$
$$ \dot v = -g $$
";
    for said in [
        "$v_0$ is the value of $v$ at $t=0$.",
        "$v_0$ is the initial value of $v$.",
        "$v_0$ is the value of $v$ at the start.",
        "$v_0$ is the initial velocity of P relative to N along z.",
        "$v_0$ is the velocity of P relative to N along z at $t=0$.",
    ] {
        assert_eq!(judged(&format!("{FALLING}{said}\n"), text), "prp", "{said}");
    }
}

const FREE: &str = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of the angular velocity of B relative to N on B.
No moment acts on the body about G.
";

#[test]
fn values_at_one_instant_tell_each_other() {
    let sentences = format!(
        "{FREE}$T$ is the kinetic energy of rotation of the body relative to N.
$T_0$ is the value of $T$ at the start.
$a$, $b$ and $c$ are the values of $\\omega_1$, $\\omega_2$ and $\\omega_3$ at the start.\n"
    );
    let text = r"
$$ T_0 = \frac12(I_1a^2+I_2b^2+I_3c^2) $$
$$ T_0 = \frac12(I_1a^2+I_2b^2-I_3c^2) $$
$$ T = T_0 $$
$$ I_1\omega_1^2+I_2\omega_2^2+I_3\omega_3^2 = I_1a^2+I_2b^2+I_3c^2 $$
";
    assert_eq!(judged(&sentences, text), "prpp");
}

#[test]
fn a_value_of_which_nothing_can_be_made_denies_nothing() {
    let sentences = format!(
        "{FREE}$T$ is the kinetic energy of rotation of the body relative to N.
$T_0$ is the value of $T$ at the start.\n"
    );
    let text = r"
$$ T_0 = \frac12I_1\omega_1^2 $$
$$ \omega_1 = 0 $$
";
    assert!(!judged(&sentences, text).contains('p'));
}

#[test]
fn what_starts_from_rest_keeps_its_energy() {
    let sentences = format!(
        "{PENDULUM}The pendulum is released from rest.
$\\alpha$ is the value of $\\theta$ at the start.\n"
    );
    let text = r"
$$ A\dot\theta^2 = 2 m g a(\cos\theta-\cos\alpha) $$
$$ A\dot\theta^2 = m g a(\cos\theta-\cos\alpha) $$
$$ \theta = \alpha $$
";
    let verdicts = judged(&sentences, text);
    assert!(
        verdicts.starts_with('p') && !verdicts[1..].contains('p'),
        "{verdicts}"
    );
}

/// A ball slides on a table, and begins to roll.
#[test]
fn what_holds_at_an_instant_has_no_rate() {
    let sentences = "N is an inertial frame.
$x$, $y$, $z$ are the axes of N.
$z$ is the upward vertical.
B is a frame fixed in the ball.
The ball is a uniform solid sphere of mass $M$ and radius $R$.
G is the mass centre of the ball.
The table is a horizontal plane fixed in N.
C is the point where the ball touches the table.
G moves along $x$.
B turns relative to N about $y$ at the rate $\\omega$.
The weight and the force of the table at C are the only loads on the ball.
$g$ is the acceleration of gravity.
$t$ is the time.
$v$ is the velocity of G relative to N along $x$.
$F_N$ is the force of the table on the ball along $z$.
$F_F$ is the force of the table on the ball along $-x$.
$\\mu$ is constant.
$F_F=\\mu F_N$.
$v_0$ is the value of $v$ at $t=0$.
$\\omega$ is zero at $t=0$.
Lines 4 to 7 hold at the instant when the ball begins to roll on the table without slipping.
";
    let text = r"
$$ \dot v = -\mu g $$
$$ \omega = \frac{5\mu g}{2R}t $$
We assume $v = R\omega$.
$$ v_0 = \frac72\mu g t $$
$$ v_0 = \frac52\mu g t $$
$$ \dot v = R\dot\omega $$
";
    let verdicts = judged(sentences, text);
    assert_eq!(&verdicts[..2], "pp");
    assert_eq!(&verdicts[verdicts.len() - 3..], "prr", "{verdicts}");
}

#[test]
fn a_value_where_something_vanishes_is_worked_out() {
    let sentences = "$a$ and $b$ are constant.
$x$ is any number.
$f_0$ is the value of $f$ at $x=0$.
";
    assert!(!judged(sentences, "$$ f_0 = a $$\n").contains('p'));
}

#[test]
fn the_time_of_an_instant_is_not_denied_where_the_motion_is_not_worked_out() {
    let sentences = r"
N is an inertial frame.
X, Y, Z are the axes of N.
Z is the upward vertical.
G is the mass centre of the block.
The block is a particle of mass $m$.
G moves along X.
$F$ is the total force on the block along X.
$u$ is the velocity of G relative to N along X.
$F=-\mu m g$
$g$ is the acceleration of gravity.
$u_0$ is the value of $u$ at $t=0$.
$t_1$ is the value of $t$ at $u=0$.
";
    let text = r"
$$ m\dot u = -\mu m g $$
$$ u_0 = \mu g t_1 $$
";
    assert_eq!(judged(sentences, text), "pu");
}

#[test]
fn a_relation_that_tells_when_lines_hold_is_used_there() {
    let sentences = "K is an inertial frame.
x, y, z are the axes of K.
O is a point fixed in K and in B.
B turns relative to K about the axis through O along z by the angle $\\alpha$.
P is a particle of mass $m$.
$p$ is the position of P from O in components on B.
$v$ is the velocity of P relative to K in components on K.
$u$ is the velocity of P relative to B in components on B.
$\\omega$ is the angular velocity of B relative to K in components on B.
Lines 2 and 3 hold at $\\alpha = 0$.
";
    let text = r"
$$ v = \omega\times p + u $$
$$ v = \omega\times p - u $$
$$ v = \omega\times p + u $$
";
    assert_eq!(judged(sentences, text), "pru");
}

#[test]
fn a_root_may_have_its_value_by_the_motion_from_an_instant() {
    let sentences = "N is an inertial frame.
z is the upward vertical.
P is a particle of mass $m$.
P moves along z.
The weight is the only load on P.
$g$ is the acceleration of gravity.
$v$ is the speed of P.
$z$ is the height of P.
$z = h$ at $t = 0$.
P is at rest at $t = 0$.
The whatever of P is somehow.
";
    let text = r"
$$ v = \sqrt{2 g (h - z)} $$
";
    assert_eq!(super::verdicts(sentences, text).0, "u");
}
