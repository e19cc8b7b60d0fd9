//! Small worked examples: what a problem hands over in words and numbers, and what follows from it.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn three_moments_handed_over_leave_no_product() {
    let text = r"For a thin rectangular plate of mass $m$ and sides $a$ and $b$ in the $xy$ plane:

$$ I_{xx} = \frac{1}{12} m b^2,\quad I_{yy} = \frac{1}{12} m a^2,\quad I_{zz} = I_{xx} + I_{yy} = \frac{1}{12}m(a^2+b^2) $$

$$ \tau_z = I_{zz}\dot\omega_z + (I_{yy} - I_{xx})\omega_x\omega_y $$

$$ \tau_z = I_{zz}\dot\omega_z + (I_{xx} - I_{yy})\omega_x\omega_y $$
";
    assert_eq!(verdicts(text), "aaapr");
    let text = text.replace("and sides", "with a product of inertia $I_{xy}$ and sides");
    assert_eq!(verdicts(&text), "aaauu");
}

#[test]
fn a_length_is_no_angular_momentum() {
    let text = r"A thin rod of mass $m$ and length $L$ makes the constant angle $\beta$ with a shaft that turns at the constant rate $\Omega$.
The moment of inertia about its end is $I = \frac13 mL^2$. With $x$ along the rod, $I_x = 0$, $I_y = I_z = I$:

$$ \omega_x = \Omega\cos\beta,\quad \omega_y = 0,\quad\omega_z = \Omega\sin\beta $$

$$ M_y = (I_x - I_z)\omega_z\omega_x = -\frac13mL^2\Omega^2\sin\beta\cos\beta $$

$$ M_y = -\frac23mL^2\Omega^2\sin\beta\cos\beta $$
";
    assert_eq!(verdicts(text), "aaaaaapr");
}

#[test]
fn a_rotor_about_one_axis_has_an_acceleration_too() {
    let text = r"A rotor turns about the fixed $z$ axis with angular velocity $\omega$ and angular acceleration $\alpha$. The axes are fixed in the rotor.

$$ M_x = -I_{xz}\alpha + I_{yz}\omega^2 $$

$$ M_y = -I_{yz}\alpha + I_{xz}\omega^2 $$

At constant speed

$$ M_x = I_{yz}\omega^2 $$
";
    assert_eq!(verdicts(text), "prp");
}

#[test]
fn loads_that_words_exclude_are_zero() {
    let text = r"A body has $I_1 = I_2 = A$ and $I_3 = C$. Thrusters give a moment $M$ about axis 1 only, so $M_1 = M$ and $M_2 = M_3 = 0$.

$$ A\dot\omega_2 = (C - A)\omega_3\omega_1 $$

$$ A\dot\omega_1 = (A - C)\omega_2\omega_3 + M $$

$$ A\dot\omega_1 = (A - C)\omega_2\omega_3 - M $$
";
    assert_eq!(verdicts(text), "aapappr");
}

#[test]
fn columns_have_units_and_lists_are_columns() {
    for (list, expected) in [
        (r"[10, -6, 0]^T\ \mathrm{N\,m\,s}", "aap"),
        (r"(10, -6, 0)", "aap"),
        (
            r"\begin{pmatrix} 10 \\ -6 \\ 0 \end{pmatrix}\ \text{kg m}^2/\text{s}",
            "aap",
        ),
        (r"2(5, -3, 0)^T", "aap"),
        (r"(10, 6, 0)", "aar"),
    ] {
        let text = format!(
            r"$$ J = \begin{{pmatrix}} 3 & -1 & 0 \\ -1 & 3 & 0 \\ 0 & 0 & 5 \end{{pmatrix}}\ \text{{kg m}}^2, \qquad \omega = [3, -1, 0]^T\ \text{{rad/s}} $$

$$ h = J\omega = {list} $$
"
        );
        assert_eq!(verdicts(&text), expected, "{list}");
    }
}

