//! Which letters stand for what, where a document has several for one thing or one for several.

use polhode::notation::{document::Format, read};
use polhode::verify::check;

/// The verdicts on the lines of a document, in order.
fn verdicts(text: &str) -> Vec<&'static str> {
    let (document, _) = read("letters.md", text, Format::Markdown);
    let findings = check(&document).findings;
    findings.iter().map(|f| f.verdict.name()).collect()
}

#[test]
fn coefficients_with_one_letter_are_each_defined() {
    let text = r"
With the principal moments of inertia $I_1$, $I_2$, $I_3$ we abbreviate

$$
k_1 = \frac{I_2 - I_3}{I_1}, \qquad k_2 = \frac{I_3 - I_1}{I_2}, \qquad k_3 = \frac{I_1 - I_2}{I_3}.
$$

They satisfy

$$
k_1 + k_2 + k_3 + k_1 k_2 k_3 = 0
$$

and not

$$
k_1 + k_2 + k_3 - k_1 k_2 k_3 = 0
$$
";
    let expected = ["accepted", "accepted", "accepted", "proved", "refuted"];
    assert_eq!(verdicts(text), expected);
}

#[test]
fn a_torque_that_is_added_to_the_torque_is_another_one() {
    let text = r"
The wheels have the relative momentum $\mathbf h$ and $\mathbf J$ is the inertia matrix of the craft. With the
disturbance torque $\boldsymbol\tau$

$$
\mathbf J\dot{\boldsymbol\omega} + \dot{\mathbf h} + \boldsymbol\omega\times(\mathbf J\boldsymbol\omega + \mathbf h) = \boldsymbol\tau
$$

The motor torque is defined as

$$
\mathbf g = -\dot{\mathbf h}
$$

Hence

$$
\mathbf J\dot{\boldsymbol\omega} = \boldsymbol\tau + \mathbf g - \boldsymbol\omega\times(\mathbf J\boldsymbol\omega + \mathbf h)
$$

and not

$$
\mathbf J\dot{\boldsymbol\omega} = \boldsymbol\tau - \mathbf g - \boldsymbol\omega\times(\mathbf J\boldsymbol\omega + \mathbf h)
$$
";
    assert_eq!(verdicts(text), ["proved", "accepted", "proved", "refuted"]);
}

#[test]
fn a_quaternion_may_change_its_layout_at_a_heading() {
    let text = r"
The angular velocity $\boldsymbol\omega$ is on body axes.

## Aerospace layout

The vector part $\mathbf q$ and the scalar $q_4$ of the quaternion obey

$$
\dot{\mathbf q} = \tfrac12\left(q_4\boldsymbol\omega - \boldsymbol\omega\times\mathbf q\right)
$$

$$
\begin{bmatrix} \dot q_1 \\ \dot q_2 \\ \dot q_3 \\ \dot q_4 \end{bmatrix}
= \tfrac12\begin{bmatrix} q_4 & -q_3 & q_2 \\ q_3 & q_4 & -q_1 \\ -q_2 & q_1 & q_4 \\ -q_1 & -q_2 & -q_3 \end{bmatrix}
\begin{bmatrix} \omega_1 \\ \omega_2 \\ \omega_3 \end{bmatrix}
$$

## Textbook layout

With $\mathbf q = (q_0, q_1, q_2, q_3)$ the same is

$$
\dot{\mathbf q} = \tfrac12\begin{bmatrix} -q_1 & -q_2 & -q_3 \\ q_0 & -q_3 & q_2 \\ q_3 & q_0 & -q_1 \\ -q_2 & q_1 & q_0 \end{bmatrix}
\begin{bmatrix} \omega_1 \\ \omega_2 \\ \omega_3 \end{bmatrix}
$$

$$
\dot q_1 = \tfrac12\left(q_0\omega_1 - q_2\omega_3 - q_3\omega_2\right)
$$
";
    let expected = ["proved", "proved", "accepted", "proved", "refuted"];
    assert_eq!(verdicts(text), expected);
}

