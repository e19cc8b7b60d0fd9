//! Indices that are summed over where they are repeated.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;
use polhode::notation::{document::Format, read};
use polhode::verify::{Report, check};

fn checked(text: &str) -> Report {
    check(&read("summed.md", text, Format::Markdown).0)
}

const OPENING: &str = "Repeated indices are summed; the axes are fixed in the body, with the angular velocity \
$\\omega_i$, the angular momentum $H_i$ about the centre of mass and the torque $Q_i$ about it.\n\n";

#[test]
fn the_equations_of_motion_hold_index_by_index() {
    let text = format!(
        r"{OPENING}
$$ I_{{mn}} = \int \left(x_k x_k\,\delta_{{mn}} - x_m x_n\right) dm $$

$$ H_m = I_{{mn}}\,\omega_n $$

$$ Q_i = \dot H_i + \epsilon_{{ijk}}\,\omega_j H_k $$

$$ Q_i = I_{{ij}}\dot\omega_j - \epsilon_{{ijk}} I_{{jl}}\,\omega_l\omega_k $$

$$ 2T = I_{{ij}}\,\omega_i\omega_j, \qquad \frac{{\partial T}}{{\partial\omega_k}} = H_k $$

$$ \dot T = Q_k\omega_k $$

$$ \epsilon_{{ijk}}\,\epsilon_{{imn}} = \delta_{{jm}}\delta_{{kn}} - \delta_{{jn}}\delta_{{km}} $$

$$ \delta_{{ii}} = 3 $$
"
    );
    assert_eq!(verdicts(&text), "ppppppppp");
}

#[test]
fn false_lines_are_put_right_in_their_indices() {
    let text = format!(
        r"{OPENING}
The kinetic energy is

$$ T = I_{{ij}}\,\omega_i\omega_j $$

and the law of motion

$$ Q_i = I_{{ij}}\dot\omega_j + \epsilon_{{ijk}}\,\omega_k I_{{jl}}\,\omega_l $$
"
    );
    let report = checked(&text);
    let suggested: Vec<&str> = report
        .findings
        .iter()
        .filter_map(|f| f.diagnosis.as_ref()?.suggestion.as_deref())
        .collect();
    assert_eq!(verdicts(&text), "rr");
    assert_eq!(
        suggested,
        [
            r"T = \tfrac{1}{2}I_{ij}\,\omega_i\omega_j",
            r"Q_i = I_{ij}\dot\omega_j - \epsilon_{ijk}\,\omega_k I_{jl}\,\omega_l"
        ]
    );
}

#[test]
fn labels_and_words_are_no_indices() {
    let text = r"Let $\epsilon_{ijk}$ be the permutation symbol, $\mathbf I_b$ the inertia tensor and $\boldsymbol\omega_b$ the angular velocity, both on the axes of the body.

$$ \mathbf L_b = \mathbf I_b\,\boldsymbol\omega_b $$
";
    assert_eq!(verdicts(text), "p");
}

#[test]
fn too_many_indices_are_left_as_they_are() {
    let many: String = (0..40)
        .map(|_| r"\epsilon_{ijk}\epsilon_{lmn}\epsilon_{abc}")
        .collect();
    let text =
        format!("We sum over repeated indices.\n\n$$ {many} = 0 $$\n\n$$ v_{{ijklmn}} = 1 $$\n");
    assert_eq!(verdicts(&text).len(), 2);
}

#[test]
fn from_the_mass_centre_the_first_moment_of_the_mass_is_zero() {
    let integrals = |words: &str, letter: &str| {
        verdicts(&format!(
            "{words}\n\n$$ \\int{letter}\\,dm = 0 $$\n\n\
             $$ \\int(\\mathbf v_C + \\boldsymbol\\omega\\times{letter})\\,dm = m\\,\\mathbf v_C $$\n"
        ))
    };
    let centre = "The body has its centre of mass $C$. A particle has the position vector $\\mathbf r$ from $C$.";
    assert_eq!(integrals(centre, "\\mathbf r"), "pp");
    let other =
        "Let $C$ be the mass centre. The vector $\\boldsymbol\\rho$ from $C$ leads to a particle.";
    assert_eq!(integrals(other, "\\boldsymbol\\rho"), "pp");
    let fixed = "The body has its centre of mass $C$. A particle has the position vector $\\mathbf r$ from $O$.";
    assert_eq!(integrals(fixed, "\\mathbf r"), "uu");
    // The velocity of a particle is its own.
    assert_eq!(integrals(centre, "\\mathbf r\\times\\mathbf v"), "uu");
}

