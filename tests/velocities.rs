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

#[test]
fn an_element_of_a_body_turns_about_the_fixed_point() {
    let text = |velocity: &str| {
        verdicts(&format!(
            "A rigid body rotates with the angular velocity $\\vec\\omega$ about a fixed point $O$. Take a small element \
             $dm$ with the position vector $\\vec r$. Then the velocity of this element is $\\vec v = {velocity}$.\n\n\
             $$ \\vec L = \\int \\vec r\\times\\vec v\\,dm $$\n\n\
             On the axes $x$, $y$, $z$ we have\n\n$$ \\vec r = x\\hat i + y\\hat j + z\\hat k $$\n"
        ))
    };
    assert_eq!(text("\\vec\\omega\\times\\vec r"), "ppa");
    assert!(text("\\vec r\\times\\vec\\omega").starts_with('r'));
}

#[test]
fn a_place_that_a_line_has_turn_is_fixed_in_the_body() {
    let acceleration = |sign: &str| {
        verdicts(&format!(
            "For a rigid body with angular velocity $\\vec\\omega$, a point at $\\vec r$ from the fixed point $O$ has the \
             velocity $\\vec v = \\vec\\omega\\times\\vec r$. Its acceleration is\n\n\
             $$ \\vec a = \\dot{{\\vec\\omega}}\\times\\vec r {sign} \\vec\\omega\\times(\\vec\\omega\\times\\vec r) $$\n"
        ))
    };
    assert_eq!(acceleration("+"), "pp");
    assert_eq!(acceleration("-"), "pr");
    let rate = |sides: &str| {
        verdicts(&format!(
            "Let $\\mathbf b$ be a vector fixed in the body. Then $\\dot{{\\mathbf b}} = \\boldsymbol\\omega\\times\\mathbf b$ and\n\n\
             $$ {sides} $$\n"
        ))
    };
    assert_eq!(rate(r"\frac{d}{dt}(\mathbf b\cdot\mathbf b) = 0"), "pp");
    assert_eq!(
        rate(r"\ddot{\mathbf b} = \dot{\boldsymbol\omega}\times\mathbf b"),
        "pr"
    );
}

#[test]
fn a_point_that_moves_in_the_frame_is_not_fixed_there() {
    let document = "A particle moves relative to a frame that turns at $\\boldsymbol\\omega$ with the body.\n\n\
                    $$ \\mathbf v = \\boldsymbol\\omega\\times\\mathbf r $$\n";
    assert_ne!(verdicts(document), "p");
}
