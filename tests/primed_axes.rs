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

/// The verdict on a line about axes that words turn about z.
fn turned(line: &str) -> Option<char> {
    let text = format!(
        "The product of inertia is $I_{{xy}} = \\int xy\\,dm$, and $I_{{xz}} = I_{{yz}} = 0$. Turn the axes about $z$ \
         through an angle $\\theta$ (from $x$ towards $y$) and call them $x'$ and $y'$. On them\n\n$$ {line} $$\n"
    );
    verdicts(&text).chars().last()
}

#[test]
fn words_turn_axes_in_a_plane() {
    let product = r"I_{x'y'} = I_{xy}\cos 2\theta + \frac12(I_x - I_y)\sin 2\theta";
    assert_eq!(turned(product), Some('p'));
    assert_eq!(turned(&product.replace('+', "-")), Some('r'));
    assert_eq!(turned(r"I_{x'} + I_{y'} = I_x + I_y"), Some('p'));
    let moment =
        r"I_{x'} = \frac{I_x + I_y}{2} + \frac{I_x - I_y}{2}\cos 2\theta - I_{xy}\sin 2\theta";
    assert_eq!(turned(moment), Some('p'));
    assert_eq!(turned(&moment.replacen("x'", "y'", 1)), Some('r'));
}

#[test]
fn an_angle_may_be_chosen_and_principal_axes_numbered_behind_it() {
    let text = |last: &str| {
        format!(
            "The product of inertia is $I_{{xy}} = \\int xy\\,dm$, and $I_{{xz}} = I_{{yz}} = 0$. The axes $x'$, $y'$ are \
             rotated by $\\theta$ about the $z$ axis, and the product of inertia is\n\n$$ I_{{x'y'}} = I_{{xy}}\\cos \
             2\\theta + \\frac12(I_x - I_y)\\sin 2\\theta $$\n\nChoose the angle such that\n\n$$ \\tan 2\\theta = \
             \\frac{{2 I_{{xy}}}}{{I_y - I_x}} $$\n\nWith this choice $I_{{x'y'}} = 0$.\n\nNumber the principal axes \
             1, 2, 3. Euler's equations are\n\n$$ {last} $$\n"
        )
    };
    let euler = r"M_1 = I_1\dot\omega_1 - (I_2 - I_3)\omega_2\omega_3";
    assert_eq!(verdicts(&text(euler)), "papapp");
    let false_one = euler.replace("I_2 - I_3", "I_3 - I_2");
    assert!(verdicts(&text(&false_one)).ends_with('r'));
}
