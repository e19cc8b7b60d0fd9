//! Values at the start beside what does not change.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_does_not_change_has_the_value_that_it_had_at_the_start() {
    let text = |last: &str| {
        verdicts(&format!(
            r"A free body, no torque. The principal moments are $A$, $B$, $C$, and at the start the components $p$, $q$, $r$ of the angular velocity are $p_0$, $q_0$, $r_0$. Then

$$ 2T = Ap_0^2 + Bq_0^2 + Cr_0^2 $$

$$ {last} $$
"
        ))
    };
    assert_eq!(text("L^2 = A^2p_0^2 + B^2q_0^2 + C^2r_0^2"), "aa");
    assert_eq!(text("L^2 = A^2p_0^2 + B^2q_0^2 - C^2r_0^2"), "ar");
    assert_eq!(text("2T = Ap_0^2 + Bq_0^2 - Cr_0^2"), "ar");
    // A component of a body that turns is not what it was.
    assert_eq!(text("L_x = Ap_0"), "au");
}

#[test]
fn the_start_may_be_in_numbers() {
    let text = |energy: &str, twice: &str| {
        verdicts(&format!(
            r"A free body, no torque, with the principal moments $I_1 = 2$, $I_2 = 3$ and $I_3 = 4$. At the start $\omega_{{10}} = 1$, $\omega_{{20}} = 2$ and $\omega_{{30}} = 1$. Then

$$ 2T = I_1\omega_{{10}}^2 + I_2\omega_{{20}}^2 + I_3\omega_{{30}}^2 = {twice} $$

so $T = {energy}$.
"
        ))
    };
    assert_eq!(text("9", "18"), "aaaaaaap");
    assert_eq!(text("8", "18"), "aaaaaaar");
    assert_eq!(text("9", "19"), "aaaaaarr");
}

#[test]
fn what_is_zero_at_the_start_does_not_stay_so() {
    let text = |given: &str| {
        format!(
            r"A body that no torque acts on, on principal axes. {given}

$$ I_1\ddot\omega_1 = (I_2 - I_3)(\dot\omega_2\omega_3 + \omega_2\dot\omega_3) $$

$$ I_1\dot\omega_1 = 0 $$
"
        )
    };
    for given in [
        r"With $\omega_1 = 0$ at the start,",
        r"Let $\omega_1 = 0$ initially.",
        r"Initially $\omega_1 = 0$.",
    ] {
        assert_eq!(verdicts(&text(given)), "apr", "{given}");
    }
    for given in [
        r"Let $\omega_1 = 0$ at $t = 0$.",
        r"At $t = 0$, $\omega_1 = 0$.",
    ] {
        assert_eq!(verdicts(&text(given)), "aapr", "{given}");
    }
}

#[test]
fn a_chain_in_numbers_says_what_was_kept_from_the_start() {
    let text = |last: &str| {
        verdicts(&format!(
            r"A free body has the principal moments $J_1 = 2$, $J_2 = 3$ and $J_3 = 4$. It is released with

$$ \boldsymbol\omega(0) = (2,\ 0,\ 1) $$

No torque acts, so the kinetic energy $K$ and the length $h$ of the angular momentum keep their initial values. The starting values give

$$ {last} $$
"
        ))
        .split_off(4)
    };
    assert_eq!(text(r"K = \tfrac12(2\cdot 2^2 + 4\cdot 1^2) = 6"), "a");
    assert_eq!(text(r"K = \tfrac12(2\cdot 2^2 + 3\cdot 1^2) = 5.5"), "r");
    assert_eq!(text(r"h^2 = 4\cdot 2^2 + 16\cdot 1^2 = 32"), "a");
    assert_ne!(text(r"h^2 = 4\cdot 2^2 + 16\cdot 1^2 = 34"), "a");
    let circle = r"2\omega_1^2 + 3\omega_2^2 + 4\omega_3^2 = 12";
    assert_eq!(text(circle), "a");
    assert_eq!(text(&circle.replace("12", "16")), "r");
}
