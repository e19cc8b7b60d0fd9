//! What is said in the plainest words: what points down, a particle, other vectors on other axes, products in brackets.

use super::{judged, verdicts};

#[test]
fn bodies_are_told_apart_by_the_word_before_their_noun() {
    let sentences = "\
N is an inertial frame.
$m$ is the mass of the rod assembly, and $M$ is the mass of the wheel assembly.
P is the mass centre of the rod assembly, and Q is the mass centre of the wheel assembly.
$u$ and $v$ are the velocities of P and Q relative to N.
$p$ is the momentum of the rod assembly relative to N, and $q$ that of the wheel assembly.
";
    let text = r"
$$ p=m u $$
$$ q=M v $$
$$ q=m v $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_quaternion_and_angles_tell_of_one_turn() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
B turns relative to N about $\\vec u$ by the angle $\\theta$.
$\\vec u$ is a unit vector.
$q$ takes components on B to components on N, scalar last.
$s$ is the scalar part of $q$.
$\\vec q$ is the vector part of $q$.
$\\vec v$ is any vector in components on B.
$w$ is the same vector in components on N.
";
    let text = r"
$$ s=\cos\frac\theta2 $$
$$ \vec q=\vec u\sin\frac\theta2 $$
$$ w=q\,\vec v\,q^{-1} $$
$$ w=q^{-1}\,\vec v\,q $$
$$ \vec q=\vec u\sin\theta $$
";
    assert_eq!(judged(sentences, text), "ppprr");
}

#[test]
fn rates_of_a_quaternion_beside_euler_angles() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to N in the order z, y, x.
$q$ takes components on B to components on N, scalar first.
$a$, $b$, $c$, $d$ are the elements of $q$.
$\\omega$ is the angular velocity of B relative to N in components on B.
$p$, $r$, $s$ are the components of $\\omega$.
";
    let text = r"
$$ \dot a=-\frac12(b p+c r+d s) $$
$$ \dot a=\frac12(b p+c r+d s) $$
$$ p=\dot\phi-\dot\psi\sin\theta $$
$$ 2(b d-a c)=-\sin\theta $$
$$ 2(b d-a c)=\sin\theta $$
";
    assert_eq!(judged(sentences, text), "prppr");
}

#[test]
fn quaternions_may_be_any() {
    let sentences = "\
$a$ and $b$ are any quaternions, scalar first.
$a_0$, $a_1$, $a_2$, $a_3$ are the elements of $a$.
$b_0$, $b_1$, $b_2$, $b_3$ are the elements of $b$.
$ab$ is the Hamilton product of $a$ and $b$.
A star means the conjugate of a quaternion.
";
    let text = r"
$$ ab=\begin{pmatrix}a_0b_0-a_1b_1-a_2b_2-a_3b_3\\a_0b_1+a_1b_0+a_2b_3-a_3b_2\\a_0b_2-a_1b_3+a_2b_0+a_3b_1\\a_0b_3+a_1b_2-a_2b_1+a_3b_0\end{pmatrix} $$
$$ a_0=b_0 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn half_angles_tell_whole_ones_that_come_later() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N.
B is a frame fixed in the body.
$q$ takes components on B to components on N, scalar first.
B turns relative to N about z by the angle $\\theta$.
$R$ takes components on B to components on N.
$a$, $b$, $c$, $d$ are the elements of $q$.
";
    let text = r"
$$ a=\cos\frac\theta2 $$
$$ a^2-d^2=\cos\theta $$
$$ R=\begin{pmatrix}a^2-d^2&-2ad&0\\2ad&a^2-d^2&0\\0&0&1\end{pmatrix} $$
$$ a^2+d^2=\cos\theta $$
";
    assert_eq!(judged(sentences, text), "pppr");
}

