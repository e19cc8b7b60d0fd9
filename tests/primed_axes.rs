//! Axes with primes that are moved away from the mass centre and not turned.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// A plate, and lines about its corner.
fn plate(line: &str) -> Option<char> {
    let text = format!(
        "A thin rectangular plate lies in the $xy$ plane with its centre of mass at the origin. Its mass is $m$ and its \
         sides are $a$ along $x$ and $b$ along $y$. Its central moments of inertia are $I_x$, $I_y$ and $I_z$, and the \
         products of inertia vanish. Now move the axes, without turning them, to the corner at $x = a/2$, $y = -b/2$. \
         The parallel-axis theorem gives\n\n$$ I_{{x'}} = I_x + \\frac{{mb^2}}{{4}} $$\n\n$$ {line} $$\n"
    );
    verdicts(&text).chars().last()
}

#[test]
fn the_law_of_parallel_axes_leads_to_them() {
    assert_eq!(plate(r"I_{y'} = I_y + \frac{ma^2}{4}"), Some('p'));
    assert!(matches!(plate(r"I_{y'} = I_y + ma^2"), Some('r' | 'u')));
    assert_eq!(plate(r"I_{z'} = I_z + \frac{m}{4}(a^2 + b^2)"), Some('p'));
    assert_eq!(plate(r"I_{x'y'} = -\frac{mab}{4}"), Some('p'));
    assert!(matches!(
        plate(r"I_{x'y'} = \frac{mab}{4}"),
        Some('r' | 'u')
    ));
}

#[test]
fn primes_of_axes_that_are_turned_are_others() {
    let text = "The parallel-axis theorem gives $I_x = I_G + m d^2$. The axes $x'$, $y'$ are rotated by $\\alpha$, and\n\n\
                $$ I_{x'} = I_x + m d^2 $$\n";
    assert!(!verdicts(text).ends_with('p'));
}
