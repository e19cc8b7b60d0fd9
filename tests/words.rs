//! What words and the content of a line make of it, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::document::Format;

#[test]
fn moments_named_in_words_are_components() {
    let top = |line: &str| {
        verdicts(&format!(
            "The $z$ axis is along the axis of symmetry. With $I$ for the moment of inertia about the $z$ axis and \
             $I'$ for the one about a transverse axis,\n\n$$ {line} $$\n"
        ))
    };
    assert_eq!(
        top(r"\mathbf H = I'\omega_x\mathbf i + I'\omega_y\mathbf j + I\omega_z\mathbf k"),
        "p"
    );
    assert_eq!(
        top(r"\mathbf H = I\omega_x\mathbf i + I'\omega_y\mathbf j + I\omega_z\mathbf k"),
        "r"
    );
}

#[test]
fn words_make_symbols_constant_and_laws_stay_claims() {
    let text = r"The rate $p$ and the angle $\psi$ are constant. Let $\omega_x = p\sin\psi$. Then

$$ \dot\omega_x = 0 $$

Torque-free, we say that $T$ is constant. Also

$$ \dot\omega_x = \dot p\sin\psi + p\dot\psi\cos\psi $$
";
    assert_eq!(verdicts(text), "app");
    let moving = r"Let $\omega_x = p\sin\psi$. Then

$$ \dot\omega_x = 0 $$

$$ \dot\omega_x = \dot p\sin\psi + p\dot\psi\cos\psi $$
";
    assert_eq!(verdicts(moving), "arp");
}

