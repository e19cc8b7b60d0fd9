//! Where points and bodies are, told before or after the letters that tell it.

use super::{judged, judged_in_any_order, verdicts};

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

#[test]
fn a_letter_and_its_unit_vector_are_two() {
    let sentences = "\
N is an inertial frame.
A is a frame that turns relative to N about $\\hat z$ at the constant rate $w$.
$\\hat x$, $\\hat y$, $\\hat z$ are the axes of A.
O is a point fixed in N and in A.
P is a particle of mass $m$.
$x\\,\\hat x+y\\,\\hat y$ is the position of P from O.
No force in the plane of $\\hat x$ and $\\hat y$ acts on P.
";
    let text = r"
$$ \ddot x-2w\dot y-w^2x=0 $$
$$ \ddot y-2w\dot x-w^2y=0 $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn the_letters_of_a_size_do_not_change() {
    let sentences = "\
N is an inertial frame.
The third axis of N is the upward vertical.
O is a point fixed in N and in the rod.
The rod is a uniform thin rod of mass $m$ and length $2a$.
O is an end of the rod.
The rod turns relative to N about the second axis of N by the angle $\\theta$.
At $\\theta=0$ the rod points along the third axis of N.
$g$ is the acceleration of gravity.
$\\vec F$ is the force on the rod at O.
The weight and $\\vec F$ are the only loads on the rod.
";
    assert_eq!(
        verdicts(sentences, r"$$ \ddot\theta=\frac{3g}{4a}\sin\theta $$").0,
        "p"
    );
}

#[test]
fn particles_that_are_counted_have_numbers() {
    let sentences = "\
N is an inertial frame.
O is a point fixed in N and in B.
B is a frame that turns relative to N about the third axis of B at the rate $w$.
The rotor consists of two particles of mass $m$, fixed in B.
$(a,0,b)$ and $(-a,0,-b)$ are the positions of the particles from O in components on B.
$T$ is the kinetic energy of the rotor relative to N.
";
    let text = r"
$$ T=ma^2w^2 $$
$$ T=mb^2w^2 $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_relation_tells_what_its_letter_is() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the satellite.
G is the mass centre of the satellite.
$\\hat o$ is the unit vector from the point E, which is fixed in N, to G.
$I_1$, $I_2$, $I_3$ are the principal moments of the satellite about G on B.
$I$ is the inertia tensor of the satellite about G.
$\\vec M=k\\,\\hat o\\times(I\\hat o)$ is the total moment on the satellite about G, where $k$ is a scalar.
";
    let text = r"
$$ \hat o\cdot\vec M=0 $$
$$ \vec M=-k\,\hat o\times(I\hat o) $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_point_may_rest_before_it_is_told_what_it_is() {
    let sentences = [
        "N is an inertial frame.",
        "B is a frame fixed in the body.",
        "G is the mass centre of the body.",
        "G is at rest relative to N.",
        r"$\vec\omega$ is the angular velocity of B relative to N.",
        r"$\mathbf J$ is the inertia tensor of the body about G.",
        "$T$ is the kinetic energy of the body.",
    ];
    let text = r"
$$ T=\tfrac12\,\vec\omega\cdot\mathbf J\vec\omega $$
";
    judged_in_any_order(&sentences, text, "p");
}

#[test]
fn a_point_waits_for_that_from_which_it_is_placed() {
    let sentences = [
        "N is an inertial frame.",
        "A is a frame fixed in link 1.",
        "B is a frame fixed in link 2.",
        r"$\vec e_1$, $\vec n_1$, $\vec z$ are the axes of A.",
        r"$\vec e_2$, $\vec n_2$, $\vec z$ are the axes of B.",
        r"A turns relative to N about $\vec z$ by the angle $q_1$.",
        r"B turns relative to A about $\vec z$ by the angle $q_2$.",
        "O is a point fixed in N and in A.",
        r"$G_2$ lies at the distance $c_2$ from P along $\vec e_2$.",
        "P is a point fixed in A and in B.",
        r"P lies at the distance $l$ from O along $\vec e_1$.",
        r"$\vec v_2$ is the velocity of $G_2$ relative to N.",
    ];
    let text = r"
$$ \vec v_2=l\dot q_1\,\vec n_1+c_2(\dot q_1+\dot q_2)\,\vec n_2 $$
";
    judged_in_any_order(&sentences, text, "p");
}

#[test]
fn a_point_may_be_placed_so_far_along_an_axis() {
    let text = r"
$$ r = s i $$
$$ r\cdot j = s $$
";
    for axis in ["x", "$i$", "the first axis of B", "the axis x of B"] {
        let sentences = format!(
            r"N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$i, j, k$ are the unit vectors along x, y, z.
G is the mass centre of the body.
$r$ is the position of P from G.
P is placed from G by $s$ along {axis}."
        );
        assert_eq!(judged(&sentences, text), "pr", "{axis}");
    }
}

#[test]
fn coordinates_place_a_point() {
    let text = r"
$$ r = a i + b j + c k $$
$$ r = a i + c j + b k $$
";
    for said in [
        "P is placed from G by $a$ along x, $b$ along y and $c$ along z.",
        "P is placed from G by the column $(a,b,c)$ on B.",
        "P has the coordinates $(a,b,c)$ on B from G.",
        "The position of P from G is $(a,b,c)$ on B.",
        "The coordinates of P on B from G are $a$, $b$, $c$.",
        "$a$, $b$, $c$ are the coordinates of P relative to G on B.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$i, j, k$ are the unit vectors along x, y, z.
G is the mass centre of the body.
$r$ is the position of P from G.
{said}"
        );
        assert_eq!(judged(&sentences, text), "pr", "{said}");
    }
}