#[test]
fn moments_named_by_three_lower_letters_follow_the_rates() {
    let text = r"
The inertia matrix is $\mathbf J = \mathrm{diag}(J_x, J_y, J_z)$ and the rates are $\boldsymbol\omega = (p, q, r)$. Euler's
equations are

$$
\begin{aligned}
l &= J_x\dot p + (J_z - J_y)qr \\
m &= J_y\dot q + (J_x - J_z)pr \\
n &= J_z\dot r + (J_x - J_y)pq
\end{aligned}
$$
";
    let found = verdicts(text);
    assert_eq!(found[found.len() - 3..], ["proved", "proved", "refuted"]);
}

#[test]
fn a_cross_in_an_index_is_no_sign_that_a_formula_goes_on() {
    let text = r"
The rotation matrix $R$ takes body components to space components, $\omega$ is on body axes.

$$
R^\top\dot R = [\omega]_\times \quad\implies\quad \dot R = R\,[\omega]_\times
$$

$$
R^\top\dot R = [\omega]_\times \quad\implies\quad \dot R = [\omega]_\times R
$$
";
    assert_eq!(verdicts(text), ["proved", "proved", "proved", "refuted"]);
}

#[test]
fn moments_on_turned_axes_are_the_integrals_over_their_coordinates() {
    let text = r"
A thin plate lies in the plane $xy$, so that

$$
I_{xx} = \int y^2\,dm, \qquad I_{yy} = \int x^2\,dm, \qquad I_{xy} = \int xy\,dm
$$

Turned axes have the coordinates

$$
u = x\cos\beta + y\sin\beta, \qquad v = y\cos\beta - x\sin\beta
$$

The moments about them are

$$
I_{uu} = I_{xx}\cos^2\beta + I_{yy}\sin^2\beta - I_{xy}\sin 2\beta
$$

$$
I_{uv} = \tfrac12(I_{xx} - I_{yy})\sin 2\beta + I_{xy}\cos 2\beta
$$

$$
I_{vv} = I_{xx}\sin^2\beta + I_{yy}\cos^2\beta - I_{xy}\sin 2\beta
$$
";
    let found = verdicts(text);
    assert_eq!(found[found.len() - 3..], ["proved", "proved", "refuted"]);
}

#[test]
fn three_letters_with_their_differences_are_the_principal_moments() {
    let text = r"
A wheel has the inertia $J$ about its shaft, and

$$
J\dot n = -k n
$$

A free body obeys

$$
A\dot\omega_x - (B - C)\omega_y\omega_z = M_x, \quad B\dot\omega_y - (C - A)\omega_z\omega_x = M_y
$$

$$
C\dot\omega_z - (B - A)\omega_x\omega_y = M_z
$$
";
    let found = verdicts(text);
    assert_eq!(found[found.len() - 3..], ["proved", "proved", "refuted"]);
}

#[test]
fn a_pi_that_moves_is_a_letter() {
    let text = r"
Let $R$ be the rotation matrix that carries body vectors to space vectors, and $\Omega$ the body angular velocity,

$$ \dot R\,v = R\,(\Omega\times v) $$

for any vector $v$. The body angular momentum is

$$ \Pi = \mathbb{I}\,\Omega $$

and the spatial one is

$$ \pi = R\,\Pi $$

By the product rule

$$ \dot\pi = \dot R\,\Pi + R\,\dot\Pi $$

$$ \dot\pi = \dot R\,\Pi - R\,\dot\Pi $$
";
    let found = verdicts(text);
    assert_eq!(found[3..], ["proved", "refuted"], "{found:?}");
}

#[test]
fn a_tensor_with_products_is_not_on_the_principal_axes_of_the_words() {
    let text = r"
A cube has the mass $M$ and the side $a$. With $\mu = Ma^2/12$ the tensor about a corner is

$$ \mathbf I = \mu\begin{pmatrix} 8 & -3 & -3 \\ -3 & 8 & -3 \\ -3 & -3 & 8 \end{pmatrix} $$

The principal moments are not needed. For $\omega_x = \Omega$, $\omega_y = \omega_z = 0$

$$ L_y = -3\mu\Omega $$

$$ T = 5\mu\Omega^2 $$
";
    let found = verdicts(text);
    assert_eq!(found[4..], ["proved", "refuted"], "{found:?}");
}

