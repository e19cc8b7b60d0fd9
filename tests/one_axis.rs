//! Turns about one fixed axis, values at one instant, and tensors about several points, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::document::Format;

#[test]
fn two_states_of_a_body_have_one_momentum_where_it_is_conserved() {
    let text = |words: &str, ratio: &str| {
        format!(
            "The moment of inertia of a platform changes from $J_1$ to $J_2$. {words}\n\n$$ J_1\\omega_1 = J_2\\omega_2 $$\n\n\
             so that\n\n$$ \\omega_2 = {ratio}\\,\\omega_1 $$\n"
        )
    };
    let conserved = "Its angular momentum is conserved:";
    assert_eq!(verdicts(&text(conserved, r"\frac{J_1}{J_2}")), "pp");
    assert_eq!(verdicts(&text(conserved, r"\frac{J_2}{J_1}")), "pr");
    // Nothing says what happens between them.
    assert!(verdicts(&text("Then", r"\frac{J_1}{J_2}")).starts_with('u'));
}

#[test]
fn a_turn_about_one_axis_may_change_its_moment_of_inertia() {
    let text = r"A ring of mass $m$ slides out along a rod that turns about a fixed axis at the rate $\Omega$; $x(t)$ is its distance.

$$ J = J_0 + m x^2 $$

$$ \dot J = 2 m x\,\dot x $$

The angular momentum about the axis is

$$ h = J\,\Omega $$

and the torque $Q$ about it

$$ Q = \dot h $$

$$ Q = J\,\dot\Omega $$

$$ Q = J\,\dot\Omega + 2 m x\,\dot x\,\Omega $$

Suppose $Q = 0$, with $\Omega(0) = \Omega_0$ at the beginning.

$$ \dot\Omega = -\frac{\dot J}{J}\,\Omega $$
";
    assert_eq!(verdicts(text), "apppr paap".replace(' ', ""));
}

#[test]
fn a_one_behind_a_number_of_vectors_is_the_unit_matrix() {
    let text = r"The tensor about the corner is, with the inertia tensor $I_G$ about the mass centre and $\mathbf c$ the vector between them,

$$ I_K = I_G + m\left(\mathbf c^T\mathbf c\,1 - \mathbf c\,\mathbf c^T\right) $$

$$ I_K = I_G - m\,\tilde{\mathbf c}\,\tilde{\mathbf c} $$

$$ \operatorname{tr} I_K = \operatorname{tr} I_G + 2 m\,\mathbf c\cdot\mathbf c $$

$$ \operatorname{tr} I_K = \operatorname{tr} I_G + m\,\mathbf c\cdot\mathbf c $$
";
    assert_eq!(verdicts(text), "pppr");
}

#[test]
fn what_has_a_value_at_the_beginning_goes_on_from_it() {
    let text = |solution: &str| {
        format!(
            "The body has the moment of inertia $J$ about axis 3 and $K$ about the principal axes 1 and 2. The \
             motor gives a torque about one axis only,\n\n$$ M_1 = 0, \\quad M_2 = 0, \\quad M_3 = M $$\n\nwith constant \
             $M$. With $\\omega_3 = s$ at $t = 0$,\n\n$$ \\omega_3 = {solution} $$\n"
        )
    };
    let right = verdicts(&text(r"s + \frac{M}{J}\,t"));
    assert!(right.ends_with('a'), "{right}");
    let wrong = verdicts(&text(r"2s + \frac{M}{J}\,t"));
    assert!(!wrong.ends_with(['a', 'p']), "{wrong}");
}

#[test]
fn what_is_kept_has_the_value_of_the_beginning() {
    let text = |kept: &str| {
        format!(
            "A rod turns about a fixed axis at the rate $\\Omega$; a ring of mass $m$ slides along it, $x(t)$ away.\n\n\
             $$ J = K + m x^2 $$\n\n$$ L = J\\,\\Omega $$\n\nSuppose that no torque acts, so that $\\dot L = 0$. With \
             $x(0) = 0$ and $\\Omega(0) = \\Omega_0$ at the beginning\n\n$$ J\\,\\Omega = {kept} $$\n"
        )
    };
    let right = verdicts(&text(r"K\,\Omega_0"));
    assert!(right.ends_with('a'), "{right}");
    let wrong = verdicts(&text(r"2 K\,\Omega_0"));
    assert!(!wrong.ends_with(['a', 'p']), "{wrong}");
}

