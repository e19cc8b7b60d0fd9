//! Motion in a plane with contacts: what rolls on planes that rest or move, wheels that mesh, strings, and ladders.

use super::{judged, verdicts};

/// The hoop turns across the plane of the way along which it rolls and the vertical, and no sentence says so.
#[test]
fn a_hoop_pulled_along_a_floor() {
    let sentences = "N is an inertial frame with the axes x, y, z, and y is the upward vertical.
The floor is a horizontal plane fixed in N.
The hoop is a uniform thin ring of mass $m$ and radius $b$.
The hoop rolls along x on the floor without slipping.
G is the mass centre of the hoop.
$s$ is the displacement of G along x.
$w$ is the angular velocity of the hoop along z.
The constant force $P$ acts on the hoop at G along x.
$f$ is the friction of the floor on the hoop along $-x$.
$N$ is the normal force of the floor on the hoop.
The weight, the force $P$ and the force of the floor are the only loads on the hoop.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \dot s=-b w $$
$$ \dot s=b w $$
$$ m\ddot s=P-f $$
$$ m\ddot s=P+f $$
$$ \ddot s=\frac{P}{2m} $$
$$ \ddot s=\frac{2P}{3m} $$
$$ f=\frac P2 $$
$$ f=-\frac P2 $$
$$ N=mg $$
";
    assert_eq!(judged(sentences, text), "prprprprp");
}

/// A slope whose axes are told in one clause, and loads that point up and away from it.
#[test]
fn a_roller_on_a_slope_with_named_axes() {
    let sentences = "E is an inertial frame.
The incline is a plane fixed in E that makes the angle $a$ with the horizontal.
$x$, $y$, $z$ are the axes of E, where $x$ points down the incline and $y$ is the upward normal of the incline.
The roller is a uniform solid cylinder of mass $m$ and radius $b$.
The axis of the roller is parallel to $z$.
K is the mass centre of the roller, and Q is the point where it touches the incline.
The roller rolls on the incline without slipping.
$s$ is the distance that K has travelled along $x$.
The roller turns relative to E about $-z$ by the angle $q$.
At Q the incline acts on the roller with the normal force $H$ along $y$ and with the friction $J$ along $-x$.
Apart from these two forces only the weight acts on the roller.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \dot s=b\dot q $$
$$ \dot s=-b\dot q $$
$$ m\ddot s=mg\sin a-J $$
$$ m\ddot s=mg\sin a+J $$
$$ H=mg\cos a $$
$$ H=mg\sin a $$
$$ \tfrac12mb^2\ddot q=Jb $$
$$ \ddot s=\frac23g\sin a $$
$$ \ddot s=\frac23g\cos a $$
$$ J=\frac13mg\sin a $$
";
    assert_eq!(judged(sentences, text), "prprprpprp");
}

/// The plank moves, and so does what rolls on it.
#[test]
fn a_disc_on_a_belt_that_moves() {
    let sentences = "E is an inertial frame with the axes x, y, z, and y is the upward vertical.
The belt is horizontal.
$u$ is the velocity of the belt relative to E along x.
The disc is a uniform disc of mass $m$ and radius $b$.
The disc rolls on the belt without slipping.
The axis of the disc is parallel to z.
G is the mass centre of the disc.
$v$ is the velocity of G relative to E along x.
$w$ is the angular velocity of the disc relative to E along z.
The weight and the force of the belt are the only loads on the disc.
$R$ is the component of the force of the belt on the disc along x.
";
    let text = r"
$$ v+b w=u $$
$$ v-b w=u $$
$$ v=-bw $$
$$ m\dot v=R $$
$$ \dot v=\frac13\dot u $$
$$ \dot v=\frac23\dot u $$
$$ \dot w=\frac{2\dot u}{3b} $$
$$ \dot w=-\frac{2\dot u}{3b} $$
";
    assert_eq!(judged(sentences, text), "prrpprpr");
}

#[test]
fn gears_turn_against_each_other_and_a_pinion_in_a_ring_with_it() {
    let outside = "H is an inertial frame; x, y, z are its axes.
A and B are fixed in H.
B lies at the distance $a+b$ from A along x.
Gear 1 has the radius $a$, and gear 2 has the radius $b$.
Gear 1 turns relative to H about z by the angle $p$.
Gear 2 turns relative to H about z by the angle $q$.
A is the mass centre of gear 1.
B is the mass centre of gear 2.
Gears 1 and 2 touch each other at P and roll on one another without slipping.
";
    let text = r"
$$ a\dot p+b\dot q=0 $$
$$ a\dot p-b\dot q=0 $$
";
    assert_eq!(judged(outside, text), "pr");
    let inside = "H is an inertial frame; x, y, z are its axes.
A and B are fixed in H.
B lies at the distance $c-b$ from A along x.
The ring has the radius $c$, and the pinion has the radius $b$.
The ring turns relative to H about z by the angle $p$.
The pinion turns relative to H about z by the angle $q$.
A is the mass centre of the ring.
B is the mass centre of the pinion.
The pinion rolls inside the ring without slipping.
";
    let text = r"
$$ c\dot p=b\dot q $$
$$ c\dot p=-b\dot q $$
";
    assert_eq!(judged(inside, text), "pr");
}

