//! What is not worked with keeps what rests on it from being proved.

use super::{judged, verdicts};

#[test]
fn a_mass_centre_that_is_elsewhere_does_not_roll_as_the_middle_does() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
The floor is a horizontal plane fixed in N.
The ball is a sphere of mass $m$ and radius $r$.
G is the mass centre of the ball.
G does not coincide with the centre of the ball.
The ball rolls on the floor at C without slipping.
$w$ is the angular velocity of the ball relative to N.
$u$ is the velocity of G relative to N.
";
    let text = r"
$$ u = r w\times z $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

/// A false line about what sentences connect with what it names is not denied, and another one is. All is connected with
/// the ground.
#[test]
fn what_is_not_worked_with_bears_on_what_is_connected_with_it() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
The ball is a sphere of mass $m$ and radius $r$.
G is the mass centre of the ball.
C is a frame fixed in the ball.
C turns relative to N about z by the angle $c$.
$p$ is the rate of $c$.
A turns relative to N about z by the angle $a$.
$q$ is the rate of $a$.
";
    let text = r"
$$ p = 2\dot c $$
$$ q = 2\dot a $$
";
    assert_eq!(judged(sentences, text), "rr");
    let more = format!("{sentences}The ball hits the wall.\n");
    assert_eq!(judged(&more, text), "ur");
}

#[test]
fn what_is_zero_before_an_impact_is_not_zero_always() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle $a$.
$w$ is the angular velocity of A relative to N.
$\dot a$ is zero before the impact.
";
    let text = r"
$$ \ddot a = 0 $$
$$ w = 0 $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn columns_that_are_not_read_keep_the_matrix_from_being_defined() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle $a$.
$R$ takes components on A to components on N.
The columns of $X$ are the axes of A in components on N.
";
    let text = r"
$$ X = R^T $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_letter_by_custom_waits_for_the_sentence_about_it() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$x, y, z$ are the axes of B.
G is the mass centre of the body.
$I$ is the inertia tensor of the body about G in components on B.
$I_{xy}$ is the negative of the product of inertia of the body about G on x and y.
$I_{12}$ is the entry (1, 2) of $I$.
";
    let text = r"
$$ I_{12} = -I_{xy} $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

#[test]
fn a_letter_with_a_value_at_an_instant_is_not_constant() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s x + u y$.
$v$ is the velocity of P relative to N.
$u = 0$ at $t=0$.
";
    let text = r"
$$ v = \dot s x $$
";
    assert_eq!(judged(sentences, text), "r");
}

#[test]
fn products_of_no_tensor_that_is_told_are_not_free_letters() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$x, y, z$ are the axes of B.
G is the mass centre of the body.
$I$ is the inertia tensor of the body about G in components on B.
$C_{xy}$ is the centrifugal moment of the body about G on x and y.
$D_{xy}$ is the deviation moment of the body about G on x and y.
";
    let text = r"
$$ D_{xy} = C_{xy} $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_condition_of_the_text_that_no_sentence_declares_leaves_false_lines_open() {
    let sentences = r"N is an inertial frame.
P is a particle of mass $m$.
$v$ is the speed of P relative to N.
$T$ is the kinetic energy of P relative to N.
";
    let text = r"
The particle may move slowly. If it does, $T = m v^2$ holds.

It is often said that $T = m v^2$ holds.

When differentiating, we get $T = 2 m v^2$.

If we take the particle alone, we find $T = m v$. At rest

$$ T = 0 $$
";
    assert_eq!(judged(sentences, text), "urrru");
}

#[test]
fn a_letter_that_may_be_a_distance_or_a_position_is_neither() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the arm.
$b_1$, $b_2$, $b_3$ are the axes of B.
B turns relative to N about $b_3$ by the angle $q$.
O is a point fixed in N and in B.
P is a point fixed in B.
P is at $l$ from O.
$v$ is the speed of P relative to N.
";
    assert_eq!(verdicts(sentences, "$$ v = l\\dot q $$\n").0, "u");
}
