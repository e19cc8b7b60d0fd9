//! Discrete steps: values before and after one, told apart by a number over the letter.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const STEP: &str = r"The torque-free body has the principal moments $I_1$, $I_2$, $I_3$, and $I$ is its constant inertia matrix. A step of the size $h$ is defined by

$$ I\omega^{k+1} = I\omega^k + h\,(I\omega^k)\times\omega^k $$

For the increment $d = \omega^{k+1} - \omega^k$ it follows that

$$ \omega^k\cdot I d = 0 $$
";

#[test]
fn the_energy_behind_a_step_is_not_defined_by_a_claim() {
    let text = "A free body has the momentum $L = I\\omega$ and the energy $E = \\frac12 L\\cdot\\omega$. One step is defined by\n\n\
                $$ L_{n+1} = L_n + h\\,L_n\\times\\omega_n $$\n\nand the energy grows:\n\n\
                $$ E_{n+1} = E_n + h^2\\,(L_n\\times\\omega_n)\\cdot I^{-1}(L_n\\times\\omega_n) $$\n";
    let found = verdicts(text);
    assert!(found.ends_with('u'), "{found}");
}

#[test]
fn a_number_over_a_vector_counts_the_steps() {
    assert_eq!(verdicts(STEP), "aap");
    let bracketed = STEP.replace("^{k+1}", "^{(k+1)}").replace("^k", "^{(k)}");
    assert_eq!(verdicts(&bracketed), "aap");
    let other = STEP.replace(r"\omega^k\cdot I d", r"\omega^{k+1}\cdot I d");
    assert_eq!(verdicts(&other), "aar");
}

#[test]
fn a_step_gives_the_velocity_that_it_is_linear_in() {
    let text = r"A free rigid body has the inertia matrix $J$ on its principal axes. Each step of the size $h$ is defined by

$$ J\omega_{k+1} = J\omega_k - h\,\omega_k\times J\omega_k $$

The square of the momentum grows:

$$ |J\omega_{k+1}|^2 = |J\omega_k|^2 + h^2\,|\omega_k\times J\omega_k|^2 $$

$$ |J\omega_{k+1}|^2 = |J\omega_k|^2 + h\,|\omega_k\times J\omega_k|^2 $$
";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn a_chain_that_defines_an_angle_is_checked_behind_its_second_sign() {
    let chain = |last: &str| {
        format!(
            r"On principal axes the disk has $I_1 = I_2 = \tfrac14 m r^2$ and $I_3 = \tfrac12 m r^2$, and it turns with $\omega_1 = \Omega\sin\alpha$, $\omega_2 = 0$, $\omega_3 = \Omega\cos\alpha$. The angular momentum $\mathbf L$ makes with the normal the angle $\beta$, where

$$ \tan\beta = \frac{{L_1}}{{L_3}} = {last} $$
"
        )
    };
    assert!(verdicts(&chain(r"\tfrac12\tan\alpha")).ends_with(['p', 'a']));
    assert!(verdicts(&chain(r"2\tan\alpha")).ends_with('r'));
}

#[test]
fn a_general_inertia_matrix_is_put_on_principal_axes() {
    let text = r"A free rigid body has the inertia matrix $J$, which is symmetric and constant. Each step of the size $h$ is defined by

$$ J\omega_{k+1} = J\omega_k - h\,\omega_k\times J\omega_k $$

For the increment $d = \omega_{k+1} - \omega_k$ it follows that

$$ \omega_k\cdot J d = 0 $$

$$ \omega_{k+1}^T J\,\omega_{k+1} = \omega_k^T J\,\omega_k + d^T J\,d $$
";
    assert_eq!(verdicts(text), "aapp");
}

