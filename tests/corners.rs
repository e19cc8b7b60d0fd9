//! The tensor about a corner, from principal axes through the mass centre.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn corner(shift: &str, product: &str) -> String {
    verdicts(&format!(
        r"A uniform brick of mass $M$ has the edges $2p$, $2q$, $2s$. Through its centre $C$ the axes are principal:

$$ I_{{Cx}} = \tfrac13 M(q^2 + s^2) $$
$$ I_{{Cy}} = \tfrac13 M(s^2 + p^2) $$
$$ I_{{Cz}} = \tfrac13 M(p^2 + q^2) $$

The vector from the corner $A$ to $C$ is $\mathbf e = (p, q, s)$. For the whole tensor

$$ \mathbf I_A = \mathbf I_C + {shift} $$

The products are defined as $I_{{xy}} = \int xy\,dm$; about the corner

$$ I_{{Axy}} = {product} $$

For a cube, $p = q = s$, and

$$ I_{{Ax}} = \tfrac83 M p^2 $$
"
    ))
}

#[test]
fn the_axes_through_the_centre_are_principal_and_those_at_a_corner_are_not() {
    let right = r"M\left(|\mathbf e|^2\,\mathbf 1 - \mathbf e\mathbf e^T\right)";
    let lost = r"|\mathbf e|^2\,\mathbf 1 - \mathbf e\mathbf e^T";
    assert_eq!(corner(right, "Mpq"), "aaaapapap");
    assert_eq!(corner(lost, "Mpq"), "aaaarapap");
    assert_eq!(corner(right, "-Mpq"), "aaaaparap");
}

#[test]
fn lengths_and_moments_of_inertia_are_not_added() {
    let text = |last: &str| {
        verdicts(&format!(
            "A disc of mass $m$ and radius $a$ turns on an axle of length $b$. On principal axes at the end of the axle\n\n\
             $$ I_x = \\tfrac12 ma^2, \\qquad I_y = I_z = \\tfrac14 ma^2 + {last} $$\n\n\
             The kinetic energy is\n\n\
             $$ T = \\tfrac12 I_x\\omega_x^2 + \\tfrac12 I_y(\\omega_y^2 + \\omega_z^2) = \
             \\tfrac14 ma^2\\omega_x^2 + (\\tfrac18 ma^2 + \\tfrac12 mb^2)(\\omega_y^2 + \\omega_z^2) $$\n"
        ))
    };
    assert_eq!(text("mb^2"), "aap");
    assert_eq!(text("b^2"), "aru");
}
