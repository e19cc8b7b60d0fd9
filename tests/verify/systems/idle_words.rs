//! Words of sentences that the model has nothing for: what they are said of is not taken as if they were not there.

use super::scenes::of_particle;
use super::{judged, verdicts};

#[test]
fn what_several_things_have_together_is_not_what_each_has() {
    let sentences = r"O is a point fixed in the dumb-bell.
The dumb-bell consists of two particles of total mass $m$.
The first particle is placed from O by $r$ and the second by $-r$.
$M$ is the mass of the dumb-bell.
";
    let text = r"
$$M = 2m$$

$$M = m$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn a_load_that_is_zero_is_the_one_of_that_name() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
z is the upward vertical.
$R$ is the component along z of the drag on P.
The weight and the drag are the only loads on P.
The drag on P is neglected.
",
    );
    let text = r"
$$R = 0$$

$$m\ddot s = -mg$$

$$m\ddot s = R-mg$$
";
    assert_eq!(judged(sentences, text), "ppp");
}

#[test]
fn a_weight_that_is_left_out_makes_no_gravity_zero() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
$F$ is the component along z of the total force on P.
The weight of P is neglected.
",
    );
    let text = r"
$$g = 0$$

$$m\ddot s = F+7mg$$
";
    assert_eq!(judged(sentences, text), "rr");
}

#[test]
fn an_adjective_of_a_load_is_not_dropped() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
z is the upward vertical.
The weight is the only constant load on P.
",
    );
    let text = r"
$$\ddot s = -g$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_holds_at_the_start_holds_at_no_other_time() {
    let sentences = &of_particle(
        r"No force acts on P at the start.
",
    );
    let text = r"
$$\ddot s = 0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_holds_while_something_moves_is_no_law() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
z is the upward vertical.
The weight is the only load on P while it moves.
",
    );
    let text = r"
$$\ddot s = -g$$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

#[test]
fn what_holds_at_a_thing_is_no_law() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
z is the upward vertical.
The weight is the only load on P at the top.
",
    );
    let text = r"
$$\ddot s = -g$$

$$\ddot s = 0$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn what_does_not_turn_at_the_start_may_turn_later() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the rod.
$w$ is the angular velocity of B relative to N.
The rod does not turn relative to N at the start.
";
    let text = r"
$$w = 0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_component_of_something_constant_is_not_told() {
    let sentences = &of_particle(
        r"$F$ is the component along z of the constant force on P.
",
    );
    let text = r"
$$\dot F = 0$$

$$m\ddot s = F$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn a_spring_force_has_an_energy() {
    let sentences = &of_particle(
        r"z is the upward vertical.
$g$ is the gravitational acceleration.
$L$ is the Lagrangian of P.
The potential energy is zero at O.
$k$ is constant.
The spring force $-k s$ along z acts on P.
",
    );
    let text = r"
$$L = \tfrac12 m\dot s^2-m g s$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_spring_that_is_attached_has_an_energy() {
    let sentences = &of_particle(
        r"z is the upward vertical.
$g$ is the gravitational acceleration.
$V$ is the potential energy of P.
The potential energy is zero at O.
$k$ is the stiffness of the spring.
The spring is attached to O and P.
",
    );
    let text = r"
$$V = m g s$$

$$V = m g s+\tfrac12 k s^2$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn a_sense_is_not_dropped() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N and in B.
B is a frame fixed in the rod.
B turns relative to N about z by the angle $\theta$.
$I$ is the moment of inertia of the rod about z through O.
$M$ is the moment on the rod about O, positive towards growing $\theta$.
";
    let text = r"
$$I\ddot\theta = M$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn the_size_of_what_is_not_heard_may_be_that_of_anything() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
O is a point fixed in N.
$g$ is the gravitational acceleration.
P is a particle of mass $m$.
P is placed from O by $s z$.
$F$ is the push on P.
The push points along $-z$.
$f$ is the magnitude of $F$.
The weight and the push are the only loads on P.
";
    let text = r"
$$m\ddot s = f-mg$$

$$m\ddot s = -f-mg$$

$$F = -f z$$
";
    assert_eq!(judged(sentences, text), "uuu");
}

#[test]
fn turns_about_one_axis_add_up() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
B is a frame fixed in the body.
$i, j, k$ are the axes of B.
$w$ is the angular velocity of B relative to N.
A turns relative to N about z by the angle $a$.
B turns relative to A about z by the angle $b$.
";
    let text = r"
$$w = (\dot a+\dot b) z$$

$$k = z$$
";
    assert_eq!(judged(sentences, text), "pp");
}

#[test]
fn an_angle_about_an_axis_that_moves_on_both_is_no_turn() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
$u, v, s$ are the axes of A.
$w$ is the angular velocity of B relative to N.
A turns relative to N about x by the angle $a$.
B turns relative to A about y by the angle $b$.
";
    let text = r"
$$w=\dot a x+\dot b y$$

$$w=\dot a x+\dot b v$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn that_no_constant_load_acts_is_not_that_none_does() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
z is the upward vertical.
No constant load acts on P.
",
    );
    let text = r"
$$\ddot s=0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_turn_at_the_start_is_none_later() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
$w$ is the angular velocity of B relative to N.
B turns relative to N about z by the angle $a$ at the start.
";
    let text = r"
$$w=\dot a z$$
";
    assert_eq!(judged(sentences, text), "u");
}
