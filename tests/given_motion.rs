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

#[test]
fn a_plane_of_symmetry_may_be_named_by_its_equation() {
    let text = "The craft has the plane of symmetry $y = 0$, so that\n\n$$ I_{xy} = I_{yz} = 0 $$\n\n\
        and\n\n$$ L_x = I_{xx}\\omega_x - I_{xz}\\omega_z $$\n\n$$ L_x = I_{xx}\\omega_x $$\n";
    assert_eq!(verdicts(text), "appr");
}

#[test]
fn a_product_that_is_said_to_vanish_for_reasons_not_understood_is_not_called_false() {
    let text =
        "Because of its build the craft has\n\n$$ I_{xz} = 0 $$\n\nHence\n\n$$ I_{xy} = 0 $$\n";
    assert!(!verdicts(text).contains('r'), "{}", verdicts(text));
}

#[test]
fn axes_may_follow_all_of_a_turn_but_its_spin() {
    let text = "A rotor has the moments of inertia $A$, $A$, $C$. The axes $xyz$ follow its axis and not its spin, so\n\n\
        $$ \\vec\\Omega = \\omega_x\\hat i + \\omega_y\\hat j + \\Omega_z\\hat k $$\n\n\
        The moment is\n\n\
        $$ \\vec M = (\\dot{\\vec L})_{xyz} + \\vec\\Omega\\times\\vec L $$\n\n\
        $$ \\vec M = (\\dot{\\vec L})_{xyz} + \\vec\\omega\\times\\vec L $$\n\n\
        $$ M_z = C\\dot\\omega_z $$\n\n$$ M_x = A\\dot\\omega_x + C\\omega_y\\omega_z - A\\omega_y\\Omega_z $$\n";
    assert_eq!(verdicts(text), "aprpp");
}

#[test]
fn numbers_of_a_body_stay_what_they_are() {
    let text = "No torque acts; the axes are principal. Take $m = 6$, $d = 0.3$ and $f = 0.1$. Then\n\n\
        $$ I_x = m d^2 = 0.54 $$\n\n$$ I_y = m f^2 = 0.06 $$\n\n$$ I_z = m (d^2 + f^2) = 0.6 $$\n\n\
        $$ \\dot\\omega_z = \\tfrac45\\omega_x\\omega_y $$\n\n$$ \\dot\\omega_z = -\\tfrac45\\omega_x\\omega_y $$\n";
    assert_eq!(verdicts(text), "aaappppr");
}

#[test]
fn relations_of_moments_in_numbers_are_data_and_a_lamina_has_its_sum() {
    let text = "The body is symmetric, with moments $A$, $A$, $C$. **Numbers.** For the Earth\n\n\
        $$ \\frac{C - A}{A} = \\frac{1}{305} $$\n\nand one turn takes a day, $\\omega_3 = 2\\pi$ per day. Hence\n\n\
        $$ 305\\,(C - A) = A $$\n\n$$ 305\\,(C - A) = C $$\n";
    assert_eq!(verdicts(text), "aapr");
    let text = "With the products $I_{xy}$, $I_{yz}$ and $I_{xz}$ the momentum is $L_x = I_{xx}\\omega_x - I_{xy}\\omega_y - I_{xz}\\omega_z$. \
        For a thin plate this becomes\n\n$$ I_{zz} = I_{xx} + I_{yy} $$\n";
    assert_eq!(verdicts(text), "pa");
}

