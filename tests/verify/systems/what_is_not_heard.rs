//! What a sentence that is not understood leaves as it is, and words for what the model knows.

use super::{judged, verdicts};

#[test]
fn what_a_thing_does_in_words_that_are_not_understood_changes_no_letter() {
    let sentences = r"
N is an inertial frame.
G is the mass centre of the body.
B is a frame fixed in the body.
$\vec\omega$ is the angular velocity of B relative to N.
$\vec L$ is the angular momentum of the body about G relative to N.
$\mathbf I$ is the inertia tensor of the body about G.
$\vec v$ is the velocity of G relative to N.
";
    let text = r"
$$ \vec L=\mathbf I\cdot\vec\omega $$
$$ \vec v=\vec 0 $$
";
    // What moves takes nothing back, and what fails may hold by it.
    let moves = format!("{sentences}The body rests on the gribble of the floor.\n");
    assert_eq!(verdicts(&moves, text).0, "pu");
    let fixed = format!("{sentences}The body is fixed in the gribble at its rim.\n");
    assert_eq!(verdicts(&fixed, text).0, "pu");
    // What a thing is may take back what is assumed of all, and so may what it does not do.
    let is = format!("{sentences}The body is a gribbled one.\n");
    assert_eq!(verdicts(&is, text).0, "uu");
    let denies = format!("{sentences}The body turns not as a gribble does.\n");
    assert_eq!(verdicts(&denies, text).0, "uu");
}

#[test]
fn what_is_counted_or_written_otherwise_keeps_all_open() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
B is a frame fixed in the body.
O is a point fixed in N and in B.
B turns relative to N about z by the angle $\theta$.
$J$ is the moment of inertia of the body about the axis through O along z.
$M$ is the total moment on the body about O along z.
";
    let text = r"
$$ J\ddot\theta=M $$
";
    let with = |sentence: &str| verdicts(&format!("{sentences}{sentence}\n"), text).0;
    for rule in [
        "When a moment turns from x to y it is counted negative.",
        "If a frame turns from x to y its angle is negative.",
        "When an angle is written it is measured in degrees.",
        "When a letter is bold it has components on B.",
        "While the body turns it loses mass.",
        "The moment is counted negative.",
        "The body burns fuel.",
        "While the body turns, sand falls onto it.",
        "The cross product obeys the left-hand rule.",
        "The axes of N form a left system.",
        "The axis y points opposite to the usual way.",
        "B spins backwards.",
        "B is skewed against the body.",
        "The gribbles are those of the body.",
    ] {
        assert_eq!(with(rule), "u", "{rule}");
    }
    for fact in [
        "The strings of the body do not stretch.",
        "The gribble at O and its weight are the only loads on the body with its axle.",
        "The hinges exert no force on the body.",
        "When the wind blows the body turns on and on.",
        "The foot of the body lies on the side of positive x.",
        "A is the frame before the third of these turns.",
    ] {
        assert_eq!(with(fact), "p", "{fact}");
    }
}

#[test]
fn an_accelerometer_reads_the_acceleration_less_that_of_gravity() {
    let sentences = r"
N is an inertial frame.
$P_B$ is the origin of B, and $P_S$ is a point fixed in B.
B is a frame fixed in the body.
A frame at the upper left means components on that frame.
${}^N R_B$ takes components on B to components on N.
${}^B R_N$ takes components on N to components on B.
$O_N$ is the origin of N.
${}^N p$ is the position of $P_B$ from $O_N$ in components on N.
${}^N q$ is the position of $P_S$ from $O_N$ in components on N.
${}^B r$ is the position of $P_S$ from $P_B$ in components on B.
${}^B\omega$ is the angular velocity of B relative to N in components on B.
${}^N g$ is the acceleration of gravity in components on N.
${}^B m$ is the specific force at $P_B$ in components on B.
${}^B s$ is the reading of the accelerometer at $P_S$ in components on B.
A vector followed by $\times$ with nothing to its right means the cross-product matrix of that vector.
";
    let text = r"
$$ {}^N \dot R_B={}^N R_B\,{}^B\omega\times $$
$$ {}^B m={}^B R_N({}^N\ddot p-{}^N g) $$
$$ {}^B s={}^B m+{}^B\dot\omega\times{}^B r+{}^B\omega\times({}^B\omega\times{}^B r) $$
$$ {}^B m={}^B R_N({}^N\ddot p+{}^N g) $$
$$ {}^B s={}^B m+{}^B\dot\omega\times{}^B r $$
";
    assert_eq!(judged(sentences, text), "ppprr");
}

