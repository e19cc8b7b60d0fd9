//! New symbols that words and laws together say the value of.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_a_line_yields_is_no_definition_of_a_symbol_that_is_known() {
    let with = |force: &str| {
        let text = r"Body axes at $O$. The body turns at a constant rate, $\boldsymbol\omega = \omega\,\mathbf{k}$. Its moment about $O$ has the component

$$ M_y = -I_{xz}\omega^2 $$

The bearings, $2b$ apart, act with the forces $R\,\mathbf i$ and $-R\,\mathbf i$, whose moment is

$$ \mathbf M = 2Rb\,\mathbf j $$

which yields $R = FORCE$.
";
        verdicts(&text.replace("FORCE", force)).chars().last()
    };
    assert_eq!(with(r"-\dfrac{I_{xz}\omega^2}{2b}"), Some('p'));
    assert_eq!(with(r"-\dfrac{I_{xz}\omega^2}{b}"), Some('r'));
}

#[test]
fn the_vertical_component_of_the_momentum_is_along_the_vertical() {
    let with = |first: &str| {
        let text = r"The axes of a symmetric top with the moments $A$, $A$, $C$ follow its axis and not its spin, and the upward vertical is $\sin\beta\,\mathbf{e}_2 + \cos\beta\,\mathbf{e}_3$. Let

$$ \mathbf{L} = A\dot\beta\,\mathbf{e}_1 + A\dot\alpha\sin\beta\,\mathbf{e}_2 + C n\,\mathbf{e}_3 $$

The vertical component of $\mathbf{L}$ is

$$ k = FIRST + C n\cos\beta $$
";
        verdicts(&text.replace("FIRST", first)).chars().last()
    };
    assert_eq!(with(r"A\dot\alpha\sin^2\beta"), Some('p'));
    assert_ne!(with(r"A\dot\alpha\sin\beta"), Some('a'));
}

#[test]
fn the_pitching_moment_is_one_of_three() {
    let with = |sign: &str| {
        let text = r"The body rates are $p$, $q$, $r$, and $xz$ is a plane of symmetry. In a roll at a constant rate $p$ with $q = 0$ and $r = 0$ the pitching moment is

$$ M = SIGN I_{xz}\,p^2 $$

because

$$ I_x\dot p = 0 $$
";
        verdicts(&text.replace("SIGN", sign))
    };
    assert!(with("").contains('p'), "{}", with(""));
    assert!(with("-").contains('r'), "{}", with("-"));
}

#[test]
fn gravity_turns_with_the_angles_on_body_axes() {
    let with = |third: &str| {
        let text = r"The attitude is made by yaw $\psi$ about the down axis, pitch $\theta$ and roll $\phi$. The body rates are

$$ p = \dot\phi - \dot\psi\sin\theta $$

$$ q = \dot\theta\cos\phi + \dot\psi\sin\phi\cos\theta $$

$$ r = -\dot\theta\sin\phi + \dot\psi\cos\phi\cos\theta $$

On body axes the vector $\mathbf g$ has the components

$$ g_x = -g\sin\theta $$

$$ g_z = THIRD $$
";
        verdicts(&text.replace("THIRD", third))
    };
    assert_eq!(with(r"g\cos\theta\cos\phi"), "ppppp");
    assert_eq!(with(r"g\sin\theta\cos\phi"), "ppppr");
}

#[test]
fn small_swings_have_a_frequency() {
    let with = |square: &str| {
        let text = r"A body of mass $m$ swings about a horizontal axis at the distance $h$ from its mass centre, with

$$ I\,\ddot\theta = -m g h\sin\theta $$

For small $\theta$ the motion is harmonic with the natural frequency $p_0$,

$$ p_0^2 = SQUARE $$
";
        verdicts(&text.replace("SQUARE", square)).chars().last()
    };
    assert_eq!(with(r"\frac{m g h}{I}"), Some('p'));
    assert_ne!(with(r"\frac{m g}{I h}"), Some('a'));
    assert_ne!(with(r"\frac{m g}{I h}"), Some('p'));
}

