//! A free symmetric body: the moments that words name, and how its axis goes round the angular momentum.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// A line about a free body that is symmetric about x.
fn free(words: &str, line: &str) -> Option<char> {
    let text = format!(
        "The probe is symmetric about its spin axis $x$. We write $J_a$ for the moment of inertia about this axis and \
         $J_t$ for the one about any transverse axis. No torque acts, and $\\mathbf H$ is the angular momentum.\n\n\
         {words}\n\n$$ {line} $$\n"
    );
    verdicts(&text).chars().last()
}

#[test]
fn words_name_the_moments_about_this_axis_and_across() {
    let euler = "Euler's equations read";
    let line = |sign: &str| format!(r"J_t\,\dot\omega_y {sign} (J_a - J_t)\,\omega_z\omega_x = 0");
    assert_eq!(free(euler, &line("+")), Some('p'));
    assert_eq!(free(euler, &line("-")), Some('r'));
}

#[test]
fn the_axis_goes_round_the_angular_momentum() {
    let words = "The axis circles the direction of $\\mathbf H$ with the inertial precession rate";
    assert_eq!(free(words, r"\dot\psi = \frac{H}{J_t}"), Some('a'));
    assert_eq!(free(words, r"\dot\psi = \frac{H}{J_a}"), Some('r'));
    assert_eq!(free(words, r"\Omega_p = \frac{H}{J_t - J_a}"), Some('r'));
    let other = "As seen from the body, the precession rate in space of something else is";
    assert_ne!(free(other, r"\dot\psi = \frac{H}{J_a}"), Some('r'));
}

#[test]
fn small_letters_are_moments_beside_large_rates() {
    let text = "The body rates are $P$, $Q$, $R$ and the moments $\\ell$, $m$, $n$. On principal axes\n\n\
                $$ m = J_y\\dot Q + (J_x - J_z)\\,PR $$\n\n$$ n = J_z\\dot R + (J_x - J_y)\\,PQ $$\n";
    assert_eq!(verdicts(text), "pr");
}

#[test]
fn a_pronoun_stands_for_the_axis_of_symmetry() {
    for words in [
        r"Let $z$ be the symmetry axis. The moment of inertia about it is $C$, and about every perpendicular axis through the mass centre it is $A$.",
        r"Its moment of inertia is $C$ about the axis of figure $z$ and $A$ about any axis through $O$ at right angles to it.",
    ] {
        let line = |sign: &str| {
            let text = format!(
                "A spheroid is free of torque. {words}\n\n$$ A\\,\\dot\\omega_x = {sign}(A - C)\\,\\omega_y\\omega_z $$\n"
            );
            verdicts(&text)
        };
        assert_eq!(line(""), "p", "{words}");
        assert_eq!(line("-"), "r", "{words}");
    }
}

#[test]
fn lines_behind_a_false_rate_go_by_the_true_one() {
    let text = |rate: &str, next: &str| {
        format!(
            "No torque acts on the disc. Let $z$ be its symmetry axis. The moment of inertia about it is $C$, and about every \
             perpendicular axis it is $A$. An observer at rest sees the axis go round $\\mathbf L$ at the rate\n\n\
             $$ \\dot\\phi = {rate} $$\n\nso that, with $A = 2$,\n\n$$ \\dot\\phi = {next} $$\n"
        )
    };
    assert_eq!(verdicts(&text(r"\frac{L}{A}", r"\frac{L}{2}")), "aap");
    assert_eq!(verdicts(&text(r"\frac{L}{C}", r"\frac{L}{2}")), "rap");
    assert_eq!(verdicts(&text(r"\frac{L}{C}", r"\frac{L}{3}")), "rar");
    assert_eq!(
        verdicts(&text(r"\frac{L}{A} = \frac{L\,C}{A\,C}", r"\frac{L}{2}")),
        "pap"
    );
    assert_eq!(
        verdicts(&text(r"\frac{L}{A} = \frac{L}{C}", r"\frac{L}{2}")),
        "rap"
    );
}

#[test]
fn words_give_the_rates_of_precession_and_spin_their_letters() {
    let text = |rates: &str, spin: &str| {
        verdicts(&format!(
            r"The moment about the mass centre is zero. The body has the axis of symmetry $\hat e_3$; the moment of inertia about it is $I_a$ and about any diameter $I_t$. We write $\omega_3 = s$.

The angular momentum $\mathbf L$ is fixed in space. Let $\theta$ be the angle between it and $\hat e_3$. {rates} Then

$$ s = \dot\psi + \dot\phi\cos\theta $$

$$ \dot\phi = \frac{{I_a s}}{{I_t\cos\theta}} $$

$$ \dot\psi = \frac{{{spin}}}{{I_t}}\,s $$
"
        ))
    };
    for rates in [
        r"The body precesses about $\mathbf L$ at the rate $\dot\phi$ and spins about its own axis at $\dot\psi$.",
        r"It precesses about the angular momentum at $\dot\phi$ and rotates about its symmetry axis at the rate $\dot\psi$.",
    ] {
        assert_eq!(text(rates, "I_t - I_a"), "appp", "{rates}");
        assert_eq!(text(rates, "I_a - I_t"), "appr", "{rates}");
    }
    // The rate of what is not said stays open.
    let about_vertical = r"The body precesses about the vertical at the rate $\dot\phi$ and spins about its own axis at $\dot\psi$.";
    assert!(!text(about_vertical, "I_t - I_a").contains('r'));
}
