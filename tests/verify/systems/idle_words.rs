//! Words of sentences that the model has nothing for: what they are said of is not taken as if they were not there.

use super::{judged, verdicts};

#[test]
fn what_several_things_have_together_is_not_what_each_has() {
    let sentences = r"O is a point fixed in the dumb-bell.
The dumb-bell consists of two particles of total mass $m$.
The first particle is placed from O by $r$ and the second by $-r$.
$M$ is the mass of the dumb-bell.
";
    let text = r"
$$M = 2m$$

$$M = m$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn the_centre_of_half_a_shape_is_not_its_mass_centre() {
    let sentences = r"The hemisphere is a uniform solid hemisphere of mass $m$ and radius $r$.
B is a frame fixed in the hemisphere.
$i, j, k$ are the axes of B.
k is the axis of the hemisphere.
A is the centre of the hemisphere.
G is the mass centre of the hemisphere.
$p$ is the position of G from A.
";
    let text = r"
$$p = 0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_rolls_on_a_ceiling_touches_it_from_below() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
z is the upward vertical.
The disc is a uniform thin disc of mass $m$ and radius $r$.
B is a frame fixed in the disc.
y is the axis of the disc.
G is the mass centre of the disc.
G is placed from O by $s x - r z$.
The ceiling is a horizontal plane fixed in N.
The disc rolls on the ceiling at C without slipping.
B turns relative to N about y by the angle $\theta$.
";
    let text = r"
$$\dot s = -r\dot\theta$$

$$\dot s = r\dot\theta$$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_load_that_is_zero_is_the_one_of_that_name() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
z is the upward vertical.
$R$ is the component along z of the drag on P.
The weight and the drag are the only loads on P.
The drag on P is neglected.
";
    let text = r"
$$R = 0$$

$$m\ddot s = -mg$$

$$m\ddot s = R-mg$$
";
    assert_eq!(judged(sentences, text), "ppp");
}

#[test]
fn a_weight_that_is_left_out_makes_no_gravity_zero() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
$F$ is the component along z of the total force on P.
The weight of P is neglected.
";
    let text = r"
$$g = 0$$

$$m\ddot s = F+7mg$$
";
    assert_eq!(judged(sentences, text), "rr");
}

#[test]
fn an_adjective_of_a_load_is_not_dropped() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
z is the upward vertical.
The weight is the only constant load on P.
";
    let text = r"
$$\ddot s = -g$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_holds_at_the_start_holds_at_no_other_time() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
No force acts on P at the start.
";
    let text = r"
$$\ddot s = 0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_holds_while_something_moves_is_no_law() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
z is the upward vertical.
The weight is the only load on P while it moves.
";
    let text = r"
$$\ddot s = -g$$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}

#[test]
fn what_holds_at_a_thing_is_no_law() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
z is the upward vertical.
The weight is the only load on P at the top.
";
    let text = r"
$$\ddot s = -g$$

$$\ddot s = 0$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn what_does_not_turn_at_the_start_may_turn_later() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the rod.
$w$ is the angular velocity of B relative to N.
The rod does not turn relative to N at the start.
";
    let text = r"
$$w = 0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_component_of_something_constant_is_not_told() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$F$ is the component along z of the constant force on P.
";
    let text = r"
$$\dot F = 0$$

