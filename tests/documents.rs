//! Small documents in many manners, and the verdict that each of their lines must get.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_a_problem_hands_over_is_taken() {
    let text = "A rotor has $I_{xx} = 2$, $I_{yy} = 3$ and $I_{zz} = 4$ on principal axes, and it turns with\n\
                $\\boldsymbol\\omega = (3, 4, 0)$. The angular momentum is\n\n$$ \\mathbf L = (6, 12, 0) $$\n\n\
                and not\n\n$$ \\mathbf L = (6, 12, 1) $$\n";
    assert_eq!(verdicts(text), "aaaapr");
}

#[test]
fn a_zero_that_is_derived_is_no_gift() {
    let text = "On principal axes $\\Sigma M_z = I_z\\dot\\omega_z - (I_x - I_y)\\omega_x\\omega_y$. Hence\n\n\
                $$ \\omega_x = 0 $$\n";
    assert_eq!(verdicts(text), "pr");
}

#[test]
fn the_form_of_the_inertia_matrix_is_given_and_its_signs_are_claimed() {
    let given = "The body has the inertia matrix\n\n$$ J = \\begin{bmatrix} J_x & 0 & -J_{xz} \\\\ 0 & J_y & 0 \\\\ \
                 -J_{xz} & 0 & J_z \\end{bmatrix} $$\n\nand the angular momentum is $H_y = J_y\\omega_y$.\n";
    assert_eq!(verdicts(given), "ap");
}

#[test]
fn a_bare_letter_is_the_component_that_it_is_set_equal_to() {
    let text = "For a turn about the shaft take $\\omega_x = \\omega_y = 0$ and $\\omega_z = \\omega$. Then\n\n\
                $$ H_x = -I_{xz}\\omega, \\qquad M_x = -I_{xz}\\dot\\omega + I_{yz}\\omega^2 $$\n\n\
                but not $M_y = -I_{yz}\\dot\\omega + I_{xz}\\omega^2$.\n";
    assert_eq!(verdicts(text), "aappr");
}

#[test]
fn the_length_of_the_momentum_is_a_number() {
    let text = "The angular momentum $\\mathbf M$ on principal axes is $M_i = I_i\\omega_i$, so that\n\n\
                $$ M^2 = I_1^2\\omega_1^2 + I_2^2\\omega_2^2 + I_3^2\\omega_3^2 $$\n";
    let found = verdicts(text);
    assert!(found.ends_with('p'), "{found}");
}

#[test]
fn a_turn_about_one_axis_needs_no_vectors() {
    let text = "A pendulum of moment of inertia $I$ turns through the angle $\\theta$; its angular velocity is $\\omega$\n\
                and its angular momentum $L$. Then $L = I\\omega$, the moment is $M = I\\ddot\\theta$ and the kinetic energy is\n\
                $T = \\frac12 I\\dot\\theta^2$, not $T = I\\dot\\theta^2$.\n";
    assert_eq!(verdicts(text), "pppr");
}

