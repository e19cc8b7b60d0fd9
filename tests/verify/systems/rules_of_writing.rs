//! Axes by their names, numbers beside matrices, crosses with matrices, operators, and what is told of parts of a document.

use super::judged;

const TURNED: &str = r"N is an inertial frame.
B is a frame fixed in the body.
B turns relative to N about the third axis of N by the angle $a$.
$u$, $w$ are the axes x and z of N in components on N.
$R$ takes components on B to components on N.
";

#[test]
fn axes_are_those_that_are_named() {
    let text = r"
$$ u = (1, 0, 0) $$
$$ w = (0, 0, 1) $$
$$ w = (0, 1, 0) $$
$$ R w = w $$
$$ R u = u $$
$$ R u = (\cos a, \sin a, 0) $$
$$ f\cdot w = 1 $$
$$ f\cdot u = 1 $$
$$ e\cdot u = 1 $$
";
    let wordings = [
        "$e$, $f$ are the unit vectors along x and z of N.",
        "$e$, $f$ are the first and third axes of N.",
        "$e$, $f$ are the axes 1 and 3 of N.",
        "$f$, $e$ are the axes z and x of N.",
        "$e$ and $f$ are the x axis and the z axis of N.",
    ];
    for wording in wordings {
        let sentences = format!("{TURNED}{wording}\n");
        assert_eq!(judged(&sentences, text), "pprprpprp", "{wording}");
    }
}

const ATTITUDE: &str = r"N is an inertial frame.
B is a frame fixed in the body.
$R$ takes components on B to components on N.
$q$ takes components on B to components on N, scalar first.
$\omega$ is the angular velocity of B relative to N in components on B.
$\eta$ and $\epsilon$ are the scalar part and the vector part of the quaternion that takes components on B to components on N.
A number added to a matrix means that number times the identity matrix.
A cross as an exponent means the cross-product matrix.
A vector times a matrix with a cross means the cross product with each column of the matrix.
$w$ is the angular velocity of B relative to N in components on N.
$S(v)$ is the cross-product matrix of $v$, for any vector $v$.
";

#[test]
fn a_number_beside_a_matrix_is_that_many_times_the_identity() {
    let text = r"
$$ R = (\eta^2 - \epsilon^T\epsilon) + 2\epsilon\epsilon^T + 2\eta\epsilon^\times $$
$$ R = (\eta^2 - \epsilon^T\epsilon) + 2\epsilon\epsilon^T - 2\eta\epsilon^\times $$
$$ R R^T - 1 = 0 $$
$$ R + R^T - 1 = 0 $$
$$ \dot\epsilon = \frac12(\eta + \epsilon^\times)\omega $$
$$ \dot\epsilon = \frac12(\eta - \epsilon^\times)\omega $$
$$ \dot R = w\times R $$
$$ \dot R = \omega\times R $$
$$ w\times R = S(w) R $$
";
    assert_eq!(judged(ATTITUDE, text), "prprprprp");
}

#[test]
fn columns_rows_and_components_of_a_matrix() {
    let sentences = r"I is an inertial frame.
A is a frame that turns relative to I.
A turns relative to I about the third axis of I by the angle $s$.
$T$ takes components on A to components on I.
$v$ is any vector.
$C_X(v)$ means the components of $v$ on X, for any frame X and any vector $v$.
$\sigma$ is the trace of $T$.
$d$ is the determinant of $T$.
$H$ is the inverse of $T$.
$r_i$ is row $i$ of $T$ as a column.
$c_1$, $c_2$, $c_3$ are the columns of $T$.
$T^{-1}$ is the inverse of $T$.
$e_1$, $e_2$, $e_3$ are the axes of I in components on I.
$a_1$, $a_2$, $a_3$ are the axes of A in components on I.
";
    let text = r"
$$ C_A(v) = T^T C_I(v) $$
$$ C_A(v) = T C_I(v) $$
$$ \sigma = 1 + 2\cos s $$
$$ \sigma = 1 + \cos s $$
$$ d = 1 $$
$$ H = T^T $$
$$ H = T $$
$$ e_i = T r_i $$
$$ a_i = r_i $$
$$ r_1 = (\cos s, -\sin s, 0) $$
$$ c_1 = (\cos s, -\sin s, 0) $$
$$ c_1 = a_1 $$
$$ c_2 = a_1 $$
";
    assert_eq!(judged(sentences, text), "prprpprprprpr");
}

