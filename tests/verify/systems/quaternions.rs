//! Attitudes by quaternions: their products, their rates and the matrix that they make.

use super::judged;

const ATTITUDE: &str = "N is an inertial frame.
B is a frame fixed in the body.
$\\vec\\omega$ is the angular velocity of B relative to N in components on B.
$\\omega_1$, $\\omega_2$ and $\\omega_3$ are the components of $\\vec\\omega$ on B.
$R$ takes components on B to components on N.
$\\vec v$ is any vector in components on B.
";

const SCALAR_FIRST: &str = "$\\mathbf q$ takes components on B to components on N, scalar first.
$q_0$, $q_1$, $q_2$, $q_3$ are the components of $\\mathbf q$.
$\\vec p$ is the vector part of $\\mathbf q$.
$\\otimes$ is the quaternion product.
";

#[test]
fn the_rate_of_a_quaternion_follows_the_angular_velocity() {
    let text = r"
$$ \dot{\mathbf q} = \frac12\mathbf q\otimes\begin{bmatrix} 0 \\ \vec\omega\end{bmatrix} $$
$$ \dot{\mathbf q} = \frac12\begin{bmatrix} 0 \\ \vec\omega\end{bmatrix}\otimes\mathbf q $$
$$ \dot{\mathbf q} = \mathbf q\otimes\vec\omega $$
$$ \dot{\mathbf q} = \frac12\mathbf q\otimes(0, \vec\omega) $$
$$ \vec\omega = 2\mathbf q^*\otimes\dot{\mathbf q} $$
$$ \dot q_1 = \frac12(q_0\omega_1 + q_2\omega_3 - q_3\omega_2) $$
$$ \dot q_1 = \frac12(q_0\omega_1 - q_2\omega_3 + q_3\omega_2) $$
$$ \dot{\vec p} = \frac12(q_0\vec\omega + \vec p\times\vec\omega) $$
$$ \dot{\vec p} = \frac12(q_0\vec\omega - \vec p\times\vec\omega) $$
$$ \dot{\mathbf q} = \frac12\begin{bmatrix} 0 & -\omega_1 & -\omega_2 & -\omega_3 \\
  \omega_1 & 0 & \omega_3 & -\omega_2 \\ \omega_2 & -\omega_3 & 0 & \omega_1 \\
  \omega_3 & \omega_2 & -\omega_1 & 0\end{bmatrix}\mathbf q $$
";
    let sentences = format!("{ATTITUDE}{SCALAR_FIRST}");
    assert_eq!(judged(&sentences, text), "prrppprprp");
}

#[test]
fn a_unit_quaternion_makes_the_matrix_of_its_rotation() {
    let text = r"
$$ \mathbf q\otimes\mathbf q^{-1} = \begin{bmatrix} 1 \\ 0 \\ 0 \\ 0\end{bmatrix} $$
$$ |\mathbf q| = 1 $$
$$ q_0^2 + q_1^2 + q_2^2 - q_3^2 = 1 $$
$$ R = (q_0^2 - \vec p\cdot\vec p)\mathbf 1 + 2\vec p\vec p^T + 2q_0[\vec p]_\times $$
$$ R = (q_0^2 - \vec p\cdot\vec p)\mathbf 1 + 2\vec p\vec p^T - 2q_0[\vec p]_\times $$
$$ \begin{bmatrix} 0 \\ R\vec v\end{bmatrix} = \mathbf q\otimes\vec v\otimes\mathbf q^* $$
$$ \begin{bmatrix} 0 \\ R\vec v\end{bmatrix} = \mathbf q^*\otimes\vec v\otimes\mathbf q $$
";
    let sentences = format!("{ATTITUDE}{SCALAR_FIRST}$\\mathbf 1$ is the identity matrix.\n");
    assert_eq!(judged(&sentences, text), "pprprpr");
}

#[test]
fn the_scalar_may_stand_last_and_the_matrix_may_go_the_other_way() {
    let sentences = format!(
        "{ATTITUDE}$\\mathbf q$ takes components on N to components on B, scalar last.
$q_1$, $q_2$, $q_3$, $q_4$ are the components of $\\mathbf q$.
"
    );
    let text = r"
$$ \dot q_4 = \frac12(q_1\omega_1 + q_2\omega_2 + q_3\omega_3) $$
$$ \dot q_4 = -\frac12(q_1\omega_1 + q_2\omega_2 + q_3\omega_3) $$
$$ \dot{\mathbf q} = -\frac12\begin{bmatrix} \vec\omega \\ 0\end{bmatrix}\otimes\mathbf q $$
";
    assert_eq!(judged(&sentences, text), "prp");
}

#[test]
fn quaternions_side_by_side_are_multiplied_and_numbers_beside_them_are_scalars() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$q$ takes components on B to components on N, scalar first.
$q$ and $p$ are unit quaternions.
$p$ takes components on N to components on B, scalar first.
Letters side by side are the Hamilton product of quaternions.
$w$ is the angular velocity of B relative to N in components on N, written as a quaternion with the scalar part zero.
$u$ is the angular velocity of B relative to N in components on B, written as a pure quaternion with scalar part zero.
A star means the conjugate.
";
    let text = r"
$$ \dot q=\tfrac12 w q $$
$$ \dot q=\tfrac12 q w $$
$$ \dot q=\tfrac12 q u $$
$$ w = q u q^* $$
$$ q p = 1 $$
$$ q p = -1 $$
";
    assert_eq!(judged(sentences, text), "prpppr");
}

#[test]
fn quaternions_of_two_frames_that_turn_against_a_third_are_composed() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
D is a frame that turns relative to N.
$q$ takes components on B to components on N, scalar first.
$p$ takes components on D to components on N, scalar first.
$r$ takes components on B to components on D, scalar first.
$\eta$ is the scalar part of $r$.
$\epsilon$ is the vector part of $r$.
A star means the conjugate.
";
    let text = r"
$$ r=p^* q $$
$$ r=q p^* $$
$$ \eta^2+\epsilon^T\epsilon=1 $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn a_quaternion_that_is_written_as_two_has_a_scalar_part_and_a_vector_part() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
$\omega$ is the angular velocity of B relative to N in components on B.
";
    let text = r"
$$ \dot\eta = -\frac12 e^T\omega $$
$$ \dot\eta = \frac12 e^T\omega $$
$$ \eta^2+e^Te = 1 $$
";
    for told in [
        r"$(\eta, e)$ takes components on B to components on N, scalar first.",
        r"$(e, \eta)$ takes components on B to components on N, scalar last.",
        r"$q=(\eta, e)$ is the unit quaternion that takes components on B to components on N, with the scalar part first.",
    ] {
        let said = format!("{sentences}{told}\n");
        assert_eq!(judged(&said, text), "prp", "{told}");
    }
}
