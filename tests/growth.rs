//! What grows or decays from its value at the beginning, in one case and in the next.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// A line about rates that a feedback damps, on principal axes.
fn damped(line: &str) -> Option<char> {
    let text = format!(
        "On principal axes, for small rates, the product of two rates is dropped. Choose the torque\n\n\
         $$ \\mathbf M = -c\\,\\boldsymbol\\omega $$\n\nwith a constant $c$. The solution is\n\n$$ {line} $$\n"
    );
    verdicts(&text).chars().last()
}

#[test]
fn a_rate_decays_from_its_value_at_the_beginning() {
    assert_eq!(damped(r"\omega_2(t) = \omega_2(0)\,e^{-ct/I_2}"), Some('a'));
    assert_eq!(
        damped(r"\omega_2(t) = \omega_2(0)\,e^{-2ct/I_2}"),
        Some('r')
    );
    assert_eq!(damped(r"\omega_2(t) = \omega_2(0)\,e^{ct/I_2}"), Some('r'));
}

/// A feedback that takes the place of another one.
fn cancelled(line: &str) -> Option<char> {
    let text = format!(
        "On body axes $J\\dot\\omega = -\\omega\\times J\\omega + u$ with the torque $u$ and the inertia matrix $J$.\n\n\
         **First law.** Choose $u = -c\\,\\omega$.\n\n**Second law.** Take instead\n\n\
         $$ u = \\omega\\times J\\omega - c J\\omega $$\n\nso that\n\n$$ {line} $$\n"
    );
    verdicts(&text).chars().last()
}

#[test]
fn another_law_takes_the_place_of_the_first() {
    assert_eq!(cancelled(r"\dot\omega = -c\,\omega"), Some('p'));
    assert_eq!(cancelled(r"J\dot\omega = -c\,\omega"), Some('r'));
    assert_eq!(
        cancelled(r"\lVert\omega(t)\rVert = \lVert\omega(0)\rVert\,e^{-ct}"),
        Some('a')
    );
    assert_eq!(
        cancelled(r"\lVert\omega(t)\rVert = \lVert\omega(0)\rVert\,e^{-ct/2}"),
        Some('r')
    );
}

#[test]
fn a_complex_rate_turns_from_its_value_at_the_beginning() {
    let turned = |sign: &str| {
        let text = format!(
            "The body rates are $p$, $q$, $r$. No torque acts on a body with the principal moments of inertia $A$, $B$ and $C$, where $A = B$. With $\\zeta = p + \\mathrm{{i}} q$ and\n\n\
             $$ A\\dot p = (A - C)\\,q r, \\quad A\\dot q = (C - A)\\,r p, \\quad C\\dot r = 0 $$\n\n\
             $$ \\lambda = \\frac{{C - A}}{{A}}\\,r $$\n\nthe solution is\n\n\
             $$ \\zeta(t) = \\zeta(0)\\,e^{{{sign}\\mathrm{{i}}\\lambda t}} $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_ne!(turned("-"), Some('a'));
    assert_eq!(turned(""), Some('a'));
}

#[test]
fn what_a_deviation_grows_by_is_what_the_motion_says() {
    let document = |square: &str| {
        format!(
            r"The principal moments are $I_1$, $I_2$ and $I_3$. No moment acts about the centre of mass. Put

$$ \omega_1 = \varepsilon_1, \qquad \omega_2 = \Omega, \qquad \omega_3 = \varepsilon_3 $$

with small $\varepsilon_1$, $\varepsilon_3$, of which we keep the first order only; then $\Omega$ is constant. Elimination leads to

$$ \ddot\varepsilon_1 = \kappa^2\,\varepsilon_1, $$

where

$$ \kappa^2 = \frac{{(I_3 - I_2)({square})}}{{I_1 I_3}}\,\Omega^2 $$
"
        )
    };
    assert_eq!(verdicts(&document("I_2 - I_1")), "aaapp");
    assert!(!verdicts(&document("I_1 - I_2")).ends_with(['p', 'a']));
}

#[test]
fn two_lines_do_not_solve_one_equation_of_motion() {
    let text = |exponent: &str| {
        verdicts(&format!(
            "The function obeys $\\dot V = -2kV$. Then\n\n$$ V(t) = V(0)e^{{-2kt}} $$\n\n\
             $$ V(t) = V(0)e^{{{exponent}}} $$\n"
        ))
    };
    assert_eq!(text("-2kt"), "aap");
    assert_eq!(text("-kt"), "aar");
}

#[test]
fn an_angular_velocity_decays_as_a_vector() {
    let text = |exponent: &str| {
        verdicts(&format!(
            "With the control torque $u = \\omega\\times I\\omega - kI\\omega$ the body obeys\n\n\
             $$ \\dot{{\\vec\\omega}} = -k\\vec\\omega $$\n\n\
             $$ \\vec\\omega(t) = e^{{{exponent}}}\\vec\\omega(0) $$\n"
        ))
    };
    assert!(text("-kt").ends_with("pa"), "{}", text("-kt"));
    assert!(text("-2kt").ends_with("pr"), "{}", text("-2kt"));
}