#[test]
fn another_section_has_another_step() {
    let text = r"A free rigid body has the constant inertia matrix $J$.

## Forward

One step of the size $h$ is defined by

$$ J\omega^{k+1} = J\omega^k - h\,\omega^k\times J\omega^k $$

$$ |J\omega^{k+1}|^2 = |J\omega^k|^2 + h^2\,|\omega^k\times J\omega^k|^2 $$

## Midpoint

With $\omega_m = \tfrac12(\omega^k + \omega^{k+1})$ the step solves

$$ J(\omega^{k+1} - \omega^k) = -h\,\omega_m\times J\omega_m $$

The square of the momentum is kept:

$$ |J\omega^{k+1}|^2 = |J\omega^k|^2 $$
";
    assert_eq!(verdicts(text), "apaap");
}

#[test]
fn a_bar_is_the_mean_of_two_steps() {
    let text = r"The midpoint rule for $J\dot\omega = -\omega\times J\omega$ is

$$ J\frac{\omega_{n+1} - \omega_n}{h} = -\bar\omega\times J\bar\omega,\qquad \bar\omega = \frac{\omega_n + \omega_{n+1}}{2} $$

$$ \bar\omega\cdot J(\omega_{n+1} - \omega_n) = 0 $$

hence

$$ \omega_{n+1}\cdot J\omega_{n+1} = \omega_n\cdot J\omega_n $$
";
    assert_eq!(verdicts(text), "paapp");
}

#[test]
fn unmarked_rates_with_a_zero_and_a_one_that_a_matrix_multiplies_are_vectors() {
    let text = |last: &str| {
        format!(
            r"The hat of a vector is the matrix of its cross product, $\hat{{a}}\,b = a\times b$, and $J$ is the inertia matrix.

$$ J\dot\omega = \tau - \hat{{\omega}}J\omega $$

A step of length $h$ leads from $\omega_0$ to $\omega_1$. With the midpoint

$$ \omega_m = \frac{{1}}{{2}}\left(\omega_0 + \omega_1\right) $$

we define the residual

$$ F(\omega_1) = J(\omega_1 - \omega_0) + h\,\hat{{\omega}}_m J\omega_m - h\tau $$

and Newton's method needs

$$ \frac{{\partial F}}{{\partial\omega_1}} = J + {last} $$
"
        )
    };
    let half = r"\frac{h}{2}\left(\hat{\omega}_m J - \widehat{J\omega_m}\right)";
    assert!(verdicts(&text(half)).ends_with("aap"));
    let whole = r"h\left(\hat{\omega}_m J - \widehat{J\omega_m}\right)";
    assert!(verdicts(&text(whole)).ends_with("aar"));
}

#[test]
fn the_rate_is_a_function_whose_slopes_are_taken_at_the_step() {
    let document = |matrix: &str, torque: &str| {
        format!(
            r"On principal axes with the moments $J_1$, $J_2$, $J_3$ and the torque $\boldsymbol\tau$

$$ J_1\dot\omega_1 = (J_2 - J_3)\,\omega_2\omega_3 + \tau_1. $$

An Euler step of size $h$ is defined by

$$ \boldsymbol\omega_{{k+1}} = \boldsymbol\omega_k + h\,\dot{{\boldsymbol\omega}}(\boldsymbol\omega_k, \boldsymbol\tau_k) $$

and its Jacobians are

$$ \frac{{\partial\boldsymbol\omega_{{k+1}}}}{{\partial\boldsymbol\omega_k}} = {matrix}\,\frac{{\partial\dot{{\boldsymbol\omega}}}}{{\partial\boldsymbol\omega}} $$

$$ \frac{{\partial\boldsymbol\omega_{{k+1}}}}{{\partial\boldsymbol\tau_k}} = {torque}\,\frac{{\partial\dot{{\boldsymbol\omega}}}}{{\partial\boldsymbol\tau}} $$
"
        )
    };
    assert_eq!(verdicts(&document(r"\mathbf I_3 + h", "h")), "papp");
    assert_eq!(verdicts(&document(r"\mathbf I_3 - h", "h")), "parp");
    assert_eq!(verdicts(&document(r"\mathbf I_3 + h", "2h")), "papr");
}

