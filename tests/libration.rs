//! Libration in orbit: the moment of the gradient of gravity on a direction that one angle gives.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

fn pitch(moment: &str, motion: &str, potential: &str) -> String {
    verdicts(&format!(
        r"Pitch motion under the gravity gradient. A satellite is on a circular orbit with the rate $\nu$. On principal axes the unit vector from the Earth is $\hat{{\mathbf e}} = (a, b, c)$, and the moment is

$$ \mathbf M = 3\nu^2\,\hat{{\mathbf e}}\times(\mathbf I\hat{{\mathbf e}}) $$

$$ M_y = 3\nu^2\,{moment}\,ca $$

For a pitch error $\beta$ alone $a = -\sin\beta$, $b = 0$ and $c = \cos\beta$. It obeys

$$ I_y\ddot\beta = {motion}\,\nu^2(I_x - I_z)\sin\beta\cos\beta $$

It has the integral

$$ E = \tfrac12 I_y\dot\beta^2 {potential} \tfrac32\nu^2(I_x - I_z)\sin^2\beta, \qquad \dot E = 0 $$
"
    ))
}

#[test]
fn the_angle_of_the_direction_turns_the_body() {
    assert_eq!(pitch("(I_x - I_z)", "-3", "+"), "aapaaapap");
    assert_eq!(pitch("(I_z - I_x)", "-3", "+"), "aaraaapap");
    assert_eq!(pitch("(I_x - I_z)", "-6", "+"), "aapaaarap");
    assert_eq!(pitch("(I_x - I_z)", "-3", "-"), "aapaaapar");
}

#[test]
fn sides_of_an_equation_are_no_lengths() {
    let text = "With the body rates $p$, $q$, $r$, the moments $A$, $B$, $C$ and the torques $L$, $M$, $N$ define the right-hand \
                sides\n\n$$ R = L + (B - C)qr, \\qquad S = M + (C - A)rp $$\n\nso that\n\n\
                $$ \\dot p = \\frac RA, \\qquad \\dot q = \\frac SA $$\n";
    assert_eq!(verdicts(text), "aapr");
}
