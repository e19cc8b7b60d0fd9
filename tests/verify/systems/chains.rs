//! Chains of bodies: links with numbers, joints, bodies of one kind that words tell apart.

use super::{judged, verdicts};

#[test]
fn links_with_neighbours_are_things_of_their_own() {
    let sentences = r"
Frame 0 is an inertial frame.
$i$ numbers the links.
Frame $i$ is a frame fixed in link $i$, for any $i$.
Joint $i$ is a point fixed in link $i-1$ and in link $i$, for any $i$.
Point $ci$ is the mass centre of link $i$.
The axis of joint $i$ is fixed in frame $i-1$ and in frame $i$.
Frame $i$ turns relative to frame $i-1$ about the axis of joint $i$ at the rate $\dot q_i$.
$z$ is the unit vector along the axis of joint $i$.
$R_i^{i-1}$ takes components on frame $i$ to components on frame $i-1$.
$\omega_i$ is the angular velocity of frame $i$ relative to frame 0.
$\omega_{i-1}$ is the angular velocity of frame $i-1$ relative to frame 0.
$w_i$ is the angular velocity of frame $i$ relative to frame 0 in components on frame $i$.
$v_i$ is the velocity of joint $i$ relative to frame 0.
$v_{i+1}$ is the velocity of joint $i+1$ relative to frame 0.
$v_{ci}$ is the velocity of point $ci$ relative to frame 0.
$r_i$ is the position of joint $i+1$ from joint $i$.
$r_{ci}$ is the position of point $ci$ from joint $i$.
$u$ is the angular velocity of frame $i$ relative to frame 0 in components on frame $i-1$.
";
    let text = r"
$$ \omega_i = \omega_{i-1} + \dot q_i z $$
$$ \omega_i = \omega_{i-1} - \dot q_i z $$
$$ v_{i+1} = v_i + \omega_i\times r_i $$
$$ v_{i+1} = v_i + \omega_{i-1}\times r_i $$
$$ v_{ci} = v_i + \omega_i\times r_{ci} $$
$$ u = R_i^{i-1} w_i $$
$$ w_i = R_i^{i-1} u $$
";
    assert_eq!(judged(sentences, text), "prprppr");
}

#[test]
fn a_joint_moves_with_both_of_its_bodies() {
    let sentences = r"
N is an inertial frame.
A is a frame fixed in the arm.
B is a frame fixed in the hand.
J is a point fixed in the arm and in the hand.
C is the mass centre of the hand.
D is the mass centre of the arm.
$w$ is the angular velocity of B relative to N.
$u$ is the angular velocity of A relative to N.
$r$ is the position of C from J.
$s$ is the position of D from J.
$v_C$ is the velocity of C relative to N.
$v_D$ is the velocity of D relative to N.
$v_J$ is the velocity of J relative to N.
";
    let text = r"
$$ v_C = v_J + w\times r $$
$$ v_D = v_J + u\times s $$
$$ v_C = v_D + w\times r - u\times s $$
$$ v_C = v_D + w\times r + u\times s $$
";
    assert_eq!(judged(sentences, text), "pppr");
}

#[test]
fn bodies_of_one_kind_are_told_apart_by_words_before_it() {
    for (one, other, kind) in [
        ("upper", "lower", "arm"),
        ("front", "rear", "wheel"),
        ("inner", "outer", "ring"),
        ("left", "right", "disc"),
    ] {
        let sentences = format!(
            r"
N is an inertial frame.
A is a frame fixed in the {one} {kind}.
B is a frame fixed in the {other} {kind}.
O is a point fixed in N.
G is the mass centre of the {one} {kind}.
H is the mass centre of the {other} {kind}.
$m$ is the mass of the {one} {kind}.
$M$ is the mass of the {other} {kind}.
The machine consists of the {one} {kind} and the {other} {kind}.
$p$ is the momentum of the machine relative to N.
$v$ is the velocity of G relative to N.
$V$ is the velocity of H relative to N.
"
        );
        let text = r"
$$ p = m v + M V $$
$$ p = m V + M v $$
";
        assert_eq!(judged(&sentences, text), "pr", "{one} {kind}");
    }
}

