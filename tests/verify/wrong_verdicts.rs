//! No verdict is wrong where the checker has not understood: a claim that the theory has to settle is not taken as given
//! or as a definition, no line is proved by itself, and no true line is false by one reading of its symbols.
use polhode::notation::{document::Format, read};
use polhode::verify::check;

/// The verdicts of the lines, a letter each.
fn verdicts(text: &str) -> String {
    let report = check(&read("a document", text, Format::Markdown).0);
    let letter = |name: &str| name.chars().next().unwrap_or('?');
    report
        .findings
        .iter()
        .map(|f| letter(f.verdict.name()))
        .collect()
}

/// The verdict of the last line.
fn last(text: &str) -> char {
    verdicts(text).chars().last().expect("a line")
}

#[test]
fn a_bound_names_nothing() {
    let text = r"A spinning top with $J_1 = J_2 = J$ and $J_3 < J$ feels no torque.

$$ \dot\omega_1 = \frac{J - J_3}{J}\,\omega_2\omega_3 $$

$$ \dot\omega_2 = 0 $$
";
    assert_eq!(verdicts(text), "aapr");
}

#[test]
fn a_dot_means_the_same_in_two_lines() {
    let text = r"A platform carries rotors and has the angular momentum $\mathbf H = I\boldsymbol\omega + \mathbf h_r$; the moment $\mathbf T$ acts on it.

$$ I\dot{\boldsymbol\omega} + \dot{\mathbf h}_r + \boldsymbol\omega\times(I\boldsymbol\omega + \mathbf h_r) = \mathbf T $$

$$ I\dot{\boldsymbol\omega} + \dot{\mathbf h}_r + \boldsymbol\omega\times I\boldsymbol\omega = \mathbf T $$
";
    assert_eq!(verdicts(text), "apu");
}

#[test]
fn a_spin_about_another_axis_ends_the_one_before() {
    let with = |sign: &str| {
        format!(
            r"No torque acts on a body with the principal moments $I_1$, $I_2$, $I_3$.

Let it turn about the first axis, $\omega_1 \approx n$, with $\omega_2$ and $\omega_3$ small:

$$ I_2\dot\omega_2 = (I_3 - I_1)\,n\,\omega_3 $$

Let it turn about the second axis, $\omega_2 \approx n$, with $\omega_1$ and $\omega_3$ small:

$$ I_3\dot\omega_3 = {sign}(I_1 - I_2)\,n\,\omega_1 $$
"
        )
    };
    assert_eq!(verdicts(&with("")), "apap");
    assert_eq!(verdicts(&with("-")), "apar");
}

#[test]
fn a_potential_energy_is_no_proof_of_itself() {
    let with = |potential: &str| {
        let kinetic = r"\frac{I_1}{2}\left(\dot\theta^2 + \dot\phi^2\sin^2\theta\right) + \frac{I_3}{2}\left(\dot\psi + \dot\phi\cos\theta\right)^2";
        format!(
            r"# A heavy top

Let $I_1 = I_2$. The top has the mass $M$, and its mass centre lies at the distance $l$ from the fixed point. The Euler angles are $\phi,\theta,\psi$, with $\theta$ from the upward vertical. The kinetic energy is

$$ T = {kinetic} $$

and the potential energy

$$ V = {potential} $$

so that the energy is

$$ E = {kinetic} + {potential} $$
"
        )
    };
    assert_eq!(verdicts(&with(r"M g l\cos\theta")), "apap");
    assert_eq!(verdicts(&with(r"3 M g l\cos\theta")), "apuu");
}

#[test]
fn the_moment_of_a_shape_is_not_handed_over() {
    let text = r"A roller is a uniform solid cylinder of the mass $m$ and the radius $b$. About its axis

$$ I = 2 m b^2 $$

and the kinetic energy of its rotation is

$$ T = m b^2\omega^2 $$
";
    assert_eq!(verdicts(text), "uu");
}

#[test]
fn a_moment_is_its_own_sum_over_the_masses() {
    let with = |squares: &str| {
        last(&format!(
            r"A rigid body consists of particles, and the inertia tensor is $I = \sum m_i (r_i^2 1 - r_i r_i^T)$ with $r_i = (x_i, y_i, z_i)$.

$$ I_{{zz}} = \sum m_i({squares}) $$
"
        ))
    };
    assert_eq!(with("x_i^2 + y_i^2"), 'p');
    assert_eq!(with("x_i^2 + z_i^2"), 'r');
}

