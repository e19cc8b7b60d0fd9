//! Letters with one label, products that look like functions, wheels by their names, and moments by formulas.

use super::{judged, verdicts};

#[test]
fn the_letter_of_a_rotation_with_one_label_is_a_letter_of_its_own() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the aircraft.
$\psi$, $\theta$, $\phi$ are the Euler angles of B relative to N in the order z, y, x.
$R$ takes components on B to components on N.
";
    let text = r"
$$ R_3(\psi)=\begin{bmatrix}\cos\psi&-\sin\psi&0\\ \sin\psi&\cos\psi&0\\ 0&0&1\end{bmatrix} $$
$$ R_2(\theta)=\begin{bmatrix}\cos\theta&0&\sin\theta\\ 0&1&0\\ -\sin\theta&0&\cos\theta\end{bmatrix} $$
$$ R_1(\phi)=\begin{bmatrix}1&0&0\\ 0&\cos\phi&-\sin\phi\\ 0&\sin\phi&\cos\phi\end{bmatrix} $$
$$ R=R_3(\psi)R_2(\theta)R_1(\phi) $$
$$ R=R_1(\phi)R_2(\theta)R_3(\psi) $$
";
    assert_eq!(judged(sentences, text), "aaapr");
}

#[test]
fn what_is_said_of_a_rate_with_a_frame_beside_it_is_said_of_no_other() {
    let sentences = r"N is an inertial frame.
b is a frame fixed in the body.
C is the mass centre of the body.
$\frac{d}{dt}$ is the rate seen from N.
$\frac{{}^b d^2}{dt^2}$ is the second rate seen from b.
$\mathbf T$ is the total moment on the body about C.
$\mathbf h$ is the angular momentum of the body about C relative to N.
";
    let text = r"
$$ \mathbf T = \frac{d}{dt}\mathbf h $$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn a_vector_before_the_same_in_brackets_raised_to_t_is_no_function() {
    let sentences = r"N is an inertial frame.
b is a frame fixed in the body.
O is a point fixed in b.
C is the mass centre of the body.
The superscript $b$ means components on b.
$\mathbb{I}$ is the identity matrix.
$\mathbf J_C$ is the inertia tensor of the body about C.
$\mathbf J_O$ is the inertia tensor of the body about O.
$m$ is the mass of the body.
$\mathbf r$ is the position of O from C.
";
    let text = r"
$$ \mathbf J_O^b = \mathbf J_C^b+m(||\mathbf r^b||^2\mathbb{I}-\mathbf r^b(\mathbf r^b)^T) $$
$$ \mathbf J_O^b = \mathbf J_C^b+m(||\mathbf r^b||^2\mathbb{I}+\mathbf r^b(\mathbf r^b)^T) $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn moments_by_formulas_are_the_only_ones_along_an_axis() {
    let sentences = r"N is an inertial frame.
z is the upward vertical.
O is a point fixed in N.
D is a frame fixed in the door.
x, y and z are the axes of D.
D turns relative to N about the axis through O along z by the angle $\theta$.
The door is a uniform rectangular plate of mass $m$.
The door has the width $w$ along x and the height $h$ along z.
G is the mass centre of the door.
G lies at the distance $w/2$ from O along x.
$I$ is the moment of inertia of the door about the axis through O along z.
The moments $-k\theta$ and $-c\dot\theta$ are the only moments on the door along z.
";
    let text = r"
$$ I = \frac13 m w^2 $$
$$ I\ddot\theta + c\dot\theta + k\theta = 0 $$
$$ I\ddot\theta + c\dot\theta - k\theta = 0 $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_spring_exerts_a_moment_by_a_formula() {
    let sentences = r"N is an inertial frame.
z is the third axis of N.
B is a frame fixed in the rod.
B turns relative to N about z by the angle $\theta$.
$I$ is the moment of inertia of the rod about the axis through O along z.
O is a point fixed in N and in B.
A spring exerts the moment $-k\theta$ on the rod along z.
The moment $-k\theta$ is the only moment on the rod along z.
";
    let text = r"
$$ I\ddot\theta = -k\theta $$
$$ I\ddot\theta = k\theta $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_adds_to_what_is_known_in_words_that_are_not_understood_leaves_letters_as_they_are() {
    let sentences = r"N is an inertial frame.
G is the mass centre of the body.
B is a frame fixed in the body.
$\vec\omega$ is the angular velocity of B relative to N.
$\vec L$ is the angular momentum of the body about G relative to N.
$\mathbf I$ is the inertia tensor of the body about G.
$\vec v$ is the velocity of G relative to N.
The gribble of the body is a particle of mass $\mu$.
While it gribbles the force of the body obeys $F=\mu N$.
";
    let text = r"
$$ \vec L=\mathbf I\cdot\vec\omega $$
$$ \vec v=\vec 0 $$
";
    assert_eq!(verdicts(sentences, text).0, "pu");
    // What takes back what is assumed of all does not.
    let holed = format!("{sentences}The gribble of the body is a half of a particle.\n");
    assert_eq!(verdicts(&holed, text).0, "uu");
}
