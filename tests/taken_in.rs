//! What is false is not taken in as given, assumed or defined, only because it could be; a true line beside it is proved.

#[path = "outcome/verdicts.rs"]
mod outcome;
use outcome::verdicts;

const SPIN_UP: &str = "A body with principal moments $I_1 = I_2 = I_t$ and $I_3 = I_a$ is spun up by a torque $\\tau_3$ \
    about the symmetry axis, $\\tau_1 = \\tau_2 = 0$:\n";

fn last(text: &str) -> char {
    verdicts(text).chars().last().unwrap_or('-')
}

#[test]
fn a_rate_is_not_given_by_what_has_the_units_of_its_derivative() {
    let line = |left: &str| {
        let right = "\\frac{I_t - I_a}{I_t}\\omega_3\\omega_2";
        last(&format!("{SPIN_UP}$$\n{left} = {right}\n$$\n"))
    };
    assert_eq!(line("\\dot\\omega_1"), 'p');
    assert_eq!(line("\\omega_1"), 'u');
}

#[test]
fn a_vector_is_not_given_by_its_own_components() {
    let line = |third: &str| {
        last(&format!(
            "For any vector\n$$\\vec{{A}} = A_x\\hat\\imath + A_y\\hat\\jmath + {third}\\hat k$$\n"
        ))
    };
    assert_eq!(line("A_z"), 'p');
    assert!(!"ap".contains(line("A_x")));
}

#[test]
fn unit_vectors_whose_rates_are_written_turn() {
    let line = |last_rate: &str| {
        last(&format!(
            "Let $\\vec A = A_x\\hat\\imath + A_y\\hat\\jmath + A_z\\hat k$ be a vector. Then\n$$\n\\frac{{d\\vec A}}{{dt}} = \
             \\dot A_x\\hat\\imath + \\dot A_y\\hat\\jmath + \\dot A_z\\hat k + A_x\\frac{{d\\hat\\imath}}{{dt}} + \
             A_y\\frac{{d\\hat\\jmath}}{{dt}}{last_rate}\n$$\n"
        ))
    };
    assert_eq!(line(" + A_z\\frac{d\\hat k}{dt}"), 'p');
    assert_eq!(line(""), 'r');
}

#[test]
fn a_rate_that_was_worked_out_to_vanish_is_no_assumption() {
    let line = |rate: &str| {
        last(&format!(
            "A body with $I_1 = I_2 = A$ and $I_3 = C$ turns freely on principal axes without torque. From the third \
             equation we get ${rate} = 0$.\n"
        ))
    };
    assert_eq!(line("\\dot\\omega_3"), 'p');
    assert!(!"ap".contains(line("\\omega_3")));
}

#[test]
fn what_is_like_the_equation_of_motion_defines_nothing_else() {
    let line = |right: &str| {
        last(&format!(
            "# Newton-Euler\n\n$$\n\\mathbf{{n}} = {right}\n$$\n"
        ))
    };
    assert_eq!(
        line("I\\boldsymbol{\\alpha} + \\boldsymbol{\\omega}\\times I\\boldsymbol{\\omega}"),
        'p'
    );
    for slip in [
        "I\\boldsymbol{\\alpha} - \\boldsymbol{\\omega}\\times I\\boldsymbol{\\omega}",
        "2I\\boldsymbol{\\alpha} + \\boldsymbol{\\omega}\\times I\\boldsymbol{\\omega}",
    ] {
        assert_eq!(line(slip), 'u', "{slip}");
    }
}

#[test]
fn a_body_at_rest_may_begin_to_turn() {
    let line = |rate: &str| {
        last(&format!(
            "A body turns about its principal axes with moments of inertia $I_x, I_y, I_z$ under the moments $M_x, M_y, \
             M_z$. Without rates ($\\omega_x = \\omega_y = \\omega_z = 0$) the response to the controls is\n$$\n{rate} = M_x\n$$\n"
        ))
    };
    assert_eq!(line("I_x\\dot\\omega_x"), 'p');
    assert!(!"ap".contains(line("2I_x\\dot\\omega_x")));
}

#[test]
fn a_moment_of_inertia_has_its_own_integral() {
    let text = |line: &str| verdicts(&format!("The moments of inertia are\n\n$$ {line} $$\n"));
    assert_eq!(text(r"I_{xx} = \int (y^2 + z^2)\,dm"), "p");
    assert_eq!(text(r"I_{xx} = \int (y^2 - z^2)\,dm"), "r");
    assert_eq!(text(r"I_{xy} = 2\int xy\,dm"), "r");
    assert_eq!(text(r"I_{xz} = \int xy\,dm"), "r");
    assert_eq!(text(r"I_{xx} = \int y^2\,dm"), "a");
    assert_eq!(text(r"I_{xx} = \int x^2\,dm"), "u");
}

