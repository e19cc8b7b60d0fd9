//! Forces at joints between bodies, loads that are listed together, and directions that angles tell.

use super::judged;

#[test]
fn the_forces_at_joints_are_those_of_the_bodies_on_each_other() {
    let sentences = r"
N is an inertial frame.
A is a frame fixed in link 1.
B is a frame fixed in link 2.
C is a frame fixed in link 3.
Links 1, 2 and 3 are rigid bodies.
P is a point fixed in link 1 and in link 2.
Q is a point fixed in link 2 and in link 3.
G is the mass centre of link 2.
$m$ is the mass of link 2.
$g$ is the acceleration of gravity in components on N.
$a$ is the acceleration of G relative to N in components on N.
$f$ is the force of link 1 on link 2 in components on N.
$h$ is the force of link 2 on link 3 in components on N.
$K$ is the moment of link 1 on link 2 in components on N.
$L$ is the moment of link 3 on link 2 in components on N.
$p$ is the position of P from G in components on N.
$q$ is the position of Q from G in components on N.
$H$ is the angular momentum of link 2 about G relative to N in components on N.
The weight, the forces at P and at Q and the moments of link 1 and of link 3 are the only loads on link 2.
A dot means the rate entry by entry.
";
    let text = r"
$$ f-h+m g=m a $$
$$ f+h+m g=m a $$
$$ \dot H=K+L+p\times f-q\times h $$
$$ \dot H=K+p\times f-q\times h $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn the_total_aerodynamic_force_is_all_of_the_aerodynamic_forces_of_a_list() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the wing.
C is the mass centre of the wing.
O is a point fixed in B.
$\vec f$ is the total force on the wing.
$\vec w$ is the weight of the wing.
$\vec h$ is the total aerodynamic force on the wing.
$\vec k$ is the moment of the aerodynamic forces on the wing about O.
$\vec l$ is the total moment on the wing about O.
$\vec c$ is the position of C from O.
The weight and the aerodynamic forces are the only loads on the wing.
";
    let text = r"
$$ \vec f=\vec h+\vec w $$
$$ \vec f=\vec h-\vec w $$
$$ \vec l=\vec k+\vec c\times\vec w $$
$$ \vec l=\vec k $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn the_angle_to_a_vector_that_turns_with_it_tells_where_that_points() {
    let sentences = r"
N is an inertial frame.
i, j, k are the axes of N.
O is a point fixed in N.
B turns relative to N about k by the angle $\theta$.
u is the unit vector from O to P.
u is fixed in B.
The angle from j to u about k is $\theta$.
$l$ is the distance of P from O.
$l$ is constant.
$r$ is the position of P from O in components on N.
";
    let text = r"
$$ r=\begin{pmatrix}-l\sin\theta\\ l\cos\theta\\0\end{pmatrix} $$
$$ r=\begin{pmatrix}l\sin\theta\\ l\cos\theta\\0\end{pmatrix} $$
$$ r=\begin{pmatrix}l\cos\theta\\ l\sin\theta\\0\end{pmatrix} $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn a_body_moves_along_with_its_mass_centre() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the rod.
C is the mass centre of the rod.
Q is a point fixed in B.
$m$ is the mass of the rod.
$\vec v$ is the velocity of C relative to N.
$\vec u$ is the velocity of Q relative to N.
$T$ is the kinetic energy of translation of the rod with C.
";
    let text = r"
$$ T=\frac12 m\,\vec v\cdot\vec v $$
$$ T=m\,\vec v\cdot\vec v $$
$$ T=\frac12 m\,\vec u\cdot\vec u $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn an_axis_of_a_frame_may_be_a_unit_vector_between_points() {
    let sentences = r"
N is an inertial frame.
E is a point fixed in N.
A is a frame that turns relative to N.
$o_1$ is the first axis of A and the unit vector from E to G.
$R$ is the distance of G from E.
$\vec r$ is the position of G from E.
";
    let text = r"
$$ \vec r=R\,o_1 $$
$$ \vec r=-R\,o_1 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_vector_of_a_part_of_the_document_is_an_axis_of_the_frame_that_it_is_told_for() {
    let sentences = r"
N is an inertial frame.
P is a particle.
On lines 2 to 3 Q is a point fixed in N.
On lines 2 to 3 $r$ is the position of P from Q.
On lines 2 to 3 $v$ is the velocity of P relative to N.
From line 4 on E is a frame that turns relative to N.
From line 4 on $K$ is a unit vector fixed in N and in E.
From line 4 on E turns relative to N about $K$ at the rate $\Omega$.
From line 4 on T is a frame that turns relative to E.
From line 4 on $i$, $j$, $k$ are the axes of T.
From line 4 on T is turned relative to E first about $K$ by the angle $\lambda+\pi/2$ and then about $i$ by the angle $\pi/2-\phi$.
From line 4 on $w$ is the angular velocity of T relative to E.
A dot means the rate seen from N.
";
    let text = r"
$$ \dot r=v $$
$$ \dot r=-v $$
$$ K=\cos\phi\,j+\sin\phi\,k $$
$$ K=\cos\phi\,j-\sin\phi\,k $$
$$ w=-\dot\phi\,i+\dot\lambda\cos\phi\,j+\dot\lambda\sin\phi\,k $$
$$ w=\dot\phi\,i+\dot\lambda\cos\phi\,j+\dot\lambda\sin\phi\,k $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

#[test]
fn a_load_of_a_list_acts_on_the_body_of_the_list_wherever_it_is_spoken_of() {
    let sentences = r"
N is an inertial frame.
$i$, $j$, $k$ are the axes of N.
$j$ is the upward vertical.
O is a point fixed in N.
The beam is a rigid body of mass $m$.
G is the mass centre of the beam.
E lies at the distance $b$ from O along $j$.
D lies at the distance $c$ from O along $i$.
$x$, $y$ are the components on $i$ and $j$ of the position of G from O.
$g$ is the acceleration of gravity.
The weight, the force of the wall at E and the force of the floor at D are the only loads on the beam.
The force of the wall is along $i$.
The force of the floor is along $j$.
$P$ is the force of the wall on the beam along $i$.
$Q$ is the force of the floor on the beam along $j$.
";
    let text = r"
$$ P = m\ddot x $$
$$ Q - mg = m\ddot y $$
$$ Q - mg = 2m\ddot y $$
";
    let verdicts = judged(sentences, text);
    assert_eq!(&verdicts[1..], "pr");
    assert_ne!(&verdicts[..1], "r");
    let without = sentences.replace("The force of the wall is along $i$.\n", "");
    assert_ne!(&judged(&without, text)[1..2], "p");
}
