//! What is told of one angle, one instant or one line alone, and what holds things that move along lines.

use super::judged;

#[test]
fn what_lies_along_an_axis_where_an_angle_is_zero_lies_along_that_of_its_frame() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
O is a point fixed in N.
B is a frame fixed in the rod.
O is a point fixed in B.
B turns relative to N about the axis through O along z by the angle $q$.
The first axis of B and the first axis of N are the same at $q=0$.
G is the mass centre of the rod.
G lies at the distance $a$ from O along the downward vertical at $q=0$.
$u$ and $v$ are the components along x and y of the position of G from O.
";
    let text = r"
$$ u = a\sin q $$
$$ v = -a\cos q $$
$$ v = a\cos q $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

/// A line about the start that relates what moves is worked out, and one that gives a value is given.
#[test]
fn lines_at_the_start_that_relate_are_judged() {
    let sentences = r"
N is an inertial frame.
$i$, $j$, $k$ are the axes of N.
O is a point fixed in N.
P is a point.
P lies at the distance $x$ from O along $i$.
$v$ is the velocity of P relative to N.
$r$ is the position of P from O.
Lines 2 to 7 hold at $t=0$.
";
    let text = r"
$$ r = x i $$
$$ v = \dot x i $$
$$ v = 2\dot x i $$
$$ v = \dot x j $$
$$ x = 2 $$
$$ \dot x = 0 $$
";
    assert_eq!(judged(sentences, text), "ppuuaa");
}

const CART: &str = r"
N is an inertial frame.
X, Y, Z are the axes of N.
Y is the upward vertical.
O is a point fixed in N.
P is a point fixed in the cart.
P is placed from O by $x$ along X.
The cart moves along X and does not turn relative to N.
B is a frame fixed in the rod.
P is a point fixed in B.
B turns relative to N about the axis through P along Z by the angle $\theta$.
G is the mass centre of the rod.
G lies at the distance $a$ from P along the downward vertical at $\theta=0$.
The system consists of the cart and the rod.
$M$ is the mass of the cart.
$m$ is the mass of the rod.
$J$ is the moment of inertia of the rod about the axis through G along Z.
$g$ is the acceleration of gravity.
$F$ is the component along X of the push on the cart.
$S$ is the component along Y of the force of the track on the cart.
The pin at P carries no moment along Z.
The weight of the cart, the push, the force of the track and the force of the rod are the only loads on the cart.
The weight and the force at P are the only loads on the rod.
$V$ is the potential energy of the rod.
The potential energy is zero at P.
$L$ is the Lagrangian of the system.
$\frac{\partial}{\partial\theta}$ takes functions of $x$, $\theta$, $\dot x$, $\dot\theta$.
";

/// Its force is across the motion; where the cart is pushed matters to nothing, and the pin keeps the rod in its plane.
#[test]
fn a_smooth_track_carries_what_moves_along_it() {
    let sentences = format!("{CART}The track has no friction.\nThe push on the cart is along X.\n");
    let text = r"
$$ V=-mga\cos\theta $$
$$ V=mga\cos\theta $$
$$ (M+m)\ddot x+ma\ddot\theta\cos\theta-ma\dot\theta^2\sin\theta=F $$
$$ (M+m)\ddot x+ma\ddot\theta\cos\theta+ma\dot\theta^2\sin\theta=F $$
$$ (J+ma^2)\ddot\theta+ma\ddot x\cos\theta+mga\sin\theta=0 $$
$$ S=(M+m)g+ma\ddot\theta\sin\theta+ma\dot\theta^2\cos\theta $$
$$ \frac{\partial L}{\partial\theta}=-ma\dot x\dot\theta\sin\theta-mga\sin\theta $$
";
    assert_eq!(judged(&sentences, text), "prprppp");
}

#[test]
fn an_index_that_is_not_summed_is_not() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in N and in B.
A repeated axis index is summed.
On lines 2 and 3 an axis index is not summed.
$i$ numbers the axes of B.
The axes of B are principal axes of the body.
$w$ is the angular velocity of B relative to N.
$w_i$ is the component $i$ of $w$ on B.
$H$ is the angular momentum of the body about O relative to N.
$H_i$ is the component $i$ of $H$ on B.
$I_i$ is principal moment $i$ of the body about O on B.
";
    let text = r"
