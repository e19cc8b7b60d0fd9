//! Joined bodies of which only the loads are told that do work: their equations of motion by virtual power.

use super::{judged, verdicts};

#[test]
fn a_rod_on_a_cart() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
O is a point fixed in N.
The cart is a rigid body of mass $M$.
A is the mass centre of the cart.
The rod is a rigid body of mass $m$.
B is a frame fixed in the rod.
C is a frame fixed in the cart.
C does not turn relative to N.
$\hat x$ is the unit vector along x.
$\hat y$ is the unit vector along y.
A is placed from O by $s\,\hat x$.
A is a point fixed in B.
G is the mass centre of the rod.
G is placed from A by $l\sin\theta\,\hat x-l\cos\theta\,\hat y$.
B turns relative to N about z by the angle $\theta$.
$l$ is constant.
$J$ is the moment of inertia of the rod about the axis through G along z.
$g$ is the acceleration of gravity.
The force $F$ acts at A along x.
The force $F$ and the weights are the only loads that do work on the cart and the rod.
";
    let text = r"
$$ (M+m)\ddot s + m l\ddot\theta\cos\theta - m l\dot\theta^2\sin\theta = F $$
$$ (J + m l^2)\ddot\theta + m l\ddot s\cos\theta + m g l\sin\theta = 0 $$
$$ (J + m l^2)\ddot\theta + m l\ddot s\cos\theta - m g l\sin\theta = 0 $$
$$ (M+m)\ddot s + m l\ddot\theta\cos\theta = F $$
";
    assert_eq!(judged(sentences, text), "pprr");
    // What may tie the motion and is not worked with, and what nobody drives by a load, is not passed over.
    let tied = format!("{sentences}The cart slides on the wedge.\n");
    assert_eq!(verdicts(&tied, text).0, "uuuu");
    let driven = format!("{sentences}$s$ is a given function of the time.\n");
    assert_eq!(verdicts(&driven, text).0, "uuuu");
    // A list of all loads of two bodies leaves out the forces of their joint as well.
    let listed = sentences.replace("loads that do work on", "loads on");
    assert_eq!(judged(&listed, text), "pprr");
}

#[test]
fn a_double_pendulum() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
x points vertically downwards.
A is a frame fixed in link 1.
B is a frame fixed in link 2.
O is a point fixed in N and in link 1.
P is a point fixed in link 1 and in link 2.
A turns relative to N about z by the angle $\alpha$.
B turns relative to N about z by the angle $\beta$.
Link 1 is a uniform thin rod of mass $m$ and length $l$ along the first axis of A.
Link 2 is a uniform thin rod of mass $m$ and length $l$ along the first axis of B.
P lies at the distance $l$ from O along the first axis of A.
G is the mass centre of link 1.
H is the mass centre of link 2.
G lies at the distance $l/2$ from O along the first axis of A.
H lies at the distance $l/2$ from P along the first axis of B.
The pendulum consists of link 1 and link 2.
$g$ is the acceleration of gravity.
Only the weights do work on the pendulum.
$T$ is the kinetic energy of the pendulum.
$V$ is the potential energy of the pendulum.
The potential energy is zero at O.
";
    let text = r"
$$ \tfrac43 l\ddot\alpha+\tfrac12 l\ddot\beta\cos(\alpha-\beta)+\tfrac12 l\dot\beta^2\sin(\alpha-\beta)+\tfrac32 g\sin\alpha=0 $$
$$ \tfrac13 l\ddot\beta+\tfrac12 l\ddot\alpha\cos(\alpha-\beta)-\tfrac12 l\dot\alpha^2\sin(\alpha-\beta)+\tfrac12 g\sin\beta=0 $$
$$ \tfrac13 l\ddot\beta+\tfrac12 l\ddot\alpha\cos(\alpha-\beta)+\tfrac12 l\dot\alpha^2\sin(\alpha-\beta)+\tfrac12 g\sin\beta=0 $$
$$ \frac{d}{dt}(T+V)=0 $$
$$ V=-\tfrac32 m g l\cos\alpha-\tfrac12 m g l\cos\beta $$
";
    assert_eq!(judged(sentences, text), "pprpp");
}