#[test]
fn what_consists_of_parts_may_be_called_by_a_word_that_is_a_verb_as_well() {
    let sentences = r"
N is an inertial frame.
A is a frame fixed in the crank.
P is a particle of mass $M$.
O is a point fixed in N and in A.
A turns relative to N about z at the rate $w$.
z is a unit vector fixed in N and in A.
$J$ is the moment of inertia of the crank about the axis through O along z.
The drive consists of the crank and P.
$T$ is the kinetic energy of the drive relative to N.
$v$ is the speed of P relative to N.
";
    let text = r"
$$ T = \tfrac12 J w^2 + \tfrac12 M v^2 $$
$$ T = \tfrac12 J w^2 - \tfrac12 M v^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_frame_fixed_in_a_frame_makes_no_body() {
    let sentences = r"
N is an inertial frame.
F is a frame that is at rest relative to N.
x, y, z are the axes of N.
z is the upward vertical.
D is a frame fixed in the gate.
O is a point fixed in N and in D.
D turns relative to N about x by the angle $\theta$.
G is the mass centre of the gate.
$r$ is the position of G from O.
$m$ is the mass of the gate.
$g$ is the acceleration of gravity.
$M$ is the moment of the weight about O.
";
    let text = r"
$$ M = - m g\, r\times z $$
$$ M = m g\, r\times z $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_load_on_the_whole_is_the_one_that_is_told_on_its_part() {
    let sentences = r"
N is an inertial frame.
A is a frame fixed in link 1.
e, f, k are the axes of A.
k is fixed in N.
k is a principal axis of link 1 about O.
A turns relative to N about k by the angle $a$.
O is a point fixed in N and in A.
P is a particle of mass $m$.
P lies at the distance $l$ from O along e.
$l$ is constant.
The arm consists of link 1 and P.
$L$ is the angular momentum of the arm about O relative to N along k.
$M$ is the moment of the base on link 1 along k.
The force at O and the moment of the base are the only loads on the arm.
";
    let text = r"
$$ \dot L = M $$
$$ \dot L = -M $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn an_assumption_with_a_letter_that_is_not_understood_may_make_a_line_true() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in N and in B.
B turns relative to N about $n$ by the angle $q$.
$n$ is a unit vector fixed in N and in B.
$J$ is the moment of inertia of the body about the axis through O along $n$.
$M$ is the total moment on the body about O.
$K$ is the gribble of the body about O.
Line 2 is assumed.
";
    let text = r"
$$ n\cdot M = n\cdot K $$
$$ J\ddot q = k $$
";
    let (verdicts, misread) = verdicts(sentences, text);
    assert_eq!(misread.len(), 1);
    assert!(
        !verdicts.contains('r') && !verdicts.contains('p'),
        "{verdicts}"
    );
}

#[test]
fn a_shape_of_which_only_the_name_is_known_is_not_passed_over() {
    let sentences = r"
N is an inertial frame.
S is a frame fixed in the half cylinder.
x, y, z are the axes of S.
The half cylinder is a uniform half cylinder of mass $m$ and radius $R$ with its axis through K along z.
K is a point fixed in S.
G is the mass centre of the half cylinder.
G lies at the distance $d$ from K along y.
";
    assert_ne!(judged(sentences, r"$$ d = \frac{4R}{3\pi} $$"), "r");
}

/// The frames of a chain of links, and the letters of any of them.
const LINKS: &str = r"
$i$ numbers the links.
Frame $i$ is a frame fixed in link $i$.
Frame 0 is an inertial frame.
A frame at the upper left means components on that frame.
${}^{j}_{k}R$ takes components on frame $k$ to components on frame $j$, for any frames $j$ and $k$.
$\omega_i$ is the angular velocity of frame $i$ relative to frame 0.
$v_i$ is the velocity of the origin of frame $i$ relative to frame 0.
${}^{i}P_{i+1}$ is the position of the origin of frame $i+1$ from the origin of frame $i$ in components on frame $i$.
$\hat{Z}_i$ is the third axis of frame $i$.
";

#[test]
fn letters_of_one_link_are_told_for_the_next_one() {
    let sentences = r"
On lines 1 to 5 frame $i+1$ turns relative to frame $i$ about $\hat{Z}_{i+1}$ at the rate $\dot q_{i+1}$.
On lines 1 to 5 the origin of frame $i+1$ is fixed in frame $i$.
On lines 6 to 8 frame $i+1$ does not turn relative to frame $i$.
On lines 6 to 8 the origin of frame $i+1$ moves relative to frame $i$ along $\hat{Z}_{i+1}$ at the rate $\dot{d}_{i+1}$.
";
    let text = r"
$$ {}^{i+1}\omega_{i+1} = {}^{i+1}_{i}R\;{}^{i}\omega_i + \dot q_{i+1}\;{}^{i+1}\hat{Z}_{i+1} $$
$$ {}^{i+1}\omega_{i+1} = {}^{i+1}_{i}R\;{}^{i}\omega_i $$
$$ {}^{i+1}v_{i+1} = {}^{i+1}_{i}R\left({}^{i}v_i + {}^{i}\omega_i \times {}^{i}P_{i+1}\right) $$
$$ {}^{i+1}v_{i+1} = {}^{i+1}_{i}R\;{}^{i}v_i $$
$$ {}^{i+1}\omega_{i+1} = {}^{i+1}_{i}R\;{}^{i}\omega_i $$
$$ {}^{i+1}v_{i+1} = {}^{i+1}_{i}R\left({}^{i}v_i + {}^{i}\omega_i \times {}^{i}P_{i+1}\right) + \dot{d}_{i+1}\;{}^{i+1}\hat{Z}_{i+1} $$
$$ {}^{i+1}v_{i+1} = {}^{i+1}_{i}R\left({}^{i}v_i + {}^{i}\omega_i \times {}^{i}P_{i+1}\right) $$
";
    assert_eq!(judged(&[LINKS, sentences].concat(), text), "prprppr");
}

#[test]
fn letters_of_a_chain_are_told_for_the_links_with_numbers() {
    let sentences = r"
From line 1 on frame 1 turns relative to frame 0 about $\hat{Z}_1$ by the angle $a$.
From line 1 on frame 2 turns relative to frame 1 about $\hat{Z}_2$ by the angle $b$.
From line 1 on the axes of frame 3 are parallel to the axes of frame 2.
From line 1 on the origin of frame 1 is the origin of frame 0.
From line 1 on the origin of frame 2 lies at the distance $l$ from the origin of frame 1 along the first axis of frame 1.
From line 1 on the origin of frame 3 lies at the distance $h$ from the origin of frame 2 along the first axis of frame 2.
$l$ and $h$ are constant.
";
    let text = r"
$$ {}^{2}\omega_2 = {}^{2}_{1}R\;{}^{1}\omega_1 + \dot b\;{}^{2}\hat{Z}_2 $$
$$ {}^{2}\omega_2 = \begin{bmatrix} 0 \\ 0 \\ \dot a - \dot b \end{bmatrix} $$
$$ {}^{2}v_2 = \begin{bmatrix} l\dot a\sin b \\ l\dot a\cos b \\ 0 \end{bmatrix} $$
$$ {}^{3}v_3 = \begin{bmatrix} l\dot a\sin b \\ l\dot a\cos b + h(\dot a + \dot b) \\ 0 \end{bmatrix} $$
$$ {}^{3}v_3 = \begin{bmatrix} h\dot a\sin b \\ l\dot a\cos b + h(\dot a + \dot b) \\ 0 \end{bmatrix} $$
";
    assert_eq!(judged(&[LINKS, sentences].concat(), text), "prppr");
}
