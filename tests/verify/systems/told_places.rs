//! Where points and bodies are, told before or after the letters that tell it.

use super::{judged, judged_in_any_order};

#[test]
fn points_are_placed_by_letters_that_other_sentences_tell() {
    let sentences = [
        "N is an inertial frame.",
        "O is a point fixed in N.",
        "x, y, z are the axes of A.",
        "A is a frame that turns relative to N about z at the rate $\\omega$.",
        "P and Q are particles.",
        "P and Q have the mass $m$.",
        "P is placed from O by $a n$, and Q by $-a n$.",
        "$n$ is the unit vector along x.",
        "$a$ is constant.",
        "The body consists of P and Q.",
        "$H$ is the component along z of the angular momentum of the body about O relative to N.",
        "$T$ is the kinetic energy of the body relative to N.",
    ];
    let text = r"
$$ H = 2 m a^2 \omega $$
$$ H = m a^2 \omega $$
$$ T = m a^2 \omega^2 $$
$$ T = 2 m a^2 \omega^2 $$
";
    judged_in_any_order(&sentences, text, "prpr");
}

#[test]
fn particles_are_named_in_one_list() {
    let sentences = "N is an inertial frame, and O is a point fixed in N.
A is a frame that turns relative to N about z at the rate $\\omega$.
x, y, z are the axes of A.
The dumb-bell consists of the particles P1 and P2, each of mass $m$.
P1 lies at the distance $b$ from O along x.
P2 lies on the y axis of A at the distance $c$ from O.
$H$ is the component along z of the angular momentum of the dumb-bell about O relative to N.
";
    let text = r"
$$ H = m (b^2 + c^2) \omega $$
$$ H = m (b^2 - c^2) \omega $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_place_for_some_lines_holds_on_these_alone() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the rotor.
1, 2, 3 are the axes of B.
O is a point fixed in N and in B.
G is the mass centre of the rotor.
From line 3 on G lies on axis 3 of B at the distance $l$ from O.
$v$ is the velocity of G relative to N.
$w_1$, $w_2$, $w_3$ are the components on B of the angular velocity of B relative to N.
$v_1$, $v_2$, $v_3$ are the components of $v$ on B.
";
    let text = r"
$$ v_1 = l w_2 $$
$$ v_1 = l w_2 $$
$$ v_2 = l w_1 $$
$$ v_2 = -l w_1 $$
";
    assert_eq!(judged(sentences, text), "uprp");
}

#[test]
fn what_several_bodies_have_is_not_said_of_the_first_alone() {
    let sentences = "N is an inertial frame.
P and Q are particles.
$m$ is the mass of P and of Q.
$p$ is the momentum of P relative to N, and $v$ is the velocity of P relative to N.
";
    assert_eq!(judged(sentences, "$$ p = m v $$\n"), "u");
}
