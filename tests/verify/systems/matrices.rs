//! Attitudes by matrices, arrays of components, and the vector of a cross-product matrix.

use super::judged;

#[test]
fn the_vee_takes_the_vector_out_of_a_cross_product_matrix() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
D is a frame which turns relative to N.
$R$ takes components on B to components on N.
$R_d$ takes components on D to components on N.
The angular velocity of B relative to N, in components on B, is $\\Omega$.
A wedge at the upper right means the cross-product matrix.
A vee at the upper right means the vector of which the matrix is the cross-product matrix.
";
    let text = r"
$$ \Omega = (R^T\dot R)^\vee $$
$$ \Omega = (\dot R^T R)^\vee $$
$$ (\Omega^\wedge)^\vee = \Omega $$
$$ (R_d^T R)^\vee = 0 $$
";
    assert_eq!(judged(sentences, text), "prpu");
}

#[test]
fn the_trace_of_a_matrix_between_two_frames_is_that_of_its_entries() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$R$ takes components on B to components on N.
$J$ is the inertia tensor of the body about its mass centre in components on B.
$\\psi$ is an angle.
A is turned relative to N about z by the angle $\\psi$.
$C$ takes components on A to components on N.
";
    let text = r"
$$ \operatorname{tr}(R) = 3 $$
$$ \operatorname{tr}(R^T R) = 3 $$
$$ \operatorname{tr}(R J R^T) = \operatorname{tr}(J) $$
$$ \operatorname{tr}(R J) = \operatorname{tr}(J) $$
$$ \operatorname{tr}(C) = 1 + 2\cos\psi $$
$$ \det(R) = 1 $$
";
    assert_eq!(judged(sentences, text), "rpprpp");
}

#[test]
fn an_array_is_a_vector_in_components_on_a_frame() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
The body turns relative to N with the angular velocity $\\vec\\omega$.
$C$ takes components on N to components on B.
$\\vec v$ is a vector fixed in N.
$\\vec v_B$ is $\\vec v$ in components on B.
$\\vec v_N$ is $\\vec v$ in components on N.
$\\vec u$ is any vector in components on B.
$\\vec\\omega_B$ is $\\vec\\omega$ in components on B.
A dot means the rate, entry by entry.
A superscript $T$ means the transpose.
";
    let text = r"
$$ \vec v_B = C\vec v_N $$
$$ \vec v_N = C\vec v_B $$
$$ \dot{\vec v}_N = 0 $$
$$ \dot{\vec v}_B = -\vec\omega_B\times\vec v_B $$
$$ \dot{\vec v}_B = \vec\omega_B\times\vec v_B $$
$$ (C^T\vec u)^T(C^T\vec u) = \vec u^T\vec u $$
";
    assert_eq!(judged(sentences, text), "prpprp");
}

#[test]
fn unit_vectors_side_by_side_are_a_dyad() {
    let said = "N is an inertial frame.
B is a frame fixed in the body, and its axes are principal axes of the body.
$\\hat b_1$, $\\hat b_2$, $\\hat b_3$ are the axes of B.
G is the mass centre of the body.
$\\mathbf J$ is the inertia tensor of the body about G.
$J_1$, $J_2$, $J_3$ are the principal moments of the body about G.
$\\vec\\omega$ is the angular velocity of B relative to N.
";
    let text = r"
$$ \mathbf J = J_1 \hat b_1\hat b_1 + J_2 \hat b_2\hat b_2 + J_3 \hat b_3\hat b_3 $$
$$ \mathbf J = J_1 \hat b_1\hat b_1 + J_3 \hat b_2\hat b_2 + J_3 \hat b_3\hat b_3 $$
$$ \hat b_1\hat b_1\cdot\vec\omega = (\hat b_1\cdot\vec\omega)\hat b_1 $$
$$ \hat b_1\cdot\vec\omega\,\vec\omega = (\hat b_1\cdot\vec\omega)\vec\omega $$
$$ \hat b_1\cdot\vec\omega\,\vec\omega = -(\hat b_1\cdot\vec\omega)\vec\omega $$
";
    assert_eq!(judged(said, text), "prppr");
}

#[test]
fn a_frame_turns_by_an_angle_about_any_vector() {
    let sentences = "N is an inertial frame.
$e_1$, $e_2$, $e_3$ are the axes of N.
$\\vec n$ is a unit vector fixed in N.
A is a frame that turns relative to N.
A turns relative to N about $\\vec n$ by the angle $\\beta$.
$Q$ takes components on A to components on N.
$P_n(\\gamma)$ is the matrix of the rotation by $\\gamma$ about $\\vec n$, for any angle $\\gamma$.
$u$ is any vector.
$\\vec\\omega$ is the angular velocity of A relative to N.
";
    let text = r"
$$ Q = P_n(\beta) $$
$$ Q = P_n(-\beta) $$
$$ Q^{-1}(\beta) = P_n(-\beta) $$
$$ P_n(\beta)P_n(\gamma) = P_n(\beta+\gamma) $$
$$ \vec\omega = \dot\beta\,\vec n $$
$$ \vec\omega = -\dot\beta\,\vec n $$
";
    assert_eq!(judged(sentences, text), "prpppr");
}