#[test]
fn an_inertia_that_changes_has_a_rate() {
    let text = "A skater changes her moment of inertia $I(t)$; the angular velocity is $\\omega$, the angular momentum\n\
                $L = I\\omega$. The moment is $M = \\dot I\\omega + I\\dot\\omega$ and not $M = I\\dot\\omega$.\n";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn wheels_carry_a_momentum_of_their_own() {
    let text = "The wheels have the relative angular momentum $\\mathbf h$, and the total angular momentum is\n\n\
                $$ \\mathbf H = \\mathbf J\\boldsymbol\\omega + \\mathbf h $$\n\nThe torque $\\mathbf T$ is then\n\n\
                $$ \\mathbf T = \\mathbf J\\dot{\\boldsymbol\\omega} + \\dot{\\mathbf h} + \
                \\boldsymbol\\omega\\times(\\mathbf J\\boldsymbol\\omega + \\mathbf h) $$\n\nbut not\n\n\
                $$ \\mathbf T = \\mathbf J\\dot{\\boldsymbol\\omega} + \\dot{\\mathbf h} + \
                \\boldsymbol\\omega\\times(\\mathbf J\\boldsymbol\\omega - \\mathbf h) $$\n";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn an_inertia_dyadic_is_a_sum_of_dyads() {
    let text = "Along the principal axes the inertia dyadic is\n\n$$ \\mathbf I = I_1\\mathbf b_1\\mathbf b_1 + \
                I_2\\mathbf b_2\\mathbf b_2 + I_3\\mathbf b_3\\mathbf b_3 $$\n";
    assert_eq!(verdicts(text), "p");
}

#[test]
fn frames_around_a_letter_that_always_wears_them_say_nothing() {
    let text = "The angular momentum is $\\mathbf H = \\mathbf I\\cdot{}^N\\boldsymbol\\omega^B$ and the moment is\n\n\
                $$ \\mathbf M = \\mathbf I\\cdot{}^N\\dot{\\boldsymbol\\omega}^B + \
                {}^N\\boldsymbol\\omega^B\\times(\\mathbf I\\cdot{}^N\\boldsymbol\\omega^B) $$\n";
    assert_eq!(verdicts(text), "pp");
}

#[test]
fn a_constant_has_no_rate() {
    let text = "A free body on principal axes, no torque, with $I_1 = I_2$: then $\\omega_3 = \\text{const}$ but not\n\
                $\\omega_1 = \\text{const}$.\n";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn what_hangs_on_an_unexplained_symbol_is_left_open() {
    let text = "On principal axes $L_x = I_x\\omega_x + c$.\n";
    assert_eq!(verdicts(text), "u");
}

#[test]
fn no_rule_leads_to_itself_through_a_root() {
    let text = "The angular momentum is $\\mathbf M$, and $M_3 = M\\cos\\theta$ where $\\theta$ is the angle to the axis. On\n\
                principal axes, no torque acts. Then $\\frac{d}{dt}(\\mathbf M\\cdot\\mathbf M) = 0$.\n";
    let found = verdicts(text);
    assert!(found.ends_with('p'), "{found}");
}

#[test]
fn units_behind_a_value_are_no_factors() {
    let text = "Given $I_{xx} = 2.0\\ \\mathrm{kg\\,m^2}$ on principal axes and $\\omega_x = 3\\ \\text{rad}/\\text{s}$, the\n\
                angular momentum is $L_x = 6\\ \\text{N}\\cdot\\text{m}\\cdot\\text{s}$.\n";
    assert_eq!(verdicts(text), "aap");
}

#[test]
fn an_encyclopedia_wraps_everything_in_braces() {
    let text = "Euler's equations on principal axes are\n\n$$ {\\displaystyle {\\begin{aligned}I_{1}\\,{\\dot {\\omega \
                }}_{1}+(I_{3}-I_{2})\\,\\omega _{2}\\,\\omega _{3}&=M_{1}\\\\I_{2}\\,{\\dot {\\omega }}_{2}+(I_{3}-I_{1})\\,\
                \\omega _{3}\\,\\omega _{1}&=M_{2}\\end{aligned}}} $$\n\nWith no torque\n\n$$ {\\displaystyle {\\frac \
                {d}{dt}}\\left(I_{1}\\omega _{1}^{2}+I_{2}\\omega _{2}^{2}+I_{3}\\omega _{3}^{2}\\right)=0} $$\n";
    assert_eq!(verdicts(text), "prp");
}

#[test]
fn of_a_chain_of_zeros_each_is_zero() {
    let text = "On principal axes take $\\dot\\omega_x = \\ddot\\omega_x = 0$. Then\n\n\
                $$ \\Sigma M_x = (I_z - I_y)\\omega_y\\omega_z $$\n";
    assert_eq!(verdicts(text), "ap");
}

#[test]
fn a_component_with_a_running_index_is_no_new_symbol() {
    let text = "The angular momentum is $\\mathbf L$, with $\\tau_i = I_{ij}\\dot\\omega_j + q_{ijk}\\omega_j L_k$ for the torque.\n";
    assert!(!verdicts(text).contains('a'));
}