#[test]
fn the_elements_of_the_tensor_are_defined_all_at_once() {
    let text = |unit: &str, sign: &str| {
        format!(
            r"A body turns about a fixed point. A particle at $\mathbf r$ has the velocity $\mathbf v = \boldsymbol\omega\times\mathbf r$. We define the elements

$$ \Theta_{{ij}} = \int\left({unit} - x_i x_j\right)dm $$

$$ K = \frac12\int v^2\,dm = \frac12\sum_{{i,j}}\Theta_{{ij}}\,\omega_i\omega_j $$

$$ L_i = \frac{{\partial K}}{{\partial\omega_i}} = \sum_j\Theta_{{ij}}\,\omega_j $$

$$ L_1 = \Theta_{{11}}\omega_1 {sign} \Theta_{{12}}\omega_2 + \Theta_{{13}}\omega_3 $$

$$ \Theta_n = \sum_{{i,j}}\Theta_{{ij}}\,n_i n_j $$
"
        )
    };
    for unit in [r"r^2\delta_{ij}", r"\delta_{ij}\,r^2"] {
        assert_eq!(verdicts(&text(unit, "+")), "papppa", "{unit}");
        assert_eq!(verdicts(&text(unit, "-")), "pappra", "{unit}");
    }
}

#[test]
fn an_integral_with_the_distance_is_none_with_another_sign() {
    let text = |first: &str, second: &str| {
        format!(
            r"A body. The inertia tensor is

$$ I_{{ij}} = \int (r^2\delta_{{ij}} {first} x_i x_j)\,dm $$

$$ I_{{xx}} = \int (r^2 {second} x^2)\,dm $$
"
        )
    };
    assert_eq!(verdicts(&text("-", "-")), "pp");
    assert!(verdicts(&text("+", "-")).starts_with('r'));
    assert!(!verdicts(&text("-", "+")).ends_with(['p', 'a']));
}

#[test]
fn sums_in_sums_stop_in_time() {
    let sums: String = ('a'..='l').map(|c| format!(r"\sum_{{{c}=1}}^6 ")).collect();
    let text = format!("The tensor $I_{{11}}$.\n\n$$ x = {sums} I_{{11}}\\omega_1 $$\n");
    assert_eq!(verdicts(&text), "u");
    let sums = r"\sum_{ijkl} ".repeat(8);
    let text = format!("Repeated indices are summed.\n\n$$ x = {sums} I_{{ij}}\\omega_k $$\n");
    assert_eq!(verdicts(&text), "u");
}

#[test]
fn an_index_may_be_summed_over_in_one_component() {
    let text = |third: &str| {
        verdicts(&format!(
            "$L_i = I_{{ij}}\\omega_j$. In axes fixed in the body\n\n\
             $$ N_i = I_{{ij}}\\dot\\omega_j + \\epsilon_{{ijk}}\\omega_jI_{{kl}}\\omega_l $$\n\n\
             $$ N_1 = I_{{1j}}\\dot\\omega_j + \\omega_2I_{{3l}}\\omega_l - \\omega_3{third}\\omega_l $$\n"
        ))
    };
    assert!(text("I_{2l}").ends_with('p'), "{}", text("I_{2l}"));
    assert!(text("I_{1l}").ends_with('r'), "{}", text("I_{1l}"));
}

#[test]
fn the_law_of_a_running_index_holds_on_axes_that_do_not_turn() {
    let text = |lead: &str| {
        verdicts(&format!(
            "Repeated indices are summed. $L_i = I_{{ij}}\\omega_j$. {lead}\n\n$$ N_i = \\frac{{dL_i}}{{dt}} $$\n"
        ))
    };
    assert_eq!(text("The law is"), "pp");
    assert_eq!(text("On body axes"), "pr");
}

#[test]
fn a_sum_along_unit_vectors_runs_over_the_axes() {
    let rate = |sign: char| {
        verdicts(&format!(
            "Let $\\hat{{\\mathbf e}}_1$, $\\hat{{\\mathbf e}}_2$, $\\hat{{\\mathbf e}}_3$ be fixed in a frame that turns with \
             $\\boldsymbol\\Omega$. Any vector is $\\mathbf A = \\sum_i A_i\\hat{{\\mathbf e}}_i$. Then\n\n$$ \\frac{{d\\mathbf \
             A}}{{dt}} = \\sum_i\\dot A_i\\hat{{\\mathbf e}}_i {sign} \\boldsymbol\\Omega\\times\\mathbf A $$\n"
        ))
    };
    assert!(rate('+').ends_with('p'));
    assert!(rate('-').ends_with('r'));
}
