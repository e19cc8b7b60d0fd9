//! What is said of one time or place of a motion holds in no other.

use super::judged;

/// A frame that turns about an axis by an angle, and what is said of it besides.
fn turning_by(angle: &str, more: &str) -> String {
    format!(
        r"N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle ${angle}$.
$w$ is the angular velocity of A relative to N.
{more}"
    )
}

#[test]
fn what_is_zero_at_the_top_is_not_zero_before() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
$g$ is the acceleration of gravity.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
The weight is the only load on P.
$v$ is the velocity of P relative to N.
$v$ is zero at the top.
";
    let text = r"
$$ \dot s = 0 $$
$$ \dot v = -g z $$
$$ m g = 0 $$
";
    assert_eq!(judged(sentences, text), "upu");
}

#[test]
fn what_is_zero_at_a_place_is_not_zero_elsewhere() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s x$.
$F$ is the total force on P.
$v$ is the velocity of P relative to N.
$F$ is zero at O.
";
    let text = r"
$$ F = 0 $$
$$ \dot v = 0 $$
$$ F = m\dot v $$
";
    assert_eq!(judged(sentences, text), "uup");
}

#[test]
fn a_premise_of_the_instant_considered_has_no_rate() {
    let sentences = turning_by("a", r"$\dot a = 0$ at the instant considered.");
    let text = r"
$$ \ddot a = 0 $$
$$ \dot w = 0 $$
$$ w = \dot a z $$
";
    assert_eq!(judged(&sentences, text), "uup");
}

#[test]
fn what_holds_now_has_no_rate() {
    let sentences = turning_by("a", r"Now $a=0$.");
    let text = r"
$$ \dot a = 0 $$
$$ w = 0 $$
";
    assert_eq!(judged(&sentences, text), "uu");
}

#[test]
fn what_holds_for_a_while_is_no_premise_for_ever() {
    let sentences = turning_by("a", r"$\dot a$ is constant while $t<t_1$.");
    let text = r"
$$ \dot w = 0 $$
$$ t < t_1 $$
$$ w = \dot a z $$
";
    assert_eq!(judged(&sentences, text), "uup");
}

#[test]
fn a_given_line_that_holds_at_an_instant_has_no_rate() {
    let sentences = turning_by(
        r"\theta",
        r"Line 2 is given.
Line 2 holds at $t=0$.",
    );
    let text = r"
$$ \theta = 0 $$
$$ \dot\theta = 0 $$
$$ w = 0 $$
";
    assert_eq!(judged(&sentences, text), "arr");
}

#[test]
fn a_line_that_holds_at_a_time_in_words_tells_nothing_of_others() {
    let sentences = turning_by(
        "a",
        r"Line 2 is given.
Line 2 holds at the end.",
    );
    let text = r"
$$ \dot a = 0 $$
$$ \ddot a = 0 $$
$$ w = 0 $$
";
    assert_eq!(judged(&sentences, text), "auu");
}

#[test]
fn where_something_is_at_the_end_it_is_not_always() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a point.
P is placed from O by $s x$ at the end.
$v$ is the velocity of P relative to N.
";
    let text = r"
$$ v = \dot s x $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_potential_energy_may_be_zero_at_a_value_by_an_equation() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
$g$ is the gravitational acceleration.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$V$ is the potential energy of P.
$V = 0$ at $s = h$.
";
    let text = r"
$$ V = mgs $$
$$ V = mg(s-h) $$
";
    assert_eq!(judged(sentences, text), "rp");
}

#[test]
fn a_letter_of_which_something_is_so_at_an_instant_may_change() {
    let text = r"
$$ \dot a = 0 $$
";
    for sentence in [
        "$a$ is positive at $t=0$.",
        "At $t=0$ $a$ is the same as $b$.",
        "$a$ is horizontal at $t=0$.",
    ] {
        assert_eq!(judged(sentence, text), "u", "{sentence}");
    }
}

#[test]
fn what_rests_at_the_end_moves_before() {
    let text = r"
$$ v = 0 $$
$$ \dot v = 0 $$
";
    for when in ["at the end", "at the top", "at the start"] {
        let sentences = format!(
            r"N is an inertial frame.
P is at rest relative to N {when}.
$v$ is the velocity of P relative to N."
        );
        assert_eq!(judged(&sentences, text), "uu", "{when}");
    }
}
