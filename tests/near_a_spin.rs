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

#[test]
fn what_disturbs_a_spin_is_small_and_so_in_the_next_case() {
    let document = |second: &str| {
        format!(
            r"No torque acts. The principal moments are $I_1$, $I_2$ and $I_3$.

## Rotation about axis 3

The body spins with the constant rate $\Omega$ and is disturbed a little,

$$ \omega_1 = \varepsilon_1, \qquad \omega_2 = \varepsilon_2, \qquad \omega_3 = \Omega + \varepsilon_3. $$

Then

$$ \dot\varepsilon_1 = \frac{{I_2 - I_3}}{{I_1}}\Omega\varepsilon_2, \qquad \dot\varepsilon_3 = 0. $$

## Rotation about axis 2

Now the large component is the second one,

$$ \omega_1 = \eta_1, \qquad \omega_2 = \Omega + \eta_2, \qquad \omega_3 = \eta_3. $$

The linear equations are

$$ \dot\eta_1 = \frac{{I_2 - I_3}}{{I_1}}\Omega\eta_3, \qquad \dot\eta_3 = \frac{{{second}}}{{I_3}}\Omega\eta_1. $$
"
        )
    };
    assert_eq!(verdicts(&document("I_1 - I_2")), "aaappaaapp");
    assert_eq!(verdicts(&document("I_2 - I_1")), "aaappaaapr");
}

#[test]
fn a_case_that_says_again_what_the_one_before_did_keeps_to_it() {
    let text = r"Free rotation. The principal moments are $I_1$, $I_2$, $I_3$.

*(a) Spin about the middle axis.* Let $\omega_1 = \varepsilon_1$, $\omega_2 = \Omega$, $\omega_3 = \varepsilon_3$, with small $\varepsilon_1, \varepsilon_3$. To first order $\Omega$ is constant, and

$$ I_1\dot\varepsilon_1 = (I_2 - I_3)\,\Omega\,\varepsilon_3. $$

*(b) Spin about axis 3.* Now let $\omega_1 = \varepsilon_1$, $\omega_2 = \varepsilon_2$, $\omega_3 = \Omega$. In the same way

$$ I_1\dot\varepsilon_1 = (I_2 - I_3)\,\Omega\,\varepsilon_2. $$
";
    assert_eq!(verdicts(text), "aaapaaap");
}

#[test]
fn the_rate_of_the_spin_makes_no_moments_equal() {
    let document = |rate: &str| {
        format!(
            r"No torque acts. The principal moments are $I_1$, $I_2$ and $I_3$. Put

$$ \omega_1 = \varepsilon_1, \qquad \omega_2 = \Omega, \qquad \omega_3 = \varepsilon_3 $$

with small $\varepsilon_1$, $\varepsilon_3$, of which we keep the first order only; then $\Omega$ is constant. So

$$ I_3\dot\varepsilon_3 = {rate}\,\Omega\,\varepsilon_1. $$
"
        )
    };
    assert_eq!(verdicts(&document("(I_1 - I_2)")), "aaap");
    assert_eq!(verdicts(&document("(I_3 - I_2)")), "aaar");
}

#[test]
fn what_is_small_now_vanished_only_while_the_spin_was_exact() {
    let text = |last: &str| {
        verdicts(&format!(
            r"The principal moments are $A$, $B$, $C$, and no torque acts, so $\dot p = (B - C) q r/A$ for the angular velocity $(p, q, r)$.

If the body spins exactly about the first axis, that is $q = r = 0$, it goes on doing so. Give it a knock, so that $q$ and $r$ are small but not zero. Then $p$ is nearly constant and

$$ \ddot q = {last} \frac{{(A - B)(A - C)}}{{BC}}\,p^2 q $$
"
        ))
    };
    assert_eq!(text("-").chars().last(), Some('p'));
    assert_eq!(text("+").chars().last(), Some('r'));
}