#[test]
fn premises_that_are_too_large_are_taken_to_the_order_of_the_line() {
    let sentences = r"
N is an inertial frame.
K is a point fixed in N.
G is the mass centre of the satellite.
A is a frame that turns relative to N.
$o_1, o_2, o_3$ are the axes of A.
$o_3$ is the unit vector from G to K.
A turns relative to N about $o_2$ at the constant rate $-n$.
B is a frame fixed in the satellite.
The axes of B are principal axes of the satellite.
$\psi, \theta, \phi$ are the Euler angles of B relative to A in the order z, y, x.
$I$ is the inertia tensor of the satellite about G on B.
$I_1$, $I_2$, $I_3$ are the principal moments of the satellite about G on B.
$M$ is the total moment on the satellite about G.
A vector or tensor without a label has components on B.
Lines 3 to 6 hold to first order in $\phi, \theta, \psi$.
$n$ is positive.
Line 2 is given.
";
    let text = r"
$$ M=3n^2\,o_3\times(I\,o_3) $$
$$ I_1\ddot\phi+4n^2(I_2-I_3)\phi-n(I_1-I_2+I_3)\dot\psi=0 $$
$$ I_2\ddot\theta+3n^2(I_1-I_3)\theta=0 $$
$$ I_3\ddot\psi+n^2(I_2-I_1)\psi+n(I_1-I_2+I_3)\dot\phi=0 $$
$$ I_1\ddot\phi+3n^2(I_2-I_3)\phi-n(I_1-I_2+I_3)\dot\psi=0 $$
";
    assert_eq!(judged(sentences, text), "apppr");
}

#[test]
fn by_a_given_line_that_is_not_taken_in_others_may_hold() {
    let sentences = r"
N is an inertial frame.
G is the mass centre of the body.
B is a frame fixed in the body.
$\vec\omega$ is the angular velocity of B relative to N.
$\vec a$ is a unit vector fixed in B.
$s$ is a constant.
";
    let text = r"
$$ \vec\omega=s+\vec a $$
$$ \vec a\times\vec\omega=\vec 0 $$
";
    let given = format!("{sentences}Line 2 is given.\n");
    assert_eq!(judged(&given, text), "au");
    assert_eq!(&judged(sentences, text)[1..], "r");
}

#[test]
fn a_number_times_an_axis_is_a_value_and_no_letter() {
    let sentences = r"
N is an inertial frame.
$x$, $y$, $z$ are the axes of N.
B is a frame fixed in the ball.
The angular velocity of the ball relative to N is $s z$.
$w$ is the angular velocity of the ball relative to N.
";
    let text = r"
$$ w=s z $$
$$ w\cdot x=0 $$
$$ w\cdot z=2s $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

/// What something is at a time or in a case it need not be always.
#[test]
fn a_sentence_is_not_kept_without_its_condition() {
    let sentences = r"
N is an inertial frame.
E is a frame fixed in the case.
F is a frame fixed in the rotor.
$x$, $y$, $z$ are the axes of E.
$a$, $b$, $c$ are the axes of F.
F turns relative to E about $x$ by the angle $q$.
The axes of F coincide with the axes of E whenever $q=0$.
";
    let text = r"
$$ b = y $$
$$ b = y\cos q+z\sin q $$
";
    assert!(!verdicts(sentences, text).0.starts_with('p'));
}

#[test]
fn what_one_thing_does_not_exert_another_may() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the door.
O is a point fixed in N and in B.
$x$, $y$, $z$ are the axes of N.
B turns relative to N about the axis through O along z by the angle $q$.
$J$ is the moment of inertia of the door about the axis through O along z.
No moment of the hinges acts on the door along $z$.
";
    let text = r"
$$ J\ddot q = 0 $$
";
    assert_ne!(judged(sentences, text), "p");
}

