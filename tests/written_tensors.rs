//! Tensors of which integrals give some entries and a matrix the rest, and their principal moments.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const CUBE: &str = r"A uniform cube has the mass $M$ and the side $a$. We define $I_{xy} = -\int xy\,dm$.

$$ I_{xx} = \frac{M}{a^3}\int_0^a\!\int_0^a\!\int_0^a (y^2 + z^2)\,dx\,dy\,dz = \frac{2}{3}Ma^2 $$

";

#[test]
fn integrals_in_integrals_are_evaluated() {
    assert_eq!(verdicts(CUBE), "aa");
    let wrong = CUBE.replace("{2}{3}Ma^2", "{1}{3}Ma^2");
    assert!(!verdicts(&wrong).ends_with(['a', 'p']));
}

#[test]
fn a_matrix_hands_over_the_entries_that_are_not_known() {
    let rest = r"With the abbreviation $\mu = Ma^2/12$,

$$ \mathbf I = \mu\begin{pmatrix} 8 & -3 & -3 \\ -3 & 8 & -3 \\ -3 & -3 & 8 \end{pmatrix} $$

For $\boldsymbol\omega = (\omega, 0, 0)$

$$ L_x = 8\mu\omega $$
$$ L_y = 3\mu\omega $$

The principal moments are

$$ \lambda_1 = 2\mu $$
$$ \lambda_2 = \lambda_3 = 11\mu = \frac{11}{12}Ma^2 $$
$$ \lambda_1 + \lambda_2 + \lambda_3 = 24\mu $$
$$ \lambda_1 + \lambda_2 + \lambda_3 = 22\mu $$
";
    let found = verdicts(&format!("{CUBE}{rest}"));
    let lines = &found[2..];
    assert_eq!(&lines[3..5], "pr", "{found}");
    assert!(!lines[5..8].contains(['r', 'u']), "{found}");
    assert_eq!(&lines[8..], "r", "{found}");
}

#[test]
fn the_angle_of_principal_axes_is_where_the_product_vanishes() {
    let text = |words: &str, angle: &str| {
        let text = format!(
            r"The axes are turned about $y$ through $\alpha$, and the product of inertia becomes

$$ I_{{xz_s}} = \tfrac12(I_x - I_z)\sin 2\alpha + I_{{xz}}\cos 2\alpha $$

{words}

$$ {angle} $$
"
        );
        verdicts(&text)
    };
    let (right, wrong) = (r"\frac{2I_{xz}}{I_z - I_x}", r"\frac{2I_{xz}}{I_x - I_z}");
    let inclined = r"The axes on which the product of inertia disappears are inclined at the angle $\varepsilon$ with";
    let condition =
        r"The new axes are principal when $I_{xz_s} = 0$, which happens at the angle given by";
    for (words, letter, before) in [(inclined, r"\varepsilon", ""), (condition, r"\alpha", "a")] {
        let line = |value: &str| text(words, &format!(r"\tan 2{letter} = {value}"));
        assert_eq!(line(right), format!("a{before}a"), "{words}");
        assert_eq!(line(wrong), format!("a{before}r"), "{words}");
    }
}

#[test]
fn a_capital_that_lines_apply_to_vectors_is_a_matrix_whatever_its_mark() {
    let text = |rate: &str| {
        verdicts(&format!(
            r"The body has the inertia matrix $\mathbf J$ and the angular velocity $\boldsymbol\omega$. We apply the torque

$$ \mathbf T = -\mathbf D\boldsymbol\omega $$

with the gain $\mathbf D$, so that $E = \frac12\boldsymbol\omega^T\mathbf J\boldsymbol\omega$ changes at the rate

$$ \dot E = {rate}\boldsymbol\omega^T\mathbf D\boldsymbol\omega $$
"
        ))
    };
    assert_eq!(text("-"), "aap");
    assert!(!text("-2").ends_with(['p', 'a']));
}

#[test]
fn letters_beside_the_diagonal_of_a_tensor_are_no_energies() {
    let text = |sign: &str| {
        format!(
            "The kinetic energy is the same on both sets of axes. The inertia matrix about $O$ is\n\n\
             $$ \\mathbf J_O = \\mathbf J_G + m(\\mathbf d^T\\mathbf d\\,\\mathbf 1 - \\mathbf d\\,\\mathbf d^T) $$\n\n\
             For a body that is symmetric with respect to the $xz$ plane we write\n\n\
             $$ \\mathbf J = \\begin{{pmatrix}} P & 0 & -E \\\\ 0 & Q & 0 \\\\ -E & 0 & R \\end{{pmatrix}} $$\n\n\
             The determinant is\n\n$$ \\det\\mathbf J = Q\\,(PR {sign} E^2) $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "pap");
    assert_eq!(verdicts(&text("+")), "par");
}

#[test]
fn a_matrix_that_takes_components_to_other_axes_turns_them() {
    let text = |trace: &str| {
        format!(
            "The inertia matrix is $\\mathbf I$. Let $\\mathbf Q$ carry the components on the old axes to those on the new axes, so that \
             $\\boldsymbol\\omega' = \\mathbf Q\\boldsymbol\\omega$ and $\\mathbf L' = \\mathbf Q\\mathbf L$. On the new axes\n\n\
             $$ \\mathbf I' = \\mathbf Q\\,\\mathbf I\\,\\mathbf Q^T $$\n\nand the trace is\n\n$$ \\operatorname{{tr}}\\mathbf I' = {trace} $$\n"
        )
    };
    assert!(verdicts(&text(r"\operatorname{tr}\mathbf I")).ends_with('p'));
    assert!(verdicts(&text(r"2\operatorname{tr}\mathbf I")).ends_with('r'));
}

#[test]
fn words_call_other_letters_unit_vectors() {
    let text = |third: &str| {
        verdicts(&format!(
            "The unit vectors $\\mathbf a_1$, $\\mathbf a_2$, $\\mathbf a_3$ lie along the principal axes of a body.\n\n\
             $$ \\boldsymbol\\omega = \\omega_1\\mathbf a_1 + \\omega_2\\mathbf a_2 + \\omega_3\\mathbf a_3 $$\n\n\
             $$ \\mathbf L = I_1\\omega_1\\mathbf a_1 + I_2\\omega_2\\mathbf a_2 + {third}\\omega_3\\mathbf a_3 $$\n"
        ))
    };
    assert!(text("I_3").ends_with('p'), "{}", text("I_3"));
    assert!(text("I_2").ends_with('r'), "{}", text("I_2"));
}