#[test]
fn a_sum_over_the_masses_is_the_moment_of_inertia() {
    let text = |sum: &str| verdicts(&format!("$$ I_{{xx}} = \\sum m\\,({sum}) $$\n"));
    assert_eq!(text("y^2 + z^2"), "p");
    assert_ne!(text("x^2 + z^2"), "p");
    let products = r"The products are $I_{xy} = \sum_i m_i x_i y_i$.

$$ I_{xy} = 2\cdot 3 = 6 $$
";
    assert_eq!(verdicts(products), "pp");
}

#[test]
fn a_bare_rate_is_about_the_axis_that_the_words_fix() {
    let text = |row: &str| {
        verdicts(&format!(
            r"A rotor rotates about the fixed $z$ axis, and $I_{{yz}} = \int yz\,dm$.
Data: $I_{{zz}} = 0.5\ \mathrm{{kg\,m^2}}$, $I_{{yz}} = 0.03\ \mathrm{{kg\,m^2}}$, $I_{{xz}} = 0$. The angular velocity is $\omega = 20\ \mathrm{{rad/s}}$ and the angular acceleration $\dot\omega = 4\ \mathrm{{rad/s^2}}$.
Its angular momentum is $\mathbf L$. Of the moment of the bearings

$$ \mathbf M = \dot{{\mathbf L}} + \boldsymbol\omega\times\mathbf L $$

and one component of it

$$ {row} $$
"
        ))
    };
    let last = |row: &str| text(row).pop();
    assert_eq!(
        last(r"M_x = I_{yz}\,\omega^2 = 12\ \mathrm{N\,m}"),
        Some('p')
    );
    assert!(!matches!(
        last(r"M_x = -I_{yz}\,\omega^2 = -12\ \mathrm{N\,m}"),
        Some('p' | 'a')
    ));
    assert_eq!(
        last(r"M_z = I_{zz}\,\dot\omega = 2\ \mathrm{N\,m}"),
        Some('p')
    );
    assert_eq!(last(r"\tan\beta = \frac{I_{yz}}{I_{zz}} = 0.06"), Some('p'));
    assert_eq!(last(r"\tan\beta = \frac{I_{yz}}{I_{zz}} = 0.6"), Some('r'));
}

#[test]
fn a_barred_moment_of_inertia_is_the_number_about_the_mass_centre() {
    let text = r"A wheel with the centroidal moment of inertia $\bar I$ rolls with the angular velocity $\omega$, and $\alpha$ is the angular acceleration.

$$ M_G = \bar I\,\alpha $$

$$ M_G = 2\,\bar I\,\alpha $$
";
    assert_eq!(verdicts(text), "pr");
}

#[test]
fn a_number_for_the_angular_velocity_is_about_the_axis_that_is_named() {
    let text = r"A wheel spins at a constant $\omega$ about the $z$ axis and has the product of inertia $I_{yz}$; $I_{xz} = 0$.

$$ M_x = I_{yz}\omega^2,\qquad M_y = 0 $$

$$ M_x = -I_{yz}\omega^2 $$
";
    assert_eq!(verdicts(text), "appr");
}

#[test]
fn a_vector_has_no_entry_with_two_indices() {
    let text = r"A satellite has $\omega_3 = 2$ rad/s and $\omega_{12} = \sqrt{\omega_1^2+\omega_2^2} = 0.1$ rad/s.

$$ \omega_{12}\,\omega_3 = 0.2 $$
";
    assert_eq!(verdicts(text), "aap");
}

#[test]
fn moments_of_inertia_without_an_angular_velocity_are_numbers() {
    let text = r"The spin is fast, so the gyroscopic moment is $M = C n\,\Omega$. The wheel has $m = 2$, $r = 3$, $l = 4$ and $n = 5$. Its moment of
inertia is $C = m r^2 = 18$. The weight turns it at

$$ \Omega = \frac{m g l}{C n} = \frac{g l}{r^2 n} $$
";
    assert_eq!(verdicts(text), "aaaaapp");
}

