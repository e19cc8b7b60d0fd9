//! One motion of several: words turn to it, and what they say holds from there on.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// The gradient of gravity on a satellite in general, and in a roll.
fn in_orbit(general: &str, roll: &str) -> String {
    verdicts(&format!(
        "A satellite on a circular orbit has the orbital rate $n$, which satisfies\n\n$$ n^2 = \\frac{{\\mu}}{{R^3}} $$\n\n\
         Let $\\mathbf u$ be the unit vector to the Earth. On principal axes the torque of the gravity gradient is\n\n\
         $$ \\mathbf M = \\frac{{3\\mu}}{{R^3}}\\,\\mathbf u\\times\\mathbf I\\,\\mathbf u $$\n\n$$ {general} $$\n\n\
         Now consider a roll motion through the angle $\\phi$ about axis 1, with\n\n\
         $$ u_1 = 0, \\qquad u_2 = \\sin\\phi, \\qquad u_3 = \\cos\\phi $$\n\nThen\n\n$$ {roll} $$\n"
    ))
}

#[test]
fn the_gradient_of_gravity_turns_a_satellite() {
    let general = "M_2 = 3n^2 (I_1 - I_3) u_3 u_1";
    let roll = r"I_1\ddot\phi = 3n^2(I_3 - I_2)\sin\phi\cos\phi";
    assert_eq!(in_orbit(general, roll), "aapaaap");
    let slipped = r"I_1\ddot\phi = 3n^2(I_2 - I_3)\sin\phi\cos\phi";
    assert_eq!(in_orbit(general, slipped), "aapaaar");
    let slipped = "M_2 = 3n^2 (I_3 - I_1) u_3 u_1";
    assert!(in_orbit(slipped, roll).starts_with("aar"));
}

#[test]
fn a_display_may_suppose_a_steady_turn() {
    let turning = |words: &str| {
        verdicts(&format!(
            "On body axes $\\omega_x = \\omega_y = 0$ and $\\omega_z = \\omega$, so that\n\n\
             $$ M_z = I_{{zz}}\\,\\dot\\omega $$\n\n{words}\n\n$$ \\dot\\omega = 0 $$\n\nand then\n\n\
             $$ M_y = -I_{{xz}}\\,\\omega^2 $$\n"
        ))
    };
    assert!(turning("At constant speed we have").ends_with("ap"));
    let derived = turning("It follows that the speed is constant,");
    assert!(!derived.ends_with("ap"), "{derived}");
}
