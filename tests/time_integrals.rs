//! Definite integrals over time.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_spin_grows_from_its_value_at_the_beginning() {
    let text = |factor: &str| {
        format!(
            "The moments are $I_1 = I_2 = I_t$ and $I_3 = I_a$ on principal axes. The torque is $\\boldsymbol\\tau = \\tau_a\\,\\mathbf e_3$.\n\n\
             $$ I_a\\dot\\omega_3 = \\tau_a $$\n\nFor a constant torque the spin grows linearly,\n\n\
             $$ \\omega_3(t) = \\omega_3(0) + \\frac{{{factor}\\tau_a}}{{I_a}}t $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "aaapa");
    assert_ne!(verdicts(&text("2")), "aaapa");
}

#[test]
fn a_rate_over_time_gives_the_angle() {
    let text = |angle: &str| {
        format!(
            "The body turns about $z$ through $\\phi(t)$, $\\boldsymbol\\omega = \\dot\\phi\\,\\hat{{\\mathbf z}}$. \
             Choose $\\dot\\phi = w\\sin^2(\\pi t/D)$. In the time $D$ it covers\n\n\
             $$ \\phi(D) - \\phi(0) = \\int_0^D \\dot\\phi\\,dt = {angle} $$\n"
        )
    };
    let last = |angle: &str| verdicts(&text(angle)).pop();
    assert_eq!(last("\\tfrac12 w D"), Some('p'));
    assert_ne!(last("w D"), Some('p'));
}

#[test]
fn what_decays_has_an_integral_without_end() {
    let text = |turns: &str| {
        format!(
            "A wheel with the moment of inertia $J$ about its axis runs down, $w = w_0 e^{{-ct/J}}$. It turns by\n\n\
             $$ \\int_0^\\infty w_0 e^{{-ct/J}}\\,dt = {turns} $$\n"
        )
    };
    let last = |turns: &str| verdicts(&text(turns)).pop();
    assert_eq!(last("\\frac{J w_0}{c}"), Some('p'));
    assert_ne!(last("\\frac{c w_0}{J}"), Some('p'));
    assert_eq!(verdicts("$$ \\int_0^b t^2\\,dt = \\frac{b^3}{3} $$\n"), "p");
}

#[test]
fn a_value_at_some_time_beside_an_integral_is_left_open() {
    let text = "The body turns about $z$ with $\\boldsymbol\\omega = \\dot\\phi\\,\\hat{\\mathbf z}$ and $\\dot\\phi = k t$.\n\n\
                $$ \\phi(D) = \\int_0^D k t\\,dt $$\n";
    assert_eq!(verdicts(text).pop(), Some('u'));
}
