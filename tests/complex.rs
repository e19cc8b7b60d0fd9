//! Complex equations: two real ones joined by the imaginary unit.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn two_equations_are_joined_by_the_imaginary_unit() {
    let last = |right: &str| {
        let text = format!(
            "Principal axes, moments $A$, $A$, $C$, components of the angular velocity $p$, $q$, $r$. No torque acts. Define the complex rate\n\n\
             $$ \\zeta = p + i\\,q $$\n\nThe two equations across the axis become one,\n\n\
             $$ \\dot\\zeta = {right}\\frac{{C - A}}{{A}}r\\,\\zeta $$\n"
        );
        verdicts(&text)
    };
    assert_eq!(last("i\\,"), "ap");
    assert_ne!(last("-i\\,"), "ap");
    assert_ne!(last(""), "ap");
}

#[test]
fn an_i_without_complex_numbers_is_a_symbol() {
    let text = "Let $i = 3$ and $k = 2$. Then\n\n$$ i^2 = -1 $$\n";
    assert_ne!(verdicts(text).chars().last(), Some('p'));
}

#[test]
fn a_complex_solution_leaves_its_parts_free() {
    let text = |sign: &str| {
        format!(
            "Principal axes, moments $A$, $A$, $C$. No torque acts. Put $\\lambda = \\frac{{C - A}}{{A}}\\omega_z$ and \
             $\\eta = \\omega_x + i\\,\\omega_y$. Then\n\n$$ \\dot\\eta = i\\lambda\\eta, \\qquad \\eta(t) = \\eta(0)\\,e^{{i\\lambda t}} $$\n\n\
             In real form, with the amplitude $w$,\n\n$$ \\begin{{aligned}} \\omega_x &= w\\cos\\lambda t \\\\ \
             \\omega_y &= {sign}w\\sin\\lambda t \\end{{aligned}} $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "aapaap");
    assert_eq!(verdicts(&text("-")), "aapaar");
}
