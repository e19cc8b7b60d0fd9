//! Angles that words give the momentum and the angular velocity of a free symmetric body.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::document::Format;

const BODY: &str =
    "On principal axes the body has $I_1 = I_2 = A$ and $I_3 = C$. No torque acts.\n\n";

#[test]
fn the_angle_of_the_momentum_is_that_of_its_parts() {
    let text = |line: &str| {
        format!(
            "{BODY}Let $\\beta$ be the angle between the angular momentum $\\vec L$ and the axis of symmetry, and \
             $\\omega_t$ the size of the transverse part of $\\vec\\omega$. Write $L = |\\vec L|$. Then\n\n$$ {line} $$\n"
        )
    };
    let last = |line: &str| verdicts(&text(line)).pop();
    assert_eq!(last("L\\cos\\beta = C\\,\\omega_3"), Some('p'));
    assert_eq!(last("L\\cos\\beta = A\\,\\omega_3"), Some('r'));
    assert_eq!(last("L\\sin\\beta = A\\,\\omega_t"), Some('p'));
    assert_eq!(
        last("\\tan\\beta = \\frac{A\\,\\omega_t}{C\\,\\omega_3}"),
        Some('p')
    );
    assert_eq!(
        last("\\tan\\beta = \\frac{C\\,\\omega_t}{A\\,\\omega_3}"),
        Some('r')
    );
    assert_eq!(
        last("L^2\\sin^2\\beta = A^2(\\omega_1^2 + \\omega_2^2)"),
        Some('p')
    );
    assert_eq!(
        last("L^2\\sin 2\\beta = 2AC\\,\\omega_t\\,\\omega_3"),
        Some('p')
    );
}

#[test]
fn the_two_half_angles_of_the_cones_are_related() {
    let text = |line: &str| {
        format!(
            "{BODY}The angular momentum makes the angle $\\theta$ with the symmetry axis, and the angular velocity the \
             angle $\\gamma$ with the same axis.\n\n$$ {line} $$\n"
        )
    };
    let last = |line: &str| verdicts(&text(line)).pop();
    assert_eq!(last("\\tan\\theta = \\frac{A}{C}\\tan\\gamma"), Some('p'));
    assert_eq!(last("\\tan\\theta = \\frac{C}{A}\\tan\\gamma"), Some('r'));
}

#[test]
fn an_angle_of_something_else_is_none_of_these() {
    let text = "On principal axes the top has $I_1 = I_2 = A$ and $I_3 = C$. The axis of symmetry makes the angle \
                $\\theta$ with the vertical, and $\\vec L$ is the angular momentum.\n\n\
                $$ L\\cos\\theta = C\\,\\omega_3 $$\n";
    assert_eq!(verdicts(text).pop(), Some('u'));
}

#[test]
fn the_axis_may_be_named_by_its_number() {
    let text = |line: &str| {
        format!(
            "{BODY}Call $\\theta$ the angle between the angular momentum $\\vec L$ and axis 3. Write $L = |\\vec L|$.\n\n$$ {line} $$\n"
        )
    };
    let last = |line: &str| verdicts(&text(line)).pop();
    assert_eq!(last("L\\cos\\theta = C\\,\\omega_3"), Some('p'));
    assert_eq!(last("L\\sin\\theta = C\\,\\omega_3"), Some('r'));
}

#[test]
fn a_derivative_in_the_angle_of_a_cone_stays_open() {
    let text = "On principal axes the body has $I_1 = I_2 = A$ and $I_3 = C$. Let $\\theta$ be the angle between the angular \
                momentum $\\vec L$ and the axis of symmetry, $L = |\\vec L|$, and $T$ the kinetic energy.\n\n\
                $$ T = \\frac{L^2\\sin^2\\theta}{2A} + \\frac{L^2\\cos^2\\theta}{2C} $$\n\n\
                $$ \\frac{dT}{d\\theta} = L^2\\left(\\frac1A - \\frac1C\\right)\\sin\\theta\\cos\\theta $$\n";
    assert!(verdicts(text).ends_with("pu"), "{}", verdicts(text));
}

#[test]
fn a_display_with_a_stop_ends_the_sentence_before_the_angle() {
    let text = |line: &str| {
        format!(
            "{BODY}With the angular momentum $\\vec L$ the angular velocity can be split as\n\n\
             $$ \\vec\\omega = \\frac{{\\vec L}}{{A}} + \\left(1 - \\frac CA\\right)\\omega_3\\,\\hat e_3 . $$\n\n\
             The normal goes round at the rate\n\n$$ \\Omega_p = \\frac LA . $$\n\n\
             If $\\theta$ is the angle between $\\vec L$ and $\\hat e_3$, then\n\n$$ {line} $$\n"
        )
    };
    let last = |line: &str| verdicts(&text(line)).pop();
    assert_eq!(last("L\\cos\\theta = C\\,\\omega_3"), Some('p'));
    assert_eq!(
        last("\\Omega_p = \\frac{C\\,\\omega_3}{A\\cos\\theta}"),
        Some('p')
    );
    assert_eq!(
        last("\\Omega_p = \\frac{A\\,\\omega_3}{C\\cos\\theta}"),
        Some('r')
    );
}