$$m\ddot s = F$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn a_density_that_depends_on_something_is_not_uniform() {
    let sentences = r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
G is the mass centre of the wheel.
$I$ is the moment of inertia of the wheel about k through G.
The wheel is a cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
The density of the wheel depends on the distance from k.
";
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_is_hollow_is_not_solid() {
    let sentences = r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
G is the mass centre of the wheel.
$I$ is the moment of inertia of the wheel about k through G.
The wheel is a cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
The cylinder is hollow.
";
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_spring_force_has_an_energy() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
z is the upward vertical.
$g$ is the gravitational acceleration.
$L$ is the Lagrangian of P.
The potential energy is zero at O.
$k$ is constant.
The spring force $-k s$ along z acts on P.
";
    let text = r"
$$L = \tfrac12 m\dot s^2-m g s$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_spring_that_is_attached_has_an_energy() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
z is the upward vertical.
$g$ is the gravitational acceleration.
$V$ is the potential energy of P.
The potential energy is zero at O.
$k$ is the stiffness of the spring.
The spring is attached to O and P.
";
    let text = r"
$$V = m g s$$

$$V = m g s+\tfrac12 k s^2$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn which_end_of_a_rod_is_not_guessed() {
    let sentences = r"B is a frame fixed in the rod.
$i, j, k$ are the axes of B.
The rod is a uniform thin rod of mass $m$ and length $l$ along i.
O is the end of the rod.
G is the mass centre of the rod.
$p$ is the position of G from O.
";
    let text = r"
$$p = \tfrac12 l i$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_point_of_a_rim_may_be_anywhere_on_it() {
    let sentences = r"The disc is a uniform thin disc of mass $m$ and radius $r$.
B is a frame fixed in the disc.
$i, j, k$ are the axes of B.
k is the axis of the disc.
A lies on the rim of the disc.
$I$ is the moment of inertia of the disc about k through A.
";
    let text = r"
$$I = \tfrac32 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_point_of_a_surface_may_be_anywhere_on_it() {
    let sentences = r"The sphere is a uniform solid sphere of mass $m$ and radius $r$.
B is a frame fixed in the sphere.
A lies on the surface of the sphere.
G is the mass centre of the sphere.
$d$ is the distance of A from G.
";
    let text = r"
$$d = r$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_point_of_an_axis_is_not_free() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is the origin of N.
P lies on x.
$p$ is the position of P from O.
";
    let text = r"
$$p\times x = 0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn an_axis_that_is_vertical_beside_another_is_not_free() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
B is a frame fixed in the rod.
$i, j, k$ are the axes of B.
$w$ is the angular velocity of B relative to N.
k is vertical.
";
    let text = r"
$$w\times z = 0$$

$$k\times z = 0$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn rods_along_two_axes_have_one_middle() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the body.
$i, j, k$ are the axes of B.
O is a point fixed in B.
The body consists of two uniform thin rods of mass $m$ and length $l$.
Rod 1 and rod 2 lie along i and j with their middles at O.
$I$ is the moment of inertia of the body about k through O.
";
    let text = r"
$$I = \tfrac16 m l^2$$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn a_sense_is_not_dropped() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N and in B.
B is a frame fixed in the rod.
B turns relative to N about z by the angle $\theta$.
$I$ is the moment of inertia of the rod about z through O.
$M$ is the moment on the rod about O, positive towards growing $\theta$.
";
    let text = r"
$$I\ddot\theta = M$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn the_size_of_what_is_not_heard_may_be_that_of_anything() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
O is a point fixed in N.
$g$ is the gravitational acceleration.
P is a particle of mass $m$.
P is placed from O by $s z$.
$F$ is the push on P.
The push points along $-z$.
$f$ is the magnitude of $F$.
The weight and the push are the only loads on P.
";
    let text = r"
$$m\ddot s = f-mg$$

$$m\ddot s = -f-mg$$

$$F = -f z$$
";
    assert_eq!(judged(sentences, text), "uuu");
}

#[test]
fn a_point_is_not_in_two_places() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
O is a point fixed in N.
Q lies at the distance $a$ from O along x and at the distance $b$ from O along y.
$q$ is the position of Q from O.
";
    let text = r"
$$q = a x$$

$$q = a x+b y$$

$$q = 7 z$$
";
    assert_eq!(judged(sentences, text), "uuu");
}

#[test]
fn turns_about_one_axis_add_up() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
B is a frame fixed in the body.
$i, j, k$ are the axes of B.
$w$ is the angular velocity of B relative to N.
A turns relative to N about z by the angle $a$.
B turns relative to A about z by the angle $b$.
";
    let text = r"
$$w = (\dot a+\dot b) z$$

$$k = z$$
";
    assert_eq!(judged(sentences, text), "pp");
}

#[test]
fn an_angle_about_an_axis_that_moves_on_both_is_no_turn() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
$u, v, s$ are the axes of A.
$w$ is the angular velocity of B relative to N.
A turns relative to N about x by the angle $a$.
B turns relative to A about y by the angle $b$.
";
    let text = r"
$$w=\dot a x+\dot b y$$

$$w=\dot a x+\dot b v$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn what_is_up_and_down_is_neither() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
z is the upward vertical.
z is the downward vertical.
The weight is the only load on P.
";
    let text = r"
$$\ddot s=g$$

$$\ddot s=-g$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn a_cylinder_has_one_axis() {
    let sentences = r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
G is the mass centre of the wheel.
$I$ is the moment of inertia of the wheel about k through G.
The wheel is a cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
i is the axis of the cylinder.
";
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_letter_is_not_radius_and_diameter() {
    let sentences = r"The disc is a uniform thin disc of mass $m$ and radius $r$.
$r$ is the diameter of the disc.
B is a frame fixed in the disc.
$i,j,k$ are the axes of B.
k is the axis of the disc.
G is the mass centre of the disc.
$I$ is the moment of inertia of the disc about k through G.
";
    let text = r"
$$I=\tfrac12 m r^2$$

$$I=\tfrac18 m r^2$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn that_no_constant_load_acts_is_not_that_none_does() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
P is placed from O by $s z$.
$g$ is the gravitational acceleration.
z is the upward vertical.
No constant load acts on P.
";
    let text = r"
$$\ddot s=0$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_turn_at_the_start_is_none_later() {
    let sentences = r"N is an inertial frame.
$x, y, z$ are the axes of N.
$w$ is the angular velocity of B relative to N.
B turns relative to N about z by the angle $a$ at the start.
";
    let text = r"
$$w=\dot a z$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_mass_that_lies_somewhere_is_not_spread_evenly() {
    let sentences = r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
G is the mass centre of the wheel.
$I$ is the moment of inertia of the wheel about k through G.
The wheel is a cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
The mass of the wheel lies at its surface.
";
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_is_not_uniform_has_no_tensor_of_its_shape() {
    let sentences = r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
G is the mass centre of the wheel.
$I$ is the moment of inertia of the wheel about k through G.
The wheel is a cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
The wheel is not uniform.
";
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn two_ends_of_a_rod_are_not_told_apart() {
    let sentences = r"B is a frame fixed in the rod.
$i, j, k$ are the axes of B.
The rod is a uniform thin rod of mass $m$ and length $l$ along i.
A and C are the ends of the rod.
G is the mass centre of the rod.
$p$ is the position of C from A.
";
    let text = r"
$$p=l i$$

$$p=-l i$$

$$p\cdot p=l^2$$
";
    assert_eq!(judged(sentences, text), "uuu");
}

#[test]
fn the_density_of_what_is_hollow_is_not_its_mass_over_its_volume() {
    let sentences = r"B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
The wheel is a uniform cylinder of mass $m$, radius $r$ and length $l$.
k is the axis of the cylinder.
$\rho$ is the density of the wheel.
The cylinder is hollow.
";
    let text = r"
$$m=\rho\pi r^2 l$$
";
    assert_eq!(judged(sentences, text), "u");
}