#[test]
fn what_is_taken_about_a_moving_point_is_tied_to_the_mass_centre() {
    let opening = |arm: &str| {
        format!(
            "The mass centre of the body is $G$, its mass is $m$, and the point $P$ moves. {arm}\n\n\
             $$ \\mathbf H_P = \\mathbf H_G + \\boldsymbol\\rho\\times m\\,\\mathbf v_G $$\n\n"
        )
    };
    let lines = |rate: &str, extra: &str| {
        format!(
            "$$ \\dot{{\\mathbf H}}_P = \\dot{{\\mathbf H}}_G {rate} \\mathbf v_P\\times m\\,\\mathbf v_G + \\boldsymbol\\rho\\times m\\,\\mathbf a_G $$\n\n\
             $$ \\mathbf M_G = \\dot{{\\mathbf H}}_G $$\n\n$$ \\mathbf M_P = \\dot{{\\mathbf H}}_P + {extra} $$\n"
        )
    };
    let right = lines("-", "\\mathbf v_P\\times m\\,\\mathbf v_G");
    let words = opening("The vector from $P$ to $G$ is $\\boldsymbol\\rho$.");
    assert_eq!(verdicts(&format!("{words}{right}")), "pppp");
    let positions = opening("Define $\\boldsymbol\\rho = \\mathbf r_G - \\mathbf r_P$.");
    assert_eq!(verdicts(&format!("{positions}{right}")), "apppp");
    let wrong = lines("-", "\\mathbf v_G\\times m\\,\\mathbf v_P");
    assert_eq!(verdicts(&format!("{words}{wrong}")), "pppr");
    let relative = "The mass centre of the body is $C$ and the point $P$ moves.\n\n\
         $$ \\mathbf H_P = \\mathbf H_C + \\mathbf r_{C/P}\\times m\\,(\\mathbf v_C - \\mathbf v_P) $$\n\n\
         $$ \\mathbf M_P = \\dot{\\mathbf H}_P + \\mathbf r_{C/P}\\times m\\,\\mathbf a_P $$\n\n\
         $$ \\mathbf M_P = \\dot{\\mathbf H}_P - \\mathbf r_{C/P}\\times m\\,\\mathbf a_P $$\n";
    assert_eq!(verdicts(relative), "ppr");
}

#[test]
fn beside_numbered_axes_z_is_the_vertical() {
    let with = |power: &str, factor: &str| {
        let text = r"A thin rod hangs from a hinge on a spindle that is driven at the constant rate $\nu$; it makes the angle $\beta$ with the downward vertical. The principal moments at the hinge are

$$ I_1 = 0, \qquad I_2 = I_3 = K $$

The angular velocity is

$$ \omega_1 = -\nu\cos\beta $$

$$ \omega_2 = \nu\sin\beta $$

$$ \omega_3 = \dot\beta $$

The angular momentum about the spindle is

$$ L_z = K\nu\sinPOWER\beta $$

so its rate is

$$ \dot L_z = FACTOR K\nu\dot\beta\sin\beta\cos\beta $$
";
        let text = text.replace("POWER", power).replace("FACTOR", factor);
        let found = verdicts(&text);
        found[found.len() - 2..].to_owned()
    };
    assert_eq!(with("^2", "2"), "pp");
    assert_eq!(with("^2", ""), "pr");
    assert!(with("", "2").starts_with('r'));
}

#[test]
fn a_uniform_box_has_moments_by_its_edges() {
    let text = |last: &str| {
        verdicts(&format!(
            "For a solid box of mass $m$ with edges $a$, $b$, $c$ along $x$, $y$, $z$ the diagonal entries are\n\n\
             $$ I_x = \\frac{{m}}{{12}}(b^2 + c^2), \\qquad I_z = \\frac{{m}}{{12}}({last}) $$\n"
        ))
    };
    assert_eq!(text("a^2 + b^2"), "pp");
    assert_eq!(text("b^2 + c^2"), "pr");
}

#[test]
fn a_feedback_beside_no_other_torque_takes_power() {
    let text = |sign: &str| {
        verdicts(&format!(
            "A satellite with inertia $J$ is under the control torque $\\mathbf u = -k\\boldsymbol\\omega$ and no other torque.\n\n\
             $$ J\\dot{{\\boldsymbol\\omega}} = -\\boldsymbol\\omega\\times J\\boldsymbol\\omega - k\\boldsymbol\\omega $$\n\n\
             $$ \\dot T = {sign}k\\,\\boldsymbol\\omega\\cdot\\boldsymbol\\omega $$\n"
        ))
    };
    assert_eq!(text("-"), "app");
    assert_eq!(text(""), "apr");
}

#[test]
fn a_bold_sign_of_a_sum_stands_before_its_moment() {
    let text = |more: &str| {
        verdicts(&format!(
            "For a point $P$ that moves with $\\mathbf v_P$, with $\\mathbf L_P$ taken with absolute velocities,\n\n\
             $$ \\boldsymbol\\Sigma\\mathbf M_P = \\dot{{\\mathbf L}}_P {more} $$\n"
        ))
    };
    assert_eq!(text("+ \\mathbf v_P\\times m\\mathbf v_G"), "a");
    assert_eq!(text("- \\mathbf v_P\\times m\\mathbf v_G"), "u");
    assert_eq!(text(""), "u");
}