#[test]
fn a_rotor_turns_through_an_angle_about_a_bearing_with_a_letter() {
    let text = |sign: &str| {
        format!(
            "The rotor turns about the $z$ axis through the angle $\\varphi(t)$. The axes $xyz$ rotate with it. \
             The products of inertia about $A$ are $J_{{xz}} = \\int xz\\,dm$ and $J_{{yz}} = \\int yz\\,dm$.\n\n\
             $$ \\mathbf L_A = -J_{{xz}}\\dot\\varphi\\,\\mathbf i {sign} J_{{yz}}\\dot\\varphi\\,\\mathbf j + J_z\\dot\\varphi\\,\\mathbf k $$\n\n\
             $$ \\dot{{\\mathbf j}} = {sign}\\dot\\varphi\\,\\mathbf i $$\n\n$$ M_x = -J_{{xz}}\\ddot\\varphi + J_{{yz}}\\dot\\varphi^2 $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "ppppp");
    assert_eq!(verdicts(&text("+")), "pprrp");
}

#[test]
fn plain_text_crosses_the_letter_of_a_number() {
    let text = |sign: &str| {
        let text = format!(
            "Two small balls of mass m sit at the ends of a light rod of length 2b.\n\
             Axes x, y, z turn with the shaft, rod in the xz plane.\n\n\
             The positions of the balls are\n\n    r₁ = (b sin α, 0, b cos α)\n    r₂ = −r₁\n\n\
             The shaft turns at the rate ω about z, so the angular momentum is\n\n    L_x = −I_xz ω\n    L_y = 0\n    L_z = I_zz ω\n\n\
             The torque, seen from the turning axes, is\n\n    τ = L̇ + ω × L\n\nIn components\n\n    \
             τ_x = −I_xz ω̇\n    τ_y = {sign}I_xz ω²\n    τ_z = I_zz ω̇\n"
        );
        verdicts_in(&text, Format::Text)
    };
    assert_eq!(text("−"), "aappppppp");
    assert_eq!(text(""), "aappppprp");
}

#[test]
fn a_rate_that_is_said_to_be_a_component_is_all_of_a_turn_about_its_axis() {
    let text = |sign: &str, moment: &str| {
        format!(
            "A rotor turns about the fixed $z$ axis with angular velocity $\\Omega$ and angular acceleration $\\alpha = \\dot\\Omega$. Only $\\Omega_z = \\Omega$ is different from zero, so\n\n\
             $$ L_x = {sign}I_{{xz}}\\Omega $$\n\n\
             **Speed.** At constant speed the moment across the axis is\n\n$$ M_y = -I_{{xz}}\\Omega^2 $$\n\n\
             **Start.** To start with $\\alpha = 20\\text{{ rad/s}}^2$ the motor has to supply\n\n$$ M_z = {moment} $$\n"
        )
    };
    assert_eq!(verdicts(&text("-", r"20\,I_{zz}")), "ppppap");
    assert_eq!(verdicts(&text("", r"20\,I_{zz}")), "pprpap");
    assert_eq!(verdicts(&text("-", r"10\,I_{zz}")), "ppppar");
}

#[test]
fn a_torque_that_brakes_is_against_the_turn() {
    let text = |words: &str, sign: &str| {
        format!(
            "A flywheel with the moment of inertia $I$ {words} $\\tau$. Then\n\n$$ I\\dot\\omega = {sign}\\tau $$\n"
        )
    };
    for words in [
        "is slowed down by the constant torque",
        "turns at $\\omega$ against the friction torque",
        "is brought to rest by the braking torque",
    ] {
        assert_eq!(verdicts(&text(words, "-")), "p", "{words}");
        assert_eq!(verdicts(&text(words, "")), "r", "{words}");
    }
    for words in [
        "is driven by the torque",
        "turns without friction under the torque",
        "is accelerated against friction by the net torque",
    ] {
        assert_eq!(verdicts(&text(words, "")), "p", "{words}");
        assert_eq!(verdicts(&text(words, "-")), "r", "{words}");
    }
}

#[test]
fn a_constant_torque_speeds_up_from_rest_and_a_brake_stops() {
    let from_rest = |speed: &str| {
        verdicts(&format!(
            "A wheel of moment of inertia $I$ starts from rest under a constant torque $\\tau$. Then\n\n$$ {speed} $$\n"
        ))
    };
    assert_eq!(from_rest(r"\omega = \frac{\tau}{I} t"), "a");
    assert_eq!(from_rest(r"\omega = 2\frac{\tau}{I} t"), "r");
    let stops = |time: &str| {
        verdicts(&format!(
            "A wheel of moment of inertia $I$ has the speed $\\omega_0$ when a brake with the constant torque $\\tau$ is \
             applied. Then\n\n$$ \\omega = \\omega_0 - \\frac{{\\tau}}{{I}} t $$\n\nIt comes to rest after\n\n$$ {time} $$\n"
        ))
    };
    assert_eq!(stops(r"t = \frac{I\omega_0}{\tau}"), "aa");
    assert_eq!(stops(r"t = \frac{2I\omega_0}{\tau}"), "ar");
}

#[test]
fn constant_speed_holds_about_the_axis_that_a_line_names() {
    let text = |speed: &str| {
        verdicts(&format!(
            "The rotor spins about $z$ only, so $\\boldsymbol\\omega = \\omega\\,\\mathbf k$.\n\n\
             $$ M_x = -I_{{xz}}\\dot\\omega + I_{{yz}}\\omega^2 $$\n\n{speed}\n\n$$ M_x = I_{{yz}}\\omega^2 $$\n"
        ))
    };
    assert_eq!(text("At constant speed"), "app");
    assert_eq!(text("In general"), "apr");
}

#[test]
fn a_bare_omega_is_the_rate_about_the_axis_that_words_name() {
    for words in [
        "The shaft turns at $\\Omega$ about $z$.",
        "The rotor turns with the angular velocity $\\boldsymbol\\omega = \\Omega\\mathbf k$.",
    ] {
        let text = |factor: &str| {
            verdicts(&format!(
                "{words}\n\n$$ T = {factor}I_{{zz}}\\Omega^2 $$\n\n$$ L_z = I_{{zz}}\\Omega $$\n"
            ))
        };
        assert!(text("\\tfrac12").ends_with("pp"), "{words}");
        assert!(text("").ends_with("rp"), "{words}");
    }
}

#[test]
fn a_torque_about_the_axis_is_no_moment_of_inertia() {
    let energy = |value: &str| {
        verdicts(&format!(
            "A disc with moment of inertia $I$ starts from rest under the constant torque $\\tau$ about its axis. After the \
             time $t$ it turns at\n\n$$ \\omega = \\frac{{\\tau t}}{{I}} $$\n\nand its kinetic energy is\n\n$$ E = \
             \\frac12I\\omega^2 = {value} $$\n"
        ))
    };
    assert_eq!(energy(r"\frac{\tau^2t^2}{2I}"), "ap");
    assert_eq!(energy(r"\frac{\tau^2t^2}{I}"), "ar");
}

#[test]
fn the_square_of_a_part_of_the_turn_moves_with_it() {
    let rate = |factor: &str| {
        verdicts(&format!(
            "On principal axes $I_1 = I_2 = A$, $I_3 = C$ and the moment is $\\mathbf M = -k\\boldsymbol\\omega$. Then \
             $\\omega_\\perp^2 = \\omega_1^2 + \\omega_2^2$ obeys\n\n$$ \\frac{{d}}{{dt}}\\omega_\\perp^2 = \
             -\\frac{{{factor}}}{{A}}\\omega_\\perp^2 $$\n"
        ))
    };
    assert!(rate("2k").ends_with('p'));
    assert!(rate("k").ends_with('r'));
}

#[test]
fn a_speed_about_an_axis_is_the_length_of_the_vector_in_bold() {
    let moment = |sign: char| {
        verdicts(&format!(
            "The rotor turns at a constant speed $\\Omega$ about the $z$ axis; its products of inertia are $I_{{xz}}$ and \
             $I_{{yz}}$. The angular momentum is\n\n$$ \\mathbf L = -I_{{xz}}\\Omega\\,\\mathbf i - I_{{yz}}\\Omega\\,\\mathbf j + \
             I_{{zz}}\\Omega\\,\\mathbf k $$\n\nand the bearing moment is\n\n$$ \\mathbf M = \
             \\boldsymbol\\Omega\\times\\mathbf L = I_{{yz}}\\Omega^2\\,\\mathbf i {sign} I_{{xz}}\\Omega^2\\,\\mathbf j $$\n"
        ))
    };
    assert_eq!(moment('-'), "pp");
    assert_eq!(moment('+'), "pr");
}
