//! Planes of symmetry that words name in one way or another, and letters in a row beside the rates p, q, r.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::document::Format;

fn airframe(plane: &str) -> String {
    format!(
        r"Rates $p, q, r$ and moments $\ell, m, n$ on body axes. {plane} The products are $J_{{xz}} = \int xz\,dm$ and so on.

$$ m = J_y\,\dot q + (J_x - J_z)\,p\,r + J_{{xz}}(p^2 - r^2) $$

$$ n = J_z\,\dot r + (J_y - J_x)\,p\,q + J_{{xz}}(q r - \dot p) $$
"
    )
}

#[test]
fn a_product_that_is_left_does_not_vanish_in_a_chain_of_zeros() {
    let with = |zeros: &str| {
        verdicts(&format!(
            "The $x$-$z$ plane is a plane of symmetry. Hence\n\n$$ {zeros} = 0 $$\n"
        ))
    };
    assert_eq!(with("I_{xy} = I_{yz}"), "p");
    assert!(!with("I_{xz} = I_{yz}").contains('p'));
}

#[test]
fn a_plane_of_symmetry_is_named_by_its_axes() {
    for plane in [
        "It is symmetric about the plane of the body $x$ and $z$ axes.",
        "The plane $Oxz$ is a plane of symmetry.",
        "The x-z plane is its mirror plane.",
    ] {
        assert_eq!(verdicts(&airframe(plane)), "ppp", "{plane}");
    }
    let other = airframe("It is symmetric about the plane of $x$ and $y$.");
    assert!(verdicts(&other).contains('r'));
}

#[test]
fn plain_text_names_components_and_calls_a_letter_constant() {
    let text = "\
L, M, N: rolling, pitching and yawing moment, on axes fixed in the aeroplane. Its rates are (p, q, r).
The body axes are principal.

    hx = Ix p
    hy = Iy q
    hz = Iz r
    Iy q̇ = (Iz − Ix) r p + M

    L = ḣx + q hz − r hy
    N = ḣz + p hy − r hx

Suppose q = r = 0 and p constant. Then

    N = 0
    M = 0
";
    assert_eq!(verdicts_in(text, Format::Text), "ppppprapp");
}

#[test]
fn a_plane_tensor_turns_by_its_matrix() {
    let with = |sign: &str| {
        let text = r"In the plane the tensor and the turn through the angle $\beta$ are

$$ \mathbf{I} = \begin{pmatrix} I_{xx} & I_{xy} \\ I_{xy} & I_{yy} \end{pmatrix}, \qquad \mathbf{Q} = \begin{pmatrix} \cos\beta & \sin\beta \\ -\sin\beta & \cos\beta \end{pmatrix} $$

On the turned axes it is

$$ \mathbf{I}' = \mathbf{Q}\,\mathbf{I}\,\mathbf{Q}^T $$

that is

$$ I_{y'y'} = I_{xx}\sin^2\beta SIGN I_{xy}\sin 2\beta + I_{yy}\cos^2\beta $$
";
        verdicts(&text.replace("SIGN", sign)).pop()
    };
    assert_eq!(with("-"), Some('p'));
    assert_eq!(with("+"), Some('r'));
}

#[test]
fn vectors_x_y_z_are_the_axes_where_a_vector_is_written_along_them() {
    let text = |sign: &str| {
        format!(
            "The solid $(S)$ has the matrix of inertia\n\n\
             $$ [I_G] = \\begin{{bmatrix}} A & -F & -E \\\\ -F & B & -D \\\\ -E & -D & C \\end{{bmatrix}} $$\n\n\
             with the products $D = \\int yz\\,dm$, $E = \\int xz\\,dm$ and $F = \\int xy\\,dm$. \
             The rotation vector is $\\vec\\Omega = p\\,\\vec x + q\\,\\vec y + r\\,\\vec z$. The kinetic moment is\n\n\
             $$ \\vec\\sigma_G = [I_G]\\,\\vec\\Omega $$\n\n\
             $$ \\vec M_G = \\left(\\frac{{d\\vec\\sigma_G}}{{dt}}\\right)_S {sign} \\vec\\Omega\\wedge\\vec\\sigma_G $$\n"
        )
    };
    assert_eq!(verdicts(&text("+")), "apppapp");
    assert_ne!(verdicts(&text("-")), "apppapp");
}

#[test]
fn a_product_of_inertia_under_another_letter_is_none_on_no_axes() {
    let text = |sign: &str| {
        format!(
            "We define $I_x = \\int y^2\\,dm$, $I_y = \\int x^2\\,dm$ and $P = \\int xy\\,dm$ for a thin plate in the plane $xy$. \
             The axes $x'$, $y'$ are turned by the angle $\\alpha$:\n\n\
             $$ x' = x\\cos\\alpha + y\\sin\\alpha $$\n$$ y' = -x\\sin\\alpha + y\\cos\\alpha $$\n\n\
             We define $P' = \\int x'y'\\,dm$. Multiplying out,\n\n\
             $$ P' = (I_x - I_y)\\sin\\alpha\\cos\\alpha + P\\,(\\cos^2\\alpha {sign} \\sin^2\\alpha) $$\n"
        )
    };
    assert!(verdicts(&text("-")).ends_with('p'));
    assert!(verdicts(&text("+")).ends_with('r'));
}

#[test]
fn an_aircraft_of_which_one_product_is_written_has_a_plane_of_symmetry() {
    let text = |body: &str, term: &str| {
        verdicts(&format!(
            "For the lateral motion of {body} with $I_{{xz}} = \\int xz\\,dm$ we have\n\n\
             $$ L = I_{{xx}}\\dot p - I_{{xz}}\\dot r + qr(I_{{zz}} - I_{{yy}}) - I_{{xz}}pq $$\n\n\
             $$ M = I_{{yy}}\\dot q + rp(I_{{xx}} - I_{{zz}}) + I_{{xz}}(p^2 - r^2) $$\n\n\
             $$ N = I_{{zz}}\\dot r - I_{{xz}}\\dot p + pq(I_{{yy}} - I_{{xx}}) + I_{{xz}}qr $$\n\n\
             Linearised about straight flight,\n\n$$ L = I_{{xx}}\\dot p {term} I_{{xz}}\\dot r $$\n"
        ))
    };
    assert_eq!(text("an aeroplane", "-"), "apppp");
    assert_eq!(text("an aeroplane", "+"), "apppr");
    assert_ne!(text("a rigid body", "-"), "apppp");
}
