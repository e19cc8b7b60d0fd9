//! Small words that turn what a sentence says: adjectives, "or", "not", "its", a second thing in a list.

use super::{judged, verdicts};

/// Sentences behind "N is an inertial frame", formulas, and the verdicts that these get, whether the sentences are understood
/// or not.
fn hold(cases: &[(&str, &[&str], &str)]) {
    for (sentences, formulas, expected) in cases {
        let said = format!("N is an inertial frame.\n{sentences}\n").replace(" / ", "\n");
        let lines = formulas.iter().map(|formula| format!("$$ {formula} $$\n"));
        let text: String = lines.collect();
        assert_eq!(verdicts(&said, &text).0, *expected, "{sentences}");
    }
}

#[test]
fn an_adjective_that_makes_a_quantity_another_one_is_not_dropped() {
    hold(&[
        (
            "$x, y, z$ are the axes of N. / B turns relative to N about $z$ at the rate $p$. / $w$ is the negative angular velocity of B relative to N along $z$.",
            &["w = p", "w = -p"],
            "uu",
        ),
        (
            "P is a particle of mass $m$. / $u$ is the velocity of P relative to N. / $k$ is the internal force on P.",
            &["k = m \\dot u"],
            "u",
        ),
        (
            "P is a particle of mass $m$. / $u$ is the velocity of P relative to N. / No horizontal force acts on P.",
            &["\\dot u = 0"],
            "u",
        ),
        (
            "The hub and the wheel have the total mass $m$. / $a$ and $b$ are the masses of the hub and the wheel.",
            &["a = m"],
            "r",
        ),
        (
            "P is a particle of mass $m$. / $u$ is the velocity of P relative to N. / $T$ is the kinetic energy of P relative to N per unit mass.",
            &["T = \\frac12 m u \\cdot u"],
            "u",
        ),
    ]);
}

#[test]
fn a_choice_is_no_list_and_what_is_denied_does_not_hold() {
    hold(&[
        (
            "P and Q are points. / P or Q is fixed in N. / $v$ is the velocity of P relative to N.",
            &["v = 0"],
            "u",
        ),
        (
            "B is a frame fixed in the body. / G is the mass centre of the body. / The axes of B are no principal axes of the body. / $I$ is the inertia tensor of the body about G on B. / $I_{jk}$ is the entry of $I$.",
            &["I_{12} = 0"],
            "u",
        ),
        (
            "P was fixed in N. / $v$ is the velocity of P relative to N.",
            &["v = 0"],
            "u",
        ),
        (
            "A is a frame. / B is a frame. / If A is fixed in N, B turns relative to N about z at the rate $p$. / $w$ is the angular velocity of B relative to N along z.",
            &["w = p"],
            "u",
        ),
    ]);
}

#[test]
fn a_pronoun_is_not_the_thing_that_it_stands_beside() {
    hold(&[
        (
            "$x, y, z$ are the axes of N. / A turns relative to N about $z$ by the angle $a$. / B turns relative to it about $z$ by the angle $b$. / $w$ is the angular velocity of B relative to N along $z$.",
            &["w = \\dot b"],
            "u",
        ),
        (
            "$x, y, z$ are the axes of N. / The disc turns relative to N about $z$ by the angle $a$. / B is its frame. / $w$ is the angular velocity of B relative to N along $z$.",
            &["w = \\dot a", "w = 0"],
            "pr",
        ),
        (
            "P and Q are points. / They are fixed in N. / $v$ is the velocity of P relative to N.",
            &["v = 0"],
            "p",
        ),
        (
            "P and Q are points. / The former is fixed in N. / $v$ is the velocity of P relative to N.",
            &["v = 0"],
            "u",
        ),
    ]);
}

#[test]
fn what_is_said_twice_of_one_thing_is_no_first_one() {
    hold(&[
        (
            "$x, y, z$ are the axes of N. / B turns relative to N about $z$ at the rate $p$ and about $x$ at the rate $q$. / $w$ is the angular velocity of B relative to N along $z$.",
            &["w = p"],
            "u",
        ),
        (
            "G is the mass centre of the body. / $H$ is the angular momentum of the body about G relative to N. / The force at G and the moment $M$ are the only loads on the body.",
            &["\\dot H = 0"],
            "u",
        ),
        (
            "$x, y, z$ are the axes of N. / $k$ is the acceleration of gravity. / P is a particle of mass $m$. / O is a point fixed in N. / P lies at the distance $h$ from O along $z$. / $-z$ is the upward vertical. / The potential energy is zero at O. / $V$ is the potential energy of P.",
            &["V = m k h"],
            "r",
        ),
    ]);
}

#[test]
fn a_load_along_an_axis_is_its_component() {
    hold(&[(
        "$x, y, z$ are the axes of N. / G is the mass centre of the body. / No moment acts on the body about G along $x$. / $H$ is the angular momentum of the body about G relative to N. / $M$ is the total moment on the body about G.",
        &["M \\cdot x = 0", "M = 0"],
        "pr",
    )]);
}