#[test]
fn numbered_axes_behind_lettered_ones_may_be_the_principal_ones() {
    let text = "The momentum is $L_x = I_{xx}\\omega_x - I_{xy}\\omega_y - I_{xz}\\omega_z$.\n\n\
        From here on the axes 1, 2, 3 are principal. Then\n\n$$ L_1 = I_1\\omega_1 $$\n\n$$ L_2 = I_1\\omega_2 $$\n";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn a_constant_of_the_motion_is_for_laws_to_say() {
    let text = "No torque acts; the axes are principal. The rate $\\omega_1$ is a constant of the motion? No:\n\n\
        $$ \\dot\\omega_1 = 0 $$\n";
    assert!(!verdicts(text).contains('p'));
}

#[test]
fn unit_vectors_in_numbers_are_the_columns_of_a_matrix() {
    let text = "A flat plate lies in the $xy$ plane, so\n\n$$ I_{xz} = I_{yz} = 0 $$\n\nUnit vectors along the principal axes:\n\n\
        $$ \\mathbf u_1 = \\tfrac15\\begin{bmatrix} 3 \\\\ 4 \\\\ 0 \\end{bmatrix}, \\quad \
        \\mathbf u_2 = \\tfrac15\\begin{bmatrix} -4 \\\\ 3 \\\\ 0 \\end{bmatrix}, \\quad \
        \\mathbf u_3 = \\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\end{bmatrix} $$\n\n\
        Let $R = [\\,\\mathbf u_1 \\;\\; \\mathbf u_2 \\;\\; \\mathbf u_3\\,]$. Then\n\n\
        $$ R^T R = \\mathbf 1 $$\n\n$$ R\\,\\mathbf e_x = \\mathbf u_1 $$\n\n$$ R^T\\mathbf e_x = \\mathbf u_1 $$\n";
    assert_eq!(verdicts(text), "paaaappr");
}

#[test]
fn an_equation_picks_its_roots_out_and_its_rewriting_is_a_claim() {
    let text = "The principal moments are the roots of\n\n$$ (5 - \\lambda)(2 - \\lambda) - 4 = \\lambda^2 - 7\\lambda + 6 = 0 $$\n";
    assert_eq!(verdicts(text), "a");
    let false_one = text.replace("7\\lambda", "8\\lambda");
    assert!(!verdicts(&false_one).contains('a'));
}

#[test]
fn a_component_that_is_known_is_not_given_anew_by_its_own_symbol() {
    let text = "The body turns with $\\boldsymbol\\omega = [\\,n\\;\\;0\\;\\;0\\,]^T$. The axes are principal. Take\n\n\
        $$ \\omega_1 = \\tfrac12 n $$\n\n$$ n = 0 $$\n";
    assert!(!verdicts(text).starts_with("aa"), "{}", verdicts(text));
}

#[test]
fn an_equation_of_motion_is_not_taken_for_a_gift() {
    let text = "On a turntable with the constant rate $\\vec\\Omega = \\Omega\\hat k$ the position is $\\vec r = x\\hat i + y\\hat j$. \
        No force acts in its plane. The equations of motion are\n\n$$ \\ddot y = 2\\Omega\\dot x + \\Omega^2 y $$\n";
    assert!(!verdicts(text).ends_with('a'), "{}", verdicts(text));
}

#[test]
fn what_holds_initially_does_not_stay() {
    let text = |sign: &str| {
        format!(
            "The axes are principal. Initially $\\omega_1 = a$, $\\omega_2 = b$ and $\\omega_3 = 0$, and no torque acts. \
             The body therefore starts to turn with\n\n$$ \\dot\\omega_3 = {sign}\\frac{{I_1 - I_2}}{{I_3}}ab $$\n"
        )
    };
    assert!(verdicts(&text("")).ends_with('p'));
    assert!(verdicts(&text("-")).ends_with('r'));
}

#[test]
fn how_the_body_turns_in_time_is_taken_from_the_figure_and_not_checked() {
    let text = |last: &str| {
        format!(
            "On principal axes the moments of inertia are $I_1$, $I_2$ and $I_3$. The shaft turns at the constant rate $n$, the aircraft at \
             the constant rate $Q$. Then\n\n$$\\omega_1 = n$$\n\n$$\\omega_2 = Q\\cos(nt)$$\n\n$$\\omega_3 = -Q\\sin(nt)$$\n\n\
             and the moment is\n\n$$ {last} $$\n"
        )
    };
    let right = text(r"M_1 = -\tfrac12 (I_3 - I_2)\,Q^2\sin(2nt)");
    let wrong = text(r"M_1 = \tfrac12 (I_3 - I_2)\,Q^2\sin(2nt)");
    assert_eq!(verdicts(&right), "auup");
    assert_eq!(verdicts(&wrong), "auur");
}