#[test]
fn a_pendulum_on_a_driven_arm() {
    let sentences = r"
N is an inertial frame.
u is the upward vertical.
O is a point fixed in N.
A is a frame fixed in the arm.
B is a frame fixed in the rod.
The system consists of the arm and the rod.
The arm and the rod are rigid bodies.
e, f, u are the axes of A.
A turns relative to N about the axis through O along u by the angle $\psi$.
D is a point fixed in the arm and in the rod.
D lies at the distance $a$ from O along e.
B turns relative to A about the axis through D along e by the angle $\beta$.
q is a unit vector fixed in B.
q points along u when $\beta$ is zero.
G is the mass centre of the rod.
G lies at the distance $c$ from D along q.
$m$ is the mass of the rod.
$I$ is the moment of inertia of the rod about any axis through G normal to q.
The moment of inertia of the rod about the axis through G along q is zero.
$J$ is the moment of inertia of the arm about the axis through O along u.
$g$ is the acceleration of gravity.
$V$ is the potential energy of the rod.
The potential energy is zero at D.
$T$ is the kinetic energy of the system.
$L$ is the Lagrangian of the system.
$M$ is the moment of the motor on the arm along u.
The motor, the weights and the forces of the joints at O and D are the only loads.
$\partial/\partial\beta$ and $\partial/\partial\dot\beta$ take functions of $\psi$, $\beta$, $\dot\psi$, $\dot\beta$.
";
    let text = r"
$$ V = m g c\cos\beta $$
$$ L = T - V $$
$$ T=\tfrac12\left(J+m a^2+(I+m c^2)\sin^2\beta\right)\dot\psi^2+\tfrac12(I+m c^2)\dot\beta^2-m a c\cos\beta\,\dot\psi\dot\beta $$
$$ \frac{\partial L}{\partial\beta}=(I+m c^2)\sin\beta\cos\beta\,\dot\psi^2+m a c\sin\beta\,\dot\psi\dot\beta+m g c\sin\beta $$
$$ \frac{\partial L}{\partial\beta}=(I+m c^2)\sin\beta\cos\beta\,\dot\psi^2+m a c\sin\beta\,\dot\psi\dot\beta-m g c\sin\beta $$
$$ (I+m c^2)\ddot\beta-m a c\cos\beta\,\ddot\psi-(I+m c^2)\sin\beta\cos\beta\,\dot\psi^2-m g c\sin\beta=0 $$
$$ (I+m c^2)\ddot\beta-m a c\cos\beta\,\ddot\psi-(I+m c^2)\sin\beta\cos\beta\,\dot\psi^2+m g c\sin\beta=0 $$
$$ (J+m a^2+(I+m c^2)\sin^2\beta)\ddot\psi-m a c\cos\beta\,\ddot\beta+2(I+m c^2)\sin\beta\cos\beta\,\dot\beta\dot\psi+m a c\sin\beta\,\dot\beta^2=M $$
";
    assert_eq!(judged(sentences, text), "pppprprp");
}

#[test]
fn a_body_on_a_rolling_wheel() {
    let sentences = r"
N is an inertial frame.
i, j, k are the axes of N.
j is the upward vertical.
The road is a horizontal plane fixed in N.
O is a point of the road fixed in N.
All motion takes place in the plane of i and j.
The robot consists of the wheel and the chassis.
The wheel is a rigid body of mass $M$ and radius $R$.
The chassis is a rigid body of mass $m$.
F is a frame fixed in the chassis.
C is the mass centre of the wheel.
C is a point fixed in the chassis.
G is the mass centre of the chassis.
$\vec\imath$, $\vec\jmath$ and $\vec k$ are the unit vectors along i, j and k.
C is placed from O by $x\vec\imath+R\vec\jmath$.
G is placed from C by $h\sin\beta\,\vec\imath+h\cos\beta\,\vec\jmath$.
F turns relative to N about k by the angle $-\beta$.
The wheel turns relative to N about k by the angle $-\phi$.
Q is the point where the wheel touches the road.
The wheel rolls on the road at Q without slipping.
$h$ is constant.
$J$ is the moment of inertia of the wheel about the axis through C along k.
$I$ is the moment of inertia of the chassis about the axis through G along k.
$g$ is the acceleration of gravity.
$K$ is the moment of the chassis on the wheel along $-\vec k$.
The weights, the force of the road at Q and the moment $K$ with its reaction on the chassis are the only loads.
";
    let text = r"
$$ \dot x = R\dot\phi $$
$$ \left(M+m+\frac{J}{R^2}\right)\ddot x+m h\ddot\beta\cos\beta-m h\dot\beta^2\sin\beta=\frac{K}{R} $$
$$ (I+m h^2)\ddot\beta+m h\ddot x\cos\beta-m g h\sin\beta=-K $$
$$ (I+m h^2)\ddot\beta+m h\ddot x\cos\beta+m g h\sin\beta=-K $$
";
    assert_eq!(judged(sentences, text), "pppr");
}

#[test]
fn a_height_of_which_nothing_is_told_is_not_zero() {
    let sentences = r"
N is an inertial frame.
k is the upward vertical.
O is a point fixed in N.
A is a frame fixed in the arm.
The arm is a rigid body of mass $m$.
e, f, k are the axes of A.
A turns relative to N about the axis through O along k by the angle $\theta$.
$g$ is the acceleration of gravity.
$V$ is the potential energy of the arm.
The potential energy is zero at O.
";
    assert!(!judged(sentences, r"$$ V=0 $$").contains('p'));
}

/// What partial derivatives of a function take is told of that function.
#[test]
fn partial_derivatives_of_a_function_take_its_arguments() {
    let sentences = r"
R is an inertial frame.
i, j, k are the axes of R.
j is the upward vertical.
K is a frame fixed in the bar.
O is a point fixed in R and in K.
K turns relative to R about k by the angle $q$.
D is the mass centre of the bar.
D is placed from O by $a(\sin q\,i-\cos q\,j)$.
$m$ is the mass of the bar.
$J$ is the moment of inertia of the bar about the axis through O along k.
$g$ is the acceleration of gravity.
The weight and a force at O are the only loads on the bar.
The potential energy is zero at O.
$L$ is the Lagrangian of the bar.
$p$ is the generalised momentum of $q$.
Partial derivatives of $L$ take functions of $q$, $\dot q$.
";
    let text = r"
$$ L=\tfrac12 J\dot q^2+m g a\cos q $$
$$ p=J\dot q $$
$$ \frac{\partial L}{\partial q}=-m g a\sin q $$
$$ \frac{\partial L}{\partial\dot q}=p $$
$$ \frac{\partial L}{\partial q}=m g a\sin q $$
";
    assert_eq!(judged(sentences, text), "ppppr");
}