#[test]
fn plain_text_names_moments_rates_and_the_angle() {
    let text = |line: &str| {
        format!(
            "A body of revolution is free of torques. C is the moment of inertia\nabout the symmetry axis, A the one about any \
             transverse axis.\n\nLet ωs be the rate about the symmetry axis and ωt the transverse rate.\nThe angular momentum \
             is H and the kinetic energy is\n\n    T = ½ (A ωt² + C ωs²)\n\nThe angle θ between the symmetry axis and H \
             obeys\n\n    {line}\n\nLosing energy means that θ grows.\n"
        )
    };
    let last = |line: &str| verdicts_in(&text(line), Format::Text);
    assert_eq!(last("C ωs = H cos θ"), "pp");
    assert_eq!(last("A ωt = H sin θ"), "pp");
    assert_eq!(last("C ωs = H sin θ"), "pr");
    assert_eq!(last("A ωs = H cos θ"), "pr");
}

#[test]
fn the_angle_between_momentum_and_rate_has_its_cosine_by_the_energy() {
    let cosine = |words: &str, line: &str| {
        verdicts(&format!(
            "A free body with the principal moments $A$, $B$, $C$ has the kinetic energy $T$ and the angular momentum $\\mathbf L$.\n\n\
             {words}\n\n$$ \\cos\\beta = {line} $$\n"
        ))
    };
    let by_letters = r"The angle $\beta$ between $\mathbf L$ and $\boldsymbol\omega$ follows from";
    let by_words =
        r"Let $\beta$ be the angle between the angular momentum and the axis of rotation. Then";
    for words in [by_letters, by_words] {
        assert_eq!(cosine(words, r"\frac{2T}{L\omega}"), "a");
        assert_eq!(cosine(words, r"\frac{T}{L\omega}"), "r");
    }
}

#[test]
fn its_axis_may_be_all_that_is_said_of_the_axis() {
    let text = |ratio: &str| {
        verdicts(&format!(
            "A free symmetric body has the moments $A, A, C$. Its axis makes the constant angle $\\theta$ with the fixed angular \
             momentum $\\mathbf L$.\n\n$$ L\\cos\\theta = C\\omega_3 $$\n\nThe precession rate is\n\n\
             $$ \\Omega_p = \\frac{{L}}{{A}} $$\n\n$$ \\Omega_p = \\frac{{C\\omega_3}}{{A{ratio}\\theta}} $$\n"
        ))
    };
    assert_eq!(text("\\cos"), "pap");
    assert_eq!(text("\\sin"), "par");
}

#[test]
fn words_for_an_angle_may_stand_before_its_tangent() {
    let text = |rate: &str, nutation: &str, other: &str| {
        verdicts(&format!(
            "A satellite with $I_{{xx}} = I_{{yy}} = I_t$ and $I_{{zz}} = I_s$ spins about $z$ without torque. The spin is \
             constant, $\\omega_z = \\Omega$. Put $\\lambda = (I_s - I_t)\\Omega/I_t$. The solution is\n\n\
             $$ \\omega_x = \\omega_t\\cos\\lambda t, \\qquad \\omega_y = \\omega_t\\sin\\lambda t $$\n\n\
             The transverse rate $\\omega_t = {rate}$ is constant. The nutation angle is given by\n\n\
             $$ \\tan\\theta = \\frac{{{nutation}}} $$\n\n\
             and the angle between the spin axis and the angular velocity by\n\n\
             $$ \\tan\\gamma = \\frac{{{other}}} $$\n"
        ))
    };
    let root = "\\sqrt{\\omega_x^2 + \\omega_y^2}";
    let ends = |rate, nutation, other| text(rate, nutation, other)[6..].to_owned();
    let (right, other) = ("I_t\\omega_t}{I_s\\Omega", "\\omega_t}{\\Omega");
    assert_eq!(ends(root, right, other), "ppp");
    assert_eq!(
        ends("2\\sqrt{\\omega_x^2 + \\omega_y^2}", right, other),
        "rpp"
    );
    assert_eq!(ends(root, "I_s\\omega_t}{I_t\\Omega", other), "prp");
    assert_eq!(ends(root, right, "\\Omega}{\\omega_t"), "ppr");
}

