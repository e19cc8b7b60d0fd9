//! Small components beside a spin, in the ways that words have for them.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn last(words: &str, difference: &str) -> Option<char> {
    let text = format!(
        "Principal axes, the inertia matrix $J = \\mathrm{{diag}}(J_1, J_2, J_3)$ and no torque. {words} obey\n\n\
         $$ J_1\\dot\\omega_1 = {difference}\\,s\\,\\omega_2 $$\n"
    );
    verdicts(&text).chars().last()
}

#[test]
fn the_spin_keeps_its_value_and_no_moments_become_equal() {
    let ways = [
        "Near the spin $(0, 0, s)$ the small components $\\omega_1$ and $\\omega_2$",
        "Let $\\omega_3 = s$ be constant; the small components $\\omega_1$ and $\\omega_2$",
        "Let $\\omega_3 = s$ be constant; the small components $\\omega_1$, $\\omega_2$",
    ];
    for words in ways {
        assert_eq!(last(words, "(J_2 - J_3)"), Some('p'), "{words}");
        assert_eq!(last(words, "(J_1 - J_3)"), Some('r'), "{words}");
        assert_eq!(last(words, "(J_3 - J_2)"), Some('r'), "{words}");
    }
}