#[test]
fn everyday_words_are_read() {
    hold(&[
        (
            "$x, y, z$ are the axes of N. / P and Q are particles of mass $m$. / The system consists of P and Q. / The mass centre of the system is at rest relative to N. / $u$ and $v$ are the velocities of P and Q relative to N.",
            &["\\dot u + \\dot v = 0"],
            "p",
        ),
        (
            "P is a particle of mass m. / v is the velocity of P relative to N. / F is the total force on P.",
            &["F = m \\dot v", "F = 2 m \\dot v"],
            "pr",
        ),
        (
            "$x, y, z$ are the axes of N. / N is turned relative to B about $z$ by the angle $a$. / $R$ takes components on B to components on N.",
            &[
                "R = \\begin{pmatrix}\\cos a & \\sin a & 0\\\\ -\\sin a & \\cos a & 0\\\\ 0 & 0 & 1\\end{pmatrix}",
            ],
            "p",
        ),
        (
            "$x, y, z$ are the axes of N. / A is turned relative to N by $a$ about $z$ and then by $b$ about $u$. / $u, v, n$ are the axes of A. / $w$ is the angular velocity of A relative to N along $n$.",
            &["w = \\dot a \\cos b", "w = \\dot a"],
            "pr",
        ),
        (
            "P is a particle of mass $m$. / The kinetic energy of P is constant. / $T$ is the kinetic energy of P relative to N.",
            &["\\dot T = 0"],
            "p",
        ),
        (
            "P is a particle. / $2m$ is the mass of P. / Q is a particle of mass $m$. / $a$ and $b$ are the masses of P and Q.",
            &["a = 2 b", "a = b"],
            "pr",
        ),
        (
            "O is a point fixed in N. / P is a point. / $r$ is the vector from O to P. / $s$ is the position of P from O.",
            &["r = s", "r = -s"],
            "pr",
        ),
        (
            "The hub and the wheel form the craft. / B is a frame fixed in the hub. / x, y, z are the axes of B. / G is the mass centre of the craft. / G is the mass centre of the wheel. / $A$, $A$, $C$ are the principal moments of the hub about G on B. / The wheel turns relative to the hub about z at the rate $s$. / The wheel is symmetric about z. / $J$ is the moment of inertia of the wheel about z. / $w$ is the angular velocity of B relative to N along z. / $H$ is the angular momentum of the craft about G relative to N along z.",
            &["H = (C + J) w + J s", "H = C w + J s"],
            "pr",
        ),
    ]);
}

#[test]
fn nothing_is_a_part_of_itself() {
    hold(&[(
        "The craft consists of the hub and the craft. / $m$ is the mass of the hub. / $c$ is the mass of the craft.",
        &["c = m"],
        "u",
    )]);
}

#[test]
fn axes_that_are_called_otherwise_are_the_same_by_their_order() {
    hold(&[
        (
            "$x, y, z$ are the axes of N. / A turns relative to N about $z$ at the rate $s$. / $i, j, k$ are the axes of A. / $w$ is the angular velocity of A relative to N. / $\\frac{d}{dt}$ is the rate seen from N.",
            &["w = s k", "\\frac{di}{dt} = s j", "\\frac{di}{dt} = -s j"],
            "ppr",
        ),
        (
            "$x, y, z$ are the axes of N. / A is a frame fixed in the arm. / B is a frame fixed in the forearm. / The arm turns relative to N about $z$ by $a$. / The forearm turns relative to the arm about $z$ by $b$. / $S$ takes components on B to components on N. / $S_{jk}$ is the entry of $S$.",
            &["S_{11} = \\cos(a + b)", "S_{11} = \\cos b"],
            "pr",
        ),
    ]);
}

#[test]
fn what_is_called_a_particle_is_one() {
    hold(&[
        (
            "The body consists of the particles P and Q. / $a$ and $b$ are the masses of P and Q. / $u$ and $v$ are the velocities of P and Q relative to N. / $T$ is the kinetic energy of the body relative to N.",
            &[
                "T = \\frac12 a u \\cdot u + \\frac12 b v \\cdot v",
                "T = \\frac12 a u \\cdot u",
            ],
            "pr",
        ),
        (
            "m is the mass of the particle. / $v$ is the velocity of the particle relative to N. / $T$ is the kinetic energy of the particle relative to N.",
            &["T = \\frac12 m v \\cdot v", "T = m v \\cdot v"],
            "pr",
        ),
        (
            "O is a point fixed in N. / m is the mass of the bead. / $r$ is the position of the bead from O. / $v$ is the velocity of the bead relative to N. / $T$ is the kinetic energy of the bead relative to N.",
            &["T = \\frac12 m v \\cdot v", "T = m v \\cdot v"],
            "pr",
        ),
        (
            "$x, y, z$ are the axes of N. / P is a point. / $v$ is the velocity of P relative to N. / $s$ is the speed of P along $x$.",
            &["s = v \\cdot x"],
            "p",
        ),
    ]);
}

#[test]
fn it_does_not_matter_what_is_said_first() {
    hold(&[(
        "$i$ numbers the particles. / The body consists of particles. / $m_i$ is the mass of particle $i$. / $v_i$ is the velocity of particle $i$ relative to N. / $p$ is the momentum of the body relative to N.",
        &["p = \\sum_i m_i v_i"],
        "p",
    )]);
}

