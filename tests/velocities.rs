//! The velocity of a point of the body, which a line names and goes on from.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// A line that names the velocity, and one of its components.
fn named(line: &str, component: &str) -> String {
    verdicts(&format!(
        "A point of a rigid body with the angular velocity $\\vec\\omega$ has the position\n\n\
         $$ \\vec r = x\\,\\hat\\imath + y\\,\\hat\\jmath + z\\,\\hat k $$\n\nwith constant $x$, $y$, $z$. Its velocity is\n\n\
         $$ {line} $$\n\nwith the component\n\n$$ {component} $$\n"
    ))
}

#[test]
fn a_velocity_is_seen_from_space() {
    let right = r"v_x = \omega_y z - \omega_z y";
    let wrong = r"v_x = \omega_z y - \omega_y z";
    for (line, verdict) in [
        (r"\vec v = \frac{d\vec r}{dt} = \vec\omega\times\vec r", "p"),
        (r"\vec v = \frac{d\vec r}{dt} = \vec r\times\vec\omega", "r"),
        (r"\vec v = \frac{d\vec r}{dt}", "a"),
    ] {
        assert_eq!(named(line, right), format!("a{verdict}p"), "{line}");
        assert_eq!(named(line, wrong), format!("a{verdict}r"), "{line}");
    }
}
