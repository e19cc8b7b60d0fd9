//! What sentences leave to lines and to other sentences: given lines, defined letters, lists of loads, densities of shapes.

use super::judged;

#[test]
fn a_given_line_says_where_a_vector_points_by_which_others_are_placed() {
    let sentences = r"
N is an inertial frame.
$\vec i, \vec j, \vec k$ are the axes of N.
O is a point fixed in N.
P is placed from O by $s\,\vec i$.
G lies at the distance $a$ from P along $\vec n$.
$a$ is constant.
B turns relative to N about $\vec k$ by the angle $\theta$.
$\vec v$ is the velocity of G relative to N.
Line 2 is given.
";
    let text = r"
$$ \vec n=\sin\theta\,\vec i-\cos\theta\,\vec j $$
$$ \vec v=(\dot s+a\dot\theta\cos\theta)\,\vec i+a\dot\theta\sin\theta\,\vec j $$
$$ \vec v=(\dot s-a\dot\theta\cos\theta)\,\vec i+a\dot\theta\sin\theta\,\vec j $$
";
    assert_eq!(judged(sentences, text), "apr");
}

#[test]
fn a_letter_that_a_line_defines_may_be_constant_in_a_part() {
    let sentences = r"
N is an inertial frame.
A turns relative to N about $z$ by the angle $\psi$.
$x, y, z$ are the axes of A.
B turns relative to A about $x$ by the angle $\theta$.
$w$ is the angular velocity of B relative to N.
Line 2 defines $s$.
From line 4 on $s$ is constant.
";
    let text = r"
$$ s=\dot\psi+\dot\theta $$
$$ w=(s-\dot\theta) z+\dot\theta x $$
$$ \ddot\psi=-\ddot\theta $$
$$ \ddot\psi=\ddot\theta $$
";
    assert_eq!(judged(sentences, text), "appr");
}

#[test]
fn a_moment_that_only_the_list_of_loads_names_acts_on_the_body() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the craft.
G is the mass centre of the craft.
$H$ is the angular momentum of the craft about G relative to N.
The force $F$ acts at G.
The force $F$ and the moment $K$ are the only loads on the craft.
A dot over a vector means the rate seen from N.
";
    let text = r"
$$ \dot H=K $$
$$ \dot H=-K $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn one_of_many_forces_is_not_the_only_one() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the craft.
G is the mass centre of the craft.
$m$ is the mass of the craft.
$i$ numbers the rotors.
$P_i$ is placed from G by $r_i$.
The force $F_i$ acts at $P_i$.
The forces $F_i$ are the only loads on the craft.
$v$ is the velocity of G relative to N.
A dot over a vector means the rate seen from N.
";
    let text = r"
$$ m\dot v=F_1 $$
$$ m\dot v=0 $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn the_density_of_a_uniform_shape_is_its_mass_by_its_content() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the box.
$e_1, e_2, e_3$ are the axes of B.
The box is a uniform box of mass $M$ with the edges $a, b, c$ along $e_1, e_2, e_3$.
$\rho$ is the mass of the box per unit volume.
The rod is a uniform thin rod of mass $m$ and length $l$.
$\lambda$ is the density of the rod.
The disc is a uniform thin disc of mass $K$ and radius $R$.
$\sigma$ is the mass of the disc per unit area.
";
    let text = r"
$$ M=\rho a b c $$
$$ m=\lambda l $$
$$ K=\pi R^2\sigma $$
$$ M=\rho $$
";
    assert_eq!(judged(sentences, text), "pppr");
    let wrong = sentences.replace("per unit area", "per unit length");
    assert_eq!(judged(&wrong, r"$$ K=\pi R^2\sigma $$"), "u");
}

#[test]
fn the_mass_centre_of_one_and_of_another_is_that_of_each() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the hub.
A is a frame fixed in the wheel.
$s, t, g$ are the axes of A.
The craft consists of the hub and the wheel.
G is the mass centre of the hub and of the wheel.
The wheel is symmetric about $s$.
$J$ is the inertia tensor of the wheel about G.
$J_s$ is the moment of inertia of the wheel about the axis through G along $s$.
$J_t$ is the moment of inertia of the wheel about the axis through G along $t$.
$E$ is the identity tensor.
";
    let text = r"
$$ J s=J_s s $$
$$ J t=J_s t $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_the_equations_of_motion_drive_has_no_partial_derivative_of_its_own() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
The axes of B are principal axes of the body.
$A$, $A$, $C$ are the principal moments of the body about G on B.
$\omega$ is the angular velocity of B relative to N.
$p$, $q$, $n$ are the components of $\omega$ on B.
No moment acts on the body about G.
$f$ is the rate of $\omega$ seen from B in components on B.
$F = \partial f/\partial\omega$.
";
    let text = r"
$$ F=\frac{C-A}{A}\begin{pmatrix} 0 & -n & -q\\ n & 0 & p\\ 0&0&0\end{pmatrix} $$
$$ F=0 $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn rates_of_letters_with_raised_labels_are_what_sentences_say() {
    let sentences = r"
S is an inertial frame.
B is a frame that turns relative to S.
O is a point fixed in B.
Q is a point fixed in S.
p is a particle of mass $m$.
$r^a$ is the position of p from O in components on S.
$s$ is the position of p from Q in components on S.
$u$ is the position of O from Q in components on S.
$\dot{r}^a$ is the velocity of p relative to B in components on S.
$\omega$ is the angular velocity of B relative to S in components on S.
";
    let text = r"
$$ \dot s=\dot u+\dot{r}^a+\omega\times r^a $$
$$ \dot s=\dot u+\dot{r}^a-\omega\times r^a $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_meaning_that_cannot_be_read_is_none() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in N and in B.
$J$ is the inertia tensor of the body about O.
$w$ is the angular velocity of B relative to N.
$T$ is the kinetic energy of the body relative to N.
$J w^2$ means $w)+$.
";
    assert_eq!(judged(sentences, "$$ 2T=J w^2 $$"), "u");
}