#[test]
fn a_one_beside_matrices_is_the_unit_matrix() {
    let text = |sign: &str| {
        format!(
            r"The step $\omega_{{k+1}} = \omega_k + h\,I^{{-1}}(\tau_k - \omega_k\times I\omega_k)$. Its Jacobian is

$$ \frac{{\partial\omega_{{k+1}}}}{{\partial\omega_k}} = 1 {sign} hI^{{-1}}\left([I\omega_k]_\times - [\omega_k]_\times I\right) $$

Let $R$ be the rotation matrix. Then

$$ R R^T = 1 $$
"
        )
    };
    assert_eq!(verdicts(&text("+")), "app");
    assert_eq!(verdicts(&text("-")), "arp");
}

#[test]
fn the_slope_of_a_function_is_taken_where_the_step_is() {
    let step = |slope: &str| {
        verdicts(&format!(
            "Consider $f(\\omega) = I^{{-1}}(\\tau - \\omega\\times I\\omega)$. An explicit Euler step is \
             $\\omega_{{k+1}} = \\omega_k + h f(\\omega_k)$ and its Jacobian is\n\n\
             $$ \\frac{{\\partial\\omega_{{k+1}}}}{{\\partial\\omega_k}} = \\mathbf 1 {slope} $$\n"
        ))
    };
    for place in [
        r"\frac{\partial f}{\partial\omega}",
        r"\frac{\partial f}{\partial\omega_k}",
        r"\frac{\partial f}{\partial\omega}(\omega_k)",
        r"\left.\frac{\partial f}{\partial\omega}\right|_{\omega_k}",
        r"\left.\frac{\partial f}{\partial\omega}\right|_{\omega = \omega_k}",
    ] {
        assert_eq!(step(&format!("+ h{place}")), "aap", "{place}");
        assert_ne!(step(&format!("- h{place}")), "aap", "{place}");
    }
    let named = "Let $\\mathbf f(\\boldsymbol\\omega, \\mathbf u) = \\mathbf J^{-1}(\\mathbf u - \\boldsymbol\\omega\\times\\mathbf J\\boldsymbol\\omega)$. \
                 The step $\\boldsymbol\\omega_{k+1} = \\boldsymbol\\omega_k + h\\,\\mathbf f(\\boldsymbol\\omega_k, \\mathbf u_k)$ has the Jacobian\n\n\
                 $$ \\mathbf A_k = \\frac{\\partial\\boldsymbol\\omega_{k+1}}{\\partial\\boldsymbol\\omega_k} = \\mathbf 1 + h\\frac{\\partial\\mathbf f}{\\partial\\boldsymbol\\omega} $$\n";
    assert!(!verdicts(named).contains('r'));
}

#[test]
fn a_momentum_steps_by_the_velocity_it_turns_with() {
    let text = |sign: &str| {
        verdicts(&format!(
            "With the momentum $\\Pi$ on body axes, a constant $I$ and $\\omega = I^{{-1}}\\Pi$ the explicit step is\n\n\
             $$ \\Pi_{{k+1}} = \\Pi_k + h\\,\\Pi_k\\times\\omega_k $$\n\nso that\n\n\
             $$ |\\Pi_{{k+1}}|^2 = |\\Pi_k|^2 {sign} h^2\\,|\\Pi_k\\times\\omega_k|^2 $$\n"
        ))
    };
    assert_eq!(text("+"), "pap");
    assert!(!text("-").ends_with(['p', 'a']));
}

#[test]
fn stages_of_a_step_are_slopes_at_their_own_rates() {
    let text = |sign: &str| {
        verdicts(&format!(
            "For $\\dot{{\\boldsymbol\\omega}} = \\mathbf f(\\boldsymbol\\omega)$ with \
             $\\mathbf f(\\boldsymbol\\omega) = -J^{{-1}}(\\boldsymbol\\omega\\times J\\boldsymbol\\omega)$ Heun's step is\n\n\
             $$ \\mathbf k_1 = \\mathbf f(\\boldsymbol\\omega_n), \\quad \\mathbf k_2 = \\mathbf f(\\boldsymbol\\omega_n + h\\,\\mathbf k_1) $$\n\n\
             $$ \\boldsymbol\\omega_{{n+1}} = \\boldsymbol\\omega_n + \\tfrac h2(\\mathbf k_1 + \\mathbf k_2) $$\n\n\
             $$ J\\mathbf k_1 {sign} \\boldsymbol\\omega_n\\times J\\boldsymbol\\omega_n = 0 $$\n"
        ))
    };
    assert_eq!(text("+"), "apaaap");
    assert_eq!(text("-"), "apaaar");
}