#[test]
fn a_definition_behind_its_first_use_is_taken_in_before() {
    let text = |sign: &str| {
        format!(
            "Without torque, on principal axes with $I_x = I_y$,\n\n$$ \\dot\\omega_x = {sign}k\\,\\omega_y, \\qquad \
             \\dot\\omega_y = k\\,\\omega_x $$\n\nwhere $k = (I_z - I_x)\\,\\omega_z/I_x$.\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "appa");
    assert_eq!(verdicts(&text("")), "arpa");
}

#[test]
fn what_laws_determine_is_a_claim_behind_with_and_where() {
    let text = r"On body axes with principal moments, with

$$ L_x = I_x\omega_y $$

and where

$$ M_x = I_x\dot\omega_x + (I_z - I_y)\omega_y\omega_z $$
";
    assert_eq!(verdicts(text), "rp");
}

#[test]
fn news_of_free_symbols_is_given_and_used() {
    let text = r"The bearing forces are $\mathbf A$ and $\mathbf B$.

$$ A_x + B_x = 0 $$

$$ B_x = -A_x $$

$$ B_x = A_x $$
";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn a_torque_law_is_given_and_what_follows_is_checked() {
    let text = r"The body has the principal moments $A$, $A$ and $C$. The air resists:

$$ M_1 = -c\,\omega_1, \qquad M_2 = -c\,\omega_2 $$

Euler's equations are

$$ A\dot\omega_1 + (C - A)\,\omega_2\omega_3 = -c\,\omega_1 $$

$$ A\dot\omega_2 + (C - A)\,\omega_3\omega_1 = -c\,\omega_2 $$
";
    assert_eq!(verdicts(text), "aapr");
}

#[test]
fn an_angle_given_in_degrees_has_its_sine_everywhere() {
    let text = r"Let $a = b\cos\theta$.

## A right angle

Set $\theta = 90^\circ$. Then $a = 0$ and $\sin\theta = 1$.

## Sixty degrees

Set $\theta = 60^\circ$. Then $a = b/2$.
";
    assert_eq!(verdicts(text), "aappap");
}

#[test]
fn an_inequality_keeps_a_case_apart() {
    let text = r"Assume $I_x \ne I_y$ and $\omega_z > 0$. But $I_x + I_y \ne I_y + I_x$ is absurd.";
    assert_eq!(verdicts(text), "aar");
}

#[test]
fn vectors_with_a_number_are_no_components() {
    let text = r"Let $\boldsymbol\omega_1 = 2\,\mathbf j$ and $\boldsymbol\omega_2 = 3\,\mathbf k$. Then

$$ \boldsymbol\omega_1\times\boldsymbol\omega_2 = 6\,\mathbf i $$

and not

$$ \boldsymbol\omega_2\times\boldsymbol\omega_1 = 6\,\mathbf i $$
";
    assert_eq!(verdicts(text), "aapr");
}

#[test]
fn products_that_words_name_do_not_vanish() {
    let text = r"Let $A$, $B$, $C$ be the moments of inertia and $D = \int yz\,dm$, $E = \int zx\,dm$, $F = \int xy\,dm$ the
products of inertia. The momenta are

$$ h_1 = A\omega_1 - F\omega_2 - E\omega_3 $$

$$ h_1 = A\omega_1 $$
";
    assert_eq!(verdicts(text), "aaapr");
}

#[test]
fn a_value_at_one_instant_leaves_the_rate_free() {
    let text = r"The shaft turns with $\boldsymbol\omega = \omega\,\mathbf i$ on principal axes.

Take $I_x = 0.12$, at the instant when $\omega = 100$ and $\dot\omega = 50$. Then

$$ M_x = 6.0 $$

$$ M_x = 6.1 $$
";
    assert_eq!(verdicts(text), "aaaapr");
}

#[test]
fn hamiltons_and_lagranges_functions_are_no_momenta() {
    let text = r"The potential energy is $V = mgl\cos\theta$ and the Lagrangian $\mathcal L = T - V$ with

$$ T = \tfrac12 A\dot\theta^2 + \tfrac12 C\dot\psi^2 $$

Then

$$ \frac{\partial\mathcal L}{\partial\dot\psi} = C\dot\psi $$
";
    assert!(!verdicts(text).contains('r'), "{}", verdicts(text));
}

#[test]
fn marks_of_its_own_in_the_prose_do_no_harm() {
    let text = "With ⟨99⟩ for the moment of inertia about ⟨7⟩ axis and ⟨⟩ for the one about a diameter, $L_z = 1$.";
    assert_eq!(verdicts(text).len(), 1);
}

#[test]
fn functions_of_functions_cost_no_more_than_their_length() {
    let text = r"$$x = \sin(\sin(\sin(\sin(\sin(\sin(\sin(\sin(x))))))))$$";
    assert_eq!(verdicts(text).len(), 1);
}

#[test]
fn a_letter_is_a_mass_bare_and_a_moment_with_an_arrow() {
    let body = |line: &str| {
        verdicts(&format!(
            "A body of mass $M$ moves with the velocity $\\vec v_G$ of its mass centre, and $\\vec M$ is the moment about \
             it.\n\n$$ {line} $$\n\n$$ \\vec M = \\dot{{\\vec L}} + \\vec\\omega\\times\\vec L $$\n"
        ))
    };
    assert_eq!(
        body(r"T = \tfrac12 M\,\vec v_G\cdot\vec v_G + \tfrac12\,\vec\omega\cdot\vec L"),
        "pp"
    );
    assert_eq!(
        body(r"T = M\,\vec v_G\cdot\vec v_G + \tfrac12\,\vec\omega\cdot\vec L"),
        "rp"
    );
}

#[test]
fn words_name_the_formula_behind_them_and_its_list_alone() {
    let text = r"The energy $E = T + V$ is a function of $\theta$ alone. Let

$$ \omega_3 = \dot\psi + \dot\phi\cos\theta $$

Here $T$ is the kinetic energy. It is

$$ T = \tfrac12 I_3\omega_3^2 $$
";
    assert_eq!(verdicts(text), "aar");
}

#[test]
fn words_bring_a_thing_in_or_name_a_formula() {
    let moment = |opening: &str| {
        verdicts(&format!(
            "With the inertia $J$ let $\\vec L = J\\vec\\omega$.\n\n{opening}\n\n$$ \\sum\\vec N = \\dot{{\\vec L}} + \\vec\\omega\\times\\vec L $$\n"
        ))
    };
    assert_eq!(
        moment("With the angular momentum from above this becomes"),
        "pp"
    );
    assert_eq!(
        moment("The sum of the moments $N_x$ and $N_y$ is not zero, so that"),
        "pp"
    );
}

#[test]
fn moments_of_inertia_and_the_torque_are_told_by_their_places_in_a_law() {
    let text = r"On the principal axes $\mathbf H = \mu_1\omega_1\,\mathbf e_1 + \mu_2\omega_2\,\mathbf e_2 + \mu_3\omega_3\,\mathbf e_3$ and

$$ \mathbf S = \frac{d\mathbf H}{dt} $$

so that

$$ \mu_1\dot\omega_1 + (\mu_3 - \mu_2)\,\omega_2\omega_3 = S_1 $$

$$ \mu_2\dot\omega_2 + (\mu_3 - \mu_1)\,\omega_3\omega_1 = S_2 $$

For a lamina

$$ \mu_3 = \mu_1 + \mu_2 $$

$$ \mu_1(\dot\omega_1 + \omega_2\omega_3) = S_1 $$
";
    assert_eq!(verdicts(text), "pppra p".replace(' ', ""));
}

#[test]
fn what_a_supposition_calls_constant_changes_elsewhere() {
    let text = r"Let $\omega_z = \Omega_z + s$, where the axes turn with $\Omega$. Then

$$ \dot\omega_z = \dot\Omega_z $$

Suppose that $\Omega_z$ and $s$ are constant. Then

$$ \dot\omega_z = 0 $$
";
    assert_eq!(verdicts(text), "arp");
}

#[test]
fn a_claim_about_a_case_is_no_assumption() {
    let opening = "On the principal axes with the moments of inertia $C_1, C_2, C_3$ the energy is $T = \\tfrac12(C_1\\omega_1^2 + C_2\\omega_2^2 + C_3\\omega_3^2)$.";
    let text = format!(
        "{opening} For $\\omega_3 = 0$\nthis must fall back to\n\n$$ T = C_1\\omega_1^2 + C_2\\omega_2^2 $$\n"
    );
    assert_eq!(verdicts(&text), "par");
}

#[test]
fn numbered_moments_beside_lettered_ones_may_be_about_other_axes() {
    let text = r"A plate has $J_x = \int y^2\,dm$, $J_y = \int x^2\,dm$, $J_{xy} = \int xy\,dm$ and the principal moments $J_1$, $J_2$.

$$ (J_1 - J_2)^2 = (J_x - J_y)^2 + 4J_{xy}^2 $$
";
    assert!(!verdicts(text).contains('r'));
}

#[test]
fn the_determinant_of_a_letter_that_is_no_matrix_stays_open() {
    let text = r"The body rates are $\omega_1, \omega_2, \omega_3$ and $F$ is the Jacobian.

$$ \det F = 2\,\omega_1\omega_2\omega_3 $$
";
    assert_eq!(verdicts(text), "u");
}

#[test]
fn a_principal_axis_somewhere_is_no_choice_of_axes() {
    let line = "$$ I_{xy} = 0 $$\n";
    let text =
        |words: &str| format!("{words}\n\n$$ \\mathbf L = I\\boldsymbol\\omega $$\n\n{line}");
    assert_eq!(
        verdicts(&text("The body spins about a principal axis.")),
        "pa"
    );
    assert_eq!(verdicts(&text("We use the principal axis system.")), "pp");
}

#[test]
fn typed_notes_hold_lines_in_comments_and_brackets() {
    let with = |term: &str| {
        let text = "% rotor notes, axes fixed in the rotor\n\
                    % Ixz = integral of x*z dm (so a minus in H)\n\n\
                    Turn about z only (wx = 0, wy = 0). Angular momentum:\n\n    \
                    Hx = -Ixz*wz\n\n\
                    At constant speed, dwz/dt = 0:\n\n    \
                    My = TERM*wz^2\n";
        verdicts_in(&text.replace("TERM", term), Format::Text).pop()
    };
    assert_eq!(with("-Ixz"), Some('p'));
    assert_eq!(with("Ixz"), Some('r'));
}

#[test]
fn what_there_is_none_of_is_not_named() {
    let text = r"I know that $L = I\omega$. Let $R$ be the rotation matrix that takes body components to lab components, and mark body components with a subscript $b$:

$$ L = R\,L_b $$

Without a torque both $T$ and $L$ are constant in the lab frame. The body components change:

$$ \dot L_b = -\omega_b\times L_b $$
";
    assert_eq!(verdicts(text), "ppp");
}

#[test]
fn the_title_of_a_section_in_plain_text_names_no_letter() {
    let text = |energy: &str| {
        format!(
            "1. Data\n\n   A = 2 kg m^2, B = 3 kg m^2 and C = 4 kg m^2 are the principal moments.\n\n\
             2. Energy and momentum\n\n   Rate about the axle: w = 5 rad/s, with w1 = 3 rad/s, w2 = 4 rad/s, w3 = 0.\n\n\
             \x20  T = 1/2 (A w1^2 + B w2^2) = {energy} J\n\n   L1 = A w1 = 6 kg m^2/s\n"
        )
    };
    let found = verdicts_in(&text("33"), Format::Text);
    assert!(found.ends_with("pp"), "{found}");
    let found = verdicts_in(&text("66"), Format::Text);
    assert!(found.ends_with("rp"), "{found}");
}