#[test]
fn a_rate_in_time_agrees_with_its_equation() {
    let with = |factor: &str| {
        last(&format!(
            r"A motor drives a symmetric rotor, $I_1 = I_2$, about its axis with the constant torque $N$.

$$ I_3\dot\omega_3 = N $$

$$ \omega_3 = \omega_{{30}} + {factor}\frac{{N}}{{I_3}}t $$
"
        ))
    };
    assert_eq!(with(""), 'a');
    assert_eq!(with("2"), 'u');
}

#[test]
fn a_moment_about_an_axis_is_no_length() {
    let text = r"A door turns about the fixed axis z, $\vec\omega = \omega\hat k$, and the moment about this axis is $M$.

$$ M = I_{zz}\dot\omega $$
";
    assert_eq!(last(text), 'u');
}

#[test]
fn a_spin_with_constant_angular_velocity_is_steady() {
    let text = r"A crooked rotor spins with constant angular velocity $\omega$ about the fixed z axis, so $\omega_x=\omega_y=0$, $\omega_z=\omega$. The axes turn with the rotor.

$$ M_y = -I_{xz}\omega^2 $$

$$ M_z = 0 $$
";
    assert!(verdicts(text).ends_with("pp"));
}

#[test]
fn axes_that_turn_apart_from_the_body_deny_nothing() {
    let text = r"A disc spins at $\omega_s$ about its axle z, and the axes xyz turn with $\vec\Omega$. Here $I_x = I_y = I$.

$$ \omega_z = \Omega_z + \omega_s $$

$$ M_y = I\dot\Omega_y + I\Omega_x\Omega_z - I_z\Omega_x\omega_z $$
";
    assert!(!verdicts(text).contains('r'));
    let text = r"The axes turn with $\vec\Omega$ and are fixed in the body, which turns with $\vec\omega$. Then

$$ \vec\Omega = \frac{1}{2}\vec\omega $$
";
    assert_ne!(last(text), 'a');
}

#[test]
fn the_angular_velocity_by_angles_is_not_handed_over() {
    let text = r"# A gyroscope

The disc spins at $\dot\psi$ about its axle $z$, which makes the angle $\theta$ with the vertical and precesses about it at $\dot\phi$. The angular velocity is

$$
\begin{aligned}
\omega_x &= \dot\phi\sin\theta \\
\omega_y &= \dot\theta \\
\omega_z &= 2\dot\psi - \dot\phi\cos\theta
\end{aligned}
$$

$$ \omega_z = 2\dot\psi - \dot\phi\cos\theta $$
";
    assert_eq!(verdicts(text), "uuuu");
}

#[test]
fn a_part_with_a_name_is_not_defined_by_a_formula() {
    let text = r"A bead slides on a plate that turns with $\boldsymbol\omega = \omega\mathbf k$. Relative to the plate it has $\mathbf v_r = \dot x\mathbf i + \dot y\mathbf j$. Its Coriolis acceleration is

$$ \mathbf a_c = \boldsymbol\omega\times\mathbf v_r $$

$$ \mathbf a_c = -\omega\dot y\,\mathbf i + \omega\dot x\,\mathbf j $$
";
    assert_eq!(verdicts(text), "aauu");
}

#[test]
fn numbers_in_two_units_differ() {
    let text = "The rotor has the mass $m$.\n\n$$ 3\\,\\mathrm{kg} = 3\\,\\mathrm{m} $$\n";
    assert_eq!(verdicts(text), "r");
}

#[test]
fn the_slope_of_a_vector_in_an_angle_is_not_decided() {
    let with = |factor: &str| {
        last(&format!(
            r"We use the Lagrangian of a body with the angular velocity $\vec\omega$ and the inertia $I_1, I_2, I_3$. It is a function of the Euler angles $\phi$, $\theta$, $\psi$, and

$$ \omega_1=\dot{{\phi}}\sin\theta\sin\psi+\dot{{\theta}}\cos\psi $$

$$ \frac{{\partial L}}{{\partial \psi}}-{factor}\frac{{d}}{{dt}}\frac{{\partial L}}{{\partial \dot{{\psi}}}}=0 $$
"
        ))
    };
    assert_eq!(with(""), 'u');
    assert_eq!(with("7"), 'u');
}

