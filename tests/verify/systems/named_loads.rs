//! Loads that a noun names without a letter.

use super::judged;

#[test]
fn loads_are_called_by_their_nouns() {
    let sentences = "E is an inertial frame, and B is a frame fixed in the aircraft.
C is the mass centre of the aircraft.
x, y, z are the axes of B.
Z is the downward vertical, and X, Y, Z are the axes of E.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to E in the order z, y, x.
$u$, $v$, $w$ are the components on B of the velocity of C relative to E.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to E.
The aircraft has the mass $m$, and $g$ is the acceleration of gravity.
The weight, the thrust and the aerodynamic force are the only loads on the aircraft.
$T_x$, $T_y$, $T_z$ are the components of the thrust on B.
$A_x$, $A_y$, $A_z$ are the components of the aerodynamic force on B.
$l$, $n$ and $o$ are the components on B of the moment of the thrust about C.
$L$, $M$ and $N$ are the components on B of the moment of the aerodynamic force about C.
$K$ is the component x on B of the total moment on the aircraft about C.
";
    let text = r"
$$ m(\dot u + q w - r v) = T_x + A_x - m g \sin\theta $$
$$ m(\dot u + q w - r v) = T_x + A_x + m g \sin\theta $$
$$ m(\dot v + r u - p w) = T_y + A_y + m g \cos\theta\sin\phi $$
$$ m(\dot v + r u - p w) = T_y - A_y + m g \cos\theta\sin\phi $$
$$ K = l + L $$
$$ K = l - L $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

#[test]
fn the_only_forces_leave_the_moment_open() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the drone.
G is the mass centre of the drone.
x, y, z are the axes of B.
Z is the upward vertical, and X, Y, Z are the axes of N.
The mass of the drone is $m$, and $g$ is the acceleration of gravity.
$\\mathbf{F}$ is the thrust.
The weight and $\\mathbf{F}$ are the only forces on the drone.
$\\mathbf{a}$ is the acceleration of G relative to N.
$\\mathbf{k}$ is the unit vector along Z.
$\\mathbf{M}$ is the total moment on the drone about G.
";
    let text = r"
$$ m \mathbf{a} = \mathbf{F} - m g \mathbf{k} $$
$$ m \mathbf{a} = \mathbf{F} + m g \mathbf{k} $$
$$ \mathbf{M} = 0 $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn a_thrust_may_be_a_size() {
    let sentences = "N is an inertial frame.
G is the mass centre of the rocket.
The mass of the rocket is $m$.
$T$ is the thrust.
The thrust is the only load on the rocket.
$a$ is the magnitude of the acceleration of G relative to N.
";
    assert_eq!(judged(sentences, "$$ m a = T $$\n$$ m a = -T $$\n"), "uu");
}

#[test]
fn bodies_act_on_one_another_with_opposite_loads() {
    let sentences = r"N is an inertial frame.
The arm consists of link 1 and link 2.
A is a frame fixed in link 1.
B is a frame fixed in link 2.
$a$, $b$, $z$ are the axes of A.
A turns relative to N about $z$ by the angle $p$.
B turns relative to A about $z$ by the angle $q$.
O is a point fixed in N and in A.
P is a point fixed in A and in B.
P lies at the distance $l$ from O along $a$.
E is the mass centre of link 1.
E is placed from O by $e a$.
H is the mass centre of link 2.
$c$, $d$, $z$ are the axes of B.
H lies at the distance $h$ from P along $c$.
$J$ is the moment of inertia of link 1 about the axis through O along $z$.
$\mathbf F$ is the force of link 1 on link 2 at P.
$s$ is the moment of the base on link 1 along $z$.
$t$ is the moment of link 1 on link 2 along $z$.
$u$ is the moment of link 2 on link 1 along $z$.
The force at O, the moment of the base and the force and the moment of link 2 are the only loads on link 1.
The force at P and the moment of link 1 are the only loads on link 2.
";
    let text = r"
$$ u = -t $$
$$ J\ddot p = s - t - l z\cdot(a\times\mathbf F) $$
$$ J\ddot p = s + t - l z\cdot(a\times\mathbf F) $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn what_is_left_out_of_a_total_load_is_not_in_it() {
    let sentences = r"E is an inertial frame.
B is a frame fixed in the aircraft.
The aircraft is a rigid body of mass $m$.
G is the mass centre of the aircraft.
x, y, z are the axes of B.
The third axis of E points vertically down.
$\Psi$, $\Theta$, $\Phi$ are the Euler angles of B relative to E in the order z, y, x.
$U$, $V$, $W$ are the components on B of the velocity of G relative to E.
$P$, $Q$, $R$ are the components on B of the angular velocity of B relative to E.
$g$ is the acceleration of gravity.
$X$, $Y$, $Z$ are the components on B of the total force on the aircraft without its weight.
";
    let text = r"
$$ Y = m(\dot V + UR - PW - g\cos\Theta\sin\Phi) $$
$$ Y = m(\dot V + UR - PW) $$
$$ X = m(\dot U + QW - RV + g\sin\Theta) $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn several_moments_along_an_axis_come_to_the_total_one() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in link 1.
C is a frame fixed in link 2.
$z$ is the third axis of N.
O is a point fixed in N and in B.
B turns relative to N about $z$ by the angle $\theta$.
$J$ is the moment of inertia of link 1 about the axis through O along $z$.
$Q$ is the moment of the base on link 1 along $z$.
$S$ is the moment of link 2 on link 1 along $z$.
The moments of the base and of link 2 are the only moments on link 1 along $z$.
";
    let text = r"
$$ J\ddot\theta = Q + S $$
$$ J\ddot\theta = Q $$
$$ J\ddot\theta = Q - S $$
";
    assert_eq!(judged(sentences, text), "prr");
}

#[test]
fn the_only_moments_about_a_point_come_to_the_whole() {
    let text = r"
$$ \dot H = K + M $$
$$ \dot H = K $$
";
    for said in [
        "The moment of the aerodynamic forces and the moment of the thrust are the only moments on the aircraft about G.",
        "The moments of the aerodynamic forces and of the thrust are the only moments on the aircraft about G.",
        "$K$ and $M$ are the only moments on the aircraft about G.",
        "The total moment on the aircraft about G is that of the aerodynamic forces and of the thrust.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
B is a frame fixed in the aircraft.
G is the mass centre of the aircraft.
$H$ is the angular momentum of the aircraft about G relative to N.
$K$ is the moment of the aerodynamic forces on the aircraft about G.
$M$ is the moment of the thrust on the aircraft about G.
{said}"
        );
        assert_eq!(judged(&sentences, text), "pr", "{said}");
    }
}

#[test]
fn a_normal_force_that_points_along_an_axis_has_no_other_component() {
    let said = r"N is an inertial frame.
x, y, z are the axes of N.
O is a point fixed in N.
A is a particle of mass $m$.
A is placed from O by $p\,x$.
The force $R x$ and the normal force are the only loads on A.
The normal force on A is along y.
";
    let text = r"
$$ m\ddot p = R $$

$$ m\ddot p = -R $$
";
    assert_eq!(judged(said, text), "pr");
}