#[test]
fn one_clause_may_name_two_angles() {
    let text = |theta: &str, gamma: &str| {
        verdicts(&format!(
            "Body axes are principal, $z$ is the drum axis. Take $I_x = I_y = A$ and $I_z = C$; no torque acts. With $\\theta$ the \
             nutation angle (between $\\vec h$ and the drum axis) and $\\gamma$ the angle between $\\vec\\omega$ and the drum axis, \
             $\\vec h = I\\vec\\omega$ and $s = \\sqrt{{\\omega_x^2 + \\omega_y^2}}$,\n\n\
             $$ \\tan\\theta = \\frac{{{theta}}} $$\n\n$$ \\tan\\gamma = \\frac{{{gamma}}} $$\n"
        ))
    };
    let (theta, gamma) = ("A s}{C \\omega_z", "s}{\\omega_z");
    assert!(text(theta, gamma).ends_with("pp"), "{}", text(theta, gamma));
    assert!(text(theta, theta).ends_with("pr"));
    assert!(text(gamma, gamma).ends_with("rp"));
}

#[test]
fn the_axis_of_a_plate_is_its_axis_of_symmetry() {
    let text = |across: &str, along: &str| {
        verdicts(&format!(
            "Euler's equations without torque on principal axes with $I_1 = I_2$. The angle $\\theta$ between $\\mathbf L$ \
             and the axis of the plate is given by\n\n\
             $$ \\tan\\theta = \\frac{{{across}\\sqrt{{\\omega_1^2+\\omega_2^2}}}}{{{along}\\omega_3}} $$\n"
        ))
    };
    assert_eq!(text("I_1", "I_3"), "ap");
    assert_eq!(text("I_3", "I_1"), "ar");
}

/// The verdicts on lines about a free top whose moments only have labels.
fn labelled(lines: [&str; 2]) -> String {
    let [angle, spin] = lines;
    verdicts(&format!(
        r"A slender top floats without torque. Its symmetry axis is $\hat{{\mathbf s}}$; $\omega_s$ is the component of $\boldsymbol\omega$ along $\hat{{\mathbf s}}$ and $\omega_\perp$ the length of the part across it. The angular velocity leans from the symmetry axis by $\alpha$, the angular momentum by $\theta$:

$$ \tan\alpha = \frac{{\omega_\perp}}{{\omega_s}} $$

$$ \tan\theta = {angle} $$

Seen from space the symmetry axis goes round the fixed direction of $\mathbf L$ at the rate

$$ \dot\phi = \frac{{L}}{{I_t}} $$

while the top spins about its own axis, relative to the precessing plane, at

$$ \dot\psi = {spin} $$

$$ \dot\phi\,\sin(\theta - \alpha) = \dot\psi\,\sin\alpha $$

$$ T = \frac12\left(I_t\omega_\perp^2 + I_s\omega_s^2\right) $$
"
    ))
}

#[test]
fn labels_tell_the_moments_of_a_symmetric_body() {
    let angle = r"\frac{I_t\,\omega_\perp}{I_s\,\omega_s}";
    let spin = r"\omega_s - \dot\phi\cos\theta = \frac{I_t - I_s}{I_t}\,\omega_s";
    assert_eq!(labelled([angle, spin]), "ppappp");
    let turned = r"\frac{I_s\,\omega_\perp}{I_t\,\omega_s}";
    assert_eq!(&labelled([turned, spin])[1..2], "r");
    let false_spin = spin.replace("I_t - I_s", "I_s - I_t");
    assert_eq!(&labelled([angle, &false_spin])[3..4], "r");
}

#[test]
fn axes_that_words_lay_out_are_not_those_with_numbers() {
    let text = r"The disc has the moments $J_d = \frac14mR^2$ and $J_p = \frac12mR^2$ for a diameter and for the normal. Its axes $\mathbf e_1$, $\mathbf e_2$, $\mathbf e_3$ are principal, with $\omega_3 = \Omega\cos\beta$, and we take

$$ \boldsymbol\omega = \Omega\sin\beta\,\mathbf e_1 + \Omega\cos\beta\,\mathbf e_3 $$

$$ \mathbf L = J_d\,\Omega\sin\beta\,\mathbf e_1 + J_p\,\Omega\cos\beta\,\mathbf e_3 $$

Let $z$ run along the shaft, $y$ along $\mathbf e_2$, and $x$ complete the frame. Then

$$ I_{zz} = J_d\sin^2\beta + J_p\cos^2\beta $$
";
    let found = verdicts(text);
    assert!(found.ends_with("pu"), "{found}");
}