#[test]
fn the_mean_of_a_step_may_be_named_behind_it() {
    let text = |by: &str, sign: &str, kept: &str| {
        verdicts(&format!(
            "We advance $I\\dot{{\\boldsymbol\\omega}} = -\\boldsymbol\\omega\\times I\\boldsymbol\\omega$ {by}\n\n\
             $$ I\\frac{{\\boldsymbol\\omega_{{k+1}} - \\boldsymbol\\omega_k}}{{\\Delta t}} = -\\bar{{\\boldsymbol\\omega}}\\times I\\bar{{\\boldsymbol\\omega}} $$\n\n\
             with the midpoint\n\n$$ \\bar{{\\boldsymbol\\omega}} = \\tfrac12(\\boldsymbol\\omega_{{k+1}} {sign} \\boldsymbol\\omega_k) $$\n\n\
             Multiply by $\\bar{{\\boldsymbol\\omega}}$:\n\n\
             $$ \\bar{{\\boldsymbol\\omega}}\\cdot I(\\boldsymbol\\omega_{{k+1}} {kept} \\boldsymbol\\omega_k) = 0 $$\n\n\
             $$ |I\\boldsymbol\\omega_{{k+1}}|^2 = |I\\boldsymbol\\omega_k|^2 $$\n"
        ))
    };
    assert!(
        text("by", "+", "-").ends_with("aapp"),
        "{}",
        text("by", "+", "-")
    );
    let rule = "with the implicit midpoint rule";
    assert!(text(rule, "+", "-").ends_with("aapp"));
    let wrong = text(rule, "+", "+");
    assert!(wrong.ends_with("rp") || wrong.ends_with("up"), "{wrong}");
    assert!(!text(rule, "-", "-").contains("aapp"));
}

#[test]
fn an_implicit_step_gives_the_momentum_behind_it() {
    let text = |step: &str, kept: &str| {
        verdicts(&format!(
            "No external torque. All vectors are on body axes, $J$ is the constant inertia matrix. $\\omega = J^{{-1}}L$. \
             The step is\n\n$$ L_{{k+1}} = L_k + {step} $$\n\n$$ {kept} $$\n"
        ))
    };
    let mean = r"h\,\bar L\times J^{-1}\bar L,\qquad \bar L = \tfrac12(L_k + L_{k+1})";
    let energy = r"L_{k+1}\cdot J^{-1}L_{k+1} = L_k\cdot J^{-1}L_k";
    assert_eq!(text(mean, energy), "paap");
    assert_eq!(text(mean, r"|L_{k+1}|^2 = |L_k|^2"), "paap");
    let backward = r"h\,L_{k+1}\times J^{-1}L_{k+1}";
    let shrunk = |sign: &str| format!("|L_{{k+1}}|^2 = |L_k|^2 {sign} |L_{{k+1}} - L_k|^2");
    assert_eq!(text(backward, &shrunk("-")), "pap");
    assert!(!text(backward, &shrunk("+")).ends_with(['p', 'a']));
}

