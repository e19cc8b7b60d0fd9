//! Libration in orbit: the moment of the gradient of gravity on a direction that one angle gives.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn pitch(moment: &str, motion: &str, potential: &str) -> String {
    verdicts(&format!(
        r"Pitch motion under the gravity gradient. A satellite is on a circular orbit with the rate $\nu$. On principal axes the unit vector from the Earth is $\hat{{\mathbf e}} = (a, b, c)$, and the moment is

$$ \mathbf M = 3\nu^2\,\hat{{\mathbf e}}\times(\mathbf I\hat{{\mathbf e}}) $$

$$ M_y = 3\nu^2\,{moment}\,ca $$

For a pitch error $\beta$ alone $a = -\sin\beta$, $b = 0$ and $c = \cos\beta$. It obeys

$$ I_y\ddot\beta = {motion}\,\nu^2(I_x - I_z)\sin\beta\cos\beta $$

It has the integral

$$ E = \tfrac12 I_y\dot\beta^2 {potential} \tfrac32\nu^2(I_x - I_z)\sin^2\beta, \qquad \dot E = 0 $$
"
    ))
}

#[test]
fn the_angle_of_the_direction_turns_the_body() {
    assert_eq!(pitch("(I_x - I_z)", "-3", "+"), "aapaaapap");
    assert_eq!(pitch("(I_z - I_x)", "-3", "+"), "aaraaapap");
    assert_eq!(pitch("(I_x - I_z)", "-6", "+"), "aapaaarap");
    assert_eq!(pitch("(I_x - I_z)", "-3", "-"), "aapaaapar");
}

#[test]
fn sides_of_an_equation_are_no_lengths() {
    let text = "With the body rates $p$, $q$, $r$, the moments $A$, $B$, $C$ and the torques $L$, $M$, $N$ define the right-hand \
                sides\n\n$$ R = L + (B - C)qr, \\qquad S = M + (C - A)rp $$\n\nso that\n\n\
                $$ \\dot p = \\frac RA, \\qquad \\dot q = \\frac SA $$\n";
    assert_eq!(verdicts(text), "aapr");
}

/// A satellite of which the words name the components of the only unit vector, and say where its pitch axis lies.
fn named(torque: &str, frequency: &str) -> String {
    verdicts(&format!(
        r"# The torque

A station is on a circular orbit with the rate $\nu$. Let the unit vector towards the Earth have the components $a_1$, $a_2$, $a_3$ on the principal axes. The gravity-gradient torque is

$$ \mathbf T = 3\nu^2\,\hat{{\mathbf r}}\times(\mathbf J\hat{{\mathbf r}}) $$

$$ T_2 = 3\nu^2\,{torque}\,a_3a_1 $$

# Pitch

Let the pitch angle $\beta$ be the only one. With axis 2 normal to the orbit,

$$ \omega_1 = \omega_3 = 0, \qquad \omega_2 = \dot\beta - \nu $$

and the unit vector has the components

$$ a_1 = -\sin\beta, \qquad a_2 = 0, \qquad a_3 = \cos\beta $$

The equation of motion is

$$ J_2\ddot\beta + 3\nu^2 (J_1 - J_3)\sin\beta\cos\beta = 0 $$

For small angles this is a harmonic motion, $\ddot\beta + \Lambda^2\beta = 0$, with the frequency

$$ \Lambda = \nu\sqrt{{\frac{{{frequency}(J_1 - J_3)}}{{J_2}}}} $$
"
    ))
}

#[test]
fn words_name_the_components_of_a_unit_vector() {
    assert_eq!(named("(J_1 - J_3)", "3"), "apaaaaappa");
    assert_eq!(named("(J_3 - J_1)", "3"), "araaaaappa");
    assert_eq!(named("(J_1 - J_3)", "6"), "apaaaaappr");
}

#[test]
fn a_frequency_is_no_definition_where_the_motion_was_spoken_of() {
    let text = "The angle obeys $J\\ddot\\phi + e\\phi = s\\phi$. This is $\\ddot\\phi + p^2\\phi = 0$ with the frequency\n\n\
                $$ p = \\sqrt{\\frac{e + s}{J}} $$\n";
    assert_eq!(verdicts(text), "uuu");
}

#[test]
fn that_a_vector_is_one_of_unit_length_ties_it_to_nothing() {
    let text = |unit: &str, sign: &str| {
        format!(
            r"# The gradient of gravity

The orbital rate is $n$. Let $\mathbf{{o}} = (o_1, o_2, o_3)$ be the unit vector to the Earth{unit}. On principal axes the torque is

$$ \mathbf{{G}} = 3n^2\,\mathbf{{o}}\times\mathbf{{J}}\mathbf{{o}} $$

and its component is

$$ G_3 = {sign}3n^2(J_2 - J_1)\,o_1o_2 $$
"
        )
    };
    let unit = ", so that $o_1^2 + o_2^2 + o_3^2 = 1$";
    assert_eq!(verdicts(&text("", "")), "aap");
    assert_eq!(verdicts(&text(unit, "")), "aaap");
    assert_eq!(verdicts(&text(unit, "-")), "aaar");
}

#[test]
fn a_frequency_is_that_of_the_equation_near_zero() {
    let text = |ratio: &str| {
        verdicts(&format!(
            r"Pitch motion under the gravity gradient. A satellite is on a circular orbit with the rate $n$. On principal axes the unit vector from the Earth is $\hat{{\mathbf e}} = (a, b, c)$, and the moment is

$$ \mathbf M = 3n^2\,\hat{{\mathbf e}}\times(\mathbf I\hat{{\mathbf e}}) $$

For pure pitch $a = -\sin\beta$, $b = 0$ and $c = \cos\beta$. The torque about the other two axes vanishes, and

$$ I_y\ddot\beta + \tfrac32 n^2(I_x - I_z)\sin 2\beta = 0 $$

## Small angles

The long axis points down, so $I_x > I_z$. The libration frequency is

$$ \nu = n\sqrt{{{ratio}}} $$
"
        ))
    };
    assert_eq!(text(r"\frac{3(I_x - I_z)}{I_y}"), "aaaaapaa");
    assert_eq!(text(r"\frac{I_x - I_z}{I_y}"), "aaaaapar");
}
