//! Columns of two in plane motion, matrices of rates, letters with labels above, names that are words.

use super::{judged, verdicts};

const LABELS: &str = r"
$\alpha$ is a frame.
$\beta$ is a frame.
$\gamma$ is a frame that turns relative to $\beta$.
A is the origin of $\alpha$.
P is the origin of $\beta$.
A moves relative to $\beta$.
$\mathbf{r}^{\beta}_{\beta \alpha}$ is the position of A from P in components on $\beta$.
$\mathbf{v}^{\gamma}_{\beta \alpha}$ is the velocity of A relative to $\beta$ in components on $\gamma$.
$\mathbf{a}^{\beta}_{\beta \alpha}$ is the acceleration of A relative to $\beta$ in components on $\beta$.
$\mathbf{R}^{\gamma}_{\beta}$ takes components on $\beta$ to components on $\gamma$.
$\boldsymbol{\Omega}^{\gamma}_{\beta \gamma}$ is the cross-product matrix of the angular velocity of $\gamma$ relative to $\beta$ in components on $\gamma$.
A dot means the rate entry by entry.
";

#[test]
fn a_dot_stands_over_a_letter_with_labels_on_both_sides() {
    let text = r"
$$ \mathbf{a}^{\beta}_{\beta \alpha} = \ddot{\mathbf{r}}^{\beta}_{\beta \alpha} $$
$$ \mathbf{v}^{\gamma}_{\beta \alpha} = \mathbf{R}^{\gamma}_{\beta}\dot{\mathbf{r}}^{\beta}_{\beta \alpha} $$
$$ \dot{\mathbf{R}}^{\gamma}_{\beta} = -\boldsymbol{\Omega}^{\gamma}_{\beta \gamma}\mathbf{R}^{\gamma}_{\beta} $$
$$ \dot{\mathbf{R}}^{\gamma}_{\beta} = \boldsymbol{\Omega}^{\gamma}_{\beta \gamma}\mathbf{R}^{\gamma}_{\beta} $$
";
    assert_eq!(judged(LABELS, text), "pppr");
}

#[test]
fn a_frame_may_be_called_by_a_word_of_the_language() {
    let sentences = r"
World is an inertial frame.
Local is a frame fixed in the body.
The body is rigid.
$R$ takes components on Local to components on World.
$w$ is the angular velocity of Local relative to World in components on Local.
$W$ is the angular velocity of Local relative to World in components on World.
";
    let text = "
$$ W = R w $$
$$ w = R W $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn columns_of_two_hold_what_is_in_the_plane_of_motion() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the vessel.
The vessel is a rigid body.
The vessel moves in the plane of the first two axes of N.
O is a point fixed in N.
G is the mass centre of the vessel.
B turns relative to N about the third axis of N by the angle $\psi$.
$\mathbf{F}$ is the position of G from O in components on N.
$u$, $v$ are the components of the velocity of G relative to N on B.
$r$ is the angular velocity of B relative to N along the third axis of N.
$\mathbf{R}(\psi)$ takes components on B to components on N.
A dot means the rate entry by entry.
Units in brackets are notes.
";
    let text = r"
$$ \dot{\mathbf{F}} = \mathbf{R}(\psi) \begin{bmatrix} u \\ v \end{bmatrix} $$
$$ \ddot{\mathbf{F}} = \dot{\mathbf{R}}(\psi) \begin{bmatrix} u \\ v \end{bmatrix} + \mathbf{R}(\psi) \begin{bmatrix} \dot{u} \\ \dot{v} \end{bmatrix} $$
$$ \ddot{\mathbf{F}} = \mathbf{R}(\psi) \begin{bmatrix} \dot{u} - v r \\ \dot v + u r \end{bmatrix} $$
$$ \ddot{\mathbf{F}} = \mathbf{R}(\psi) \begin{bmatrix} \dot{u} + v r \\ \dot v - u r \end{bmatrix} $$
";
    assert_eq!(judged(sentences, text), "pppr");
}

#[test]
fn a_matrix_takes_the_rates_of_angles_to_components() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the craft.
$\psi, \theta, \phi$ are the Euler angles of B relative to N in the order z, y, x.
$\omega$ is the angular velocity of B relative to N in components on B.
$\theta$ lies between $-\pi/2$ and $\pi/2$.
$T$ takes the column of the rates of $\phi, \theta, \psi$ to the components of $\omega$ on B.
";
    let text = r"
$$ T = \begin{bmatrix} 1 & 0 & -\sin\theta \\ 0 & \cos\phi & \sin\phi\cos\theta \\ 0 & -\sin\phi & \cos\phi\cos\theta \end{bmatrix} $$
$$ T = \begin{bmatrix} 1 & 0 & -\sin\theta \\ 0 & \cos\phi & \sin\phi\cos\theta \\ 0 & \sin\phi & \cos\phi\cos\theta \end{bmatrix} $$
$$ \omega = T \begin{bmatrix} \dot\phi \\ \dot\theta \\ \dot\psi \end{bmatrix} $$
$$ \omega = T \begin{bmatrix} \dot\psi \\ \dot\theta \\ \dot\phi \end{bmatrix} $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_letter_may_be_the_quotient_of_what_other_sentences_tell() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the vessel.
B turns relative to N about z at the rate $r$.
z is a unit vector fixed in N and in B.
G is the mass centre of the vessel.
$M$ is the total moment on the vessel about G along z.
$\tau$ is $M$ divided by the moment of inertia of the vessel about the axis through G along z.
z is a principal axis of the vessel about G.
";
    let text = r"
$$ \tau = \dot r $$
$$ \tau = 2\dot r $$
";
    let (verdicts, misread) = verdicts(sentences, text);
    assert!(misread.is_empty(), "{misread:?}");
    assert_eq!(verdicts, "pr");
}

#[test]
fn a_letter_of_a_number_is_that_of_the_vector_where_only_this_fits() {
    let sentences = r"
N is an inertial frame.
A is a frame fixed in the disc.
$x$, $y$, $z$ are the axes of A.
A turns relative to N about $z$ at the rate $\omega$.
A bare formula: $\omega = \omega z$.
G is the mass centre of the disc.
G is a point fixed in N and in A.
$H$ is the angular momentum of the disc about G relative to N.
$r$ is a vector fixed in A.
A dot means the rate seen from N.
";
    let text = r"
$$ \dot r = \omega\times r $$
$$ \dot r = -\omega\times r $$
";
    assert_eq!(judged(sentences, text), "pr");
}