#[test]
fn roots_of_numbers_can_be_given_and_refuted() {
    let text = r"A cube of mass $M$ and side $a$ has

$$ I_{xx} = I_{yy} = I_{zz} = \frac23 Ma^2,\qquad I_{xy} = I_{yz} = I_{zx} = \frac14 Ma^2 $$

It turns about the diagonal, so

$$ \boldsymbol\omega = \frac{\omega}{\sqrt3}(1,1,1) $$

Then

$$ \mathbf L = \mathbf I\boldsymbol\omega = \frac{Ma^2}{6}\boldsymbol\omega $$

$$ \mathbf L = \frac{Ma^2}{3}\boldsymbol\omega $$

$$ \omega_x + \omega_y = \frac{2\omega}{\sqrt3} $$

$$ \omega_x + \omega_y = \frac{\omega}{\sqrt3} $$
";
    assert_eq!(verdicts(text), "aaaprpr");
    // Such a body is only possible where the products are entries of the matrix.
    assert_eq!(verdicts(&text.replace(r"\frac14", r"-\frac14")), "aaaprpr");
}

#[test]
fn most_lines_tell_the_sign_of_products() {
    let text = r"The components of the angular momentum are

$$ L_x = I_{xx}\omega_x + I_{xy}\omega_y + I_{xz}\omega_z $$

$$ L_y = I_{yx}\omega_x + I_{yy}\omega_y + I_{yz}\omega_z $$

$$ L_z = I_{zx}\omega_x + I_{zy}\omega_y + I_{zz}\omega_z $$
";
    assert_eq!(verdicts(text), "ppp");
    assert_eq!(verdicts(&text.replace("+ I_{xz}", "- I_{xz}")), "rpp");
    let text = r"The components of the angular momentum are

$$ L_x = I_{xx}\omega_x - I_{xy}\omega_y + I_{xz}\omega_z $$

$$ L_y = -I_{yx}\omega_x + I_{yy}\omega_y - I_{yz}\omega_z $$
";
    assert_eq!(verdicts(text), "rp");
}

#[test]
fn a_moment_without_a_label_is_about_the_point_of_the_tensor() {
    let text = r"Parallel axes:

$$ I_{xx} = I_{xx}^C + m(y_C^2 + z_C^2), \qquad I_{xy} = I_{xy}^C - m\,x_C y_C $$

$$ \mathbf I_O = \mathbf I_C + m\left(r^2\mathbf 1 - \mathbf r\mathbf r^T\right) $$
";
    assert_eq!(verdicts(text), "prp");
}

#[test]
fn what_is_transposed_is_no_number() {
    let text = r"If the axes are rotated by the matrix $R$,

$$ I' = R I R^T, \qquad \omega' = R\omega $$

$$ L' = I'\omega' = RI\omega = RL $$

$$ L' = R^TL $$
";
    assert_eq!(verdicts(text), "aapr");
}

#[test]
fn a_solution_names_its_value_at_the_beginning() {
    let text = r"A body with principal moments $I_1 = I_2 = I_t$ and $I_3 = I_a$ is spun up by a constant torque $\tau_3$ about the symmetry axis, $\tau_1 = \tau_2 = 0$. Integrating,

$$ \omega_3(t) = \omega_{3,0} + \frac{\tau_3}{I_a}t $$
";
    assert_eq!(verdicts(text), "aaaa");
    assert_eq!(verdicts(&text.replace("{3,0}", "0")), "aaaa");
    assert_eq!(verdicts(&text.replace("{I_a}t", "{2I_a}t")), "aaar");
}

#[test]
fn a_number_turns_about_the_axis_of_its_moment() {
    let text = r"A thin hoop of mass $M$ and radius $R$ spins about a diameter with angular velocity $\omega$. Its principal moments are

$$ I_1 = I_2 = \frac12MR^2,\qquad I_3 = MR^2 $$

so the kinetic energy is

$$ T = \frac12I_1\omega^2 = \frac14MR^2\omega^2 $$

and $L = I_1\omega = MR^2\omega$.
";
    assert_eq!(verdicts(text), "aapr");
}

