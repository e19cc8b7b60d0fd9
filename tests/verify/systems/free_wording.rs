//! Models told in the free wording of engineers: relative clauses, asides, words that lean on other sentences.

use super::judged;

#[test]
fn a_body_on_which_nothing_acts() {
    let sentences = r"
The top is a rigid body on which no force and no torque acts.
The laboratory is an inertial frame.
The moving frame is fixed in the top; its axes $e_1$, $e_2$, $e_3$ are the principal axes of inertia and meet at the centre of mass.
O is the centre of mass of the top.
O stays at rest in the laboratory.
$A$, $B$ and $C$ are the principal moments of inertia about O, in that order of the axes.
They satisfy $A < B < C$.
$\boldsymbol{w}$ is the angular velocity of the top with respect to the laboratory.
$p$, $q$, $r$ are its projections on the moving axes.
$\mathbf{L}$ is the angular momentum of the top about O with respect to the laboratory.
$L_1$, $L_2$, $L_3$ are the projections of $\mathbf{L}$ on the moving axes, and $L$ is its magnitude.
$T$ is the kinetic energy of the top, which is not zero.
A dot over a letter is its derivative with respect to time.
The dot between two bold letters is the scalar product.
";
    let text = r"
$$ A\dot p=(B-C)qr $$
$$ A\dot p=(C-B)qr $$
$$ L^2=A^2p^2+B^2q^2+C^2r^2 $$
$$ L=L_1 $$
$$ \mathbf L\cdot\boldsymbol w=2T $$
$$ \mathbf L\cdot\boldsymbol w=T $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

#[test]
fn a_rod_that_lies_along_an_axis_from_its_end() {
    let sentences = r"
The mallet is a rigid body made up of a handle and a head.
The handle is a thin uniform rod whose mass is $m_1$ and whose length is $l$.
The head is a solid uniform circular cylinder of mass $m_2$, radius $r$ and length $h$.
A is the lower end of the handle.
The upper end of the handle is the mass centre of the head.
K is a frame fixed in the mallet, with its origin at A and its axes called x, y and z.
The z axis points from A along the handle towards the head.
The axis of the cylinder is parallel to x.
S is the centre of mass of the mallet.
$c$ is the z coordinate of S, measured from A.
$J$ is the inertia tensor of the mallet about A, and $H$ the one about S; both are matrices on K.
$J_{xx}$, $J_{yy}$ and $J_{zz}$ are the diagonal entries of $J$.
$a$, $b$ and $d$ are the moments of inertia of the handle about the lines through A parallel to x, y and z.
";
    let text = r"
$$ c=\frac{\frac12m_1l+m_2l}{m_1+m_2} $$
$$ c=\frac{m_1l+m_2l}{m_1+m_2} $$
$$ J_{xx}=\frac13m_1l^2+m_2\left(\frac12r^2+l^2\right) $$
$$ J_{yy}=\frac13m_1l^2+m_2\left(\frac14r^2+\frac1{12}h^2+l^2\right) $$
$$ J_{yy}=J_{xx} $$
$$ d=0 $$
$$ a=\frac13m_1l^2 $$
$$ d=a $$
";
    assert_eq!(judged(sentences, text), "prpprppr");
}

#[test]
fn moments_about_several_lines_and_the_corresponding_ones() {
    let sentences = r"
B is a frame fixed in the body.
x, y, z are the axes of B.
G is the mass centre of the body.
$A$, $C$, $D$ are the principal moments of inertia of the body about G on B.
$I$, $J$, $K$ are the moments of inertia of the body about the lines through G parallel to x, y and z.
";
    let text = r"
$$ I=A $$
$$ J=C $$
$$ J=A $$
$$ K=D $$
";
    assert_eq!(judged(sentences, text), "pprp");
}

#[test]
fn the_corresponding_moments_of_another_body() {
    let sentences = r"
The rod is a uniform thin rod of mass $m$ and length $l$ along z.
The disc is a uniform disc of mass $M$ and radius $r$.
B is a frame fixed in the rod.
The disc is fixed in B.
The disc is symmetric about x.
x, y, z are the axes of B.
P is the mass centre of the rod, and Q that of the disc.
$a$ and $b$ are the moments of inertia of the rod about the lines through P parallel to x and z.
$c$ and $d$ are the corresponding moments of inertia of the disc about Q.
";
    let text = r"
$$ a=\frac1{12}ml^2 $$
$$ b=0 $$
$$ c=\frac12Mr^2 $$
$$ d=\frac14Mr^2 $$
$$ d=\frac12Mr^2 $$
";
    assert_eq!(judged(sentences, text), "ppppr");
}

#[test]
fn a_unit_vector_by_its_angle_with_an_axis() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$\mathbf{w}$ is the angular velocity of the body relative to N.
$p$, $q$, $r$ are the components of $\mathbf{w}$ on B.
$\mathbf{n}$ is a unit vector that lies in the plane of x and y and makes the angle $\alpha$ with x, counted from x towards y.
$s$ is the component of $\mathbf{w}$ along $\mathbf{n}$.
";
    let text = r"
$$ s=p\cos\alpha+q\sin\alpha $$
$$ s=p\cos\alpha-q\sin\alpha $$
$$ s=q\cos\alpha+p\sin\alpha $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn a_letter_that_a_formula_tells_is_no_free_direction() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$\mathbf{w}$ is the angular velocity of the body relative to N.
$p$, $q$, $r$ are the components of $\mathbf{w}$ on B.
$\alpha$ is a number.
$\mathbf{n}$ is $\cos\alpha\,x+\sin\alpha\,y$.
$s$ is the component of $\mathbf{w}$ along $\mathbf{n}$.
";
    let text = r"
$$ s=p\cos\alpha+q\sin\alpha $$
$$ s=p\cos\alpha-q\sin\alpha $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn remarks_change_nothing_and_frames_are_named_by_their_use() {
    let sentences = r"
We work in an inertial frame N.
$\mathcal B$ and $\mathcal G$ are frames fixed in the platform and in the gimbal respectively.
The system is composed of two rigid bodies, namely the platform and the gimbal.
$\hat{\boldsymbol a}$, $\hat{\boldsymbol b}$, $\hat{\boldsymbol c}$ are the right-handed orthonormal axes of $\mathcal G$.
They are named after spin, transverse and gimbal.
$\hat{\boldsymbol c}$ is fixed in the platform as well, and the gimbal turns about it by the angle $\gamma$ relative to the platform.
For any two frames X and Y, $\boldsymbol\omega_{X/Y}$ means the angular velocity of X with respect to Y.
$\boldsymbol\omega$ without a subscript is that of $\mathcal B$ with respect to N.
A script letter at the upper left of a vector says on which frame its components are written; at the upper left of a $d$ it says from which frame the rate is seen.
$p$, $q$ and $r$ are the components of $\boldsymbol\omega$ on $\mathcal G$.
$R$ is the direction cosine matrix which maps components on $\mathcal G$ into components on $\mathcal B$.
Line 10 introduces $k$.
";
    let text = r"
$$ \boldsymbol\omega_{\mathcal G/\mathcal B}=\dot\gamma\hat{\boldsymbol c} $$
$$ \frac{{}^{\mathcal B}d}{dt}\hat{\boldsymbol a}=\dot\gamma\hat{\boldsymbol b} $$
$$ \frac{{}^{\mathcal B}d}{dt}\hat{\boldsymbol a}=-\dot\gamma\hat{\boldsymbol b} $$
$$ p=\hat{\boldsymbol a}\cdot\boldsymbol\omega $$
$$ p=\hat{\boldsymbol b}\cdot\boldsymbol\omega $$
$$ R\,{}^{\mathcal G}\boldsymbol\omega={}^{\mathcal B}\boldsymbol\omega $$
";
    assert_eq!(judged(sentences, text), "pprprp");
}

#[test]
fn a_place_of_two_bodies_and_a_fluid_between_them() {
    let sentences = r"
The satellite comprises a rigid carrier and a rigid homogeneous ball.
N is a Newtonian reference frame.
C is a frame attached to the carrier.
S is the mass centre of the satellite and, at the same time, the centre of the ball.
The satellite is free of external forces and torques.
$\vec\omega$ is the angular velocity of the carrier in N.
The ball has the angular velocity $\vec\sigma$ relative to the carrier.
$J$ is the moment of inertia of the ball about any of its diameters.
The fluid exerts the torque $-c\vec\sigma$ on the ball and the opposite torque on the carrier, $c$ being a positive constant.
No other torque about S acts on the ball.
$\vec H$ is the satellite's central angular momentum in N, and $H$ its length.
A prime on a vector means that it is differentiated in C; a dot on a scalar is its time derivative.
";
    let text = r"
$$ J(\vec\omega\,'+\vec\sigma\,'+\vec\omega\times\vec\sigma)=-c\vec\sigma $$
$$ J(\vec\omega\,'+\vec\sigma\,'+\vec\omega\times\vec\sigma)=c\vec\sigma $$
$$ J(\vec\omega\,'+\vec\sigma\,')=-c\vec\sigma $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn there_is_the_part_of_the_document_before() {
    let sentences = r"
N is an inertial frame.
G is the mass centre of the body.
$m$ is the mass of the body.
On line 2, $\vec u$ is the velocity of G relative to N.
There $\vec p$ is the momentum of the body relative to N.
";
    let text = r"
$$ \vec p=m\vec u $$
$$ \vec p=m\vec u $$
";
    assert_eq!(judged(sentences, text), "pa");
}

#[test]
fn its_acceleration_is_that_of_the_point_and_not_of_its_velocity() {
    let sentences = r"
N is inertial.
P is a particle of mass $m$.
$\mathbf{v}$ is the velocity of P with respect to N.
$\mathbf{a}$ is its acceleration with respect to N.
$v_1$, $v_2$, $v_3$ are the components of $\mathbf{v}$ on N, and $v$ is its magnitude.
A dot over a letter is its derivative with respect to time.
";
    let text = r"
$$ v^2=v_1^2+v_2^2+v_3^2 $$
$$ v=v_1 $$
$$ v\dot v=\mathbf{v}\cdot\mathbf{a} $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn a_transpose_of_what_is_described_is_not_that_itself() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$R$ is the transpose of the rotation matrix that takes components on B to components on N.
$\vec v$ is a vector.
A frame at the upper left of a vector says on which frame its components are written.
";
    let text = r"
$$ R\,{}^{B}\vec v={}^{N}\vec v $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_value_at_which_something_vanishes_makes_it_vanish() {
    let sentences = r"N is an inertial frame.
$a$, $b$ and $\Omega$ are constant.
$b$ is positive.
$\Omega_1$ is the value of $\Omega$ at which $a - b\Omega$ is zero.
";
    let text = r"
$$ \Omega_1 = \frac{a}{b} $$
$$ \Omega = \frac{a}{b} $$
";
    assert_eq!(judged(sentences, text), "pr");
}