#[test]
fn both_sides_zero_is_no_proof() {
    let text = |line: &str| {
        verdicts(&format!(
            "The body floats freely, so assume $\\vec\\tau = 0$.\nAbout a principal axis $3$ with $\\omega_1 = \\omega_2 = 0$ we have ${line}$.\n"
        ))
    };
    assert_eq!(text(r"\tau_3 = I_3\dot\omega_3"), "aap");
    assert_eq!(text(r"\tau_3 = 2I_3\dot\omega_3"), "aau");
    assert_eq!(text(r"\tau_3 = I_1\dot\omega_3"), "aau");
}

#[test]
fn a_small_moment_is_of_first_order() {
    let text = |line: &str| {
        verdicts(&format!(
            "The body has the principal moments $I_x$, $I_y$, $I_z$.\n\n$$ I_x\\dot p = (I_y - I_z)qr + \\tau_\\phi $$\n$$ I_y\\dot q = (I_z - I_x)pr + \\tau_\\theta $$\n$$ I_z\\dot r = (I_x - I_y)pq + \\tau_\\psi $$\n\nKinematics with yaw-pitch-roll angles $\\psi, \\theta, \\phi$:\n\n$$ p = \\dot\\phi - \\dot\\psi\\sin\\theta $$\n\nAll angles and rates are small. Products of rates are dropped:\n\n$$ {line} $$\n"
        ))
    };
    assert_eq!(text(r"I_x\ddot\phi = \tau_\phi"), "ppppp");
    assert_eq!(text(r"I_x\ddot\phi = 2\tau_\phi"), "ppppr");
    assert_eq!(text(r"I_y\ddot\phi = \tau_\phi"), "ppppr");
}

#[test]
fn a_moment_twice_on_the_diagonal_is_a_slip_beside_the_other() {
    let tensor = |first: &str| {
        verdicts(&format!(
            "The momentum is\n\n$$ \\begin{{bmatrix}} L_x \\\\ L_y \\\\ L_z \\end{{bmatrix}} = \\begin{{bmatrix}} {first} & -I_{{xy}} & -I_{{xz}} \\\\ -I_{{xy}} & I_{{yy}} & -I_{{yz}} \\\\ -I_{{xz}} & -I_{{yz}} & I_{{zz}} \\end{{bmatrix}}\\begin{{bmatrix}} \\omega_x \\\\ \\omega_y \\\\ \\omega_z \\end{{bmatrix}} $$\n\nand so $L_x = I_{{xx}}\\omega_x - I_{{xy}}\\omega_y - I_{{xz}}\\omega_z$.\n"
        ))
    };
    assert_eq!(tensor("I_{xx}"), "pp");
    assert_eq!(tensor("I_{yy}"), "rp");
}

#[test]
fn a_value_in_another_unit_is_not_proved() {
    let given = "A plate has $m = 3\\ \\mathrm{kg}$, $a = 2\\ \\mathrm{m}$ and turns at $\\omega = 2\\ \\text{rad s⁻¹}$.";
    let text = |line: &str| last(&format!("{given} It has ${line}$.\n"));
    assert_eq!(text(r"I_b = m a^2/6 = 2\ \mathrm{kg\,m^2}"), 'p');
    assert_eq!(text(r"I_b = m a^2/6 = 2\ \text{kg·m²}"), 'p');
    assert_eq!(text(r"I_b = m a^2/6 = 2\ \mathrm{kg\,m}"), 'u');
    let rate = |unit: &str| {
        last(&format!(
            "A body turns freely with $I_1 = 10$, $I_2 = 15$, $I_3 = 20$ and $\\omega_1 = 1$, $\\omega_2 = 2$, $\\omega_3 = -1$. From Euler's equations\n\n$$ \\dot\\omega_1 = \\frac{{I_2 - I_3}}{{I_1}}\\omega_2\\omega_3 = 1\\ \\text{{{unit}}} $$\n"
        ))
    };
    assert_eq!(rate("rad/s²"), 'p');
    assert_eq!(rate("rad/s"), 'u');
}

