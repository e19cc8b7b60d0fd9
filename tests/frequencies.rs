//! Frequencies that lines give by their squares, with the sign that is said of these, and in numbers.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const BOOK: &str = r"A book with the principal moments $I_1 < I_2 < I_3$ is tossed. No torque acts. Discuss small disturbances $\epsilon_1, \epsilon_2, \epsilon_3$. Put $\omega_1 = \epsilon_1$, $\omega_2 = \epsilon_2$, $\omega_3 = \Omega$ with constant $\Omega$. Keeping terms of first order, $\ddot\epsilon_1 + \nu_3^2\,\epsilon_1 = 0$ with";

#[test]
fn a_square_with_a_sign_defines_a_frequency() {
    let text = format!(
        r"{BOOK}

$$ \nu_3^2 = \frac{{(I_3 - I_1)(I_3 - I_2)}}{{I_1 I_2}}\,\Omega^2 > 0 $$

Cyclic change of the letters:

$$ \nu_2^2 = \frac{{(I_2 - I_1)(I_2 - I_3)}}{{I_1 I_3}}\,\Omega^2 < 0 $$

With $I_1 = 2.0$, $I_2 = 3.0$, $I_3 = 4.0$ and $\Omega = 12$

$$ \nu_3 = \Omega\sqrt{{\frac{{2\cdot 1}}{{2\cdot 3}}}} = 6.9 $$

$$ \nu_3 = \Omega\sqrt{{\frac{{2\cdot 1}}{{2\cdot 3}}}} = 6.3 $$
"
    );
    let found = verdicts(&text);
    assert_eq!(&found[4..], "paaaaaapr", "{found}");
}

#[test]
fn a_frequency_with_the_wrong_factor_does_not_solve_its_equation() {
    let text = format!(
        r"{BOOK}

$$ \nu_3^2 = \frac{{(I_3 - I_1)(I_2 - I_3)}}{{I_1 I_2}}\,\Omega^2 $$
"
    );
    let found = verdicts(&text);
    assert!(!found[4..].starts_with('p'), "{found}");
}

#[test]
fn a_frequency_beside_its_oscillation_is_held_against_the_motion() {
    let text = |difference: &str| {
        format!(
            r"A satellite pitches by the angle $\theta$. We are given that

$$ I_y\ddot\theta = 3n^2(I_z - I_x)\sin\theta\cos\theta $$

where $n$ is the orbital rate. For small angles

$$ \ddot\theta + \omega_p^2\theta = 0,\qquad \omega_p = n\sqrt{{\frac{{3({difference})}}{{I_y}}}} $$
"
        )
    };
    assert_eq!(verdicts(&text("I_x - I_z")), "apa");
    assert_eq!(verdicts(&text("I_z - I_x")), "apr");
}

#[test]
fn an_equation_of_motion_left_open_leaves_the_motion_in_doubt() {
    let text = r"A body whose angle $\theta$ obeys

$$ I\ddot\theta + k\sin\theta = 0 $$

For small angles

$$ \ddot\theta + \omega_p^2\theta = 0,\qquad \omega_p = \sqrt{\frac{k}{I}} $$
";
    assert!(!verdicts(text).contains('r'));
}

#[test]
fn a_frequency_that_is_a_multiple_makes_no_rate_false() {
    for value in ["2k", r"3k", r"2\pi/T", r"2\pi/P"] {
        let text = format!(
            r"The angle is $\theta = A\sin\nu t$ with $\nu = {value}$. Then

$$ \dot\theta = A\nu\cos\nu t $$

$$ \dot\theta = 2A\nu\cos\nu t $$
"
        );
        let found = verdicts(&text);
        assert!(
            !found[..3].contains('r') && !found.ends_with('p'),
            "{value}: {found}"
        );
    }
}

#[test]
fn a_sine_of_a_long_sum_ends() {
    let sum: String = ('a'..='l').map(|c| format!("+ {c}_1 ")).collect();
    let text = format!(
        "The angle is $\\theta = \\sin(8(u_1 {sum}) t)$. Then\n\n$$ \\dot\\theta = 2\\theta $$\n"
    );
    assert_eq!(verdicts(&text).len(), 2);
}
