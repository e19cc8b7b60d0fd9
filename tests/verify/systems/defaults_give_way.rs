//! What is taken by custom gives way to sentences that speak of the same thing, and what a sentence says is not dropped.

use super::scenes::of_particle;
use super::{judged, verdicts};

#[test]
fn what_lies_at_rest_by_no_sentence_may_move() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s x$.
$v$ is the velocity of P relative to N.
The total force on P is $F x$.
";
    let text = r"
$$v = 0$$

$$F = 0$$
";
    assert_eq!(judged(sentences, text), "rr");
}

#[test]
fn what_is_fixed_or_constant_by_a_sentence_rests() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s x$.
$s$ is constant.
Q is a point fixed in N.
Q lies at the distance $a$ from O along x.
$v$ is the velocity of P relative to N.
$u$ is the velocity of Q relative to N.
";
    let text = r"
$$v = 0$$

$$u = 0$$
";
    assert_eq!(judged(sentences, text), "pp");
}

#[test]
fn a_distance_along_which_something_slides_changes() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
B turns relative to N about z by the angle $\theta$.
$i, j, k$ are the axes of B.
Q lies at the distance $a$ from O along i.
Q slides along i.
$v$ is the velocity of Q relative to N.
";
    let text = r"
$$v\cdot j = a\dot\theta$$

$$v\cdot i = 0$$
";
    assert_eq!(judged(sentences, text), "pu");
}

#[test]
fn a_distance_from_what_turns_is_constant_where_nothing_tells_that_it_changes() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
B turns relative to N about z by the angle $\theta$.
$i, j, k$ are the axes of B.
Q lies at the distance $a$ from O along i.
$v$ is the velocity of Q relative to N.
";
    let text = r"
$$v = a\dot\theta j$$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn words_that_tell_of_a_motion_keep_no_distance() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
B turns relative to N about z by the angle $\theta$.
$i, j, k$ are the axes of B.
Q is a particle of mass $m$.
Q lies at the distance $a$ from O along i.
$v$ is the velocity of Q relative to N.
";
    let text = r"
$$v = a\dot\theta j$$
";
    assert_eq!(judged(sentences, text), "p");
    for (more, expected) in [
        ("$a$ is not constant.", "u"),
        ("$a$ grows with time.", "u"),
        ("Q moves relative to B.", "r"),
        ("$u$ is the rate of $a$.", "r"),
        ("No force acts on Q.", "r"),
    ] {
        assert_eq!(
            verdicts(&format!("{sentences}{more}\n"), text).0,
            expected,
            "{more}"
        );
    }
}

#[test]
fn a_velocity_relative_to_what_turns_is_not_zero_by_custom() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
B turns relative to N about z by the angle $\theta$.
$i, j, k$ are the axes of B.
Q lies at the distance $a$ from O along i.
$u$ is the velocity of Q relative to B.
$v$ is the velocity of Q relative to N.
";
    let text = r"
$$v = u + a\dot\theta j$$