#[test]
fn steady_motions_are_supposed() {
    let text = r"Suppose the body turns with constant angular velocity about the $z$ axis, $\omega_x = \omega_y = 0$. Then $\dot{\boldsymbol\omega} = 0$.
";
    assert_eq!(verdicts(text), "ap");
    let text = r"In a steady turn $\dot p = \dot q = \dot r = 0$. With the $xz$ plane a plane of symmetry the moments are

$$ L = (I_z - I_y)qr - I_{xz}pq $$

$$ N = (I_x - I_y)pq + I_{xz}qr $$
";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn a_flat_body_needs_two_moments() {
    let text = r"A triangle has

$$ I_{xx} = \frac{mh^2}{6},\qquad I_{yy} = \frac{mb^2}{6} $$

The plate lies in the $xy$ plane, so $I_{zz} = \frac{m(b^2+h^2)}{6}$ and $I_{xz} = 0$.

$$ I_{zz} = \frac{m(b^2+h^2)}{12} $$

For a thin disk $I_3 = 2I_1$.
";
    assert_eq!(verdicts(text), "aappra");
}

#[test]
fn what_vanishes_under_a_condition_does() {
    let text = r"The product of inertia in axes turned by $\theta$ about $z$ is

$$ I_{x'y'} = \frac{I_{xx} - I_{yy}}{2}\sin2\theta + I_{xy}\cos2\theta $$

It vanishes for

$$ \tan2\theta = \frac{2I_{xy}}{I_{yy} - I_{xx}} $$
";
    assert_eq!(verdicts(text), "pa");
    assert_eq!(
        verdicts(&text.replace("I_{yy} - I_{xx}}", "I_{xx} - I_{yy}}")),
        "pr"
    );
}

#[test]
fn a_load_without_a_letter_stands_in_the_equation() {
    let text = r"For $I_1=I_2=I_t$ and a small damping torque $-c\omega_1$, $-c\omega_2$ about the transverse axes,

$$ I_t\dot\omega_1 + (I_3 - I_t)\omega_3\omega_2 = -c\,\omega_1 $$

$$ I_t\dot\omega_2 - (I_3 - I_t)\omega_3\omega_1 = -c\,\omega_2 $$

so that

$$ \frac{d}{dt}(\omega_1^2 + \omega_2^2) = -\frac{2c}{I_t}(\omega_1^2 + \omega_2^2) $$
";
    assert_eq!(verdicts(text), "aaap");
    let wrong = text.replace(r"\dot\omega_2 - (I_3", r"\dot\omega_2 + (I_3");
    assert_eq!(verdicts(&wrong), "aarr");
}

#[test]
fn what_rolls_in_a_plane_has_two_energies() {
    let text = r"For a ball of mass $m$ and radius $r$, $I = \frac25mr^2$. Rolling without slipping, $v = r\omega$, so

$$ T = \frac12mv^2 + \frac12I\omega^2 = \frac7{10}mv^2 $$

$$ T = \frac75mv^2 $$
";
    assert_eq!(verdicts(text), "aapr");
}

#[test]
fn coefficients_behind_a_system_are_its_own() {
    let text = r"Let $x_1 = \omega_1$, $x_2 = \omega_2$, $x_3 = \omega_3$ and $u_i = \tau_i/I_i$. The state equations are

$$ \dot x_1 = a_1x_2x_3 + u_1, \qquad \dot x_2 = -a_2x_3x_1 + u_2 $$

with

$$ a_1 = \frac{I_2 - I_3}{I_1},\quad a_2 = \frac{I_3 - I_1}{I_2} $$
";
    assert!(verdicts(text).ends_with("praa"), "{}", verdicts(text));
}