#[test]
fn an_operator_on_vectors_beside_the_time_is_another_letter() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$R$ takes components on B to components on N.
$w$ is the angular velocity of B relative to N in components on N.
$S(v)$ is the cross-product matrix of $v$, for any vector $v$.
$t$ is the time.
Line 2 defines $S(t)$.
";
    let text = r"
$$ S(t) = \dot R R^T(t) $$
$$ \dot R = S(t)R(t) $$
$$ S(t) = S(w) $$
$$ S(w) = R^T\dot R $$
";
    assert_eq!(judged(sentences, text), "appr");
}

#[test]
fn a_number_beside_matrices_is_defined_by_no_line() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$R$ takes components on B to components on N.
$w$ is the angular velocity of B relative to N in components on N.
$W(v)$ is the cross-product matrix of $v$, for any vector $v$.
";
    let text = r"
We define $$ \dot R = c R $$
$$ W(w) = R^T\dot R $$
";
    assert_eq!(judged(sentences, text), "ur");
}

#[test]
fn a_cross_stands_behind_a_row_or_with_nothing_behind_it() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$R$ takes components on B to components on N.
$w$ is the angular velocity of B relative to N in components on B.
$w\\times$ is the cross-product matrix of $w$.
$\\vec a$, $\\vec b$, $\\vec c$ are any vectors.
";
    let text = r"
$$ \dot R = R\,w\times $$
$$ \dot R = w\times R $$
$$ \ddot R = R\,w\times w\times + R\,\dot w\times $$
$$ \vec a^T\vec b\times\vec c = \vec a\cdot(\vec b\times\vec c) $$
$$ 2\vec a^T\vec b\times\vec c = \vec b\cdot(\vec a\times\vec c) $$
";
    assert_eq!(judged(sentences, text), "prppr");
}

#[test]
fn lists_are_on_the_frame_that_a_sentence_says() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N.
$a_1$, $a_2$, $a_3$ are the axes of A.
B is a frame fixed in the top.
B turns relative to A about $a_3$ by the angle $\\phi$.
O is a point fixed in N and in B.
$J_1$, $J_1$, $J_3$ are the principal moments of the top about O on B.
$\\vec K$ is the angular momentum of the top about O relative to N.
$\\vec w$ is the angular velocity of the top relative to N.
$w_1$, $w_2$, $w_3$ are the components of $\\vec w$ on A.
Parentheses hold components on A.
";
    let text = r"
$$ \vec K = (J_1 w_1, J_1 w_2, J_3 w_3) $$
$$ \vec K = (J_3 w_1, J_1 w_2, J_3 w_3) $$
$$ \det\begin{bmatrix} w_1 & w_2\\ w_2 & w_1\end{bmatrix} = w_1^2 - w_2^2 $$
$$ \det\begin{bmatrix} w_1 & w_2\\ w_2 & w_1\end{bmatrix} = w_1^2 + w_2^2 $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_rotation_about_a_counted_axis_is_a_matrix_as_it_is_written() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
$\phi$, $\theta$, $\psi$ are the Euler angles of B relative to N in the order z, x, z.
$U_1$ is the matrix of the rotation by $\phi$ about the third axis.
$U_2$ is the matrix of the rotation by $\theta$ about the first axis.
$U_3$ is the matrix of the rotation by $\psi$ about the third axis.
A dot means the rate, entry by entry.
$U$ takes components on B to components on N.
";
    let text = r"
$$ U_2 = \begin{pmatrix} 1 & 0 & 0 \\ 0 & \cos\theta & -\sin\theta \\ 0 & \sin\theta & \cos\theta \end{pmatrix} $$
$$ U_1 = \begin{pmatrix} \cos\phi & \sin\phi & 0 \\ -\sin\phi & \cos\phi & 0 \\ 0 & 0 & 1 \end{pmatrix} $$
$$ U_1^T\dot U_1 = \begin{pmatrix} 0 & -\dot\phi & 0 \\ \dot\phi & 0 & 0 \\ 0 & 0 & 0 \end{pmatrix} $$
$$ U = U_1U_2U_3 $$
$$ U = U_3U_2U_1 $$
";
    assert_eq!(judged(sentences, text), "prppr");
}

