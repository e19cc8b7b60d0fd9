//! Every word of a sentence counts: what is not taken in keeps lines from being judged, and is never dropped in silence.

use super::judged;

/// Sentences behind "N is an inertial frame", formulas, and the verdicts that these get.
type Case = (&'static str, &'static [&'static str], &'static str);

fn hold(cases: &[Case]) {
    for (sentences, formulas, expected) in cases {
        hold_one(sentences, formulas, expected);
    }
}

fn hold_one(sentences: &str, formulas: &[&str], expected: &str) {
    let said = format!("N is an inertial frame.\n{sentences}\n").replace(" / ", "\n");
    let lines = formulas.iter().map(|formula| format!("$$ {formula} $$\n"));
    let text: String = lines.collect();
    assert_eq!(judged(&said, &text), expected, "{sentences}");
}

#[test]
fn what_is_said_of_several_is_said_of_each() {
    hold(&[
        (
            "$x, y, z$ are the axes of N. / A and B turn relative to N about $x$ and $y$ at the rate $p$. / $w$ is the angular velocity of B relative to N.",
            &["w = p y", "w = p x"],
            "pr",
        ),
        (
            "$x, y, z$ are the axes of N. / O is a point fixed in N. / P and Q lie at the distances $a$ and $b$ from O along $x$ and $y$. / $s$ is the position of Q from O.",
            &["s = b y", "s = a x"],
            "pr",
        ),
        (
            "P and Q are the mass centres of the hub and the wheel. / $r$ is the position of Q from P.",
            &["r = 0"],
            "r",
        ),
        (
            "The hub and the wheel have the masses $M$ and $m$. / The craft consists of the hub and the wheel. / $c$ is the mass of the craft.",
            &["c = M + m", "c = 2 M"],
            "pr",
        ),
        (
            "O and P are points fixed in N and B, respectively. / $v$ is the velocity of P relative to N. / $u$ is the velocity of O relative to N.",
            &["v = 0", "u = 0"],
            "rp",
        ),
        (
            "P and Q are particles of mass $m$. / The pair consists of P and Q. / $c$ is the mass of the pair.",
            &["c = 2 m", "c = m"],
            "pr",
        ),
        (
            "P is a particle of mass $m$. / Q is a particle of mass $2m$. / The pair consists of P and Q. / $M$ is the mass of the pair.",
            &["M = 3 m", "M = 2 m"],
            "pr",
        ),
    ]);
}

#[test]
fn a_constant_rate_is_constant() {
    hold(&[
        (
            "x, y, z are the axes of B. / B turns relative to N about z at the constant rate $w$.",
            &["\\dot w = 0"],
            "p",
        ),
        (
            "$w$ is the constant angular velocity of B relative to N.",
            &["\\dot w = 0"],
            "p",
        ),
        (
            "x, y, z are the axes of N. / O is a point fixed in N. / P is a particle. / P lies at the constant distance $a$ from O along x.",
            &["\\dot a = 0"],
            "p",
        ),
    ]);
}

#[test]
fn one_force_of_several_is_not_all() {
    hold(&[
        (
            "P is a particle of mass $m$. / $a$ is the acceleration of P relative to N. / $F$ is a force on P.",
            &["F = m a"],
            "u",
        ),
        (
            "P is a particle of mass $m$. / Q is a particle of mass $M$. / $F$ is the force of Q on P. / $b$ is the acceleration of Q relative to N.",
            &["F = M b"],
            "u",
        ),
        (
            "P is a particle of mass $m$. / $a$ is the acceleration of P relative to N. / $F$ is the force on P.",
            &["F = m a", "F = -m a"],
            "pr",
        ),
    ]);
}

#[test]
fn an_adverb_may_turn_what_is_said_round() {
    hold(&[
        (
            "x, y, z are the axes of N. / B turns clockwise relative to N about z at the rate $p$. / $w$ is the angular velocity of B relative to N along z.",
            &["w = p", "w = -p"],
            "uu",
        ),
        (
            "x, y, z are the axes of N. / B turns relative to N about $-z$ by the angle $q$. / $w$ is the angular velocity of B relative to N along z.",
            &["w = -\\dot q", "w = \\dot q"],
            "pr",
        ),
        (
            "x, y, z are the axes of N. / B turns relative to N about the z axis by the angle $q$. / $w$ is the angular velocity of B relative to N along z.",
            &["w = \\dot q", "w = -\\dot q"],
            "pr",
        ),
    ]);
}

const SHAPE: &str = "B is a frame fixed in the wheel. / x, y, z are the axes of B. / G is the mass centre of the wheel. / $J$ is the moment of inertia of the wheel about the axis through G along z. / ";

#[test]
fn a_shape_is_what_all_its_words_say() {
    for (said, formulas, expected) in [
        (
            "The wheel is a uniform thin disc of mass $m$ and radius $r$. / The wheel is symmetric about z.",
            ["J = \\frac12 m r^2", "J = \\frac14 m r^2"],
            "pr",
        ),
        (
            "The wheel is a uniform thin disc of mass $m$ and radius $r$.",
            ["J = \\frac12 m r^2", "J = \\frac14 m r^2"],
            "uu",
        ),
        (
            "The wheel is a uniform thin disc. / $r$ is the radius of the wheel. / The wheel has the mass $m$. / The wheel is symmetric about z.",
            ["J = \\frac12 m r^2", "J = \\frac14 m r^2"],
            "pr",
        ),
        (
            "The wheel is a hollow sphere of mass $m$ and radius $r$.",
            ["J = \\frac25 m r^2", "J = \\frac12 m r^2"],
            "uu",
        ),
        (
            "The wheel is a uniform solid disc of mass $m$, radius $r$ and thickness $h$. / The wheel is symmetric about x.",
            ["J = \\frac14 m r^2", "J = \\frac12 m r^2"],
            "uu",
        ),
        (
            "The wheel is a uniform thin rod of mass $m$ and length $l$. / The wheel lies along x.",
            ["J = \\frac1{12} m l^2", "J = 0"],
            "pr",
        ),
    ] {
        hold_one(&format!("{SHAPE}{said}"), &formulas, expected);
    }
}

#[test]
fn what_is_at_rest_is_at_rest() {
    hold(&[
        (
            "O is a point. / O is the origin of N. / $v$ is the velocity of O relative to N.",
            &["v = 0"],
            "p",
        ),
        (
            "B is a frame. / P is a particle of mass $m$. / P is fixed in B. / $u$ is the velocity of P relative to B.",
            &["u = 0"],
            "p",
        ),
        (
            "K is a frame fixed in N. / $w$ is the angular velocity of K relative to N.",
            &["w = 0"],
            "p",
        ),
        (
            "B and C are frames fixed in the body. / $w$ is the angular velocity of B relative to N. / $u$ is the angular velocity of C relative to N.",
            &["w = u", "w = -u"],
            "pr",
        ),
        (
            "A, B and P are points fixed in N. / P is the midpoint of A and B. / $r$ is the position of P from A. / $s$ is the position of B from A.",
            &["r = \\frac12 s", "r = s"],
            "pr",
        ),
        (
            "O is the fixed point of the top. / $v$ is the velocity of O relative to N.",
            &["v = 0"],
            "p",
        ),
    ]);
}

#[test]
fn entries_of_a_rotation_matrix_are_those_of_its_array() {
    hold(&[(
        "z is an axis of N. / B turns relative to N about z by the angle $q$. / $R$ takes components on B to components on N. / $R_{12}$ is the entry (1, 2) of $R$.",
        &["R_{12} = -\\sin q", "R_{12} = 0", "R_{12} = \\sin q"],
        "prr",
    )]);
}

#[test]
fn letters_of_the_author_are_not_those_of_the_model() {
    hold(&[(
        "$M$ and $m$ are the mass and the radius of the disc. / The disc is a uniform thin disc.",
        &["m = M"],
        "r",
    )]);
}

#[test]
fn what_a_frame_does_on_some_lines_alone_is_not_what_it_does() {
    let sentences = "N is an inertial frame.
z is an axis of N.
B turns relative to N about z at the rate $p$.
On line 2 B turns relative to N about z at the rate $q$.
$w$ is the angular velocity of B relative to N along z.
";
    let text = "$$ w = p $$\n$$ w = q $$\n$$ w = p $$\n";
    assert_eq!(judged(sentences, text), "ppp");
}

#[test]
fn what_the_model_has_nothing_for_denies_nothing() {
    hold(&[
        (
            "P is a particle of mass $m$. / $F$ is one of the forces on P. / $a$ is the acceleration of P relative to N.",
            &["F = m a"],
            "u",
        ),
        (
            "P is a point fixed in the disc. / P is a point of the rim of the disc. / The disc is a uniform thin disc of mass $m$ and radius $r$. / G is the mass centre of the disc. / $s$ is the position of P from G.",
            &["s\\cdot s = r^2"],
            "u",
        ),
        (
            "The body is free. / G is the mass centre of the body. / $H$ is the angular momentum of the body about G relative to N.",
            &["\\dot H = 0"],
            "u",
        ),
        (
            "The disc and the shaft are one rigid body. / $w$ is the angular velocity of the disc relative to N. / $u$ is the angular velocity of the shaft relative to N.",
            &["w = u"],
            "u",
        ),
    ]);
}

#[test]
fn the_names_of_axes_are_their_vectors_where_a_vector_is_told() {
    hold(&[(
        "x, y, z are the axes of N. / O is a point fixed in N. / P is a particle. / $r$ is the position of P from O. / $r = a x + b y$. / $u$ is the component of $r$ along z.",
        &["u = 0", "u = a"],
        "pr",
    )]);
}
