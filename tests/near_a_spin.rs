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

#[test]
fn other_components_that_are_small_leave_the_spin_and_the_body_as_they_are() {
    let text = |small: &str, last: &str| {
        verdicts(&format!(
            r"On principal axes the body has the moments $J_1$, $J_2$, $J_3$. The momentum of a rotor along axis 3 is $h$. The angular momentum is

$$ \mathbf H = \mathbf J\boldsymbol\omega + h\,\mathbf e_3 $$

Assume $\mathbf M = \mathbf 0$ and $\dot h = 0$. Let $\omega_3 = n$ be constant and {small}. Then

$$ J_1\dot\omega_1 = -[(J_3 - J_2)\,n + h]\,\omega_2 $$

$$ \ddot\omega_1 = -\frac{{[(J_3 - J_2)\,n + h][(J_3 - J_1)\,n + h]}}{{ {last} }}\,\omega_1 $$
"
        ))
    };
    for small in [
        "the other components small",
        "the other two are small",
        "let $\\omega_1$ and $\\omega_2$ be small",
    ] {
        assert_eq!(text(small, "J_1J_2"), "aaaapp", "{small}");
        assert_eq!(text(small, "J_1^2"), "aaaapr", "{small}");
    }
    // Exactly, one of the two rates vanishes, or the body is symmetric: nothing says which.
    assert_eq!(text("known", "J_1^2"), "aaaapu");
}
