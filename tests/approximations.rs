//! Lines with an approximate sign and something small in them hold to the order to which they are written.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn small_angles_are_taken_to_the_order_written() {
    let angle = |line: &str| {
        verdicts(&format!(
            "The angle $\\theta$ is small. Then\n\n$$ {line} $$\n"
        ))
    };
    assert_eq!(angle(r"\sin\theta \approx \theta"), "p");
    assert_eq!(angle(r"\cos\theta \approx 1"), "p");
    assert_eq!(angle(r"\cos\theta \approx 1 - \tfrac12\theta^2"), "p");
    assert_eq!(angle(r"\cos\theta \approx 1 - \theta^2"), "r");
    assert_eq!(angle(r"\sin\theta \approx \tfrac12\theta"), "r");
}

#[test]
fn what_is_not_called_small_is_left_open() {
    let text = "The angle $\\theta$ is given. Then\n\n$$ \\sin\\theta \\approx \\theta $$\n";
    assert_eq!(verdicts(text), "u");
}

/// A spin about the third axis, disturbed a little, on principal axes without torque.
fn disturbed(line: &str) -> String {
    let text = format!(
        "Without torque, on principal axes, let $\\omega_1 = \\delta\\omega_1$, $\\omega_2 = \\delta\\omega_2$ and \
         $\\omega_3 = \\Omega + \\delta\\omega_3$ with a constant $\\Omega$.\n\nTo first order\n\n$$ {line} $$\n"
    );
    verdicts(&text).split_off(3)
}

#[test]
fn a_disturbed_spin_is_linearised() {
    assert_eq!(disturbed(r"I_3\,\delta\dot\omega_3 \approx 0"), "p");
    assert_eq!(
        disturbed(r"I_1\,\delta\dot\omega_1 \approx (I_2 - I_3)\,\Omega\,\delta\omega_2"),
        "p"
    );
    assert_eq!(
        disturbed(r"I_1\,\delta\dot\omega_1 \approx (I_3 - I_2)\,\Omega\,\delta\omega_2"),
        "r"
    );
    assert_eq!(
        disturbed(r"I_1\,\delta\dot\omega_1 = (I_2 - I_3)\,\Omega\,\delta\omega_2"),
        "p"
    );
    let second =
        r"I_1 I_2\,\delta\ddot\omega_1 \approx (I_2 - I_3)(I_3 - I_1)\,\Omega^2\,\delta\omega_1";
    assert_eq!(disturbed(second), "p");
}

#[test]
fn products_of_what_is_small_may_be_dropped() {
    let left_out = |words: &str, sign: &str| {
        let text = format!(
            "No torque acts. On principal axes put\n\n$$ \\omega_1 = a_1, \\quad \\omega_2 = s + a_2, \\quad \\omega_3 = a_3 $$\n\n\
             with $s$ constant and small $a_i$. {words} This leaves\n\n$$ I_1\\dot a_1 = {sign}(I_2 - I_3)\\,s\\,a_3 $$\n"
        );
        verdicts(&text).chars().last()
    };
    for words in [
        "Products of two small quantities are dropped.",
        "We neglect the product of any two disturbances.",
    ] {
        assert_eq!(left_out(words, ""), Some('p'), "{words}");
        assert_eq!(left_out(words, "-"), Some('r'), "{words}");
    }
}

#[test]
fn a_disturbed_spin_about_another_axis_takes_the_place_of_the_first() {
    let last = |line: &str| {
        let text = format!(
            "A body with three principal moments turns without torque.\n\n(a) About axis 2 put\n\n\
             $$ \\omega_1 = a_1, \\quad \\omega_2 = s + a_2, \\quad \\omega_3 = a_3 $$\n\n\
             with $s$ constant and small $a_i$. To first order\n\n$$ I_2\\dot a_2 = 0 $$\n\n\
             (b) Now let it turn about axis 3 instead. We repeat this with\n\n\
             $$ \\omega_1 = b_1, \\quad \\omega_2 = b_2, \\quad \\omega_3 = s + b_3 $$\n\nand find\n\n$$ {line} $$\n"
        );
        verdicts(&text).split_off(3)
    };
    let factor = r"\frac{(I_3 - I_1)(I_3 - I_2)}{I_1 I_2}\,s^2\,b_1";
    assert_eq!(last(&format!(r"\ddot b_1 = -{factor}")), "paaap");
    assert_eq!(last(&format!(r"\ddot b_1 = {factor}")), "paaar");
}

#[test]
fn a_case_of_small_angles_assumes_no_equation() {
    let text = "A body turns about a fixed axis with $\\ddot\\theta = -c\\,\\sin\\theta$. For small angles,\n\n\
                $$ \\ddot\\theta + 2c\\,\\theta = 0 $$\n";
    assert!(!verdicts(text).ends_with(['p', 'a']), "{}", verdicts(text));
}
