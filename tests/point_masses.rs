//! Bodies made of a few masses: only some of their moments of inertia are said.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_body_is_found_for_any_product_of_inertia() {
    let text = |moment: &str, energy: &str| {
        format!(
            "Two masses $m$ sit at $(a, 0, b)$ and $(-a, 0, -b)$. The products of inertia are $J_{{xz}} = \\sum_i m_i x_i z_i$ \
             and $J_{{yz}} = \\sum_i m_i y_i z_i$. For the two masses\n\n\
             $$ J_{{zz}} = 2ma^2, \\qquad J_{{xz}} = 2mab, \\qquad J_{{yz}} = 0 $$\n\n\
             The shaft turns at a constant rate, $\\boldsymbol\\omega = \\Omega\\,\\mathbf k$, so\n\n\
             $$ M_y = {moment}mab\\,\\Omega^2 $$\n\n\
             Let $m = 0.05$ kg, $a = 0.1$ m, $b = 0.2$ m and $\\Omega = 100$ rad/s. The kinetic energy is\n\n\
             $$ T = \\tfrac12 J_{{zz}}\\,\\Omega^2 = {energy}\\ \\mathrm J $$\n"
        )
    };
    assert!(
        verdicts(&text("-2", "5")).ends_with("paaaap"),
        "{}",
        verdicts(&text("-2", "5"))
    );
    // Half of what is shown is not rounded to it.
    assert!(
        verdicts(&text("-", "10")).ends_with("raaaar"),
        "{}",
        verdicts(&text("-", "10"))
    );
}

#[test]
fn a_step_of_some_length_is_a_time() {
    let text = "Principal axes, no torque. Let $I_1 = 2$, $I_2 = 3$ and $I_3 = 4$ (in kg m²). At the start let $\\omega_1 = 1$, \
                $\\omega_2 = 2$ and $\\omega_3 = -1$ (in rad/s). The explicit step of length $h$ is defined by \
                $\\boldsymbol\\omega^{\\text{new}} = \\boldsymbol\\omega + h\\,\\dot{\\boldsymbol\\omega}$. With $h = 0.1$ s we get\n\n\
                $$ \\omega_1^{\\text{new}} = \\omega_1 + h\\,\\dot\\omega_1 = 1.1 $$\n\n\
                $$ \\omega_3^{\\text{new}} = \\omega_3 + h\\,\\dot\\omega_3 = -0.95 $$\n";
    assert_eq!(verdicts(text), "aaaaaaaapr");
}

#[test]
fn masses_at_places_in_words_make_the_inertia() {
    let text = |body: &str, lines: &str| {
        verdicts(&format!(
            "A shaft turns about $z$. Two equal point masses $m$ are mounted on {body}. They sit at $(r, 0, a)$ and at $(-r, 0, -a)$.\n\n$$ {lines} $$\n"
        ))
    };
    assert_eq!(
        text("light arms", "I_{zz} = 2mr^2, \\qquad I_{xz} = 2mra"),
        "pp"
    );
    assert_eq!(
        text("light arms", "I_{yy} = 2mr^2, \\qquad I_{xz} = mra"),
        "rr"
    );
    // A heavy shaft has a moment of its own.
    assert_ne!(text("it", "I_{zz} = 2mr^2, \\qquad I_{xz} = 2mra"), "pp");
    assert!(text("it", "I_{zz} = 5mr^2, \\qquad I_{xz} = 2mra").ends_with('p'));
}

#[test]
fn a_sum_goes_over_the_index_of_its_masses() {
    let text = |sum: &str| verdicts(&format!("The moments of a body are\n\n$$ {sum} $$\n"));
    assert_eq!(text("I_{zz} = \\sum m_i (x_i^2 + y_i^2)"), "p");
    assert_ne!(text("I_{zz} = \\sum m_i (x_i^2 + z_i^2)"), "p");
}

#[test]
fn signs_before_coordinates_and_lists_of_masses_count_each() {
    let text = |masses: &str, line: &str| verdicts(&format!("{masses}.\n\n$$ {line} $$\n"));
    let six =
        "Six point masses $m$ are fixed at $(\\pm a, 0, 0)$, $(0, \\pm b, 0)$ and $(0, 0, \\pm c)$";
    assert_eq!(text(six, "I_{xx} = 2m(b^2 + c^2)"), "p");
    assert_eq!(text(six, "I_{xx} = 2m(a^2 + c^2)"), "r");
    let corners = "Four particles, each of mass $m$, sit at $(\\pm a, \\pm b, 0)$";
    assert_eq!(text(corners, "I_{zz} = 4m(a^2 + b^2)"), "p");
    let three = "Three point masses $m$, $2m$ and $3m$ are fixed at $(a, 0, 0)$, $(0, a, 0)$ and $(0, 0, a)$";
    assert_eq!(text(three, "I_{xx} = 5ma^2"), "p");
    // As many masses as places, or it is not known which is where.
    let unsaid = "Masses $m$ and $2m$ are fixed at $(a, 0, 0)$, $(0, a, 0)$ and $(0, 0, a)$";
    assert_eq!(text(unsaid, "I_{xx} = 5ma^2"), "a");
}

#[test]
fn moments_that_have_their_values_are_held_to_their_sums() {
    let text = |sign: &str| {
        verdicts(&format!(
            "The moments are $I_{{xx}} = 2mb^2$, $I_{{yy}} = 2ma^2$ and $I_{{zz}} = 2m(a^2 + b^2)$.\n\n\
             $$ I_{{zz}} = I_{{xx}} {sign} I_{{yy}} $$\n"
        ))
    };
    assert_eq!(text("+"), "aaap");
    assert_eq!(text("-"), "aaar");
}