#[test]
fn a_particle_and_what_points_down() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N.
z points down.
O is a point fixed in N.
$m$ is the mass of a particle.
$\\vec r$ is the position of the particle from O.
$\\vec v$ is the velocity of the particle relative to N.
$\\vec L$ is the angular momentum of the particle about O relative to N.
$W$ is the component along z of the weight of the particle.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \vec L=m\,\vec r\times\vec v $$
$$ \vec L=m\,\vec v\times\vec r $$
$$ W=m g $$
$$ W=-m g $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn products_of_two_vectors_in_brackets() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$\\omega$ is the angular velocity of B relative to N in components on B.
$L$ is the angular momentum of the body about G relative to N in components on B.
$J$ is the inertia tensor of the body about G in components on B.
$M$ is the total moment on the body about G in components on B.
$T$ is the kinetic energy of rotation of the body.
$[a,b]$ is the cross product of $a$ and $b$, for any vectors $a$ and $b$.
$(a,b)$ is the dot product of $a$ and $b$.
";
    let text = r"
$$ J\dot\omega+[\omega,J\omega]=M $$
$$ J\dot\omega-[\omega,J\omega]=M $$
$$ [\omega,[\omega,L]]=\omega(\omega,L)-L(\omega,\omega) $$
$$ 2T=(\omega,L) $$
";
    assert_eq!(judged(sentences, text), "prpp");
}

