//! Points and rods by vectors and angles about axes, dyads, and what letters and marks say by themselves.

use super::judged;

#[test]
fn a_rod_lies_along_the_vector_from_its_end_to_its_middle() {
    let sentences = r"N is an inertial frame.
x, y, z are the axes of N.
y is the downward vertical.
B is a frame fixed in the rod.
The rod is a uniform thin rod of mass $m$ and length $l$.
O is a point fixed in N and in B.
O is an end of the rod.
A is the other end of the rod.
G is the mass centre of the rod.
$\hat r$, $\hat s$ and z are the axes of B.
$\hat r$ is the unit vector from O to G.
B turns relative to N about z by the angle $\theta$.
The weight and the force at O are the only loads on the rod.
$v$ is the magnitude of the velocity of A relative to N.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \frac13 m l^2\ddot\theta = \frac12 m g l\cos\theta $$
$$ v^2 = l^2\dot\theta^2 $$
$$ \frac1{12} m l^2\ddot\theta = \frac12 m g l\cos\theta $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_gimbal_without_mass_is_no_body() {
    let sentences = r"N is an inertial frame.
z is the third axis of N.
K is a frame fixed in the gimbal.
K turns relative to N about z by the angle $a$.
x is the first axis of K.
B is a frame fixed in the rotor.
B turns relative to K about x by the angle $b$.
G is the mass centre of the rotor.
G is a point fixed in N.
The rotor is symmetric about x.
$C$ is the moment of inertia of the rotor about the axis through G along x.
$A$ is the moment of inertia of the rotor about the axis through G along z.
The gimbal has no mass.
$T$ is the kinetic energy of the rotor relative to N.
";
    let text = r"
$$ T = \frac12 C\dot b^2 + \frac12 A\dot a^2 $$
$$ T = \frac12 C\dot b^2 + A\dot a^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_holds_at_the_start_and_relates_what_moves_is_no_initial_value() {
    let sentences = r"N is an inertial frame.
x, y, z are the axes of N.
O is a point fixed in N.
G is the mass centre of the rod.
B is a frame fixed in the rod.
$e$ is the first axis of B.
B turns relative to N about z by the angle $\theta$.
G lies at the distance $c$ from O along $e$.
$v$ is the component of the velocity of G relative to N along y.
Lines 2 and 3 hold at $t=0$.
";
    let text = r"
$$ v = c\dot\theta\cos\theta $$
$$ v = 2c\dot\theta\cos\theta $$
";
    assert_eq!(judged(sentences, text), "pu");
}

#[test]
fn two_pendulums_are_placed_by_angles_about_an_axis() {
    let sentences = r"N is an inertial frame.
$i$ and $j$ are the first and second axes of N.
$j$ is the upward vertical.
z is the third axis of N.
P is a point fixed in N and in pendulum 1.
Q is a point fixed in pendulum 1 and in pendulum 2.
G is the mass centre of pendulum 1.
H is the mass centre of pendulum 2.
Pendulum 1 turns relative to N about z at the rate $\dot a$.
Pendulum 2 turns relative to N about z at the rate $\dot b$.
$\mathbf{R}$ is the position of G from P.
$\mathbf{S}$ is the position of H from Q.
$\mathbf{L}$ is the position of Q from P.
$R$ is the magnitude of $\mathbf{R}$.
$S$ is the magnitude of $\mathbf{S}$.
$L$ is the magnitude of $\mathbf{L}$.
$R$, $S$, $L$ and $c$ are constant.
$a$ is the angle about z from $-j$ to $\mathbf{R}$.
$b$ is the angle about z from $-j$ to $\mathbf{S}$.
$c$ is the angle about z from $\mathbf{R}$ to $\mathbf{L}$.
$\mathbf{X}$ is the position of H from P.
$x$ and $y$ are the components of $\mathbf{X}$ on $i$ and $j$.
$m$ is the mass of pendulum 1.
$n$ is the mass of pendulum 2.
$I$ is the moment of inertia of pendulum 1 about the axis through G along z.
$J$ is the moment of inertia of pendulum 2 about the axis through H along z.
$g$ is the acceleration of gravity.
$\mathbf{T}$ is the force on pendulum 1 at P.
$\mathbf{U}$ is the force of pendulum 2 on pendulum 1 at Q.
$U_x$ and $U_y$ are the components of $\mathbf{U}$ on $i$ and $j$.
The weight, the force $\mathbf{T}$ at P and the force $\mathbf{U}$ at Q are the only loads on pendulum 1.
The weight and the force $-\mathbf{U}$ at Q are the only loads on pendulum 2.
On line 6 $\times$ means the component of the cross product along z.
";
    let text = r"
$$ \mathbf{L} = L\sin(a+c)i - L\cos(a+c)j $$
$$ \ddot x = L\ddot a\cos(a+c) - L\dot a^2\sin(a+c) + S\ddot b\cos b - S\dot b^2\sin b $$
$$ n\ddot x = -U_x $$
$$ n\ddot y = -U_y - n g $$
$$ J\ddot b = (-\mathbf{S})\times(-\mathbf{U}) = S\sin b\,U_y + S\cos b\,U_x $$
$$ m\ddot{\mathbf{R}} = \mathbf{T} + \mathbf{U} - m g j $$
";
    assert_eq!(judged(sentences, text), "pppppp");
}

#[test]
fn vectors_side_by_side_are_a_dyad() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the plate.
$\boldsymbol a_1$, $\boldsymbol a_2$, $\boldsymbol a_3$ are the axes of B.
G is the mass centre of the plate.
$\boldsymbol I$ is the inertia tensor of the plate about G.
$p$, $q$, $r$ are the principal moments of the plate about G on B.
$\boldsymbol u$ and $\boldsymbol v$ are any vectors.
Two vectors side by side are their dyad.
A full stop between vectors is the dot product.
";
    let text = r"
$$ \boldsymbol I = p\,\boldsymbol a_1\boldsymbol a_1 + q\,\boldsymbol a_2\boldsymbol a_2 + r\,\boldsymbol a_3\boldsymbol a_3 $$
$$ \boldsymbol I = p\,\boldsymbol a_1\boldsymbol a_1 + q\,\boldsymbol a_2\boldsymbol a_2 + q\,\boldsymbol a_3\boldsymbol a_3 $$
$$ (\boldsymbol u\boldsymbol v)\cdot\boldsymbol u = \boldsymbol u(\boldsymbol v\cdot\boldsymbol u) $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn counted_motors_have_letters_for_names() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the cross.
$x$, $y$, $z$ are the axes of B.
G is the mass centre of the cross.
The cross consists of the four motors.
Motor $f$, motor $l$, motor $b$ and motor $r$ are particles of mass $\mu$.
Motor $f$ is placed from G by $d x$.
Motor $l$ is placed from G by $d y$.
Motor $b$ is placed from G by $-d x$.
Motor $r$ is placed from G by $-d y$.
$d$ is constant.
$I$ is the moment of inertia of the cross about the axis through G along $z$.
";
    let text = r"
$$ I = 4\mu d^2 $$
$$ I = 2\mu d^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_unit_vector_with_the_letter_of_time_is_no_time() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the gimbal.
$\hat{\mathbf s}$ is the first axis of B.
$\hat{\mathbf g}$ is the third axis of B.
Line 2 defines $\hat{\mathbf t}$.
$\omega$ is constant.
B turns relative to N about $\hat{\mathbf g}$ at the rate $\omega$.
A dot means the rate seen from N.
";
    let text = r"
$$ \hat{\mathbf t} = \hat{\mathbf g}\times\hat{\mathbf s} $$
$$ \dot{\hat{\mathbf s}} = \omega\hat{\mathbf t} $$
$$ \dot{\hat{\mathbf t}} = \omega\hat{\mathbf s} $$
";
    assert_eq!(judged(sentences, text), "apr");
}

#[test]
fn a_transpose_by_its_mark_says_nothing_new() {
    let sentences = r"N is an inertial frame.
B is a frame.
$T_{N\to B}$ takes components on N to components on B.
$T^\top_{N\to B}$ is the transpose of $T_{N\to B}$.
$T_{B\to N}$ takes components on B to components on N.
";
    let text = r"
$$ T_{B\to N} = T^\top_{N\to B} $$
$$ T_{B\to N} = T_{N\to B} $$
";
    // How B lies nothing tells: the second line may.
    assert_eq!(judged(sentences, text), "pu");
}

#[test]
fn the_other_entries_of_a_tensor_are_off_its_diagonal() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$I$ is the inertia tensor of the body about G in components on B.
$I_{xx}$, $I_{yy}$, $I_{zz}$ are the diagonal entries of $I$.
$I_{xy}$, $I_{xz}$, $I_{yz}$, $I_{yx}$, $I_{zx}$, $I_{zy}$ are the other entries of $I$.
Products of inertia are entries.
";
    let text = r"
$$ I = \begin{bmatrix} I_{xx} & I_{xy} & I_{xz}\\ I_{yx} & I_{yy} & I_{yz}\\ I_{zx} & I_{zy} & I_{zz}\end{bmatrix} $$
$$ I = \begin{bmatrix} I_{xx} & I_{xy} & I_{xz}\\ I_{yx} & I_{yy} & I_{xz}\\ I_{zx} & I_{zy} & I_{zz}\end{bmatrix} $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn angles_place_points_of_bodies_by_their_frames_and_distances() {
    let sentences = r"N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
C is a frame fixed in the upper link.
D is a frame fixed in the lower link.
C turns relative to N about z.
D turns relative to N about z.
O is a point fixed in N and in C.
P is a point fixed in C and in D.
G is the mass centre of the upper link.
H is the mass centre of the lower link.
O, P, G and H lie in the plane of x and y.
$\mathbf a$ is the position of G from O.
$\mathbf b$ is the position of P from O.
$\mathbf c$ is the position of H from P.
$k$ is the distance of G from O.
$l$ is the distance of P from O.
$n$ is the distance of H from P.
$k$, $l$, $n$ and $\epsilon$ are constant.
$\alpha$ is the angle about z from the downward vertical to $\mathbf a$.
$\beta$ is the angle about z from $-y$ to $\mathbf c$.
$\epsilon$ is the angle about z from $\mathbf a$ to $\mathbf b$.
$u$ and $v$ are the components of the position of H from O along x and y.
The cross product of two vectors of the plane means its component along z.
";
    let text = r"
$$ \mathbf a = k\sin\alpha\,x - k\cos\alpha\,y $$
$$ \mathbf b = l\sin(\alpha+\epsilon)\,x - l\cos(\alpha+\epsilon)\,y $$
$$ u = l\sin(\alpha-\epsilon) + n\sin\beta $$
$$ u = l\sin(\alpha+\epsilon) + n\sin\beta $$
$$ \dot v = l\dot\alpha\sin(\alpha+\epsilon) + n\dot\beta\sin\beta $$
$$ \mathbf a\times\mathbf b = k l\sin\epsilon $$
$$ \mathbf a\times\mathbf b = k l\cos\epsilon $$
";
    assert_eq!(judged(sentences, text), "pprpppr");
}

#[test]
fn a_frame_is_turned_by_the_azimuth_and_the_lean_of_its_axis() {
    let sentences = r"N is an inertial frame.
$e_1$, $e_2$, $e_3$ are the axes of N.
A is a frame that turns relative to N.
$u$, $v$, $w$ are the axes of A.
The angle between $e_3$ and $w$ is $q$.
The plane of $e_3$ and $w$ turns about $e_3$ by the angle $p$ from the plane of $e_3$ and $e_1$.
$v=\frac{w\times e_3}{\sin q}$.
$\omega$ is the angular velocity of A relative to N.
";
    let text = r"
$$ w = \sin q\cos p\,e_1+\sin q\sin p\,e_2+\cos q\,e_3 $$
$$ w = \sin q\cos p\,e_1-\sin q\sin p\,e_2+\cos q\,e_3 $$
$$ \omega = -\dot q\,v + \dot p\,e_3 $$
$$ \omega = \dot q\,v + \dot p\,e_3 $$
$$ v = \sin p\,e_1 - \cos p\,e_2 $$
";
    assert_eq!(judged(sentences, text), "prprp");
    let sentences = r"N is an inertial frame.
$e_1$, $e_2$, $e_3$ are the axes of N.
A is a frame that turns relative to N.
$u$, $v$, $w$ are the axes of A.
$q$ is the angle between $w$ and $e_3$.
$p$ is the angle about $e_3$ from $e_2$ to the projection of $w$ on the plane of $e_1$ and $e_2$.
$u$ points along $e_3\times w$.
$\omega$ is the angular velocity of A relative to N.
";
    let text = r"
$$ w = \sin q\cos p\,e_2-\sin q\sin p\,e_1+\cos q\,e_3 $$
$$ w = \sin q\cos p\,e_1+\sin q\sin p\,e_2+\cos q\,e_3 $$
$$ \omega = \dot q\,u + \dot p\,e_3 $$
$$ \omega = \dot q\,v + \dot p\,e_3 $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn a_line_lies_by_its_angle_with_an_axis_and_that_of_its_projection() {
    let sentences = r"N is an inertial frame with the axes x, y, z.
z is the upward vertical.
O is a point fixed in N.
P is a particle of mass $m$ that hangs from O by a massless string of length $l$.
$r$ is the position of P from O.
$h$ is the component along z of the angular momentum of P about O relative to N.
";
    let text = r"
$$ r = l(-\sin a\sin b\,x+\sin a\cos b\,y-\cos a\,z) $$
$$ r = l(\sin a\cos b\,y-\cos a\,z) $$
$$ h = ml^2\dot b\sin^2 a $$
$$ h = -ml^2\dot b\sin^2 a $$
$$ h = ml^2\dot b\cos^2 a $$
";
    for told in [
        "The string makes the angle $a$ with the downward vertical, and the vertical plane through the string makes the angle $b$ with y, positive about z.",
        "The string makes the angle $a$ with the downward vertical. $b$ is the angle from y to the projection of the string on the horizontal plane, counted positive about z.",
        "$a$ is the angle between $-z$ and the string. $b$ is the angle from y to the projection of the string on the plane of x and y, counted positive about z.",
    ] {
        let said = format!("{sentences}{told}\n");
        assert_eq!(judged(&said, text), "puprr", "{told}");
    }
    // Counted the other way.
    let against = "$a$ is the angle between $-z$ and the string. $b$ is the angle from y to the projection of the string on the plane of x and y, counted positive about $-z$.";
    let said = format!("{sentences}{against}\n");
    assert_eq!(judged(&said, text), "uurpr");
}
