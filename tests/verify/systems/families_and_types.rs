//! Wheels of a family and what they have together, counted parts by their names, letters by their type and their sign.

use super::judged;

#[test]
fn wheels_have_an_angular_momentum_relative_to_what_carries_them() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the platform.
The craft consists of the platform and the wheels.
$k$ numbers the wheels.
G is the mass centre of the craft.
Wheel $k$ is symmetric about $\mathbf{s}_k$.
$\mathbf{s}_k$ is a unit vector fixed in B.
Wheel $k$ turns relative to B about $\mathbf{s}_k$ at the rate $\nu_k$.
The mass centre of wheel $k$ lies on its axis $\mathbf{s}_k$ and is fixed in B.
$J_k$ is the moment of inertia of wheel $k$ about the axis through its mass centre along $\mathbf{s}_k$.
$n$ is the number of the wheels.
$\boldsymbol{\omega}$ is the angular velocity of B relative to N in components on B.
$\mathbf{I}$ is the inertia tensor of the craft about G in components on B.
$\mathbf{h}$ is the angular momentum of the wheels relative to B in components on B.
$\mathbf{H}$ is the angular momentum of the craft about G relative to N in components on B.
$\mathbf{D}$ is the rate of $\mathbf{H}$ seen from N in components on B.
A dot over a letter means the rate, entry by entry.
";
    let text = r"
$$ \mathbf{h} = \sum_{k=1}^{n} J_k\nu_k\mathbf{s}_k $$
$$ \mathbf{H} = \mathbf{I}\boldsymbol{\omega} + \mathbf{h} $$
$$ \mathbf{H} = \mathbf{I}\boldsymbol{\omega} - \mathbf{h} $$
$$ \mathbf{D} = \dot{\mathbf{H}} + \boldsymbol{\omega}\times\mathbf{H} $$
$$ \mathbf{D} = \dot{\mathbf{H}} - \boldsymbol{\omega}\times\mathbf{H} $$
";
    assert_eq!(judged(sentences, text), "pprpr");
}

#[test]
fn parts_that_are_counted_are_those_that_have_names() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
O is a point fixed in N and in B.
The body consists of two particles.
P is a particle of mass $m$.
Q is a particle of mass $n$.
P lies at the distance $r$ from O along z.
Q lies at the distance $s$ from O along $-z$.
$a$, $b$, $c$ are the components of the angular velocity of B relative to N on B.
$L$ is the angular momentum of the body about O relative to N.
$d$, $e$, $f$ are the components of $L$ on B.
";
    let text = r"
$$ d = (m r^2 + n s^2) a $$
$$ d = m r^2 a $$
$$ f = 0 $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn letters_without_bold_type_are_magnitudes() {
    let sentences = r"N is an inertial frame.
O is a point fixed in N.
P is a particle of mass $m$.
$\mathbf r$ is the position of P from O.
$\mathbf v$ is the velocity of P relative to N.
$\mathbf p$ is the momentum of P relative to N.
A letter of a vector without bold type is its magnitude.
";
    let text = r"
$$ p = m v $$
$$ p = 2 m v $$
$$ r^2 = \mathbf r\cdot\mathbf r $$
$$ v = \dot r $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn what_is_not_negative_is_the_root_of_its_square() {
    let sentences = r"N is an inertial frame.
$A$ is a real constant and not negative.
$b$ is a positive constant.
$c$ is never negative.
$c$ is a scalar.
$s$ is a unit.
A brace before several equations means that all of them hold.
Double bars mean the magnitude.
";
    let text = r"
$$ \sqrt{A^2} = A $$
$$ \sqrt{A^2} = -A $$
$$ |b| = b $$
$$ \sqrt{c^2} = c $$
";
    assert_eq!(judged(sentences, text), "prpp");
}

#[test]
fn the_angle_between_vectors_may_be_written_with_both() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the hub.
A is a frame fixed in the gimbal.
A turns relative to B about $g$ at the rate $\dot d$.
$g$ is a unit vector fixed in B.
$\mathbf{h}$ is a vector fixed in A, the angular momentum of the rotor relative to A.
$h$ is the magnitude of $\mathbf{h}$.
$\angle(g, \mathbf{h})$ is the angle between $g$ and $\mathbf{h}$.
$g\cdot\mathbf{h}=0$.
$\mathbf{M}$ is the opposite of the rate of $\mathbf{h}$ seen from B.
";
    let text = r"
$$ \mathbf{M} = -\dot d\,g\times\mathbf{h} $$
$$ \lVert\mathbf{M}\rVert = |\dot d| h \sin\angle(g,\mathbf{h}) $$
$$ \cos\angle(g,\mathbf{h}) = 1 $$
$$ \lVert\mathbf{M}\rVert = 2|\dot d| h $$
";
    assert_eq!(judged(sentences, text), "pprr");
}