#[test]
fn frames_that_are_turned_and_their_matrices() {
    let sentences = "\
N is a frame.
x, y, z are the axes of N.
P is the frame turned relative to N about z by the angle $\\alpha$.
$R$ takes components on N to components on P.
$M(a)$ takes components on a frame to components on the frame turned relative to it about its third axis by the angle $a$.
$c_\\alpha$ and $s_\\alpha$ mean $\\cos\\alpha$ and $\\sin\\alpha$.
";
    let text = r"
$$ R=\begin{pmatrix}c_\alpha&s_\alpha&0\\-s_\alpha&c_\alpha&0\\0&0&1\end{pmatrix} $$
$$ R=M(\alpha) $$
$$ R=M(-\alpha) $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_wheel_whose_height_above_its_contact_is_told() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N.
z is the upward vertical.
The floor is a horizontal plane fixed in N.
B is a frame fixed in the wheel.
B turns relative to N about y by the angle $\\phi$.
G is the mass centre of the wheel.
Q is the point where the wheel touches the floor.
G lies at the height $R$ above Q.
The wheel rolls on the floor at Q without slipping.
$v$ is the component along x of the velocity of G relative to N.
";
    let text = r"
$$ v=R\dot\phi $$
$$ v=-R\dot\phi $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn the_force_without_the_weight() {
    let sentences = "\
N is an inertial frame.
G is the mass centre of the rotor.
$m$ is the mass of the rotor.
$v$ is the velocity of G relative to N.
$F$ is the total force on the rotor without its weight.
$\\vec g$ is the acceleration of gravity.
";
    let text = r"
$$ m\dot v=F+m\vec g $$
$$ m\dot v=F $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn rounded_decimals_keep_their_own_lines_open() {
    let sentences = "\
N is an inertial frame.
$v$ and $w$ are constant.
Decimal numbers are rounded to the digits shown.
";
    let text = r"
$$ \frac13=0.333 $$
$$ \frac13=\frac14 $$
";
    assert_eq!(judged(sentences, text), "ur");
}

#[test]
fn angles_about_the_cross_product_of_two_axes() {
    let sentences = "\
N is an inertial frame.
$x$ and $y$ are the first two axes of N.
$y$ is the upward vertical.
$\\mathbf{i}$ is the unit vector along $x$.
$\\mathbf{j}$ is the unit vector along $y$.
P is a point fixed in N and in the pendulum.
G is the mass centre of the pendulum.
The pendulum turns relative to N about the axis through P along $\\mathbf{i}\\times\\mathbf{j}$.
$\\mathbf{R}$ is the position of G from P.
$R$ is the magnitude of $\\mathbf{R}$.
$\\theta$ is the angle from $-\\mathbf{j}$ to $\\mathbf{R}$ about $\\mathbf{i}\\times\\mathbf{j}$.
$a$ and $b$ are the components of $\\mathbf{R}$ on N.
";
    let text = r"
$$ a=R\sin\theta $$
$$ b=-R\cos\theta $$
$$ a=-R\sin\theta $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_pendulum_that_hangs_below_its_pivot_where_its_angle_is_zero() {
    let sentences = "\
N is an inertial frame.
S is a frame fixed in the arm.
n is a horizontal unit vector fixed in N.
O is a point fixed in N and in S.
G is the mass centre of the arm.
G lies at the distance $l$ from O.
S turns relative to N about the axis through O along n by the angle $\\theta$.
At $\\theta=0$ G lies vertically below O.
$m$ is the mass of the arm.
$J$ is the moment of inertia of the arm about the axis through O along n.
$g$ is the acceleration of gravity.
$V$ is the potential energy of the arm, which is zero at O.
The weight and the force at O are the only loads on the arm.
";
    let text = r"
$$ V=-mgl\cos\theta $$
$$ J\ddot\theta=-mgl\sin\theta $$
$$ V=mgl\cos\theta $$
$$ J\ddot\theta=mgl\sin\theta $$
";
    assert_eq!(judged(sentences, text), "pprr");
}

#[test]
fn the_only_particle_is_the_one_that_is_told() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P lies at the distance $s$ from O along x.
$T$ is the kinetic energy of the particle relative to N.
";
    let text = r"
$$ T=\frac12m\dot s^2 $$
$$ T=m\dot s^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_turns_is_no_particle() {
    let sentences = "\
N is an inertial frame.
$m$ is the mass of A.
$w$ is the angular velocity of A relative to N.
$v$ is the velocity of A relative to N.
$T$ is the kinetic energy of A relative to N.
";
    let text = r"
$$ T=\frac12m v\cdot v $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn products_in_brackets_of_other_factors_are_not_worked_with() {
    let sentences = "\
N is an inertial frame.
$c$ and $d$ are vectors fixed in N.
$[a,b]$ is the cross product of $b$ and $a$.
";
    let text = r"
$$ [c,d]=d\times c $$
$$ [c,d]=c\times d $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn where_a_body_of_any_form_touches_moves_on_its_own() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
The third axis of N is the upward vertical.
The ground is a horizontal plane fixed in N.
C is the point where the body touches the ground.
The body rolls on the ground at C without slipping.
$\\omega$ is the angular velocity of B relative to N.
$\\gamma$ is the position of C from G.
";
    let text = r"
$$ \dot\gamma=\omega\times\gamma $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn parts_of_an_angle_that_come_up_later_tell_it() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N.
B is a frame fixed in the body.
B turns relative to N about z by the angle $\\theta$.
";
    let text = r"
$$ \sin^2\theta+\cos^2\theta=1 $$
$$ \cos\theta=2\cos^2\frac\theta2-1 $$
$$ \cos\theta=2\cos^2\frac\theta2 $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_vector_that_points_up_is_no_unit_vector() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
$\\omega$ is the angular velocity of B relative to N.
$\\omega$ points up.
";
    let text = r"
$$ \omega\cdot\omega=1 $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

#[test]
fn a_rule_that_is_not_worked_with_keeps_its_sign_open() {
    let sentences = "\
N is an inertial frame.
$c$ and $d$ are vectors fixed in N.
A cross means the tensor product.
";
    let text = r"
$$ c\times d=d\times c $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_unit_quaternion_is_not_any() {
    let sentences = "\
$q$ is a unit quaternion, scalar first.
$a$, $b$, $c$, $d$ are the elements of $q$.
";
    assert_eq!(judged(sentences, "$$ a^2+b^2+c^2+d^2=1 $$\n"), "u");
}

#[test]
fn quaternions_of_two_layouts_are_not_worked_with() {
    let sentences = "\
$q$ is any quaternion, scalar last.
$p$ is any quaternion, scalar first.
$a$, $b$, $c$, $d$ are the elements of $q$.
$s$ is the scalar part of $q$.
";
    assert_eq!(judged(sentences, "$$ s=a $$\n"), "u");
}
