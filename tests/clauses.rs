//! Suppositions in the many ways to say them, and what only sounds like one.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const COMPONENT: &str = r"$$ M_x = I_{xx}\dot\omega_x - (I_{yy} - I_{zz})\,\omega_y\omega_z $$";
const CONSERVED: &str = r"$$ \mathbf L\cdot\dot{\mathbf L} = 0 $$";
const BEARINGS: &str =
    r"$$ M_x = I_{yz}\,\omega^2, \qquad M_y = -I_{xz}\,\omega^2, \qquad M_z = 0 $$";

/// Each way to say it, with the verdicts of the lines behind it.
fn all_are(ways: &[&str], lines: &str, expected: &str) {
    for words in ways {
        assert_eq!(
            verdicts(&format!("{words}\n\n{lines}\n")),
            expected,
            "{words}"
        );
    }
}

#[test]
fn products_of_inertia_may_be_nothing() {
    let ways = [
        "Choosing the axes along the principal directions,",
        "All products of inertia vanish.",
        "The inertia matrix is diagonal.",
        "Diagonalizing the inertia tensor,",
        "Because the off-diagonal terms are zero we have",
        "Neglecting products of inertia,",
        "The body has three orthogonal planes of symmetry.",
    ];
    all_are(&ways, COMPONENT, "p");
    let others = [
        "The products of inertia do not vanish.",
        "Both products of inertia of the last section vanish.",
        "No product of inertia is left out.",
        "No products of inertia are neglected here.",
        "Without neglecting any product of inertia,",
        "None of the products of inertia is dropped.",
        "Is the inertia matrix, with its off-diagonal terms, general?",
    ];
    all_are(&others, COMPONENT, "r");
}

#[test]
fn a_moment_may_be_absent() {
    let ways = [
        r"The body is free of external torques $\mathbf M$.",
        r"Suppose the torque $\mathbf M$ vanishes.",
        r"The body tumbles freely in space.",
        r"The resultant moment $\mathbf M$ about the fixed point is zero.",
    ];
    all_are(&ways, CONSERVED, "p");
    let others = [
        r"The moment of the forces is $\mathbf M$, without friction.",
        r"The moment $\mathbf M$ about the axis of the rotor vanishes.",
        r"Then the shaft needs no driving torque, with $\mathbf M$ the moment.",
    ];
    all_are(&others, CONSERVED, "r");
}

#[test]
fn a_rotor_may_turn_uniformly_about_an_axis() {
    let ways = [
        r"The body rotates about the fixed $z$ axis with constant angular velocity $\omega$.",
        r"The shaft rotates with the constant angular speed $\omega$ about the $z$-axis.",
        r"The rotor turns uniformly about the fixed axis $z$ with the angular velocity $\omega$.",
    ];
    all_are(&ways, BEARINGS, "ppp");
    // The frame turns, and nothing is said of a body.
    let frame = "A frame turns about the $z$ axis with the constant angular velocity $\\omega$.";
    assert_ne!(verdicts(&format!("{frame}\n\n{BEARINGS}\n")), "ppp");
}

#[test]
fn what_you_say_for_a_moment_is_supposed() {
    let with = |sign: &str| {
        let text = r"A rotor with the moments $A$, $A$, $C$ about its axis $z$ spins with $\nu$ in axes that turn with $\boldsymbol\Omega$, so that $\boldsymbol\omega = \boldsymbol\Omega + \nu\,\mathbf{k}$. If you say that $\nu = 0$, the first equation is

$$ M_x = A\dot\Omega_x SIGN (C - A)\,\Omega_y\Omega_z $$
";
        verdicts(&text.replace("SIGN", sign)).pop()
    };
    assert_eq!(with("+"), Some('p'));
    assert_eq!(with("-"), Some('r'));
}

#[test]
fn no_torque_about_a_shaft_leaves_those_across_it() {
    let text = |words: &str| {
        verdicts(&format!(
            r"A rotor turns with the constant rate $\boldsymbol\omega = \Omega\,\hat k$ on axes fixed in it. {words}

$$ \mathbf M = -I_{{yz}}\Omega^2\,\hat\imath $$
"
        ))
    };
    // With none at all, both sides would vanish.
    assert_eq!(text("No torque acts about the shaft."), "ar");
    assert_eq!(
        text("By its bearings no torque acts on it along the axis."),
        "ar"
    );
    assert_eq!(text("No torque acts about any axis."), "au");
}

#[test]
fn a_rate_that_is_not_zero_is_given_by_the_equality_before_it() {
    let text = |last: &str| {
        format!(
            "Principal axes, no torque. Let $\\omega_2 = n {last}$. Then\n\n$$ \\omega_2\\omega_1 = n\\,\\omega_1 $$\n"
        )
    };
    for last in ["", r"\ne 0", "> 0"] {
        assert_eq!(verdicts(&text(last)), "ap", "{last}");
    }
}

#[test]
fn a_display_right_behind_a_claim_is_claimed_too() {
    let text = |sign: &str| {
        format!(
            r"Parallel axes: with $\mathbf d$ from the mass centre $G$ to the point $A$ of the body,

$$ \mathbf I_A = \mathbf I_G - m[\mathbf d]_\times[\mathbf d]_\times $$

$$ \mathbf I_A = \mathbf I_G {sign} m\left[(\mathbf d\cdot\mathbf d)\mathbf 1 - \mathbf d\mathbf d^T\right] $$
"
        )
    };
    assert_eq!(verdicts(&text("+")), "pp");
    assert_eq!(verdicts(&text("-")), "pr");
}

#[test]
fn a_body_is_without_a_moment_in_many_words() {
    let verdict = |words: &str| {
        verdicts(&format!(
            "A rigid body has principal moments $I_1, I_2, I_3$ and turns with $\\vec\\omega$; the moment on it is $\\vec M$. \
             {words}\n\n$$ I_1\\dot\\omega_1 = (I_2 - I_3)\\omega_2\\omega_3 $$\n"
        ))
    };
    for words in [
        "Without moment,",
        "Without a torque,",
        "Without any torque",
        "Left to itself, it obeys",
        "In the absence of moments",
    ] {
        assert_eq!(verdict(words), "p", "{words}");
    }
    for words in [
        "Without moment of friction",
        "Without a torque about the shaft",
    ] {
        assert_ne!(verdict(words), "p", "{words}");
    }
}
