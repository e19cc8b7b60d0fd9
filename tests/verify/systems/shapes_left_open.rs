//! Places and shapes that words leave open or that sentences tell in two ways: nothing of them is guessed.

use super::judged;
use super::scenes::{of_particle, of_wheel};

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
fn a_density_that_depends_on_something_is_not_uniform() {
    let sentences = &of_wheel(
        r"The density of the wheel depends on the distance from k.
",
    );
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_is_hollow_is_not_solid() {
    let sentences = &of_wheel(
        r"The cylinder is hollow.
",
    );
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
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
fn a_point_is_not_in_two_places() {
    let sentences = &of_particle(
        r"O is a point fixed in N.
Q lies at the distance $a$ from O along x and at the distance $b$ from O along y.
$q$ is the position of Q from O.
",
    );
    let text = r"
$$q = a x$$

$$q = a x+b y$$

$$q = 7 z$$
";
    assert_eq!(judged(sentences, text), "uuu");
}

#[test]
fn what_is_up_and_down_is_neither() {
    let sentences = &of_particle(
        r"$g$ is the gravitational acceleration.
z is the upward vertical.
z is the downward vertical.
The weight is the only load on P.
",
    );
    let text = r"
$$\ddot s=g$$

$$\ddot s=-g$$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn a_cylinder_has_one_axis() {
    let sentences = &of_wheel(
        r"i is the axis of the cylinder.
",
    );
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
fn a_mass_that_lies_somewhere_is_not_spread_evenly() {
    let sentences = &of_wheel(
        r"The mass of the wheel lies at its surface.
",
    );
    let text = r"
$$I = \tfrac12 m r^2$$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn what_is_not_uniform_has_no_tensor_of_its_shape() {
    let sentences = &of_wheel(
        r"The wheel is not uniform.
",
    );
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

#[test]
fn a_shape_is_uniform_where_its_middle_and_its_mass_centre_are_one() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the wheel.
The wheel is a disc of mass $m$ and radius $R$.
The wheel is symmetric about the third axis of B.
C is the centre of the wheel.
$I$ is the moment of inertia of the wheel about the axis through C along the third axis of B.
";
    let text = r"
$$ I = \tfrac12 m R^2 $$
$$ I = m R^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
    let apart = format!("{sentences}G is the mass centre of the wheel.\n");
    let (found, _) = super::verdicts(&apart, text);
    assert_eq!(found, "uu");
}
