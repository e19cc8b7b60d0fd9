//! How a body turns, handed over component by component, and spins about one axis after the other.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::document::Format;

#[test]
fn components_of_the_angular_velocity_are_taken_as_given_a_zero_among_them_included() {
    let text = "A disc is skew on its shaft, whose angle with the normal is γ, a constant between 0 and 90°.\n\
        The shaft turns at the constant rate ω. Principal axes are fixed in the disc. They point so that\n\n    \
        ω₁ = ω sin γ\n    ω₂ = 0\n    ω₃ = ω cos γ\n\n\
        With I₁ = I₂ = A and I₃ = C the moment is\n\n    M₁ = 0\n    M₂ = (A − C) ω² sin γ cos γ\n    \
        M₂ = (C − A) ω² sin γ cos γ\n";
    assert_eq!(verdicts_in(text, Format::Text), "aaaaappr");
}

#[test]
fn a_line_with_a_root_is_refuted_by_numbers_of_which_the_root_is_rational() {
    let text = "Principal axes. The body turns at a constant rate $\\Omega$ about the diagonal, of length\n\n\
        $$ d = \\sqrt{a^2 + b^2} $$\n\nSo\n\n\
        $$ \\omega_1 = \\frac{a}{d}\\Omega, \\quad \\omega_2 = \\frac{b}{d}\\Omega, \\quad \\omega_3 = 0 $$\n\nTherefore\n\n\
        $$ L_1 = \\frac{I_1 a}{d}\\Omega $$\n\n$$ L_2 = \\frac{I_2 b}{d}\\Omega $$\n\n$$ L_2 = \\frac{I_2 a}{d}\\Omega $$\n";
    assert_eq!(verdicts(text), "aaaappr");
}

#[test]
fn a_spin_about_one_axis_ends_where_the_next_section_gives_its_rate_to_another() {
    let about = |axis: &str, small: [&str; 2], lines: &str| {
        format!(
            "### About axis {axis}\n\nLet $\\omega_{}$ and $\\omega_{}$ be small, and $\\omega_{axis} = n$ constant.\n\n{lines}\n\n",
            small[0], small[1]
        )
    };
    let text = format!(
        "No torque acts. The axes are principal.\n\n{}{}",
        about(
            "3",
            ["1", "2"],
            "$$ I_1\\dot\\omega_1 = (I_2 - I_3) n \\omega_2 $$"
        ),
        about(
            "2",
            ["1", "3"],
            "$$ I_3\\dot\\omega_3 = (I_1 - I_2) n \\omega_1 $$\n\n\
             $$ \\ddot\\omega_1 = \\frac{(I_3 - I_2)(I_2 - I_1)}{I_1 I_3} n^2 \\omega_1 $$\n\n\
             $$ \\ddot\\omega_1 = -\\frac{(I_3 - I_2)(I_2 - I_1)}{I_1 I_3} n^2 \\omega_1 $$"
        )
    );
    assert_eq!(verdicts(&text), "apappr");
}

#[test]
fn numbers_of_a_data_sheet_are_no_result() {
    let text = "The data sheet gives\n\n$$ I_{xx} = 5, \\quad I_{yy} = 4, \\quad I_{zz} = 3 $$\n\nHence\n\n\
        $$ I_{xx} + I_{zz} = 2 I_{yy} $$\n";
    assert_eq!(verdicts(text), "aaap");
}