#[test]
fn a_momentum_about_another_point_is_no_mere_name() {
    let text = |first: &str| {
        last(&format!(
            "$$ \\mathbf H_P = {first}\\mathbf H_G + \\mathbf r_{{G/P}}\\times m\\mathbf v_G $$\n"
        ))
    };
    assert_eq!(text(""), 'p');
    assert!(!"ap".contains(text("-")));
    assert!(!"ap".contains(text("2\\,")));
    assert!(!"ap".contains(last("$$ \\mathbf H_P = \\mathbf H_G $$\n")));
}

#[test]
fn a_moment_about_one_point_is_not_given_by_another_one_and_a_mass() {
    let text = |index: &str| {
        verdicts(&format!(
            "$$ I_{{xx}} = I_{{{index}}}^C + m(y_C^2 + z_C^2), \\qquad I_{{xy}} = I_{{xy}}^C + m\\,x_C y_C $$\n"
        ))
    };
    assert_eq!(text("xx"), "pp");
    assert_eq!(text("yy"), "rp");
}

#[test]
fn a_rate_on_the_axes_is_not_the_one_from_space() {
    let text = |rest: &str| {
        last(&format!(
            "For any vector, with $\\mathbf\\Omega$ the angular velocity of the axes,\n\n$$ \\frac{{d\\mathbf A}}{{dt}} = \\left(\\frac{{d\\mathbf A}}{{dt}}\\right)_{{rel}}{rest} $$\n"
        ))
    };
    assert_eq!(text(r" + \mathbf\Omega\times\mathbf A"), 'p');
    assert_eq!(text(""), 'u');
}

#[test]
fn axes_do_not_turn_by_a_multiple_of_the_turning_of_the_body() {
    let text = |right: &str| {
        last(&format!(
            "The axes turn with $\\vec\\Omega$ and the body with $\\vec\\omega$. The axes are attached to the body, so\n\n$$ \\vec\\Omega = {right} $$\n"
        ))
    };
    assert!("ap".contains(text(r"\vec\omega")));
    assert!(!"ap".contains(text(r"2\,\vec\omega")));
    assert!(!"ap".contains(text(r"-\vec\omega")));
}

#[test]
fn a_momentum_is_not_given_without_that_of_the_wheels() {
    let text = |rest: &str| {
        last(&format!(
            "The satellite has the inertia $\\mathbf J$ and wheels with the relative angular momentum $\\vec h$. The total angular momentum is\n\n$$ \\vec H = \\mathbf J\\vec\\omega{rest} $$\n"
        ))
    };
    assert_eq!(text(r" + \vec h"), 'p');
    assert!(!"ap".contains(text(r" - \vec h")));
}

#[test]
fn what_acts_is_written_out_but_once() {
    let text = |rate: &str| {
        last(&format!(
            "Choose $\\mathbf u = -k\\boldsymbol\\omega$ with $k > 0$ as the control torque. The closed loop is\n\n$$ \\mathbf J\\dot{{\\boldsymbol\\omega}} = -\\boldsymbol\\omega\\times\\mathbf J\\boldsymbol\\omega - k\\boldsymbol\\omega $$\n\nWith the Lyapunov function $V = \\tfrac12\\boldsymbol\\omega^T\\mathbf J\\boldsymbol\\omega$,\n\n$$ \\dot V = {rate} = -k\\boldsymbol\\omega^T\\boldsymbol\\omega $$\n"
        ))
    };
    assert_eq!(
        text(r"\boldsymbol\omega^T\mathbf J\dot{\boldsymbol\omega}"),
        'p'
    );
    assert_eq!(
        text(r"2\boldsymbol\omega^T\mathbf J\dot{\boldsymbol\omega}"),
        'r'
    );
}

#[test]
fn what_follows_with_names_is_claimed_behind_another_display() {
    let text = |index: u8| {
        verdicts(&format!(
            "A solid of revolution with $I_1 = I_2 = A$ and $I_3 = C$ has $M_1 = M$, $M_2 = M_3 = 0$ and $\\omega_3 = n$.\n$$ A\\dot\\omega_1 = (A - C)n\\omega_2 + M $$\n$$ A\\dot\\omega_2 = -(A - C)n\\omega_1 $$\nWith $\\lambda = \\frac{{(A - C)n}}{{A}}$ and $\\mu = M/A$\n$$ \\dot\\omega_{index} = -\\lambda\\omega_1 $$\n"
        ))
    };
    assert!(text(2).ends_with('p'));
    assert!(text(1).ends_with('r'));
}

