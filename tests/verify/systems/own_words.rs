//! Models told in sentences of the author's own: several things in one, names by their use, quantities of wholes, shapes.

use super::verdicts;

#[test]
fn what_turns_is_a_frame_and_what_has_a_velocity_a_point() {
    let sentences = "\
N is an inertial frame.
S turns relative to N.
O is a point fixed in S.
$\\vec r$ is the position of P from O.
$\\vec\\omega$ is the angular velocity of S relative to N.
$\\vec u$ is the velocity of P relative to S.
$\\vec v$ is the velocity of P relative to N.
$\\vec v_O$ is the velocity of O relative to N.
";
    let text = r"
$$ \vec v=\vec v_O+\vec u+\vec\omega\times\vec r $$
$$ \vec v=\vec v_O+\vec u-\vec\omega\times\vec r $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn the_entries_of_an_array_are_told_with_it() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
$\\lambda$, $\\mu$ are the Euler angles of B relative to N in the order z, x.
$w=(w_1,w_2,w_3)^T$ is the angular velocity of B relative to N in components on B.
";
    let text = r"
$$ w_2=\dot\lambda\sin\mu $$
$$ w_3=\dot\lambda\sin\mu $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_quantity_of_two_things_is_that_of_both() {
    let sentences = "\
N is an inertial frame.
P is a particle of mass $m$ and Q is a particle of mass $M$.
$\\vec u$ and $\\vec v$ are the velocities of P and Q relative to N.
$T$ is the kinetic energy of P and Q together.
";
    let text = r"
$$ T=\frac12m\vec u\cdot\vec u+\frac12M\vec v\cdot\vec v $$
$$ T=\frac12m\vec u\cdot\vec u $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn the_axis_of_symmetry_has_a_letter() {
    let sentences = "\
N is an inertial frame.
The body is symmetric about $\\vec e$, and $\\vec e$ is a unit vector fixed in the body.
G is the mass centre of the body.
$K$ is the moment of inertia of the body about the axis through G along $\\vec e$.
$J$ is the moment of inertia of the body about any axis through G normal to $\\vec e$.
$\\vec\\omega$ is the angular velocity of the body relative to N.
$\\vec L$ is the angular momentum of the body about G relative to N.
";
    let text = r"
$$ \vec L=J\vec\omega+(K-J)(\vec\omega\cdot\vec e)\vec e $$
$$ \vec L=J\vec\omega+(J-K)(\vec\omega\cdot\vec e)\vec e $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn the_sides_of_a_box_lie_along_its_axes() {
    let sentences = "\
B is a frame fixed in the block.
x, y, z are the axes of B.
The block is a uniform box of mass $m$ with the edges $a$, $b$, $c$ along x, y, z.
G is the mass centre of the block.
$J$ is the inertia tensor of the block about G in components on B.
";
    let text = r"
$$ J=\frac{m}{12}\begin{pmatrix}b^2+c^2&0&0\\0&a^2+c^2&0\\0&0&a^2+b^2\end{pmatrix} $$
$$ J=\frac{m}{12}\begin{pmatrix}a^2+c^2&0&0\\0&b^2+c^2&0\\0&0&a^2+b^2\end{pmatrix} $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_cone_has_an_apex() {
    let sentences = "\
The top is a uniform solid cone of mass $m$, height $h$ and base radius $r$.
O is the apex of the cone, and G is its mass centre.
$d$ is the distance of G from O.
$J$ is the moment of inertia of the cone about any axis through O normal to the axis of symmetry.
$K$ is the moment of inertia of the cone about its axis of symmetry.
";
    let text = r"
$$ d=\frac34h $$
$$ K=\frac{3}{10}mr^2 $$
$$ J=\frac35m\left(h^2+\frac{r^2}{4}\right) $$
$$ J=\frac35m\left(h^2+\frac{r^2}{2}\right) $$
";
    assert_eq!(verdicts(sentences, text).0, "pppr");
}

#[test]
fn a_momentum_points_along_an_axis() {
    let sentences = "\
N is an inertial frame with the axes X, Y, Z.
B is a frame fixed in the body, and G is the mass centre of the body.
$A$, $A$, $C$ are the principal moments of the body about G on B.
$\\vec L$ is the angular momentum of the body about G relative to N, and $L$ is its magnitude.
$\\vec L$ points along Z.
$\\alpha$, $\\beta$, $\\gamma$ are the Euler angles of B relative to N in the order z, x, z.
$\\sin\\beta$ is not zero.
";
    let text = r"
$$ \dot\alpha=\frac{L}{A} $$
$$ \dot\beta=0 $$
";
    assert_eq!(verdicts(sentences, text).0, "pp");
}

#[test]
fn what_is_small_tells_what_it_stands_beside() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
The axes of B are principal axes of the body.
$J_1$, $J_2$, $J_3$ are the principal moments of the body about its mass centre on B.
No moment acts on the body about its mass centre.
$w_1$, $w_2$, $w_3$ are the components on B of the angular velocity of the body relative to N.
$w_1=s+a$, $w_2=b$ and $w_3=c$.
$s$ is a constant.
$a$, $b$, $c$ are small, and all formulas hold to first order in them.
";
    let text = r"
$$ J_1\dot a=0 $$
$$ J_2\dot b=(J_3-J_1)sc $$
";
    assert_eq!(verdicts(sentences, text).0, "pp");
}

#[test]
fn a_wheel_is_mounted_on_its_axis() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the hub.
The spacecraft consists of the hub and the wheel.
The wheel is symmetric about its axis $\\hat a$, a unit vector fixed in B.
The wheel turns relative to B about $\\hat a$ at the rate $s$.
$K$ is the moment of inertia of the wheel about its axis.
$J$ is the inertia tensor of the whole spacecraft, the wheel included, about C.
C is the mass centre of the spacecraft.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\vec H$ is the angular momentum of the spacecraft about C relative to N.
";
    let text = r"
$$ \vec H=J\vec\omega+Ks\hat a $$
";
    assert_eq!(verdicts(sentences, text).0, "p");
}

#[test]
fn a_weight_that_is_written_out_tells_the_letter_of_gravity() {
    let sentences = "\
N is an inertial frame.
$\\vec k$ is the unit vector along the upward vertical.
P is a particle of mass $m$.
$\\vec a$ is the acceleration of P relative to N.
The weight of magnitude $mg$ and the force $\\vec F$ are the only loads on P.
";
    let text = r"
$$ m\vec a=\vec F-mg\vec k $$
$$ m\vec a=\vec F+mg\vec k $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn values_are_told_in_turn() {
    let sentences = "\
N is an inertial frame.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
The reference values of $p$, $q$, $r$ are $0$, $0$, $\\Omega$, respectively.
$\\alpha$, $\\beta$, $\\gamma$ are the small disturbances of $p$, $q$, $r$, respectively.
";
    let text = r"
$$ q=\beta $$
$$ q=\Omega+\beta $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn an_axis_of_a_turn_is_fixed_in_both_frames() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the hub.
W is a frame fixed in the wheel.
W turns relative to B about $\\hat a$ at the rate $s$.
$\\hat a$ is a unit vector fixed in B.
$\\vec\\omega$ is the angular velocity of B relative to N.
$w_1$, $w_2$, $w_3$ are the components on W of the angular velocity of W relative to N.
A dot means the rate seen from N.
";
    let text = r"
$$ \dot{\hat a} = \vec\omega\times\hat a $$
$$ \dot{\hat a} = \hat a\times\vec\omega $$
";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_letter_that_means_a_formula_says_nothing_of_the_letter_before() {
    let sentences = "\
N is an inertial frame.
The rotor is a rigid body.
$J$ is the mass of the rotor, and $h$ means $J s$.
$s$ is a constant.
";
    let text = "$$ h = J s $$\n\n$$ h = J $$\n";
    assert_eq!(verdicts(sentences, text).0, "pr");
}

#[test]
fn a_lagrangian_without_its_potential_energy_is_none() {
    let sentences = "\
N is an inertial frame, and z is the upward vertical.
P is a particle of mass $m$.
$g$ is the acceleration of gravity.
$v$ is the speed of P relative to N.
$L$ is the Lagrangian of P.
The potential energy is zero at the gribble of O.
";
    assert_eq!(verdicts(sentences, "$$ L = \\frac12 m v^2 $$\n").0, "u");
}

#[test]
fn what_is_not_understood_of_a_thing_may_take_back_what_is_assumed_of_all() {
    let proved = |sentence: &str, text: &str| {
        let said = format!("N is an inertial frame.\n{sentence}\n");
        verdicts(&said, text).0
    };
    let axes = "A is a frame.\n$i$, $j$, $k$ are the axes of A.\n";
    let cross = "$$ i\\times j = k $$\n";
    assert_eq!(proved(axes, cross), "p");
    assert_eq!(
        proved(&format!("{axes}A is a left-handed frame."), cross),
        "u"
    );
    let oblique = format!("{axes}A is a frame whose axes are not orthogonal.");
    assert_eq!(proved(&oblique, "$$ i\\cdot j = 0 $$\n"), "u");
    let disc = "The disc is a uniform thin disc of mass $m$ and radius $r$.\n\
        $J$ is the moment of inertia of the disc about its axis.\n";
    let moment = "$$ J = \\frac12 m r^2 $$\n";
    assert_eq!(proved(disc, moment), "p");
    assert_eq!(proved(&format!("{disc}The disc has a hole."), moment), "u");
}

#[test]
fn a_letter_d_with_a_mark_is_no_differential() {
    let sentences = "\
B is a frame fixed in the body.
G is the mass centre of the body, and O is a point fixed in B.
$m$ is the mass of the body.
$d$ is the position of G from O in components on B.
$J$ and $K$ are the inertia tensors of the body about G and about O in components on B.
$E$ is the identity matrix.
A tilde means the cross-product matrix.
";
    let text = r"
$$ K = J - m\,\tilde d\,\tilde d $$
$$ K = J + m\,(d^T d\,E - d\,d^T) $$
$$ K = J + m\,\tilde d\,\tilde d $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
    let placed = [sentences, "G lies at the distance $l$ from O along $-z$.\n"].concat();
    assert_eq!(verdicts(&placed, "$$ l=\\frac34h $$").0, "u");
}

#[test]
fn the_axis_of_a_cone_goes_from_its_apex_and_momenta_belong_to_coordinates() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the cone.
x, y, z are the axes of B.
Z is the upward vertical.
The cone is a uniform cone of mass $M$, radius $R$ and height $h$.
O is the apex of the cone.
O is a point fixed in N and in B.
z is the axis of symmetry of the cone.
G is the mass centre of the cone.
$a$, $b$, $c$ are the Euler angles of B relative to N in the order Z, x, z.
$a$, $b$, $c$ are the generalised coordinates.
$g$ is the acceleration of gravity.
The weight and the force at O are the only loads on the cone.
$I$, $J$, $K$ are the principal moments of the cone about O on B.
The potential energy is zero at O.
$V$ is the potential energy of the cone.
$L$ is the Lagrangian of the cone.
$p$ is the generalised momentum of $a$.
";
    let text = r"
$$ V=\frac34Mgh\cos b $$
$$ p=I\sin^2b\,\dot a+K(\dot a\cos b+\dot c)\cos b $$
$$ p=I\sin^2b\,\dot a+K(\dot a\cos b+\dot c) $$
";
    assert_eq!(verdicts(sentences, text).0, "ppr");
    let placed = [sentences, "G lies at the distance $l$ from O along $-z$.\n"].concat();
    assert_eq!(verdicts(&placed, "$$ l=\\frac34h $$").0, "u");
}
