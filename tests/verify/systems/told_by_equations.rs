//! Letters that sentences tell by equations: periods, eigenvalues, rotations about vectors, values at steps; and what drives
//! wheels.

use super::{judged, judged_in_any_order};

#[test]
fn a_period_and_a_frequency_are_those_of_harmonic_oscillations() {
    let sentences = "N is an inertial frame.
$x$ is a function of the time.
$k$ and $m$ are positive.
$k$ and $m$ are constant.
$m \\ddot x = -k x$.
$x$ is not zero.
$T$ is the period of $x$.
$f$ is the frequency of $x$.
";
    let text = r"
$$ k T^2 = 4 \pi^2 m $$
$$ k T^2 = 2 \pi^2 m $$
$$ f T = 1 $$
$$ f T = 2 $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn an_eigenvalue_is_a_root_of_the_characteristic_equation() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the body.
G is the mass centre of the body.
$J_1$, $J_2$, $J_3$ are the principal moments of the body about G on B.
$J$ is the inertia tensor of the body about G in components on B.
$\\lambda$ is an eigenvalue of $J$.
";
    let text = r"
$$ (\lambda - J_1)(\lambda - J_2)(\lambda - J_3) = 0 $$
$$ (\lambda - J_1)(\lambda - J_2)(\lambda + J_3) = 0 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_rotation_by_the_length_of_a_vector_is_that_of_rodrigues() {
    let sentences = "$W(v)$ is the cross-product matrix of $v$, for any vector $v$.
$Q(v)$ is the matrix of the rotation by $|v|$ about $v$, for any vector $v$.
$n$ is a unit vector.
$a$ is any vector.
$\\beta$ is constant.
$E$ is the identity matrix.
";
    let text = r"
$$ Q(\beta n) = \cos\beta\, E + \sin\beta\, W(n) + (1 - \cos\beta) n n^T $$
$$ Q(\beta n) = \cos\beta\, E - \sin\beta\, W(n) + (1 - \cos\beta) n n^T $$
$$ Q(-a) = Q(a)^T $$
$$ Q(-a) = Q(a) $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_turn_by_a_letter_in_capitals_is_told_by_a_matrix() {
    let sentences = [
        "A is an inertial frame.",
        "B is turned relative to A by $R$.",
        "$\\mathbf a_1$, $\\mathbf a_2$, $\\mathbf a_3$ are the axes of A.",
        "$\\mathbf b_1$, $\\mathbf b_2$, $\\mathbf b_3$ are the axes of B.",
        "$R_{21}$ is entry (2, 1) of $R$.",
    ];
    let text = r"
$$ \mathbf a_2 \cdot \mathbf b_1 = R_{21} $$
$$ \mathbf a_1 \cdot \mathbf b_2 = R_{21} $$
";
    judged_in_any_order(&sentences, text, "pr");
}

#[test]
fn values_at_steps_follow_the_step() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the body.
G is the mass centre of the body.
$A$, $B$, $C$ are the principal moments of the body about G on B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
$L$, $M$, $N$ are the components on B of the total moment on the body about G.
$p_k$, $q_k$, $r_k$, $L_k$ and $t_k$ are the values of $p$, $q$, $r$, $L$ and $t$ at step $k$; the step is explicit Euler.
";
    let text = r"
$$ p_{k+1} = p_k + \frac{t_{k+1} - t_k}{A}\left(L_k + (B - C) q_k r_k\right) $$
$$ p_{k+1} = p_k + \frac{t_{k+1} - t_k}{A} L_k $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn wheels_are_parts_of_the_whole_whichever_sentence_comes_first() {
    let sentences = [
        "N is an inertial frame.",
        "B is a frame fixed in the hub.",
        "$i$ numbers the wheels.",
        "The spacecraft consists of the hub and the wheels.",
        "Wheel $i$ turns relative to B about $g_i$ at the rate $\\Omega_i$.",
        "Wheel $i$ is symmetric about $g_i$.",
        "The mass centre of wheel $i$ is fixed in B.",
        "$g_i$ is a unit vector fixed in B.",
        "C is the mass centre of the spacecraft.",
        "$\\omega$ is the angular velocity of B relative to N.",
        "$I$ is the inertia tensor of the spacecraft about C.",
        "$J_i$ is the moment of inertia of wheel $i$ about $g_i$.",
        "$H$ is the angular momentum of the spacecraft about C relative to N.",
        "$h_i$ is the angular momentum of wheel $i$ about its mass centre relative to N along $g_i$.",
        "$u_i$ is the moment of the hub on wheel $i$ along $g_i$.",
        "The moment of the hub is the only moment on wheel $i$ along $g_i$.",
    ];
    let text = r"
$$ H = I \omega + \sum_i J_i \Omega_i g_i $$
$$ H = I \omega $$
$$ h_i = J_i (\Omega_i + g_i \cdot \omega) $$
$$ h_i = J_i \Omega_i $$
$$ u_i = J_i (\dot\Omega_i + g_i \cdot \dot\omega) $$
$$ u_i = J_i \dot\Omega_i $$
";
    judged_in_any_order(&sentences, text, "prprpr");
}

#[test]
fn the_only_moment_along_an_axis_drives_one_wheel() {
    let sentences = "N is an inertial frame.
G is a frame fixed in the gimbal, and x, y, z are the axes of G.
$p$, $q$, $r$ are the components on G of the angular velocity of G relative to N.
The wheel turns relative to G about x at the rate $\\Omega$.
The wheel is symmetric about x.
$A$, $B$, $B$ are the principal moments of the wheel about its mass centre on G.
$u$ is the moment of the gimbal on the wheel along x.
The moment of the gimbal is the only moment on the wheel along x.
";
    let text = r"
$$ u = A (\dot p + \dot\Omega) $$
$$ u = A \dot\Omega $$
";
    assert_eq!(judged(sentences, text), "pr");
}