#[test]
fn a_disturbance_ends_the_steady_spin_that_it_disturbs() {
    let text = |given: &str, rate: &str| {
        format!(
            "A torque-free body is looked at on its principal axes. We linearise about a steady spin, {given}. Put \
             $\\omega_1 = \\epsilon_1$, $\\omega_2 = \\epsilon_2$, $\\omega_3 = \\Omega + \\epsilon_3$ with all $\\epsilon$ small. Then\n\n\
             $$ I_1\\dot\\epsilon_1 = {rate} $$\n"
        )
    };
    let right = r"(I_2 - I_3)\Omega\epsilon_2";
    let wrong = r"(I_3 - I_2)\Omega\epsilon_2";
    let whole = r"$\omega = (0, 0, \Omega)$";
    assert_eq!(verdicts(&text(whole, right)), "aaaap");
    assert_eq!(verdicts(&text(whole, wrong)), "aaaar");
    let parts = r"$\omega_1 = \omega_2 = 0$ and $\omega_3 = \Omega$";
    assert_eq!(verdicts(&text(parts, right)), "aaaaap");
    assert_eq!(verdicts(&text(parts, wrong)), "aaaaar");
}

#[test]
fn their_product_is_dropped_in_many_ways() {
    for words in [
        "can be dropped, so that",
        "is neglected, so",
        "is left out, and",
    ] {
        let text = format!(
            "Principal axes, no torque. The body rotates about the second axis; $\\omega_1$ and $\\omega_3$ are small. Their \
             product {words} $\\dot\\omega_2 = 0$.\n"
        );
        assert!(!verdicts(&text).contains('r'), "{words}");
    }
}

#[test]
fn the_spin_may_be_about_another_axis_instead() {
    let text = |sign: &str| {
        verdicts(&format!(
            "Let $I_1 < I_2 < I_3$ be the principal moments of a body free of torque. It spins about axis 2, $\\omega_2 = s$, \
             and the other two rates are small. To first order $s$ is constant and\n\n\
             $$ I_1I_3\\ddot\\omega_1 = (I_2 - I_3)(I_1 - I_2)s^2\\omega_1 $$\n\n\
             $$ \\ddot\\omega_1 = k^2\\omega_1, \\qquad k^2 = \\frac{{(I_3 - I_2)(I_2 - I_1)}}{{I_1I_3}}s^2 $$\n\n\
             About axis 1 instead,\n\n\
             $$ \\ddot\\omega_2 = {sign}\\frac{{(I_1 - I_2)(I_1 - I_3)}}{{I_2I_3}}s^2\\omega_2 $$\n"
        ))
    };
    assert_eq!(text("-"), "aappap");
    assert!(text("").ends_with('r'), "{}", text(""));
}

#[test]
fn a_disturbed_spin_may_be_about_another_axis_instead() {
    let text = |sign: &str| {
        verdicts(&format!(
            "No torque acts. $I_1 < I_2 < I_3$. Let $\\omega_1 = \\epsilon_1$, $\\omega_2 = \\Omega + \\epsilon_2$, \
             $\\omega_3 = \\epsilon_3$ with small $\\epsilon_i$. To first order\n\n\
             $$ I_1\\dot\\epsilon_1 = (I_2 - I_3)\\Omega\\epsilon_3 $$\n\n\
             For spin about axis 3 instead\n\n\
             $$ \\ddot\\epsilon_1 = {sign}\\frac{{(I_3 - I_1)(I_3 - I_2)}}{{I_1I_2}}\\Omega^2\\epsilon_1 $$\n"
        ))
    };
    let (right, wrong) = (text("-"), text(""));
    assert!(right.ends_with("pp"), "{right}");
    assert!(wrong.ends_with("pr"), "{wrong}");
}

#[test]
fn words_may_give_the_spin_about_a_numbered_axis() {
    let text = |words: &str, sign: &str| {
        verdicts(&format!(
            "Assume $I_1 < I_2 < I_3$, principal moments of a free body. {words}\n\n\
             $$ \\ddot\\omega_1 = {sign}\\frac{{(I_3 - I_1)(I_3 - I_2)}}{{I_1 I_2}}\\Omega^2\\omega_1 $$\n"
        ))
    };
    for words in [
        "The body spins with a large rate $\\Omega$ about axis 3 while $\\omega_1$, $\\omega_2$ are small. Then",
        "With the big spin $\\Omega$ on axis 3 and small $\\omega_1$, $\\omega_2$:",
        "Let $\\Omega$ be the spin about axis 3 and let $\\omega_1$ and $\\omega_2$ be small.",
    ] {
        assert_eq!(text(words, "-"), "ap", "{words}");
        assert_eq!(text(words, ""), "ar", "{words}");
    }
    let angle = "The body is turned through the angle $\\Omega$ about axis 3; $\\omega_1$ and $\\omega_2$ are small.";
    assert_eq!(text(angle, "-"), "au");
}