#[test]
fn either_of_two_triads_may_rest() {
    let text = r"# Rate of a vector

Let $\vec B$ be any vector. In an inertial frame
$$\frac{d}{dt}\vec{B}=\hat{i}\frac{d}{dt}B_x+\hat{j}\frac{d}{dt}B_y+\hat{k}\frac{d}{dt}B_z+B_x\frac{d\hat{i}}{dt}+B_y\frac{d\hat{j}}{dt}+B_z\frac{d\hat{k}}{dt}.$$
There the unit vectors rest. Thus we have
$$\frac{d\vec{B}}{dt}_{inertial}=\hat{i}\frac{d}{dt}B_x+\hat{j}\frac{d}{dt}B_y+\hat{k}\frac{d}{dt}B_z.$$
Now consider turning axes, where $\vec{B}=B_x^\prime\hat{i}^\prime+B_y^\prime\hat{j}^\prime+B_z^\prime\hat{k}^\prime$.
";
    assert!(!verdicts(text).contains('r'));
}

#[test]
fn the_inverse_of_the_inertia_is_another_matrix() {
    let text = r"A body has the moment of inertia $I$, a symmetric matrix, and $J = I^{-1}$. With the angular momentum $L$ it turns with $\omega = J L$.
";
    assert!(!verdicts(text).contains('r'));
}

#[test]
fn a_value_at_the_start_denies_no_line_in_time() {
    let text = r"A heavy top of the mass $m$ has the moments $A, A, C$ at its fixed point. Its Euler angles are $\theta$, $\varphi$, $\psi$. It starts with

$$ \theta = \frac{\pi}{4}, \quad \dot\varphi = \frac{2\gamma}{\sqrt{3}} $$

and with $u = \cos\theta$ we find

$$ \dot u^2 = \gamma^2 (1-u)^2 (2u - 1) $$
";
    assert!(!verdicts(text).contains('r'));
}

#[test]
fn a_rate_is_not_left_out_of_its_own_vector() {
    let text = r"Any vector $\mathbf Q$ has on moving axes the rate

$$ (\dot{\mathbf{Q}})_{xyz} = \dot{Q}_x\mathbf{i} + \dot{Q}_z\mathbf{k} $$
";
    assert_eq!(verdicts(text), "r");
}

#[test]
fn a_letter_of_another_kind_gets_no_meaning_by_a_claim() {
    let mass = r"A body of the mass $m$ has the angular momentum $\vec L$. About the point G

$$ \Sigma m_{G} = \dot{\vec L}_{G} $$
";
    assert_ne!(last(mass), 'a');
    let rate = r"An aircraft has the angular velocity $\boldsymbol\omega = (p, q, r)^T$ and the principal moments of inertia $I_x$, $I_y$, $I_z$. The components of its angular momentum are

$$ h_x = I_x p $$

$$ r_y = I_y q $$
";
    assert_ne!(last(rate), 'a');
}

#[test]
fn the_position_from_the_mass_centre_is_another_one() {
    let with = |right: &str| {
        format!(
            r"The body turns with the angular velocity $\boldsymbol\omega$. A particle has the positions $\mathbf r_i$ and $\mathbf r_i^c$. Then

$$ \boldsymbol\omega\times\mathbf r_i^c = \boldsymbol\omega\times{right} $$
"
        )
    };
    assert_eq!(verdicts(&with(r"\mathbf r_i^c")), "p");
    assert_ne!(last(&with(r"\mathbf r_i")), 'p');
}

#[test]
fn components_of_several_vectors_name_none() {
    let with = |first: &str| {
        format!(
            r"An aircraft has the angular velocity $\boldsymbol\omega = (p, q, r)^T$ and the principal moments of inertia $I_x$, $I_y$, $I_z$. The angular momentum vector is then

$$ \begin{{bmatrix}} {first} \\ h_y \\ h_z \end{{bmatrix}} = \begin{{bmatrix}} I_x p \\ I_y q \\ I_z r \end{{bmatrix}} $$
"
        )
    };
    assert_eq!(last(&with("h_x")), 'p');
    assert_ne!(last(&with("r_x")), 'p');
}