#[test]
fn a_box_may_be_any_vector_and_functions_may_lack_their_backslash() {
    let sentences = r"N is an inertial frame.
B is a frame that turns relative to N.
$u$ is a unit vector fixed in N.
$v$ is any vector in components on N.
$w$ is $v$ turned about $u$ by the angle $a$.
$\square^B$ is any vector in components on B.
$\omega^B$ is the angular velocity of B relative to N in components on B.
$\frac{d}{dt^N}$ is the rate seen from N in components on B.
$\frac{d}{dt^B}$ is the rate seen from B in components on B.
The particle is a particle of mass $m$.
P is the place of the particle.
O is a point fixed in N.
$p$ is the position of P from O in components on N.
$F$ is the total force on the particle in components on N.
";
    let text = r"
$$ w = v cos(a) + (u\times v) sin(a) + u (u\cdot v)(1 - cos(a)) $$
$$ w = v cos(a) - (u\times v) sin(a) + u (u\cdot v)(1 - cos(a)) $$
$$ \frac{d\square^B}{dt^N} = \frac{d\square^B}{dt^B} + \omega^B\times\square^B $$
$$ \frac{d\square^B}{dt^N} = \frac{d\square^B}{dt^B} - \omega^B\times\square^B $$
$$ F = m\ddot p $$
$$ F = -m\ddot p $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

#[test]
fn a_line_may_tell_how_a_frame_turns_of_which_no_sentence_tells_it() {
    let sentences = r"N is an inertial frame.
C is a frame that turns relative to N.
$x$, $z$ are the axes x and z of N in components on N.
$P$ is the matrix of the rotation by $a$ about $z$.
$Q$ is the matrix of the rotation by $b$ about $x$.
$T$ takes components on C to components on N.
A dot means the rate, entry by entry.
";
    let text = r"
$$ T = PQ $$
$$ \dot T = \dot P Q + P\dot Q $$
$$ T^T = T $$
$$ P^T P = T^T T $$
";
    assert_eq!(judged(sentences, text), "uurp");
}

#[test]
fn what_a_section_tells_anew_may_not_be_meant_in_a_section_inside() {
    let sentences = r#"N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in N and in B.
$R$ takes components on B to components on N.
$S(v)$ is the cross-product matrix of $v$, for any vector $v$.
$w$ is the angular velocity of B relative to N in components on N.
A dot means the rate, entry by entry.
In the section "Bodies" $w$ is the angular velocity of B relative to N in components on B.
In the section "Inside" $I$ is the inertia tensor of the body about O on B.
"#;
    let text = r"
# Bodies

$$ \dot R = R S(w) $$
$$ \dot R = S(w) R $$

## Inside

$$ \dot R = S(w) R $$
$$ \dot R = R S(w) $$
$$ \dot R = -S(w) R $$
";
    assert_eq!(judged(sentences, text), "prupr");
}

#[test]
fn the_quaternion_of_a_turn_about_an_axis_that_may_turn() {
    let sentences = r"A is an inertial frame.
B is a frame fixed in the body.
$\psi$, $\theta$, $\phi$ are the Euler angles of B relative to A in the order 3, 2, 1.
$q$ takes components on B to components on A, scalar first.
$q_0$, $q_1$, $q_2$, $q_3$ are the components of $q$.
$e$ is the column of $q_1$, $q_2$, $q_3$.
B is turned relative to A about the unit vector $n$ by the angle $c$.
$k$ is the column of $\phi$, $\theta$, $\psi$.
$h$ has the entries $\psi$, $\theta$.
";
    let text = r"
$$ e = n \sin(c/2) $$
$$ e = -n \sin(c/2) $$
$$ h = (\psi, \theta) $$
$$ h = (\theta, \psi) $$
$$ c = \psi $$
";
    assert_eq!(judged(sentences, text), "pupuu");
}

const AIRCRAFT: &str = r"N is an inertial frame.
B is a frame fixed in the body.
$\psi$, $\theta$, $\phi$ are the Euler angles of B relative to N in the order 3, 2, 1.
$\omega$ is the angular velocity of B relative to N in components on B.
$p$, $q$, $r$ are the components of $\omega$ on B.
$\cos\theta$ is not zero.
";

#[test]
fn what_takes_rates_and_what_takes_them_back() {
    let sentences = r"$H$ takes $p$, $q$, $r$ to the rates of $\phi$, $\theta$, $\psi$.
$K$ takes $\omega$ to the rates of $\phi$, $\theta$, $\psi$.
$T$ takes the rates of $\phi$, $\theta$, $\psi$ to $p$, $q$, $r$.
$1$ is the identity matrix.
";
    let text = r"
$$ H = \begin{bmatrix} 1 & sin(\phi)tan(\theta) & cos(\phi)tan(\theta) \\ 0 & cos(\phi) & -sin(\phi) \\
  0 & sin(\phi)/cos(\theta) & cos(\phi)/cos(\theta)\end{bmatrix} $$
$$ H = \begin{bmatrix} 1 & sin(\phi)tan(\theta) & cos(\phi)tan(\theta) \\ 0 & cos(\phi) & sin(\phi) \\
  0 & sin(\phi)/cos(\theta) & cos(\phi)/cos(\theta)\end{bmatrix} $$
$$ H = K $$
$$ H T = 1 $$
$$ H + T = 1 $$
$$ \begin{bmatrix} p \\ q \\ r\end{bmatrix} = T\begin{bmatrix} \dot\phi \\ \dot\theta \\ \dot\psi\end{bmatrix} $$
$$ \begin{bmatrix} p \\ q \\ r\end{bmatrix} = T^T\begin{bmatrix} \dot\phi \\ \dot\theta \\ \dot\psi\end{bmatrix} $$
";
    let sentences = format!("{AIRCRAFT}{sentences}");
    assert_eq!(judged(&sentences, text), "prpprpr");
}

#[test]
fn lists_of_matrices_of_turns_about_axes() {
    let sentences = r"$C$ takes components on N to components on B.
$A(v)$, $D(v)$, $E(v)$ take components on a frame to components on that frame turned about x, y, z by the angle $v$, for any angle $v$.
";
    let text = r"
$$ C = A(\phi) D(\theta) E(\psi) $$
$$ C = E(\psi) D(\theta) A(\phi) $$
$$ C(\phi, \theta, \psi) = A(\phi) D(\theta) E(\psi) $$
$$ p \in \R $$
";
    let sentences = format!("{AIRCRAFT}{sentences}");
    assert_eq!(judged(&sentences, text), "prp");
}

#[test]
fn labels_of_brackets_are_no_labels_of_letters() {
    let sentences = r"S is inertial and B is fixed in the body.
$Q$ takes components on S to components on B.
$L$ is the angular momentum of the body about its mass centre relative to S.
$J$ is the inertia tensor of the body about its mass centre.
$\omega$ is the angular velocity of the body relative to S.
";
    let text = r"
$$ [L]_B = [J]_B[\omega]_B $$
$$ [L]_S = Q^T[L]_B $$
$$ [J]_S = Q[J]_B Q^T $$
$$ L_B = [L]_B $$
";
    for told in [
        "Braces with a frame at the lower right, as in $[L]_B$, hold components on that frame.",
        "Brackets with a frame at the lower right mean components on that frame.",
        "The label $B$ on brackets means components on B. The label $S$ on brackets means components on S.",
    ] {
        let said = format!("{sentences}{told}\n");
        assert_eq!(judged(&said, text), "ppra", "{told}");
    }
}

#[test]
fn a_label_that_is_told_of_one_letter_is_that_of_this_letter() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
$C$ takes components on N to components on B.
$v$ and $u$ are any vectors.
The label $N$ on $v$ means components on N.
The label $B$ on $v$ means components on B.
";
    let text = r"
$$ v_B = C v_N $$
$$ v_N = C v_B $$
$$ u_B = C u_N $$
";
    assert_eq!(judged(sentences, text), "pra");
}