/// The side on which the string leaves the disc tells how this turns.
#[test]
fn a_disc_unwinds_from_a_string_on_a_side_that_is_told() {
    let sentences = "The room is an inertial frame, and x, y, z are its axes.
z is the upward vertical.
The string is wound on the disc.
The string hangs from the ceiling, which is fixed in the room.
The string is vertical.
The disc is a uniform disc of mass $m$ and radius $b$.
G is the mass centre of the disc.
The string leaves the disc at C.
C lies at the distance $b$ from G along x.
The disc turns relative to the room about y at the rate $w$.
$F$ is the tension of the string.
$h$ is the displacement of G along z.
The weight and the pull of the string at C are the only loads on the disc.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \dot h=b w $$
$$ \dot h=-b w $$
$$ m\ddot h=F-mg $$
$$ m\ddot h=mg-F $$
$$ F=\frac13mg $$
$$ F=\frac23mg $$
$$ \ddot h=-\frac23g $$
";
    assert_eq!(judged(sentences, text), "prprprp");
}

#[test]
fn a_ladder_slides_on_a_wall_and_a_floor() {
    let sentences = "E is an inertial frame with the axes x, y, z, and y is the upward vertical.
O is a point fixed in E.
The ladder AB is a uniform thin rod of mass $m$ and length $2a$.
The wall is the line through O along y, and the floor is the line through O along x.
A slides on the wall, and B slides on the floor.
$q$ is the angle from $-y$ to the line from A to B, counted about z.
$T$ is the kinetic energy of the ladder AB relative to E.
The wall acts on the ladder AB at A with the force $P$ along x, and the floor acts on it at B with the force $Q$ along y.
These forces and the weight are the only loads on the ladder AB.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ T=\tfrac23ma^2\dot q^2 $$
$$ T=\tfrac16ma^2\dot q^2 $$
$$ \ddot q=\frac{3g}{4a}\sin q $$
$$ \ddot q=\frac{3g}{4a}\cos q $$
$$ P=ma(\ddot q\cos q-\dot q^2\sin q) $$
$$ P=ma(\ddot q\cos q+\dot q^2\sin q) $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

/// The piston moves on a line, and the crank is called by its ends.
#[test]
fn a_crank_drives_a_piston_along_a_line() {
    let sentences = r"N is an inertial frame, and $i$, $j$, $k$ are its axes.
O is a point fixed in N.
The crank OA has the length $b$ and is hinged at O.
$p$ is the angle from $i$ to the line OA, counted about $k$.
The connecting rod AB, which has the length $l$, is hinged to the crank at A and to the piston at B.
B moves on the straight line through O along $i$.
B is placed from A by $l\cos q\,i-l\sin q\,j$.
$q$ lies between $-\pi/2$ and $\pi/2$.
$s$ is the component of the position of B from O along $i$.
";
    let text = r"
$$ b\sin p=l\sin q $$
$$ b\cos p=l\cos q $$
$$ s=b\cos p+l\cos q $$
$$ s=b\cos p-l\cos q $$
$$ \dot q=\frac{b\dot p\cos p}{l\cos q} $$
$$ \dot q=-\frac{b\dot p\cos p}{l\cos q} $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

/// The force of a trough where a cylinder rolls in it is that of the list of loads.
#[test]
fn a_cylinder_presses_on_the_trough_in_which_it_rolls() {
    let sentences = "S is an inertial frame; x, y, z are its axes and y is vertical upward.
The trough is a hollow circular cylinder fixed in S, of radius $R$, whose axis passes through the point A along z.
The cylinder is a uniform solid cylinder of mass $m$ and radius $r$.
The cylinder rolls without slipping inside the trough.
The cylinder turns relative to S about z.
C is the centre of the cylinder.
$q$ is the angle from the downward vertical to the line from A to C, positive about z.
$N$ is the normal force of the trough on the cylinder.
The weight and the force of the trough are the only loads on the cylinder.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ N=mg\cos q+m(R-r)\dot q^2 $$
$$ N=mg\cos q-m(R-r)\dot q^2 $$
$$ \ddot q=-\frac{2g}{3(R-r)}\sin q $$
$$ \ddot q=\frac{2g}{3(R-r)}\sin q $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

/// Where the way is not told along which a disc rolls, nothing is known of how it turns.
#[test]
fn what_rolls_anyhow_is_left_open() {
    let sentences = "N is an inertial frame with the axes x, y, z, and y is the upward vertical.
The floor is a horizontal plane fixed in N.
The disc is a uniform disc of mass $m$ and radius $b$.
The disc rolls on the floor without slipping.
G is the mass centre of the disc.
$v$ is the velocity of G relative to N along x.
$w$ is the component of the angular velocity of the disc relative to N along z.
$u$ is the component of the angular velocity of the disc relative to N along x.
";
    let text = r"
$$ v=-bw $$
";
    let found = verdicts(sentences, text).0;
    assert!(!found.contains('p'), "{found}");
}

/// The letter of the whole force at a contact and the one of its normal part are of one load.
#[test]
fn the_normal_force_is_a_part_of_a_force_with_a_letter() {
    let sentences = "E is an inertial frame, and x, y, z are the axes of E.
The slope is a plane fixed in E, and y is the upward normal of the slope.
x points up the slope.
The slope is inclined to the horizontal by the angle $c$.
The roller is a uniform solid cylinder of mass $m$ and radius $r$.
The roller is symmetric about z.
C is the mass centre of the roller.
P is the point where the roller touches the slope.
The roller rolls on the slope at P without slipping.
$u$ is the component of the velocity of C relative to E along x.
$N$ is the normal force of the slope on the roller.
$\\vec f$ is the force of the slope at P.
$g$ is the acceleration of gravity.
The weight and the force of the slope at P are the only loads on the roller.
";
    let text = r"
$$ N=mg\cos c $$
$$ N=mg\sin c $$
$$ \dot u=-\frac23g\sin c $$
";
    assert_eq!(judged(sentences, text), "prp");
}