#[test]
fn what_is_small_is_not_nothing() {
    let text = |line: &str| {
        last(&format!(
            "Let $\\omega = (\\Omega + \\epsilon_1, \\epsilon_2, \\epsilon_3)$ with small $\\epsilon_i$ on principal axes, and no torque. To first order\n$$ {line} = 0 $$\n"
        ))
    };
    assert_eq!(text(r"\dot\epsilon_1"), 'p');
    assert_eq!(text(r"\epsilon_1"), 'u');
    let since = |line: &str| {
        last(&format!(
            "Rotation on principal axes, mainly about $\\hat e_1$: $\\boldsymbol\\omega = \\omega_1\\hat e_1 + \\lambda\\hat e_2 + \\mu\\hat e_3$ with $\\lambda,\\mu$ small. Without torque and to first order, since $\\lambda\\mu\\approx 0$, ${line} = 0$.\n"
        ))
    };
    assert_eq!(since(r"\dot\omega_1"), 'p');
    assert!(!"ap".contains(since(r"\omega_1")));
}

#[test]
fn what_has_a_name_does_not_vanish() {
    let text = |line: &str| {
        last(&format!(
            "The shaft turns at the constant rate $n$ and the body is free of torque, so $\\omega_1 = n$. The derivatives are ${line} = 0$.\n"
        ))
    };
    assert!("ap".contains(text(r"\dot\omega_1")));
    assert!(!"ap".contains(text(r"\omega_1")));
}

#[test]
fn a_term_that_is_zero_here_has_its_factor_still() {
    let text = |term: &str| {
        last(&format!(
            "Body axes, principal, with $I_1 = I$, $I_2 = 0$ and $I_3 = I$. Euler's equation is\n\n$$ M_2 = {term} - (I_3 - I_1)\\omega_3\\omega_1 $$\n"
        ))
    };
    assert_eq!(text(r"I_2\dot\omega_2"), 'p');
    assert_eq!(text(r"2I_2\dot\omega_2"), 'u');
    assert_eq!(text(r"I_2\omega_2"), 'u');
}

#[test]
fn a_product_by_its_integral_does_not_vanish() {
    let text = |sign: &str| {
        last(&format!(
            "The thin plate lies in the plane $xy$.\n\n$$ I_x = \\int y^2\\,dm $$\n$$ I_y = \\int x^2\\,dm $$\n$$ P = \\int xy\\,dm $$\n\nWith $x' = x\\cos\\alpha + y\\sin\\alpha$, $y' = -x\\sin\\alpha + y\\cos\\alpha$ and $I_x' = \\int y'^2\\,dm$,\n\n$$ I_x' = I_x\\cos^2\\alpha + I_y\\sin^2\\alpha {sign} 2P\\sin\\alpha\\cos\\alpha $$\n"
        ))
    };
    assert_eq!(text("-"), 'p');
    assert!(!"ap".contains(text("+")));
}

#[test]
fn a_tensor_with_a_hole_is_no_form_of_it() {
    let text = |entry: &str| {
        verdicts(&format!(
            "The inertia matrix is\n\n$$ \\mathbf I = \\begin{{bmatrix}} I_{{xx}} & -I_{{xy}} & -I_{{xz}} \\\\ -I_{{xy}} & I_{{yy}} & {entry} \\\\ -I_{{xz}} & -I_{{yz}} & I_{{zz}} \\end{{bmatrix}} $$\n"
        ))
    };
    assert!("ap".contains(&text("-I_{yz}")));
    assert!(!"ap".contains(&text("0")));
}

#[test]
fn an_inertia_about_another_point_has_that_about_the_centre_once() {
    let text = |first: &str| {
        last(&format!(
            "The tensor form is\n\n$$ \\mathbf I_O = {first}\\mathbf I_C + m\\left(r^2\\mathbf 1 - \\mathbf r\\mathbf r^T\\right) $$\n\nwith $\\mathbf r$ the position of the mass centre.\n"
        ))
    };
    assert_eq!(text(""), 'p');
    assert_eq!(text("2\\,"), 'u');
}

#[test]
fn a_plane_of_symmetry_leaves_its_product() {
    let text = |sign: char| {
        last(&format!(
            "The airframe is symmetric about its $x$-$z$ plane, so of the products of inertia only $J_{{xz}} = \\int xz\\,dm$ remains.\n\n$$ \\mathbf J = \\begin{{pmatrix}} J_x & 0 & -J_{{xz}} \\\\ 0 & J_y & 0 \\\\ {sign}J_{{xz}} & 0 & J_z \\end{{pmatrix}} $$\n"
        ))
    };
    assert!("ap".contains(text('-')));
    assert!(!"ap".contains(text('+')));
}
