//! Sentences as people write them: relative clauses, asides, words for "is", parts of the document meant by "there".

use super::judged;

#[test]
fn frames_are_called_by_numbers_with_the_noun() {
    let sentences = r"Frame 0 is an inertial frame.
Frame 1 is a frame that turns relative to frame 0.
$R_{1}^{0}$ takes components on frame 1 to components on frame 0.
P is a point fixed in frame 1.
O is the origin of frame 0 and of frame 1.
$p^{1}$ is the position of P from O in components on frame 1.
$p^{0}$ is the position of P from O in components on frame 0.
A dot means the rate entry by entry.
";
    let text = r"
$$ p^{0}=R_{1}^{0}p^{1} $$
$$ \dot p^{0}=\dot R_{1}^{0}p^{1} $$
$$ p^{1}=R_{1}^{0}p^{0} $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_right_handed_set_of_unit_vectors_fixed_in_a_body_is_its_axes() {
    let sentences = r"The ground is an inertial frame.
$a$, $b$ and $c$ form a right-handed set of unit vectors fixed in the drum.
The drum turns relative to the ground about $c$ at the rate $w$.
$u$ is the angular velocity of the drum relative to the ground.
A dot over a vector means the rate seen from the ground.
";
    let text = r"
$$ u=w\,c $$
$$ a\times b=c $$
$$ \dot a=w\,b $$
$$ \dot a=-w\,b $$
";
    assert_eq!(judged(sentences, text), "pppr");
}

#[test]
fn there_means_the_lines_of_the_sentence_before() {
    let sentences = r"A is an inertial frame.
B turns relative to A about $n$ by the angle $q$.
$w$ is the component along $n$ of the angular velocity of B relative to A.
On line 5 $q$ is constant.
There, $w$ is zero.
";
    let text = r"
$$ w=\dot q $$

$$ w=0 $$
$$ w=0 $$
";
    assert_eq!(judged(sentences, text).chars().next(), Some('p'));
}

#[test]
fn the_last_of_several_is_told_beside() {
    let sentences = r"The hall is an inertial frame.
Its axes are $i$, $j$, $k$, the last of which points vertically up.
P is a particle of mass $m$.
$r$ is the position of P from O.
O is fixed in the hall.
$z$ is the component of $r$ along $k$.
$g$ is the acceleration of gravity.
The weight is the only load on P.
A dot means the time derivative.
";
    let text = r"
$$ \ddot z=-g $$
$$ \ddot z=g $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn coordinates_are_counted_from_points() {
    let sentences = r"N is an inertial frame.
$i$, $j$, $k$ are the axes of N.
O is a point fixed in N.
$r$ is the position of P from O.
The coordinate of P along $i$, counted from O, is denoted by $x$.
$y$ and $z$ are the coordinates of P from O along $j$ and $k$.
";
    let text = r"
$$ r=x\,i+y\,j+z\,k $$
$$ r=x\,i+z\,j+y\,k $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn four_letters_are_no_axes_of_a_frame() {
    let sentences = r"N is an inertial frame.
$a$, $b$, $c$, $d$ are the axes of N.
$w$ is the component of $d$ along $a$.
";
    let text = r"
$$ w=0 $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn axes_that_meet_have_the_point_fixed_in_all_that_turns() {
    let sentences = r"The base is an inertial frame.
The fork turns relative to the base about $z$ by the angle $p$.
The wheel turns relative to the fork about $n$ by the angle $q$.
$n$ is a unit vector fixed in the fork and in the wheel.
Both axes meet at O.
$v$ is the velocity of the point O of the wheel relative to the base.
$r$ is the position of P from O.
P is a point fixed in the wheel.
$w$ is the angular velocity of the wheel relative to the base.
$u$ is the velocity of P relative to the base.
";
    let text = r"
$$ u=w\times r $$
$$ u=r\times w $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_that_two_sentences_tell_is_both() {
    let sentences = r"N is an inertial frame.
A and B are rigid bodies.
$a$ is a unit vector fixed in N, in A and in B.
A turns relative to N about $a$ at the rate $p$.
B turns relative to N about $a$ at the rate $q$.
O is a point fixed in N, in A and in B.
$J$ is the moment of inertia of A about the axis through O along $a$.
$J$ is the moment of inertia of B about the axis through O along $a$.
The system consists of A and B.
$L$ is the angular momentum of the system about O along $a$.
";
    let text = r"
$$ L=J(p+q) $$
$$ L=J(p-q) $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn each_of_three_wheels_has_the_same_inertia() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the hub, with axes $b_1$, $b_2$, $b_3$.
The satellite consists of the hub and three wheels.
$i$ numbers the wheels.
G is the mass centre of the satellite.
Wheel $i$ turns relative to the hub about $b_i$ at the rate $w_i$, is symmetric about that axis, and has its mass centre fixed in the hub.
$J$ is the moment of inertia of each wheel about its spin axis.
$K$ is the inertia tensor of the satellite, wheels included, about G.
$u$ is the angular velocity of B relative to N.
$h$ is the angular momentum of the satellite about G relative to N.
";
    let text = r"
$$ h=Ku+J(w_1b_1+w_2b_2+w_3b_3) $$
$$ h=Ku+J(w_1b_1+w_2b_2-w_3b_3) $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn both_bodies_of_a_kind_are_meant_by_one_word() {
    let sentences = r"The base is an inertial frame.
O is fixed in the base.
The outer gimbal turns relative to the base about $k$ by the angle $p$.
The inner gimbal turns relative to the outer gimbal about $n$ by the angle $q$.
$k$ is a unit vector fixed in the base and in the outer gimbal.
$n$ is a unit vector fixed in both gimbals.
$u$ and $v$ are the angular velocities of the outer gimbal and of the inner gimbal relative to the base.
";
    let text = r"
$$ v=u+\dot q\,n $$
$$ v=u-\dot q\,n $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_noun_before_a_noun_is_no_other_body() {
    let sentences = r"N is an inertial frame.
The system consists of the pendulum arm and the wheel.
$n$ is a unit vector fixed in N, in the arm and in the wheel.
The arm turns relative to N about $n$ at the rate $p$.
The wheel turns relative to the arm about $n$ at the rate $q$.
$u$ is the angular velocity of the wheel relative to N.
";
    let text = r"
$$ u=(p+q)n $$
$$ u=(p-q)n $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn the_gravity_vector_is_the_acceleration_of_gravity() {
    let sentences = r"N is an inertial frame.
P is a particle of mass $m$.
$v$ is the velocity of P relative to N in components on N.
$g$ is the gravity vector in components on N.
The weight is the only load on P.
A dot means the rate entry by entry.
";
    let text = r"
$$ \dot v=g $$
$$ \dot v=-g $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn no_line_settles_a_letter_of_which_a_sentence_tells_that_is_not_used() {
    let sentences = r"N is an inertial frame.
$k$ is a unit vector fixed in N.
B is a rigid body of mass $m$.
$v$ is the velocity of the mass centre of B relative to N.
$S k$ is the force of the string on B.
";
    let text = r"
$$ S=2mv\cdot k $$
";
    assert_eq!(judged(sentences, text), "r");
}

#[test]
fn what_a_part_does_to_another_denies_nothing_where_no_list_of_loads_is_told() {
    let sentences = r"N is an inertial frame.
The machine consists of the rod and the wheel.
O is a point fixed in N and in the rod.
$n$ is a unit vector fixed in N, in the rod and in the wheel.
The rod turns relative to N about $n$ by the angle $p$.
The wheel turns relative to the rod about $n$ by the angle $q$.
S is the mass centre of the wheel.
S is fixed in the rod.
$J$ is the moment of inertia of the wheel about the axis through S along $n$.
$u$ is the moment of the rod on the wheel along $n$.
";
    let text = r"
$$ J(\ddot p+\ddot q)=u $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn an_entry_by_names_of_axes_is_not_the_first_one() {
    let sentences = r"B is a frame fixed in the body.
x, y, z are the axes of B.
G is the mass centre of the body.
$J$ is the inertia tensor of the body about G in components on B.
$p$ is the moment of inertia of the body about the axis through G along x.
$q$ is the entry (y, y) of $J$.
";
    let text = r"
$$ q=p $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn adjectives_stand_in_a_list_before_their_noun() {
    let sentences = r"N is an inertial frame.
The rod is a thin, uniform, rigid rod of mass $m$ and length $l$ along the first axis of B.
B is a frame fixed in the rod.
G is the mass centre of the rod.
$J$ is the moment of inertia of the rod about the axis through G along the third axis of B.
";
    let text = r"
$$ J=\tfrac1{12}ml^2 $$
$$ J=\tfrac1{3}ml^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn axes_in_turn_are_those_of_the_subjects() {
    let text = r"
$$ w = p\,i + q\,j + r\,k $$
$$ i\times j = k $$
$$ w = q\,i + p\,j + r\,k $$
";
    for axes in [
        "along the axes x, y, z of B",
        "along the axes x, y and z of B",
        "along the x, y, z axes of B",
        "along the axes 1, 2 and 3 of B",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$i, j, k$ are unit vectors {axes}.
$w$ is the angular velocity of B relative to N.
$p, q, r$ are the components of $w$ {axes}."
        );
        assert_eq!(judged(&sentences, text), "ppr", "{axes}");
    }
}

#[test]
fn an_axis_may_be_named_by_its_number_alone() {
    let text = r"
$$ M_3 = I_3 w_3 $$
$$ M_3 = I_1 w_3 $$
";
    for axes in [
        "The axes 1, 2, 3 of K are principal axes of the top.",
        "1, 2, 3 are the axes of K. The axes of K are principal axes of the top.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
K is a frame fixed in the top.
{axes}
G is the mass centre of the top.
$I_1$, $I_1$, $I_3$ are the principal moments of the top about G on K.
$M_3$ is the angular momentum of the top about G relative to N along 3.
$w_1, w_2, w_3$ are the components on K of the angular velocity of K relative to N."
        );
        assert_eq!(judged(&sentences, text), "pr", "{axes}");
    }
}

#[test]
fn an_axis_may_be_along_a_vector() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
$e_1, e_2, e_3$ are the unit vectors along x, y and z.
B is a frame fixed in the body.
G is the mass centre of the body.
$H$ is the angular momentum of the body about G relative to N.
z is the unit vector along the angular momentum of the body about G relative to N.
";
    let text = r"
$$ H\cdot e_1 = 0 $$
$$ H\cdot e_3 = 0 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_with_an_index_behind_a_list_of_components_is_the_one_of_that_number() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is the mass centre of the body.
$i$ and $j$ number the axes of B.
$\mathbf w$ is the angular velocity of B relative to N.
$w_1$, $w_2$, $w_3$ and $w_j$ are the components of $\mathbf w$ on B.
$\mathbf I$ is the inertia tensor of the body about O.
$I_{ij}$ is entry (i, j) of $\mathbf I$ on B.
$\mathbf L$ is the angular momentum of the body about O relative to N.
$L_i$ is the component $i$ of $\mathbf L$ on B.
";
    let text = r"
$$ L_i = \sum_j I_{ij} w_j $$
$$ \mathbf w\cdot\mathbf w = w_1^2 + w_2^2 + w_3^2 $$
$$ L_i = \sum_j I_{ij} w_i $$
$$ \mathbf w\cdot\mathbf w = w_1^2 + w_2^2 - w_3^2 $$
";
    assert_eq!(judged(sentences, text), "pprr");
}
