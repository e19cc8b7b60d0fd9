//! Functions of the state, their Jacobians, and what they are elsewhere.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_jacobian_in_words_is_that_of_the_function_before_it() {
    let text = |sign: &str| {
        format!(
            "The inertia tensor is $I$, the time step $h$, the old rate $\\omega_0$. The root of\n\n\
             $$ g(\\omega) = I(\\omega - \\omega_0) + h\\,\\omega\\times(I\\omega) $$\n\n\
             is wanted. The Jacobian of $g$ reads\n\n\
             $$ J(\\omega) = I + h\\left([\\omega]_\\times I {sign} [I\\omega]_\\times\\right) $$\n\n\
             and a step of Newton's method is\n\n\
             $$ \\omega_1 = \\omega_0 - J(\\omega_0)^{{-1}}g(\\omega_0) $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "apa");
    assert_eq!(verdicts(&text("+")), "ara");
}

#[test]
fn numbered_functions_are_the_column_that_is_derived() {
    let text = |entry: &str| {
        format!(
            "Principal axes, moments $J_1, J_2, J_3$, torques $u_1, u_2, u_3$. Write $\\dot\\omega_i = f_i$ with\n\n\
             $$ f_1 = \\frac{{u_1 + (J_2 - J_3)\\omega_2\\omega_3}}{{J_1}}, \\quad f_2 = \\frac{{u_2 + (J_3 - J_1)\\omega_3\\omega_1}}{{J_2}}, \\quad \
             f_3 = \\frac{{u_3 + (J_1 - J_2)\\omega_1\\omega_2}}{{J_3}} $$\n\nand\n\n\
             $$ G = \\frac{{\\partial f}}{{\\partial u}} = \\begin{{bmatrix}} {entry} & 0 & 0 \\\\ 0 & 1/J_2 & 0 \\\\ 0 & 0 & 1/J_3 \\end{{bmatrix}} $$\n"
        )
    };
    assert_eq!(verdicts(&text("1/J_1")).chars().last(), Some('p'));
    assert_eq!(verdicts(&text("J_1")).chars().last(), Some('r'));
}

#[test]
fn a_step_is_not_derived_in_a_rate_that_it_is_not_made_of() {
    let last = |by: &str| {
        let text = format!(
            "The inertia tensor is $I$ on body axes, the step $h$. The next rate is defined by\n\n\
             $$ \\omega_{{k+1}} = \\omega_k + h\\,\\omega_k\\times I\\omega_k $$\n\nand its derivative is\n\n\
             $$ \\frac{{\\partial\\omega_{{k+1}}}}{{\\partial{by}}} = \\mathbf 1 + h\\left([\\omega_k]_\\times I - [I\\omega_k]_\\times\\right) $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_eq!(last("\\omega_k"), Some('p'));
    assert_ne!(last("\\omega"), Some('r'));
}

#[test]
fn a_residual_vanishes_where_its_root_is_found() {
    let text = |factor: &str| {
        format!(
            "The inertia tensor is $I$, the time step $h$, the torque $\\tau$. The residual is the function\n\n\
             $$ g(\\omega_{{k+1}}) = I(\\omega_{{k+1}} - \\omega_k) + h(\\omega_{{k+1}}\\times I\\omega_{{k+1}} - \\tau) $$\n\n\
             After convergence $g = 0$. Multiplied by $\\omega_{{k+1}}^\\top$ it says\n\n\
             $$ \\omega_{{k+1}}^\\top I(\\omega_{{k+1}} - \\omega_k) = {factor}h\\,\\omega_{{k+1}}^\\top\\tau $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "aap");
    assert_eq!(verdicts(&text("2")), "aar");
}

#[test]
fn a_right_hand_side_of_several_arguments_has_its_name_from_the_left() {
    let text = |entry: &str| {
        format!(
            "Principal axes, moments $J_1, J_2, J_3$, torque $u$. The state equation is $\\dot\\omega = f(\\omega, u)$. Its derivative is\n\n\
             $$ F = \\frac{{\\partial f}}{{\\partial\\omega}} = \\begin{{pmatrix}} 0 & a\\omega_3 & a\\omega_2 \\\\ \
             {entry} & 0 & b\\omega_1 \\\\ c\\omega_2 & c\\omega_1 & 0 \\end{{pmatrix}} $$\n\n"
        )
    };
    let with = "Let $a = \\frac{J_2 - J_3}{J_1}$, $b = \\frac{J_3 - J_1}{J_2}$, $c = \\frac{J_1 - J_2}{J_3}$.\n\n";
    let trace = "$$ \\operatorname{tr} F = 0 $$\n";
    assert_eq!(
        verdicts(&format!("{with}{}{trace}", text("b\\omega_3"))),
        "aaaapp"
    );
    assert_eq!(
        verdicts(&format!("{with}{}{trace}", text("-b\\omega_3"))),
        "aaaarp"
    );
}

#[test]
fn an_energy_is_taken_at_the_rate_in_its_brackets() {
    let text = |half: &str| {
        format!(
            "Before the step the angular velocity is $\\omega_0$. With the inertia tensor $I$ the kinetic energy is\n\n\
             $$ T(\\omega) = \\tfrac12\\,\\omega^T I\\,\\omega $$\n\n\
             $$ T(\\omega_0) = {half}\\,\\omega_0^T I\\,\\omega_0 $$\n"
        )
    };
    assert_eq!(verdicts(&text("\\tfrac12")), "ap");
    assert_ne!(verdicts(&text("\\tfrac13")), "ap");
}

#[test]
fn the_exponential_of_a_turn_in_the_plane_is_a_turn() {
    let with = |sine: &str, sign: &str| {
        let text = r"The two rates $x = [\,u\;\;w\,]^\top$ turn with the constant $\nu$ and the matrix

$$ A = \begin{bmatrix} 0 & -\nu \\ \nu & 0 \end{bmatrix} $$

so that

$$ P(t) = e^{At} = \begin{bmatrix} \cos\nu t & -\sin\nu t \\ SINE & \cos\nu t \end{bmatrix} $$

A code that uses

$$ P_1 = \mathbf{1} + hA $$

has the determinant

$$ \det P_1 = 1 SIGN h^2\nu^2 $$
";
        let found = verdicts(&text.replace("SINE", sine).replace("SIGN", sign));
        found[1..].to_owned()
    };
    assert_eq!(
        with(r"\sin\nu t", "+"),
        "apap",
        "{}",
        with(r"\sin\nu t", "+")
    );
    assert_eq!(with(r"\sin\nu t", "-"), "apar");
    assert!(with(r"-\sin\nu t", "+").contains('r'));
}

#[test]
fn a_regressor_of_several_arguments_may_be_defined_behind() {
    let text = |power: &str| {
        format!(
            r"Along principal axes the parameters are collected in

$$ p = \begin{{bmatrix}} I_1 & I_2 & I_3 \end{{bmatrix}}^T, \qquad D(\omega) = \mathrm{{diag}}(\omega_1, \omega_2, \omega_3). $$

The torque is linear in $p$,

$$ \tau = I\dot\omega + \omega\times I\omega = Y(\omega, \dot\omega)\,p $$

$$ Y(\omega, \dot\omega) = D(\dot\omega) + [\omega]_\times D(\omega) $$

$$ \frac{{\partial\tau}}{{\partial\dot\omega}} = I, \qquad \frac{{\partial\tau}}{{\partial\omega}} = [\omega]_\times I {power} [I\omega]_\times $$
"
        )
    };
    assert_eq!(verdicts(&text("-")), "aapapp");
    assert_eq!(verdicts(&text("+")), "aapapr");
}

#[test]
fn a_function_of_the_momentum_is_derived_in_it() {
    let text = |sign: &str| {
        format!(
            "A free body has the angular momentum $L = I\\omega$. Define $f(L) = L\\times I^{{-1}}L$. Its Jacobian is\n\n\
             $$ \\frac{{\\partial f}}{{\\partial L}} = [L]_\\times I^{{-1}} {sign} [\\omega]_\\times $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "pap");
    assert_eq!(verdicts(&text("+")), "par");
}

#[test]
fn a_derivative_in_the_momentum_goes_by_the_angular_velocity() {
    let text = r"A rigid body has the energy $T = \frac12\boldsymbol\omega\cdot\mathbf L$ and principal moments $I_1$, $I_2$, $I_3$.

$$ \frac{\partial T}{\partial L_1} = \frac{L_1}{I_1} = \omega_1 $$

$$ \frac{\partial T}{\partial L_2} = \frac{L_2}{2I_2} $$

$$ \frac{\partial T}{\partial\mathbf L} = \boldsymbol\omega $$

$$ \frac{\partial\boldsymbol\omega}{\partial\mathbf L} = \mathbf I^{-1} $$
";
    assert_eq!(verdicts(text), "pprpp");
}

#[test]
fn a_rate_that_is_called_a_function_says_what_it_is() {
    let last = |middle: &str| {
        verdicts(&format!(
            "On principal axes the torque-free dynamics are $\\dot\\omega = f(\\omega)$ with\n\n\
             $$ f(\\omega) = \\begin{{bmatrix}} \\frac{{I_2 - I_3}}{{I_1}}\\omega_2\\omega_3 \\\\ {middle}\\omega_3\\omega_1 \\\\ \
             \\frac{{I_1 - I_2}}{{I_3}}\\omega_1\\omega_2 \\end{{bmatrix}} $$\n"
        ))
    };
    assert_eq!(last("\\frac{I_3 - I_1}{I_2}"), "ap");
    assert_eq!(last("\\frac{I_1 - I_3}{I_2}"), "ar");
    let jacobian = |entry: &str| {
        verdicts(&format!(
            "On principal axes without torque $\\dot\\omega = f(\\omega)$. The Jacobian is\n\n\
             $$ \\frac{{\\partial f}}{{\\partial\\omega}} = \\begin{{bmatrix}} \
             0 & \\frac{{I_2 - I_3}}{{I_1}}\\omega_3 & \\frac{{I_2 - I_3}}{{I_1}}\\omega_2 \\\\ \
             \\frac{{I_3 - I_1}}{{I_2}}\\omega_3 & 0 & \\frac{{I_3 - I_1}}{{I_2}}\\omega_1 \\\\ \
             \\frac{{I_1 - I_2}}{{I_3}}\\omega_2 & {entry}\\omega_1 & 0 \\end{{bmatrix}} $$\n"
        ))
    };
    assert_eq!(jacobian("\\frac{I_1 - I_2}{I_3}"), "ap");
    assert_eq!(jacobian("\\frac{I_2 - I_1}{I_3}"), "ar");
}

#[test]
fn the_name_of_a_rate_has_the_jacobian_of_what_gives_the_rate() {
    let text = |jacobian: &str, component: &str| {
        verdicts(&format!(
            "Write $\\dot\\omega = f(\\omega)$ with\n\n$$ f(\\omega) = J^{{-1}}(\\tau - \\omega\\times J\\omega) $$\n\n\
             where $J$ is the constant inertia matrix and $\\tau$ a constant torque in body axes.\n\n\
             $$ \\frac{{\\partial f}}{{\\partial\\omega}} = J^{{-1}}({jacobian}) $$\n\n\
             For principal axes\n\n$$ \\frac{{\\partial f_1}}{{\\partial\\omega_2}} = \\frac{{{component}}}{{J_1}}\\omega_3 $$\n"
        ))
    };
    let (right, wrong) = (
        "[J\\omega]_\\times - [\\omega]_\\times J",
        "[\\omega]_\\times J - [J\\omega]_\\times",
    );
    assert_eq!(text(right, "J_2 - J_3"), "appp");
    assert_eq!(text(wrong, "J_2 - J_3"), "aprp");
    assert_eq!(text(right, "J_3 - J_2"), "appr");
}

#[test]
fn a_bare_letter_of_a_right_side_has_components() {
    let text = |called: &str, moments: &str| {
        verdicts(&format!(
            "Let $J$ be the constant inertia matrix and $\\tau$ a torque in body axes. Define\n\n\
             $$ f(\\omega) = J^{{-1}}(\\tau - \\omega\\times J\\omega) $$\n\nFor principal axes\n\n\
             $$ {called} = \\frac{{\\tau_1 + ({moments})\\omega_2\\omega_3}}{{J_1}} $$\n"
        ))
    };
    for called in ["f_1", "f_1(\\omega)"] {
        assert_eq!(text(called, "J_2 - J_3"), "ap");
        assert_eq!(text(called, "J_3 - J_2"), "ar");
    }
}

#[test]
fn a_bracket_varies_with_what_is_in_it() {
    let text = |line: &str| {
        verdicts(&format!(
            "The kinetic energy is $T = \\frac12\\omega\\cdot J\\omega$ with the constant inertia matrix $J$.\n\n$$ {line} $$\n"
        ))
    };
    let energy = |factor: &str| {
        text(&format!(
            "\\delta\\left(\\tfrac12\\omega\\cdot J\\omega\\right) = {factor}\\delta\\omega\\cdot J\\omega"
        ))
    };
    assert_eq!(energy(""), "pp");
    assert_eq!(energy("2"), "pr");
    let term = "\\delta(\\omega\\times J\\omega) = \\delta\\omega\\times J\\omega + \\omega\\times J\\delta\\omega";
    assert_eq!(text(term), "pp");
}
