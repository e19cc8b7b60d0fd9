//! Marks that a document makes for itself, and letters whose reach ends: skew matrices in plain brackets, matrix
//! functions under a power, the momentum of a wheel as a number, two triads.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;
use outcome::verdicts;

/// `[a]` is the matrix of a × where the document says so, and nothing but a bracket elsewhere.
#[test]
fn plain_square_brackets_are_a_skew_matrix_where_the_document_says_so() {
    let text = r"
Write $[\omega]\,x = \omega\times x$ for the matrix of the cross product.

$$
[\omega]^\top + [\omega] = 0
$$

$$
[\omega]^\top = [\omega]
$$

$$
[\omega]^2\,r = \omega\times(\omega\times r)
$$
";
    assert_eq!(verdicts(text), "pprp");
}

/// A transpose or a power behind a matrix function is that of its value.
#[test]
fn a_power_behind_a_matrix_function_is_that_of_the_matrix() {
    let text = r"
For a column $\mathbf{u}$ let

$$
K(\mathbf{u}) = \begin{pmatrix} 0 & -u_3 & u_2 \\ u_3 & 0 & -u_1 \\ -u_2 & u_1 & 0 \end{pmatrix}.
$$

Then

$$
K(\mathbf{u})^T = -K(\mathbf{u})
$$

$$
K(\mathbf{u})^2 = \mathbf{u}\,\mathbf{u}^T - (\mathbf{u}\cdot\mathbf{u})\,\mathbf{1}
$$

$$
K(\mathbf{u})^2 = \mathbf{u}\,\mathbf{u}^T + (\mathbf{u}\cdot\mathbf{u})\,\mathbf{1}
$$
";
    assert_eq!(verdicts(text), "appr");
}

/// The cross of a last `[a]_\times` in a bracket belongs to its own bracket.
#[test]
fn a_skew_mark_may_end_a_larger_bracket() {
    let text = r"
$$
2\left(\mathbf{J}\,[\boldsymbol\omega]_\times\right)\boldsymbol\omega = \mathbf{0}
$$
";
    assert_eq!(verdicts(text), "p");
}

/// What a wheel adds to the momentum may be a number, and the line of the whole hands it over.
#[test]
fn the_momentum_of_a_wheel_may_be_a_number() {
    let text = r"
The axes are principal. A wheel turns about axis 2; its momentum relative to the body is $h$. The whole has the
angular momentum

$$
\mathbf{L} = I_1\omega_1\,\mathbf{e}_1 + (I_2\omega_2 + h)\,\mathbf{e}_2 + I_3\omega_3\,\mathbf{e}_3 .
$$

For the torque $\mathbf{M}$ of outer forces

$$
M_1 = I_1\dot\omega_1 + (I_3 - I_2)\,\omega_2\omega_3 - h\,\omega_3
$$

$$
M_3 = I_3\dot\omega_3 + (I_2 - I_1)\,\omega_1\omega_2 - h\,\omega_1
$$
";
    assert_eq!(verdicts(text), "apr");
}

/// What is assumed of ω_x, ω_y, ω_z does not hold of ω_1, ω_2, ω_3, which stand on other axes.
#[test]
fn what_is_assumed_on_one_triad_is_not_on_another() {
    let text = r"
Assume $\omega_x = \omega_y = 0$ and $\omega_z = n$ on the axes of the shaft.

On the principal axes 1, 2, 3 of the disc, tilted by $\delta$, the angular velocity is

$$
\omega_1 = n\sin\delta, \qquad \omega_2 = 0, \qquad \omega_3 = n\cos\delta .
$$
";
    let found = verdicts(text);
    assert!(!found.contains('r'), "{found}");
}

/// A rate of the momentum's square is no momentum that is handed over.
#[test]
fn a_rate_of_the_momentum_is_checked_though_nothing_gives_the_motion() {
    let text = r"
The axes are principal. Assume $\boldsymbol\tau = -k\,\boldsymbol\omega$.

The momentum shrinks:

$$
\frac{d}{dt}\left(L^2\right) = -4 k T
$$

$$
\frac{d}{dt}\left(L^2\right) = -k T
$$

Here $T = \frac12\,\boldsymbol\omega\cdot\mathbf{L}$.
";
    assert_eq!(verdicts(text), "aprp");
}

#[test]
fn a_line_may_name_the_parts_of_a_quaternion() {
    let text = r"The unit quaternion $q = (c, \mathbf v)$, with $\mathbf v = (a, b, d)^T$, turns body components into space ones, and
$\boldsymbol\omega$ is the angular velocity on body axes.

$$ \dot q = \tfrac12\, q\otimes(0, \boldsymbol\omega) $$

$$ \dot{\mathbf v} = \tfrac12\left(c\,\boldsymbol\omega - \mathbf v\times\boldsymbol\omega\right) $$

$$ \dot a = \tfrac12\left(c\,\omega_x + b\,\omega_z - d\,\omega_y\right) $$
";
    assert!(verdicts(text).ends_with("prp"), "{}", verdicts(text));
}

#[test]
fn a_letter_for_the_four_numbers_is_the_quaternion() {
    let text = r"The quaternion $\Lambda = (\lambda_0, \lambda_1, \lambda_2, \lambda_3)$ takes body components into space ones:

$$ \dot\Lambda = \tfrac12\,\Lambda\circ\vec\omega $$

$$ \dot{\widetilde\Lambda} = -\tfrac12\,\vec\omega\circ\widetilde\Lambda $$

$$ \dot{\widetilde\Lambda} = -\tfrac12\,\widetilde\Lambda\circ\vec\omega $$
";
    assert!(verdicts(text).ends_with("ppr"), "{}", verdicts(text));
}

#[test]
fn where_quaternions_are_circled_two_vectors_are_too() {
    let text = |sign: &str| {
        format!(
            "The unit quaternion $q$ leads from the body to space, and $\\omega_B$ is the angular velocity on the body's axes.\n\n\
             $$ \\dot q = \\tfrac12\\,q\\otimes\\boldsymbol\\omega_B $$\n\n\
             $$ \\boldsymbol\\omega_B\\otimes\\boldsymbol\\omega_B = {sign}|\\boldsymbol\\omega_B|^2 $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "pp");
    assert_eq!(verdicts(&text("")), "pr");
}

#[test]
fn an_unmarked_e_in_a_sum_of_matrices_is_the_identity() {
    let text = |sign: &str| {
        verdicts(&format!(
            "The matrix of the cross product is $[\\omega]_\\times$. Then\n\n\
             $$ [\\omega]_\\times^2 = \\omega\\omega^T {sign} |\\omega|^2 E $$\n"
        ))
    };
    assert_eq!(text("-"), "p");
    assert_eq!(text("+"), "r");
}
