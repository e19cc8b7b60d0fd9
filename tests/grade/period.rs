//! Milestones that a rule gives: the period and the frequency of small oscillations.

use super::{marked_by, outcomes};

const KEY: &str = r#"---
marks: {"(1)": 1, "(2)": 2, "(3)": 2}
polhode:
- N is an inertial frame.
- x, y, z are the axes of N.
- x points vertically downwards.
- B is a frame fixed in the body.
- O is a point fixed in N and in B.
- B turns relative to N about z by the angle $\theta$.
- G is the mass centre of the body.
- G lies at the distance $l$ from O along the first axis of B.
- $m$ is the mass of the body.
- $J$ is the moment of inertia of the body about the axis through O along z.
- $g$ is the acceleration of gravity.
- The weight and the force at O are the only loads on the body.
- $\omega$ is the angular frequency of the small oscillations of $\theta$.
- $T$ is the period of the small oscillations of $\theta$.
---
$$ J\ddot\theta=-m g l\sin\theta \tag{1}$$
$$ \omega^2=\frac{m g l}{J} \tag{2}$$
$$ T=2\pi\sqrt{\frac{J}{m g l}} \tag{3}$$
"#;

const MOTION: &str = "$$ J\\ddot\\theta=-m g l\\sin\\theta $$\n";

#[test]
fn a_frequency_may_be_written_as_a_root_or_as_a_square() {
    for frequency in [
        r"\omega^2=\frac{m g l}{J}",
        r"\omega=\sqrt{\frac{m g l}{J}}",
        r"J\omega^2=m g l",
    ] {
        let text =
            format!("{MOTION}$$ {frequency} $$\n$$ T=2\\pi\\sqrt{{\\frac{{J}}{{m g l}}}} $$\n");
        let graded = marked_by(KEY, &text);
        assert_eq!(outcomes(&graded), ["full"; 3], "{text}: {graded:?}");
    }
}

#[test]
fn a_period_in_another_form_waits_for_a_person() {
    for period in [
        r"T=\frac{2\pi}{\sqrt{m g l/J}}",
        r"T=\frac{2\pi}{\omega}",
        r"T^2=\frac{4\pi^2J}{m g l}",
    ] {
        let text = format!("{MOTION}$$ \\omega^2=\\frac{{m g l}}{{J}} $$\n$$ {period} $$\n");
        let graded = marked_by(KEY, &text);
        assert_eq!(outcomes(&graded), ["full", "full", "human"], "{graded:?}");
        assert!(graded.queue.is_some());
    }
}

#[test]
fn a_period_that_is_upside_down_is_wrong_and_a_frequency_is_no_period() {
    let text = format!(
        "{MOTION}$$ \\omega^2=\\frac{{m g l}}{{J}} $$\n$$ T=2\\pi\\sqrt{{\\frac{{m g l}}{{J}}}} $$\n"
    );
    let graded = marked_by(KEY, &text);
    assert_eq!(outcomes(&graded), ["full", "full", "none"], "{graded:?}");
    assert_eq!(
        graded.first_slip.map(|slip| slip.place.source_line),
        Some(3)
    );
    let frequency = format!("{MOTION}$$ \\omega^2=\\frac{{m g l}}{{J}} $$\n");
    assert_eq!(
        outcomes(&marked_by(KEY, &frequency)),
        ["full", "full", "none"]
    );
}

#[test]
fn a_frequency_and_a_period_carry_on_a_wrong_equation_of_motion() {
    let wrong = "$$ J\\ddot\\theta=-2 m g l\\sin\\theta $$\n";
    for (frequency, period) in [
        (
            r"\omega^2=\frac{2 m g l}{J}",
            r"T=2\pi\sqrt{\frac{J}{2 m g l}}",
        ),
        (
            r"\omega=\sqrt{\frac{2 m g l}{J}}",
            r"T=2\pi\sqrt{\frac{J}{2 m g l}}",
        ),
    ] {
        let text = format!("{wrong}$$ {frequency} $$\n$$ {period} $$\n");
        let graded = marked_by(KEY, &text);
        let expected = ["none", "follow-through", "follow-through"];
        assert_eq!(outcomes(&graded), expected, "{text}: {graded:?}");
        let slip = graded.first_slip.map(|slip| slip.place.source_line);
        assert_eq!(slip, Some(1), "{text}");
    }
}

#[test]
fn a_period_alone_carries_on_a_wrong_equation_of_motion() {
    let text =
        "$$ J\\ddot\\theta=-2 m g l\\sin\\theta $$\n$$ T=2\\pi\\sqrt{\\frac{J}{2 m g l}} $$\n";
    let graded = marked_by(KEY, text);
    assert_eq!(
        outcomes(&graded),
        ["none", "none", "follow-through"],
        "{graded:?}"
    );
}

#[test]
fn a_period_carries_on_a_wrong_frequency() {
    let text = format!(
        "{MOTION}$$ \\omega^2=\\frac{{2 m g l}}{{J}} $$\n$$ T=2\\pi\\sqrt{{\\frac{{J}}{{2 m g l}}}} $$\n"
    );
    let graded = marked_by(KEY, &text);
    assert_eq!(
        outcomes(&graded),
        ["full", "none", "follow-through"],
        "{graded:?}"
    );
}

#[test]
fn a_frequency_that_does_not_follow_from_a_wrong_equation_of_motion_earns_nothing() {
    let wrong = "$$ J\\ddot\\theta=-2 m g l\\sin\\theta $$\n";
    let text = format!("{wrong}$$ \\omega^2=\\frac{{3 m g l}}{{J}} $$\n");
    let graded = marked_by(KEY, &text);
    assert_eq!(outcomes(&graded), ["none"; 3], "{graded:?}");
    // What is right after all does not follow from what is wrong: a person looks.
    let text = format!("{wrong}$$ \\omega^2=\\frac{{m g l}}{{J}} $$\n");
    assert_eq!(outcomes(&marked_by(KEY, &text))[1], "human");
}