#[test]
fn an_axis_that_is_a_unit_vector_in_the_same_part_is_no_other_vector() {
    let sentences = r"
N is an inertial frame.
From line 3 on E is a frame fixed in the Earth.
From line 3 on $K$ is the third axis of E.
From line 3 on $K$ is a unit vector fixed in N and in E.
From line 3 on E turns relative to N about $K$ at the constant rate $\Omega$.
From line 3 on $\vec\Omega$ is the angular velocity of E relative to N.
";
    let text = r"
$$ a=b $$
$$ \vec\Omega=\Omega K $$
$$ \vec\Omega=-\Omega K $$
";
    assert_eq!(judged(sentences, text), "apr");
}

#[test]
fn the_potential_energy_that_a_sentence_names_is_all_of_it() {
    let sentences = r"
N is an inertial frame.
$i, j, k$ are the axes of N.
$k$ is the upward vertical.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $\ell\sin\theta\, i-\ell\cos\theta\, k$.
$\ell$ is constant.
$g$ is the acceleration of gravity.
$T$ is the kinetic energy of P relative to N.
$V$ is the potential energy of P.
$L$ is the Lagrangian of P.
The weight and the force $S$ are the only loads on P.
";
    let text = r"
$$ L=T-V $$
$$ L=T+V $$
";
    assert_eq!(judged(sentences, text), "pr");
    let silent = sentences.replace("$V$ is the potential energy of P.\n", "");
    assert_eq!(judged(&silent, r"$$ L=T $$"), "u");
}

#[test]
fn columns_of_the_identity_matrix_and_definitions_of_numbers() {
    let sentences = r"
N is an inertial frame.
B turns relative to N about $z$ by the angle $\psi$.
$x, y, z$ are the axes of B.
$R$ takes components on B to components on N.
$e$ is the first column of the identity matrix.
$c=\cos\psi$.
$F=\partial c/\partial\psi$.
";
    let text = r"
$$ R e=\begin{pmatrix}\cos\psi\\ \sin\psi\\ 0\end{pmatrix} $$
$$ R e=\begin{pmatrix}\cos\psi\\ -\sin\psi\\ 0\end{pmatrix} $$
$$ F=-\sin\psi $$
$$ F=\sin\psi $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_formula_for_an_angle_or_a_place_is_no_letter_of_its_own() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
B turns relative to N about $z$ by the angle $\theta$.
$\omega$ is constant.
$\theta=\omega t$.
$w$ is the angular velocity of B relative to N.
P is placed from O by $s x$.
$s=b\sin\theta$.
$b$ is constant.
$v$ is the velocity of P relative to N.
";
    let text = r"
$$ w=\omega z $$
$$ w=2\omega z $$
$$ v=b\omega\cos\theta\, x $$
$$ v=b\omega\sin\theta\, x $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_matrix_is_told_by_what_it_makes_of_any_vector() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
$\psi$, $\theta$, $\phi$ are the Euler angles of B relative to N in the order z, y, x.
$\cos\theta$ is not zero.
$\vec\omega$ is the angular velocity of B relative to N in components on B.
Line 2 defines $\Phi$.
Line 3 defines $E(\Phi)$.
";
    let text = r"
$$ \Phi = \begin{bmatrix} \phi \\ \theta \\ \psi \end{bmatrix} $$
$$ \dot\Phi = E(\Phi)\vec\omega $$
$$ E(\Phi) = \begin{bmatrix} 1 & \tan\theta\sin\phi & \tan\theta\cos\phi \\ 0 & \cos\phi & -\sin\phi \\ 0 & \sin\phi/\cos\theta & \cos\phi/\cos\theta \end{bmatrix} $$
$$ E(\Phi) = \begin{bmatrix} 1 & \tan\theta\sin\phi & \tan\theta\cos\phi \\ 0 & \cos\phi & \sin\phi \\ 0 & \sin\phi/\cos\theta & \cos\phi/\cos\theta \end{bmatrix} $$
";
    assert_eq!(judged(sentences, text), "aapr");
}

#[test]
fn a_number_that_a_line_defines_stands_in_sentences() {
    let sentences = r"N is an inertial frame.
$\Omega$ and $e_1$ are constant.
$\rho=\Omega/e_1$.
Line 2 defines $e_1$.
";
    let text = "
$$ e_1 = 3\\Omega $$
$$ 3\\rho = 1 $$
$$ 2\\rho = 1 $$
";
    assert_eq!(judged(sentences, text), "apr");
}

#[test]
fn of_two_definitions_of_a_letter_the_first_holds() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle $a$.
$w$ is the angular velocity of A relative to N.
Lines 2 and 3 define $p$.
";
    let text = r"
$$ p = \dot a $$
$$ p = 2\dot a $$
$$ w = 0 $$
";
    assert_ne!(judged(sentences, text).pop(), Some('p'));
}