$$ H_i = I_i w_i $$
$$ H_i = 2 I_i w_i $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_turns_evenly_has_a_period() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
A turns relative to N about z at the constant rate $w$.
$w$ is positive.
$T$ is the period of the turning of A relative to N.
";
    let text = r"
$$ T = \frac{2\pi}{w} $$
$$ T w = \pi $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn with_velocities_relative_to_the_mass_centre_energy_is_that_of_rotation() {
    let sentences = r"
E is an inertial frame.
B is a frame fixed in the hub.
x, y, z are the axes of B.
The craft consists of the hub and the rotor.
G is the mass centre of the craft.
The rotor turns relative to B about x at the constant rate $s$.
The rotor is symmetric about x.
The mass centre of the rotor is fixed in B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to E.
$J$ is the moment of inertia of the rotor about its axis.
The axes of B are principal axes of the craft.
$A$, $D$, $C$ are the principal moments of the craft about G on B.
$T$ is the kinetic energy of the craft relative to E, with velocities relative to G.
";
    let text = r"
$$ T = \frac12(Ap^2+Dq^2+Cr^2)+Jsp+\frac12Js^2 $$
$$ T = \frac12(Ap^2+Dq^2+Cr^2)+\frac12Js^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_vector_lies_in_a_plane() {
    let sentences = r"
N is an inertial frame.
$x$, $y$, $z$ are the axes of N.
u is a unit vector perpendicular to $x$ in the plane of $x$ and $y$.
";
    let text = r"
$$ u\cdot z = 0 $$
$$ (u\cdot y)^2 = 1 $$
";
    assert_eq!(judged(sentences, text), "pp");
}

/// What pushes along the motion is no track, and what two things exert is not the same force.
#[test]
fn only_tracks_hold_across_the_motion() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
The cart is a particle of mass $m$.
The cart moves along x.
$s$ is the component along x of the position of the cart from O.
$w$ is the component along x of the force of the wall on the cart.
$u$ is the component along x of the force of the track on the cart.
The force of the wall and the force of the track are the only loads on the cart.
";
    let text = r"
$$ m\ddot s = w + u $$
$$ w = u $$
$$ w = 0 $$
";
    assert_eq!(judged(sentences, text), "prr");
    let wall = format!("{sentences}The wall is smooth.\n");
    assert_eq!(judged(&wall, text), "puu");
    let track = format!("{sentences}The track is smooth.\n");
    assert_eq!(
        judged(&track, "\n$$ u = 0 $$\n$$ m\\ddot s = w $$\n$$ w = 0 $$\n"),
        "ppr"
    );
}

/// An angle about an axis may be an azimuth.
#[test]
fn an_azimuth_places_nothing_in_a_plane() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
$\vec r$ is the position of P from O.
$r$ is the magnitude of $\vec r$.
$\phi$ is the angle about z from x to $\vec r$.
The angle between z and $\vec r$ is $\theta$.
";
    let text = r"
$$ \vec r\cdot z = r\cos\theta $$
$$ \vec r\cdot z = 0 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_wheel_that_turns_about_a_diameter_is_not_round_about_that() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the wheel.
$i, j, k$ are the axes of B.
The wheel is a uniform thin disc of mass $m$ and radius $r$.
B turns relative to N about i by the angle $\theta$.
i is a diameter of the wheel.
$I$ is the moment of inertia of the wheel about the axis through its mass centre along $i$.
";
    let text = r"
$$ I = \frac14 m r^2 $$
$$ I = \frac12 m r^2 $$
";
    assert!(
        !judged(sentences, text).contains(['p', 'r']),
        "{}",
        judged(sentences, text)
    );
}

/// How far a quantity is from its reference value is not told where no disturbance is.
#[test]
fn a_reference_value_without_a_disturbance_denies_nothing() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
C is the mass centre of the body.
The axes of B are principal axes of the body.
$A$, $A$, $C$ are the principal moments of the body about C on B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
No moment acts on the body about C.
$\Omega$ is the reference value of $r$.
$p$ and $q$ are small disturbances.
$\Omega$ is a constant.
Lines 2 to 3 hold to first order in $p$ and $q$.
";
    let text = r"
$$ A\dot p+(C-A)\Omega q=0 $$
$$ A\dot p-(C-A)\Omega q=0 $$
";
    assert_eq!(judged(sentences, text), "uu");
}