$$u = 0$$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_touches_a_body_is_not_all_that_acts_on_it() {
    let sentences = &of_particle(
        r"z is the upward vertical.
$g$ is the gravitational acceleration.
$F$ is the component along z of the reaction on P.
The weight and the reaction are the only loads on P.
",
    );
    let text = r"
$$m\ddot s = F-mg$$

$$m\ddot s = F$$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn friction_is_no_total_force() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s x$.
$F$ is the component along x of the friction on P.
$H$ is the component along x of the push on P.
The friction and the push are the only loads on P.
";
    let text = r"
$$m\ddot s = F+H$$

$$m\ddot s = F$$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_formula_tells_what_a_listed_load_is() {
    let sentences = &of_particle(
        r"The force $m g z$ is the only load on P.
$g$ is constant.
",
    );
    let text = r"
$$\ddot s = g$$

$$\ddot s = 0$$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn the_letter_of_a_listed_load_keeps_what_a_sentence_says_of_it() {
    let sentences = &of_particle(
        r"z is the upward vertical.
$g$ is the gravitational acceleration.
$v$ is the velocity of P relative to N.
$c$ is constant.
The drag $D$ and the weight are the only loads on P.
$D=-c v$.
",
    );
    let text = r"
$$m\dot v = -c v-m g z$$

$$m\dot v = -m g z$$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_for_the_weight_is_the_weight_in_a_list() {
    let sentences = &of_particle(
        r"z is the upward vertical.
$g$ is the gravitational acceleration.
$W$ is the weight of P.
The weight $W$ is the only load on P.
",
    );
    let text = r"
$$W = -m g z$$

$$\ddot s = -g$$
";
    assert_eq!(judged(sentences, text), "pp");
}

#[test]
fn a_load_that_is_named_again_is_the_one_that_was_told() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N and in B.
B is a frame fixed in the rod.
B turns relative to N about z by the angle $\theta$.
$I$ is the moment of inertia of the rod about z through O.
The moment $M$ of the motor acts on the rod along z.
The force at O and the moment of the motor are the only loads on the rod.
";
    let text = r"
$$I\ddot\theta = M$$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn a_thrust_with_a_formula_acts_where_it_was_said_to() {
    let sentences = r"
N is an inertial frame.
G is the mass centre of the rocket.
The rocket is a rigid body of mass $m$.
B is a frame fixed in the rocket.
$i, j, k$ are the axes of B.
$H$ is the angular momentum of the rocket about G relative to N.
$F$ is constant.
The thrust $F k$ acts on the rocket at G.
The thrust is the only load on the rocket.
";
    let text = r"
$$\dot H = 0$$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn up_is_only_where_a_sentence_says_it() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
The weight is the only load on P.
",
    );
    let text = r"
$$\ddot s = g$$

$$\ddot s = -g$$
";
    assert_eq!(judged(sentences, text), "uu");
    let down = format!(
        "{sentences}z is the downward normal of the floor.\nThe floor is a horizontal plane fixed in N.\n"
    );
    assert_eq!(judged(&down, text), "pr");
    let to_the_ground = format!("{sentences}z points to the ground.\n");
    assert_eq!(judged(&to_the_ground, text), "uu");
}

#[test]
fn where_an_angle_begins_is_not_taken_by_custom_beside_a_sentence_on_it() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
B turns relative to N about z by the angle $a$.
$i, j, z$ are the axes of B.
";
    let text = r"
$$i = \cos a x+\sin a y$$
";
    assert_eq!(judged(sentences, text), "p");
    for more in [
        "$a$ is measured from y.",
        "$a$ is zero when i points along y.",
        "$a$ is the angle between i and y.",
        "$a$ is counted against z.",
        "$a$ is measured clockwise.",
        "The angle $a$ is measured from y.",
        "$a$ is positive clockwise.",
        "i lies along y at $a=0$.",
    ] {
        assert_eq!(
            verdicts(&format!("{sentences}{more}\n"), text).0,
            "u",
            "{more}"
        );
    }
}

#[test]
fn how_a_body_hangs_at_an_angle_tells_where_that_begins() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N and in B.
y is the upward vertical.
$g$ is the gravitational acceleration.
The rod is a uniform thin rod of mass $m$ and length $l$ from O along i.
B is a frame fixed in the rod.
$i, j, z$ are the axes of B.
B turns relative to N about z by the angle $\theta$.
The rod hangs from O at $\theta=0$.
The weight and the force at O are the only loads on the rod.
";
    let text = r"
$$\ddot\theta = -\tfrac{3g}{2l}\cos\theta$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_is_positive_the_other_way_has_the_other_sign() {
    let sentences = &of_particle(
        r"$v$ is the component along z of the velocity of P relative to N, counted positive towards $-z$.
$w$ is the angular velocity of B relative to N.
B turns relative to N about z.
$\Omega$ is the angular velocity of B relative to N about z, counted positive about $-z$.
",
    );
    let text = r"
$$v = \dot s$$

$$v = -\dot s$$

$$w = \Omega z$$

$$w = -\Omega z$$
";
    assert_eq!(judged(sentences, text), "rprp");
}

#[test]
fn a_moment_opposite_to_an_axis_is_counted_against_it() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N and in B.
B is a frame fixed in the rod.
B turns relative to N about z by the angle $\theta$.
$I$ is the moment of inertia of the rod about z through O.
$M$ is the friction moment on the rod about O along z, opposite to z.
The friction moment and the force at O are the only loads on the rod.
";
    let text = r"
$$I\ddot\theta = M$$

$$I\ddot\theta = -M$$
";
    assert_eq!(judged(sentences, text), "rp");
}

#[test]
fn the_sense_of_a_turn_is_not_dropped() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
$w$ is the angular velocity of B relative to N.
B turns relative to N about z by the angle $\theta$, counted from y towards x.
";
    let text = r"
$$w = \dot\theta z$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_axes_are_said_not_to_be_they_are_not_by_custom() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
";
    let text = r"
$$x\times y = z$$

$$x\cdot y = 0$$
";
    assert_eq!(judged(sentences, text), "pp");
    let left = format!("{sentences}$x, y, z$ form a left-handed system.\n");
    assert_eq!(verdicts(&left, text).0, "uu");
    let oblique = format!("{sentences}$x, y, z$ are not orthogonal.\n");
    assert_eq!(verdicts(&oblique, text).0, "uu");
}
