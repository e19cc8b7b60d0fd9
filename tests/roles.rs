//! What a line is by the words around it and by what stands in it.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_was_concluded_is_claimed_and_a_sum_that_vanishes_defines_nothing() {
    let concluded = r"A free body has the principal moments $I_1$, $I_2$, $I_3$. From $\dot{\vec L} = \vec\tau$ with $\vec\tau = 0$ I concluded
$$I_1\dot\omega_1 = 0$$
and so the body keeps its rates.";
    assert_ne!(verdicts(concluded).chars().last(), Some('a'));
    let second = |sign: char| {
        format!(
            r"No torque acts on a body with the principal moments $I_1$, $I_1$, $I_3$. Let us define
$$n = \frac{{I_3 - I_1}}{{I_1}}\omega_3$$
$$\dot\omega_1 {sign} n\omega_2 = 0$$
"
        )
    };
    assert_eq!(verdicts(&second('+')), "ap");
    assert_eq!(verdicts(&second('-')), "ar");
}

#[test]
fn what_is_solved_for_is_no_assumption() {
    let with = |value: &str| {
        let text = format!(
            "A force $P$ keeps the block of weight $W$ up, so that\n\n$$ \\mathbf M = b(W - P)\\,\\mathbf j $$\n\n\
             Let $M_y = -c$. Setting the moment equal to this and solving for the force,\n\n$$ P = {value} $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_eq!(with("W + \\frac{c}{b}"), Some('p'));
    assert_eq!(with("W - \\frac{c}{b}"), Some('r'));
}

#[test]
fn a_force_may_lie_in_a_plane() {
    let with = |force: &str| {
        verdicts(&format!(
            "The body turns with $\\vec\\omega$. A support acts with the force $\\vec F = {force}$.\n"
        ))
    };
    assert_eq!(with("F_x\\hat i + F_y\\hat j"), "a");
    assert_ne!(with("F_x\\hat i + F_y\\hat i"), "a");
    assert_ne!(with("F_x\\hat j + F_y\\hat i"), "a");
}

#[test]
fn the_power_of_a_unit_in_words_is_no_formula() {
    let text = "Take $A = 5$ and $B = 7$ (both in kg m$^2$), $C = 9$.\n\n$$ A + B - C = 3 $$\n";
    assert_eq!(verdicts(text), "aaap");
}

#[test]
fn a_rotor_may_turn_about_an_axis_parallel_to_one() {
    let with = |sum: &str| {
        verdicts(&format!(
            "A carrier with the principal moments $J_1, J_2, J_3$ has a rotor, which turns about an axis parallel to axis 2. \
             Its angular momentum relative to the carrier is denoted by $h$, so that the total becomes\n\n\
             $$ \\mathbf H = \\mathbf J\\boldsymbol\\omega + {sum} $$\n"
        ))
    };
    assert_eq!(with("h\\,\\mathbf e_2"), "p");
    assert_ne!(with("h\\,\\mathbf e_3"), "p");
}

#[test]
fn what_is_said_to_be_equal_is_supposed() {
    let text = "The four speeds are equal, $n_1 = n_2 = n_3 = n_4$.\n\n$$ n_1 - n_2 + n_3 - n_4 = 0 $$\n\n\
                $$ n_1 + n_2 + n_3 = 2n_4 $$\n";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn what_is_set_against_mass_times_acceleration_is_a_force() {
    let text = |point: &str, sign: &str| {
        verdicts(&format!(
            r"The mass centre $C$ of the link is at the position $\mathbf r$ from the joint, which has the acceleration $\mathbf a_J$:

$$ \mathbf a_C = \mathbf a_J + \dot{{\boldsymbol\omega}}\times\mathbf r + \boldsymbol\omega\times(\boldsymbol\omega\times\mathbf r) $$

Force and moment on the link are then

$$ \mathbf f = m\,\mathbf a_{point} $$

$$ \mathbf n_C = \mathcal I_C\,\dot{{\boldsymbol\omega}} {sign} \boldsymbol\omega\times\mathcal I_C\boldsymbol\omega $$
"
        ))
    };
    let found = text("C", "+");
    assert!(found.ends_with("ap"), "{found}");
    // Of the joint it is not known, and no definition.
    let found = text("J", "+");
    assert!(found.ends_with("up"), "{found}");
    let found = text("C", "-");
    assert!(!found.ends_with(['p', 'a']), "{found}");
}

#[test]
fn the_inertia_times_the_angular_velocity_is_the_momentum() {
    let text = |sign: &str| {
        verdicts(&format!(
            r"The axes $x$, $y$, $z$ are carried by the body, with $J_{{xy}} = -\int xy\,dm$ and so on.

$$ \bm{{K}} = \begin{{pmatrix}} J_{{xx}} & J_{{xy}} & J_{{xz}} \\ J_{{xy}} & J_{{yy}} & J_{{yz}} \\ J_{{xz}} & J_{{yz}} & J_{{zz}} \end{{pmatrix}} \begin{{pmatrix}} \omega_x \\ \omega_y \\ \omega_z \end{{pmatrix}} $$

The balance of moments about the mass centre,

$$ \bm{{M}} = \frac{{d^{{*}}\bm{{K}}}}{{dt}} {sign} \bm{{\omega}}\times\bm{{K}}, $$

in which the star marks the rate seen from the body, has the components

$$ M_x = \dot K_x + \omega_y K_z - \omega_z K_y. $$

Inserting the angular momentum gives the full equation

$$ M_x = J_{{xx}}\dot\omega_x + J_{{xy}}(\dot\omega_y - \omega_z\omega_x) + J_{{xz}}(\dot\omega_z + \omega_x\omega_y) + (J_{{zz}} - J_{{yy}})\,\omega_y\omega_z + J_{{yz}}(\omega_y^2 - \omega_z^2) $$
"
        ))
    };
    assert!(text("+").ends_with("ppp"), "{}", text("+"));
    assert!(text("-").ends_with("rpp"), "{}", text("-"));
}

#[test]
fn a_product_under_another_letter_is_one_on_turned_axes_too() {
    let text = |last: &str| {
        verdicts(&format!(
            r"Turn the axes through the angle $\theta$ about $z$,

$$ x' = x\cos\theta + y\sin\theta, \qquad y' = -x\sin\theta + y\cos\theta. $$

The moments of inertia are $I_x = \int(y^2+z^2)\,dm$ and $I_y = \int(z^2+x^2)\,dm$, and the product of inertia is $P_{{xy}} = \int xy\,dm$. Then

$$ P_{{x'y'}} = ({last})\sin\theta\cos\theta + P_{{xy}}\cos 2\theta $$
"
        ))
    };
    assert!(text("I_x - I_y").ends_with('p'), "{}", text("I_x - I_y"));
    assert!(text("I_x + I_y").ends_with('r'), "{}", text("I_x + I_y"));
}

#[test]
fn numbered_lambdas_are_the_moments_that_words_call_principal() {
    let text = |difference: &str| {
        verdicts(&format!(
            "The principal moments are $\\lambda_1$, $\\lambda_2$, $\\lambda_3$. No torque acts.\n\n\
             $$ \\lambda_1\\dot\\omega_1 = ({difference})\\,\\omega_2\\omega_3 $$\n"
        ))
    };
    assert_eq!(text("\\lambda_2 - \\lambda_3"), "p");
    assert_eq!(text("\\lambda_3 - \\lambda_2"), "r");
}

#[test]
fn a_derivative_is_no_definition_of_itself() {
    let swing = "A body of mass $m$ swings about $O$, and $\\theta$ is its angle. With the radius of gyration $k$ defined by \
                 $I_G = m k^2$ the equation of motion is\n\n$$ \\ddot\\theta = -\\frac{g\\sin\\theta}{k^2 + d^2} $$\n";
    assert_ne!(verdicts(swing).chars().last(), Some('a'));
    let slope = "Write the unknown as $w$, and let\n\n$$ R(w) = J(w - u) $$\n\nThe Jacobian that you asked for is\n\n\
                 $$ \\frac{\\partial R}{\\partial w} = 2J $$\n";
    assert_ne!(verdicts(slope).chars().last(), Some('a'));
}

#[test]
fn pitching_and_yawing_moments_need_no_third() {
    let text = |sign: &str| {
        verdicts(&format!(
            "A missile with moments of inertia $I_x$, $I_y = I_z = I$ has the body rates $p, q, r$. On principal axes\n\n\
             $$ M = I\\dot q {sign} (I_x - I)\\,rp $$\n\n$$ N = I\\dot r - (I_x - I)\\,pq $$\n"
        ))
    };
    assert_eq!(text("+"), "app");
    assert_eq!(text("-"), "arp");
}

#[test]
fn what_one_wants_is_assumed_and_what_one_compares_is_claimed() {
    let text = |lead: &str, factor: &str| {
        verdicts(&format!(
            "A body is symmetric about its $xy$ plane. I write $P = \\int xy\\,dm$. {lead} $P = 0$. Then\n\n\
             $$ L_x = {factor}\\omega_x $$\n"
        ))
    };
    assert_eq!(text("I want axes such that", "I_{xx}"), "aap");
    assert_eq!(text("I want axes such that", "I_{yy}"), "aar");
    let force = |sign: &str| {
        verdicts(&format!(
            "Principal axes. $\\mathbf L = I\\boldsymbol\\omega$. Comparing with step 2,\n\n$$ L_x = {sign}I_1\\omega_x $$\n"
        ))
    };
    assert!(force("").ends_with('p'), "{}", force(""));
    assert!(!force("-").ends_with(['a', 'p']));
}

#[test]
fn words_of_a_latex_paragraph_reach_the_display_below_it() {
    use polhode::notation::{document::Format, read};
    let text = "No torque acts on a body with the principal moments $I_1$, $I_2$, $I_3$.\n\nChoose the angle such that\n\n\
                $$ \\tan 2\\theta = \\frac{2 I_2}{I_1} $$\n";
    for format in [Format::Markdown, Format::Latex] {
        let (document, _) = read("chosen", text, format);
        let found = polhode::verify::check(&document).findings;
        assert_eq!(found[0].role.name(), "assume", "{format:?}");
    }
}