#[test]
fn the_axes_that_words_turn_with_an_omega_are_not_the_body() {
    let text = r"
A symmetric top spins about its axis $z$. About $O$ the moment of inertia is $C$ for the axis of symmetry and $A$ for every perpendicular axis. The axes precess with the top, but do not share the spin $s$, therefore their angular velocity is

$$ \boldsymbol\Omega = p\sin\theta\,\mathbf j + p\cos\theta\,\mathbf k $$

and that of the top is

$$ \boldsymbol\omega = p\sin\theta\,\mathbf j + (s + p\cos\theta)\,\mathbf k $$

so that the angular momentum is

$$ \mathbf H = A\,p\sin\theta\,\mathbf j + C\,(s + p\cos\theta)\,\mathbf k $$

$$ \mathbf H = A\,p\sin\theta\,\mathbf j + C\,p\cos\theta\,\mathbf k $$
";
    assert_eq!(
        verdicts(text),
        ["accepted", "accepted", "proved", "refuted"]
    );
}

#[test]
fn words_call_a_bold_j_the_angular_momentum() {
    let text = |order: &str| {
        format!(
            "Let $\\mathbf I$ be the inertia tensor for the fixed point, $\\mathbf J$ the angular momentum about it and \
             $\\mathbf N$ the torque.\n\n$$ \\mathbf J = \\mathbf I\\cdot\\boldsymbol\\omega $$\n\n\
             $$ \\left(\\frac{{d\\mathbf J}}{{dt}}\\right)_{{\\text{{space}}}} = \
             \\left(\\frac{{d\\mathbf J}}{{dt}}\\right)_{{\\text{{body}}}} + {order} $$\n\nOn principal axes\n\n\
             $$ T = \\frac{{J_1^2}}{{2I_1}} + \\frac{{J_2^2}}{{2I_2}} + \\frac{{J_3^2}}{{2I_3}} $$\n"
        )
    };
    let verdicts = |order: &str| verdicts(&text(order)).concat();
    assert_eq!(
        verdicts(r"\boldsymbol\omega\times\mathbf J"),
        "provedprovedproved"
    );
    assert_eq!(
        verdicts(r"\mathbf J\times\boldsymbol\omega"),
        "provedrefutedproved"
    );
}

#[test]
fn one_of_the_row_of_moments_stands_alone() {
    let text = |left: &str, sign: &str| {
        verdicts(&format!(
            "Body rates $p, q, r$; the body has a plane of symmetry.\n\n\
             $$ {left} = I_x\\dot p - I_{{xz}}\\dot r + qr(I_z - I_y) {sign} I_{{xz}}pq $$\n"
        ))
        .concat()
    };
    assert_eq!(text("L", "-"), "proved");
    assert_eq!(text("L", "+"), "refuted");
    assert_eq!(text("N", "-"), "refuted");
}

#[test]
fn a_label_and_brackets_stand_beside_names() {
    let energy = |name: &str, half: &str| {
        verdicts(&format!(
            "Principal axes. The rotational energy is\n\n\
             $$ {name} = {half}(I_1\\omega_1^2 + I_2\\omega_2^2 + I_3\\omega_3^2) $$\n"
        ))
    };
    for name in ["E_{\\mathrm{rot}}", "E_{rot}", "T_{\\text{rot}}", "E_k"] {
        assert_eq!(energy(name, "\\tfrac12"), ["proved"], "{name}");
        assert_eq!(energy(name, ""), ["refuted"], "{name}");
    }
    let moments = |first: &str| {
        verdicts(&format!(
            "$J$ denotes its (constant, symmetric) inertia matrix on body axes, $\\vec u$ the torque of the thrusters. On the \
             principal axes, with the moments $\\Theta_1$, $\\Theta_2$, $\\Theta_3$,\n\n\
             $$ u_1 = \\Theta_1\\dot\\omega_1 + ({first})\\omega_2\\omega_3 $$\n"
        ))
    };
    assert_eq!(moments("\\Theta_3 - \\Theta_2"), ["proved"]);
    assert_eq!(moments("\\Theta_2 - \\Theta_3"), ["refuted"]);
}

#[test]
fn what_is_put_in_names_no_letter_of_the_result() {
    let text = r"
The axes are carried by the body. The law of angular momentum is

$$\vec{M} = \left(\frac{d\vec{H}}{dt}\right)_{xyz} + \vec{\omega}\times\vec{H}$$

The axes are principal. Substituting the angular momentum and collecting terms:

$$M_x = I_x\dot\omega_x + (I_z-I_y)\omega_y\omega_z$$
";
    assert_eq!(verdicts(text), ["proved", "proved"]);
}