#[test]
fn the_mean_moves_with_the_state_behind_the_step() {
    let text = |half: &str| {
        verdicts(&format!(
            r"No external torque. All vectors are on body axes, $J$ is the constant inertia matrix. We advance the angular momentum $\Pi$, $\Omega = J^{{-1}}\Pi$, by hats $\widehat{{a}}\,b = a\times b$. Let the midpoint be

$$ \bar\Pi = \tfrac12(\Pi_n + \Pi_{{n+1}}) $$

and let $\bar\Omega = J^{{-1}}\bar\Pi$. The residual in the unknown $\Pi_{{n+1}}$ is, by definition,

$$ R(\Pi_{{n+1}}) = \Pi_{{n+1}} - \Pi_n - h\,\bar\Pi\times J^{{-1}}\bar\Pi $$

and the matrix for Newton's method is

$$ \frac{{\partial R}}{{\partial\Pi_{{n+1}}}} = \mathbf{{1}} - {half}\left(\widehat{{\bar\Pi}}\,J^{{-1}} - \widehat{{\bar\Omega}}\right) $$
"
        ))
    };
    assert!(text(r"\frac h2").ends_with("aaap"), "{}", text(r"\frac h2"));
    assert!(text("h").ends_with("aaar"), "{}", text("h"));
}

#[test]
fn the_unit_matrix_is_named_before_its_letter() {
    let text = |step: &str, more: &str| {
        verdicts(&format!(
            r"A rigid body has principal moments $A$, $B$, $C$ and no external torque.

$$ \dot\omega = f(\omega) $$

$$ K(\omega) = \frac{{\partial f}}{{\partial\omega}} = \begin{{pmatrix}} 0 & (B-C)\omega_3/A & (B-C)\omega_2/A \\ (C-A)\omega_3/B & 0 & (C-A)\omega_1/B \\ (A-B)\omega_2/C & (A-B)\omega_1/C & 0 \end{{pmatrix}} $$

The step is

$$ \omega_{{n+1}} = \omega_n + h\,f(\omega_n), $$

and, with the unit matrix $E$,

$$ \frac{{\partial\omega_{{n+1}}}}{{\partial\omega_n}} = E + {step}\,K(\omega_n). $$

{more}
"
        ))
    };
    assert_eq!(text("h", ""), "apap");
    assert_eq!(text(r"\frac h2", ""), "apar");
    // Which rate the bare f₁ is taken at is not said.
    assert_eq!(text("h", r"$$ Af_1^2 + Bf_2^2 = Cf_3^2 $$"), "apapu");
}

/// The verdict on a last line behind an Euler step and a midpoint step by the function of the rate.
fn midpoint(line: &str) -> String {
    let text = format!(
        r"A free body has the principal moments $A$, $B$, $C$. Its equations $\dot\omega = f(\omega)$ have the right-hand side

$$ f(\omega) = \begin{{pmatrix}} \frac{{B-C}}{{A}}\omega_2\omega_3 \\ \frac{{C-A}}{{B}}\omega_3\omega_1 \\ \frac{{A-B}}{{C}}\omega_1\omega_2 \end{{pmatrix}} $$

## Euler

The step of size $h$ is defined by

$$ \omega^{{(n+1)}} = \omega^{{(n)}} + h\,f(\omega^{{(n)}}) $$

It changes the energy $T = \frac12(A\omega_1^2 + B\omega_2^2 + C\omega_3^2)$ by

$$ T^{{(n+1)}} - T^{{(n)}} = \frac12 h^2\left(A f_1^2 + B f_2^2 + C f_3^2\right) $$

where $f_i$ are the components of $f(\omega^{{(n)}})$.

## Midpoint

Define the half step

$$ \omega^{{*}} = \omega^{{(n)}} + \frac{{h}}{{2}}\,f(\omega^{{(n)}}) $$

and the full step, which replaces the one above,

$$ \omega^{{(n+1)}} = \omega^{{(n)}} + h\,f(\omega^{{*}}) $$

Then

$$ {line} $$
"
    );
    verdicts(&text)
}

#[test]
fn a_half_step_leads_to_a_full_one_and_components_are_taken_where_words_say() {
    let first = r"\omega_1^{(n+1)} = \omega_1^{(n)} + h\,\frac{B-C}{A}\omega_2^{*}\omega_3^{*}";
    assert_eq!(midpoint(first), "apappaap");
    assert!(midpoint(&first.replace("B-C", "C-B")).ends_with('r'));
}