#[test]
fn frames_with_indices_are_meant_by_these_in_labels() {
    let sentences = r"
$F_\beta$ is an inertial frame.
$F_\alpha$ is a frame that turns relative to $F_\beta$.
$F_\delta$ is a frame that turns relative to $F_\alpha$.
$\omega^{\gamma}_{\beta \alpha}$ is the angular velocity of $F_\alpha$ relative to $F_\beta$ in components on $F_\gamma$, for any frames $F_\alpha$, $F_\beta$ and $F_\gamma$.
$R^{\alpha}_{\beta}$ takes components on $F_\beta$ to components on $F_\alpha$, for any frames $F_\alpha$ and $F_\beta$.
";
    let text = r"
$$ \omega^{\delta}_{\beta \alpha} = -\omega^{\delta}_{\alpha\beta} $$
$$ \omega^{\beta}_{\beta \alpha} = R^\beta_\alpha \omega^{\alpha}_{\beta\alpha} $$
$$ \omega^{\beta}_{\beta \delta} = \omega^\beta_{\beta\alpha} + \omega^{\beta}_{\alpha\delta} $$
$$ R^\delta_\beta = R^\delta_\alpha R^\alpha_\beta $$
$$ \omega^{\delta}_{\beta \alpha} = \omega^{\delta}_{\alpha\beta} $$
$$ \omega^{\alpha}_{\beta \alpha} = R^\beta_\alpha \omega^{\beta}_{\beta\alpha} $$
$$ \omega^{\beta}_{\beta \delta} = \omega^\beta_{\beta\alpha} - \omega^{\beta}_{\alpha\delta} $$
$$ R^\delta_\beta = R^\alpha_\beta R^\delta_\alpha $$
";
    assert_eq!(judged(sentences, text), "pppprrrr");
}

#[test]
fn a_number_beside_a_square_matrix_may_mean_the_identity() {
    let sentences = r"
N is an inertial frame.
B is a frame that turns relative to N.
$R$ takes components on B to components on N.
$w$ is the angular velocity of B relative to N in components on B.
";
    let text = r"
$$ R^T R = 1 $$
$$ R = 1 $$
$$ R^T R = 2 $$
$$ R + 1 = 1 + R $$
$$ w = 1 $$
";
    assert_eq!(super::verdicts(sentences, text).0, "uurur");
}

/// A bold 0 is as large as what stands on the other side.
#[test]
fn a_bold_zero_has_any_shape() {
    let sentences = r"
R is an inertial frame.
K is a frame fixed in the hull.
D is the mass centre of the hull.
$C$ takes components on R to components on K.
$\mathbf w$ is the angular velocity of K relative to R in components on K.
$\mathbf J$ is the inertia tensor of the hull about D.
A dot is the rate seen from K.
$\frac{d}{dt}$ is the rate entry by entry.
";
    let text = r"
$$ \dot{\mathbf J}=\mathbf 0 $$
$$ \frac{d}{dt}(C C^T)=\mathbf{0} $$
$$ \frac{d}{dt}(C+C^T)=\mathbf{0} $$
$$ \mathbf w\times\mathbf J\mathbf w=\mathbf 0 $$
";
    assert_eq!(judged(sentences, text), "pprr");
}

/// Where no sentence says what a matrix is, its entries are those of what a line makes of it.
#[test]
fn letters_may_be_entries_of_a_matrix_that_a_line_tells() {
    let sentences = r"
N is an inertial frame.
K is a frame fixed in the hull.
D is the mass centre of the hull.
$A_{ij}$ is entry (i, j) of $A$.
$i$ and $j$ number the axes of K.
";
    let text = r"
$$ A=\begin{pmatrix}1&2&3\\4&5&6\\7&8&9\end{pmatrix} $$
$$ A_{12}=2 $$
$$ A_{21}=2 $$
";
    assert_eq!(judged(sentences, text), "apr");
}

#[test]
fn adjugates_and_cofactors_are_made_of_a_matrix() {
    let sentences = r"
$C$ is the adjugate of $A$.
$F$ is the cofactor matrix of $A$.
";
    let text = r"
$$ A=\begin{pmatrix}1&2&0\\0&5&6\\7&0&9\end{pmatrix} $$
$$ A C=\det(A)\begin{pmatrix}1&0&0\\0&1&0\\0&0&1\end{pmatrix} $$
$$ F=C^T $$
$$ F=C $$
";
    assert_eq!(judged(sentences, text), "appr");
}

#[test]
fn a_matrix_of_angles_may_be_written_as_a_function_of_their_column() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$\phi$, $\theta$, $\psi$ are the Euler angles of B relative to N in the order 3, 2, 1.
$\eta=(\phi,\theta,\psi)^T$.
$R$ takes components on B to components on N.
$v$ is any vector.
";
    let text = r"
$$ R(\eta)^T R(\eta) = R^T R $$
$$ R(\eta) = R^T $$
";
    assert_eq!(judged(sentences, text), "pr");
}
