//! Frames, planes and carts that move: what is fixed in them moves with them.

use super::judged;

#[test]
fn an_inertial_frame_may_move_against_another() {
    let sentences = r"
N and A are inertial frames.
$v$ is the velocity of P relative to N.
$w$ is the velocity of P relative to A.
$a$ is the acceleration of P relative to N.
$b$ is the acceleration of P relative to A.
";
    let text = r"
$$ v = w $$
$$ a = b $$
";
    assert_eq!(judged(sentences, text), "rp");
}

#[test]
fn a_frame_that_moves_is_not_at_rest() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A is a frame that moves along x relative to N.
A does not turn relative to N.
$v$ is the velocity of P relative to N.
$w$ is the velocity of P relative to A.
";
    let text = r"
$$ v = w $$
";
    assert_eq!(judged(sentences, text), "r");
}

#[test]
fn a_frame_fixed_at_a_point_moves_with_it() {
    let sentences = r"
N is an inertial frame.
P is a particle of mass $m$.
Q is a particle of mass $M$.
The system consists of P and Q.
G is the mass centre of the system.
A is a frame fixed at G that does not turn relative to N.
$V$ is the velocity of G relative to N.
$T$ is the kinetic energy of the system relative to A.
$E$ is the kinetic energy of the system relative to N.
";
    let text = r"
$$ T = E $$
$$ E = T+\frac12(m+M)V\cdot V $$
";
    assert_eq!(judged(sentences, text), "rp");
}

#[test]
fn what_is_fixed_in_a_cart_moves_as_the_point_by_which_it_is_placed() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
The cart is a rigid body of mass $M$.
The cart does not turn relative to N.
D is a point fixed in the cart.
D is placed from O by $s x$.
$u$ is the velocity of P relative to N.
$v$ is the velocity of P relative to the cart.
$T$ is the kinetic energy of the cart.
";
    let text = r"
$$ u = \dot s x+v $$
$$ T = \frac12M\dot s^2 $$
$$ u = v $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_point_fixed_in_a_rod_keeps_its_place_there() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
The rod turns relative to N about z by the angle $a$.
$i, j, z$ are the axes of the rod.
O is a point fixed in N and in the rod.
P is placed from O by $s i$.
P is fixed in the rod.
$v$ is the velocity of P relative to N.
";
    let text = r"
$$ v = s\dot a j $$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn a_plane_that_turns_carries_what_rolls_on_it() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
The turntable is a horizontal plane that turns relative to N about z at the rate $\Omega$.
O is a point fixed in N and in the turntable.
The ball is a uniform ball of mass $m$ and radius $r$.
G is the mass centre of the ball.
The ball rolls on the turntable at C without slipping.
$p$ is the position of G from O.
$w$ is the angular velocity of the ball relative to N.
$v$ is the velocity of G relative to N.
";
    let text = r"
$$ v = \Omega z\times p + r w\times z $$
$$ v = r w\times z $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_plane_that_moves_carries_what_rolls_on_it() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
The table is a horizontal plane that moves along x.
The ball is a uniform ball of mass $m$ and radius $r$.
G is the mass centre of the ball.
The ball rolls on the table at C without slipping.
$w$ is the angular velocity of the ball relative to N.
$v$ is the velocity of G relative to N.
";
    let text = r"
$$ v = r w\times z $$
";
    assert_eq!(judged(sentences, text), "r");
}

#[test]
fn what_does_not_turn_on_one_line_turns_on_the_others() {
    let sentences = r"
A is a frame.
B is a frame that moves relative to A.
Q is a point.
$w$ is the angular velocity of B relative to A.
$r$ is the position of Q from the origin of A.
$p$ is the position of the origin of B from the origin of A.
$s$ is the position of Q from the origin of B.
On line 3 B does not turn relative to A.
On lines 4 to 5 the origin of B is the origin of A.
";
    let text = r"
$$ w = 0 $$
$$ w = 0 $$
$$ r = s $$
$$ r = p + s $$
";
    assert_eq!(judged(sentences, text), "rppp");
}

#[test]
fn a_frame_is_inclined_about_the_axis_that_stays_level() {
    let sentences = r"
N is an inertial frame.
The floor is a horizontal plane fixed in N.
$z$ is the upward vertical.
The coin is a uniform thin disc of mass $m$ and radius $r$.
G is the mass centre of the coin.
C is the point where the coin touches the floor.
The coin rolls on the floor at C without slipping.
A is a frame that turns relative to N about $z$ at the rate $w$.
$e$, $f$, $h$ are the axes of A.
$f$ is the unit vector from C to G.
$h$ is the axis of the coin.
The angle between $h$ and $z$ is $a$.
$e$ is horizontal.
G is at rest relative to N.
The coin turns relative to A about $h$ at the rate $s$.
$g$ is the acceleration of gravity.
$V$ is the potential energy of the coin, which is zero on the floor.
$T$ is the kinetic energy of the coin relative to N.
$E$ is the sum of $T$ and $V$.
C moves along the floor relative to N with the speed $v$.
$w$ is positive.
$a$ lies between $0$ and $\pi/2$.
$a$ and $w$ are constant.
";
    let text = r"
$$ z = \sin a\, f + \cos a\, h $$
$$ z = -\sin a\, f + \cos a\, h $$
$$ s = -w\cos a $$
$$ V = m g r\sin a $$
$$ V = m g r\cos a $$
$$ E = T + m g r\sin a $$
";
    assert_eq!(judged(sentences, text), "prpprp");
}
