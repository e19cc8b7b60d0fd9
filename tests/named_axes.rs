//! Axes of the body with names of their own, and spins that words move from one to another.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// Euler's equation about the first axis, and one about the second, on axes with the names.
fn free(names: [&str; 3], second: &str) -> String {
    let [a, b, c] = names;
    verdicts(&format!(
        "No torque acts. The body axes ${a}$, ${b}$, ${c}$ are principal. Then\n\n$$ I_{{{a}}}\\dot\\omega_{{{a}}} = \
         (I_{{{b}}} - I_{{{c}}})\\omega_{{{b}}}\\omega_{{{c}}} $$\n\n$$ I_{{{b}}}\\dot\\omega_{{{b}}} = {second} $$\n"
    ))
}

#[test]
fn axes_may_have_letters() {
    assert_eq!(free(["a", "b", "c"], r"(I_c - I_a)\omega_c\omega_a"), "pp");
    assert_eq!(free(["a", "b", "c"], r"(I_a - I_c)\omega_c\omega_a"), "pr");
    let greek = [r"\xi", r"\eta", r"\zeta"];
    let second = r"(I_\zeta - I_\xi)\omega_\zeta\omega_\xi";
    assert_eq!(free(greek, second), "pp");
    assert_eq!(
        free(greek, r"(I_\xi - I_\zeta)\omega_\zeta\omega_\xi"),
        "pr"
    );
}

#[test]
fn entries_of_the_tensor_have_two_letters() {
    let text = r"The axes $\xi\eta\zeta$ are fixed in the body. Then

$$ L_\xi = I_{\xi\xi}\omega_\xi - I_{\xi\eta}\omega_\eta - I_{\xi\zeta}\omega_\zeta $$

$$ M_\xi = \dot L_\xi + \omega_\eta L_\zeta - \omega_\zeta L_\eta $$

$$ M_\xi = \dot L_\xi + \omega_\eta L_\zeta + \omega_\zeta L_\eta $$
";
    assert_eq!(verdicts(text), "ppr");
}

/// Lines on a spin with a small disturbance about a, and then about c or b.
fn disturbed(axis: &str, lines: [&str; 2]) -> String {
    let [rate, last] = lines;
    let text = format!(
        r"No torque acts. The body axes $a$, $b$, $c$ are principal.

**(i)** Let the body spin steadily about $a$ with a small disturbance: suppose $\omega_a = n + u$, where $n$ is constant and $u$, $\omega_b$, $\omega_c$ are small. We keep first-order terms only. Then

$$ I_b\dot\omega_b = (I_c - I_a)\,n\,\omega_c $$

**(ii)** Now the steady spin $n$ is about ${axis}$ and the other two components are the small ones. To first order

$$ I_a\dot\omega_a = {rate} $$

which grows like $e^{{\sigma t}}$ or oscillates by

$$ \ddot\omega_a = {last} $$
"
    );
    verdicts(&text)
}

#[test]
fn a_spin_moves_to_another_axis() {
    let about_c = [
        r"(I_b - I_c)\,n\,\omega_b",
        r"-\frac{(I_c - I_b)(I_c - I_a)}{I_a I_b}\,n^2\,\omega_a",
    ];
    assert_eq!(disturbed("c", about_c), "appp");
    let about_b = [
        r"(I_b - I_c)\,n\,\omega_c",
        r"\frac{(I_c - I_b)(I_b - I_a)}{I_a I_b}\,n^2\,\omega_a",
    ];
    assert_eq!(disturbed("b", about_b), "appr");
}

#[test]
fn a_growth_rate_is_held_to_the_laws_behind_a_false_equation() {
    let rate = |value: &str| {
        let text = format!(
            r"No torque acts, and on principal axes a body spins with $\omega_2 = n$, where $n$ is constant and $\omega_1$, $\omega_3$ are small. To first order

$$ \ddot\omega_1 = \frac{{(I_3 - I_2)(I_2 - I_1)}}{{I_1 I_2}}\,n^2\,\omega_1 $$

The disturbance grows like $e^{{\sigma t}}$ with the rate

$$ \sigma = n\sqrt{{{value}}} $$
"
        );
        verdicts(&text).split_off(1)
    };
    assert_eq!(rate(r"\frac{(I_3 - I_2)(I_2 - I_1)}{I_1 I_2}"), "rr");
    assert_ne!(rate(r"\frac{(I_3 - I_2)(I_2 - I_1)}{I_1 I_3}"), "rr");
}