#[test]
fn the_letter_a_may_be_a_frame() {
    let sentences = r"
N is an inertial frame.
a is a frame fixed in the aeroplane.
b is a frame fixed in the propeller.
$x$, $y$, $z$ are the axes of a.
a turns relative to N about $z$ at the constant rate $\Omega$.
b turns relative to a about $x$ by the angle $q$.
$w$ is the angular velocity of b relative to N.
";
    let text = r"
$$ w = \Omega z + \dot q x $$
$$ w = \Omega z - \dot q x $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_rule_for_a_quoted_word_concerns_what_carries_it() {
    let text = "
$$ v = \\dot s x $$
$$ v = \\dot s x = \\text{constant} $$
";
    let scene = "N is an inertial frame.
x, y, z are the axes of N.
O is a point fixed in N.
P is placed from O by $s x$.
$v$ is the velocity of P relative to N.
";
    for (rule, judged) in [
        (
            "A member \"constant\" at the end of a chain says that the one before it stays.",
            "pu",
        ),
        ("The word \"constant\" names the rate of the rate.", "uu"),
    ] {
        let (given, misread) = verdicts(&format!("{scene}{rule}\n"), text);
        assert_eq!((given.as_str(), misread.len()), (judged, 1), "{rule}");
    }
}

#[test]
fn two_turns_of_one_frame_about_two_axes_contradict_each_other() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z at the rate $p$.
A turns relative to N about x at the rate $q$.
$w$ is the angular velocity of A relative to N.
";
    let text = r"
$$ w = p z $$
$$ w = q x $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn two_axes_of_one_frame_are_not_both_vertical() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
y is the upward vertical.
$g$ is the gravitational acceleration.
P is a particle of mass $m$.
The weight is the only load on P.
$c$ is the acceleration of P relative to N.
";
    let text = r"
$$ c = -g z $$
$$ c = -g y $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn what_a_sentence_tells_is_not_defined_anew_by_a_line() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle $a$.
$w$ is the angular velocity of A relative to N.
Line 2 defines $w$.
";
    let text = r"
$$ w = 2\dot a z $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_acts_in_words_that_are_not_understood_changes_no_kinematics() {
    let text = r"
$$ v = \dot r $$
$$ F = m \dot v $$
$$ F = 0 $$
";
    for said in [
        "A force with the whatever $F_B$ along the first axis of N acts at B.",
        "The drag is $-d$ times the whatever of the air.",
        "Between the time $0$ and the time $t_2$ the ball glides somehow.",
        "After the impact the ball does whatever it likes.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
P is a particle of mass $m$.
O is a point fixed in N.
$r$ is the position of P from O.
$v$ is the velocity of P relative to N.
$F$ is the total force on P.
{said}"
        );
        assert_eq!(verdicts(&sentences, text).0, "ppu", "{said}");
    }
}

#[test]
fn a_cancelled_term_may_be_told_to_vanish() {
    let text = "$$ v = \\dot r $$\n";
    let heard = |said: &str| verdicts(said, text).1.is_empty();
    assert!(heard("A cancelled term is read as if it stood there."));
    assert!(!heard("A cancelled term is read as if it were zero."));
}

#[test]
fn a_rule_in_words_that_are_not_understood_touches_what_carries_its_sign() {
    let text = r"
$$ v = \dot r $$
$$ w \times r = v $$
$$ r^2 = d^2 $$
$$ v = -\dot r $$
";
    let judged = |said: &str| {
        let sentences = format!(
            r"N is an inertial frame.
P is a particle of mass $m$.
O is a point fixed in N.
$r$ is the position of P from O.
$d$ is the distance of P from O.
$v$ is the velocity of P relative to N.
$w$ is any vector.
{said}"
        );
        verdicts(&sentences, text).0
    };
    assert_eq!(
        judged("A curly brace means somehow that all of it holds."),
        "prpr"
    );
    assert_eq!(
        judged("The cross between things means whatever they like."),
        "pupr"
    );
    assert_eq!(judged("An upper sign means whatever they like."), "prur");
    // What lacks a sign may mean something else as well.
    assert_eq!(
        judged("The cross between things means no whatever."),
        "uuuu"
    );
}

#[test]
fn a_rule_for_a_sign_keeps_open_what_carries_it() {
    let sentences = r"N is an inertial frame.
B is a frame.
B turns freely relative to N.
$\mathbf{w}$ is the angular velocity of B relative to N.
$\mathbf{u}$ is a vector fixed in B.
$\mathbf{d}$ is the rate of $\mathbf{u}$ seen from N.
$n$ is a constant.
";
    let text = r"
$$ \mathbf{d} = \mathbf{w}\times\mathbf{u} $$
$$ \mathbf{d} = \overbrace{\mathbf{w}\times\mathbf{u}} $$
$$ 2^{n}\mathbf{d} = 2^{n}\mathbf{w}\times\mathbf{u} $$
";
    let with = |rule: &str| verdicts(&format!("{sentences}{rule}\n"), text).0;
    assert_eq!(&with("")[..1], "p");
    assert_eq!(&with("A brace over a letter snorkels its value.")[..1], "u");
    assert_eq!(&with("A brace over a letter shows its flurbel.")[..2], "pu");
    let raised = with("`2^{n}` is the flurbel of `n`.");
    assert_eq!((&raised[..1], &raised[2..3]), ("p", "u"));
    assert_eq!(
        &with("`\\mathbf{a}\\times b` is the flurbel of `b`.")[..1],
        "u"
    );
}

#[test]
fn what_a_thing_undergoes_changes_no_formula() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the rotor.
B turns relative to N about z by the angle $q$.
$w$ is the component along z of the angular velocity of B relative to N.
";
    let with = |rule: &str| verdicts(&format!("{sentences}{rule}\n"), "$$ w = \\dot q $$\n").0;
    assert_eq!(
        with("The rotor is snorkelled by its weight and by the force of its bearing alone."),
        "p"
    );
    for rule in [
        "The rotor is snorkelled by its bearings.",
        "The rotor is snorkelled by a force with components on N.",
        "The rotor is snorkelled with its sign reversed.",
        "All rates are snorkelled.",
    ] {
        assert_eq!(with(rule), "u", "{rule}");
    }
}