#[test]
fn what_a_thing_consists_of_are_things() {
    hold(&[(
        "The body consists of the particles P, Q and S of masses $m$, $2m$ and $3m$. / $a$ and $b$ are the masses of P and Q.",
        &["b = 2 a"],
        "u",
    )]);
}

#[test]
fn the_normal_of_a_ring_is_its_axis() {
    hold(&[(
        "The ring is a uniform thin ring of mass $m$ and radius $r$. / G is the centre of the ring. / n is the unit vector perpendicular to the plane of the ring. / $J$ is the moment of inertia of the ring about the axis through G along n.",
        &["J = m r^2", "J = \\frac12 m r^2"],
        "pr",
    )]);
}

#[test]
fn a_product_that_vanishes_denies_none_of_its_factors() {
    hold(&[(
        "$X, Y, Z$ are the axes of N. / O is a point fixed in N and in B. / The rod is a uniform thin rod of mass $m$ and length $2a$. / B is a frame fixed in the rod. / $x, y, z$ are the axes of B. / The rod is symmetric about $x$. / G is the mass centre of the rod. / G lies at the distance $a$ from O along $x$. / B turns relative to N about $Z$ by the angle $h$. / The force at O is the only load on the rod.",
        &["\\ddot h = 0"],
        "u",
    )]);
}

#[test]
fn a_unit_vector_that_points_from_a_point_is_no_position() {
    hold(&[(
        "O and Q are points. / $\\hat u$ points from O to Q. / $s$ is the position of Q from O.",
        &["\\hat u = s"],
        "r",
    )]);
}

#[test]
fn an_end_or_a_rim_is_not_the_mass_centre() {
    hold(&[
        (
            "The rod is a uniform thin rod of mass $m$ and length $l$. / $J$ is the moment of inertia of the rod about its end.",
            &["J = \\frac13 m l^2", "J = \\frac1{12} m l^2"],
            "uu",
        ),
        (
            "B is a frame fixed in the body. / G is the mass centre of the body. / $L$ is the angular momentum of the body about G relative to N. / $M$ is the moment on the body about its corner.",
            &["\\dot L = M"],
            "u",
        ),
        (
            "The disc is a uniform disc of mass $m$ and radius $r$. / The rod is a uniform thin rod of mass $M$ and length $l$. / $J$ is the moment of inertia of the disc about the axis of the rod.",
            &["J = \\frac12 m r^2"],
            "u",
        ),
    ]);
}

#[test]
fn a_particle_is_where_it_is_said_to_be() {
    for particle in ["at E", "that lies at E"] {
        let sentences = format!(
            "E is a point fixed in N. / P is a particle of mass $m$ {particle}. / $v$ is the velocity of P relative to N."
        );
        hold(&[(&sentences, &["v = 0"], "p")]);
    }
}

#[test]
fn a_frame_that_turns_is_not_the_inertial_one() {
    for frame in ["N is a rotating frame", "N is not an inertial frame"] {
        let said = format!(
            "{frame}.\nP is a particle of mass $m$.\n$F$ is the total force on P.\n$a$ is the acceleration of P relative to N.\n"
        );
        assert_eq!(verdicts(&said, "$$ F = m a $$\n").0, "r", "{frame}");
    }
}

#[test]
fn an_assumption_that_is_taken_back_is_none() {
    let said = "\
N is an inertial frame.
G is the mass centre of the body.
$L$ is the angular momentum of the body about G relative to N.
$M$ is the moment on the body about G.
";
    let text =
        |words: &str| format!("{words}\n\n$$ M = 0 $$\n\nIn general,\n\n$$ \\dot L = 0 $$\n");
    assert_eq!(verdicts(said, &text("We assume that")).0, "ap");
    for words in ["We do not assume that", "It would be wrong to assume that"] {
        assert!(
            !verdicts(said, &text(words)).0.contains(['a', 'p']),
            "{words}"
        );
    }
}

#[test]
fn the_opposite_of_a_quantity_may_be_what_a_sentence_tells() {
    let text = r"
$$ X = -v $$
$$ X = v $$
";
    for said in [
        "$-X$ is the velocity of P relative to N.",
        "$X$ is minus the velocity of P relative to N.",
        "$X$ is the negative of the velocity of P relative to N.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
$v$ is the velocity of P relative to N.
{said}"
        );
        assert_eq!(judged(&sentences, text), "pr", "{said}");
    }
}

#[test]
fn a_quantity_with_a_word_that_is_not_worked_with_tells_nothing() {
    let text = r"
$$ X = w $$
";
    for said in [
        "$X$ is the own angular velocity of the disc.",
        "$X$ is the angular velocity of the disc except the sign.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
x, y, z are the axes of N.
A turns relative to N about z at the rate $\Omega$.
The disc turns relative to A about x at the rate $p$.
$w$ is the angular velocity of the disc relative to N.
{said}"
        );
        assert_eq!(verdicts(&sentences, text).0, "u", "{said}");
    }
}
