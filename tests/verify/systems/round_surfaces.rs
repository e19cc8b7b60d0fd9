//! Bodies that roll inside or outside of spheres and cylinders.

use super::judged;

const BALL: &str = r"
N is an inertial frame.
$x$, $y$, $z$ are the axes of N.
The bowl is a sphere of radius $R$ fixed in N.
O is the centre of the bowl.
The ball is a uniform solid sphere of mass $m$ and radius $r$.
C is the mass centre of the ball.
P is the point where the ball touches the bowl.
A is a frame that turns relative to N about $z$ by the angle $\theta$.
$a$, $b$, $c$ are the axes of A.
$w$ is the angular velocity of the ball relative to N.
$s$ is the component of $w$ along $z$.
$p$ is the position of P from C.
";

#[test]
fn a_ball_in_a_bowl_touches_it_beyond_its_centre() {
    let place = r"The ball rolls without slipping inside the bowl.
C lies at the distance $R-r$ from O along $a$.
";
    let text = r"
$$ p=r a $$
$$ p=-r a $$
$$ s=-(R-r)\dot\theta/r $$
$$ s=(R-r)\dot\theta/r $$
";
    assert_eq!(judged(&format!("{BALL}{place}"), text), "prpr");
}

#[test]
fn a_ball_on_top_of_a_sphere_touches_it_between_the_centres() {
    let place = r"The ball rolls without slipping on the outside of the bowl.
C lies at the distance $R+r$ from O along $a$.
";
    let text = r"
$$ p=r a $$
$$ p=-r a $$
$$ s=-(R+r)\dot\theta/r $$
$$ s=(R+r)\dot\theta/r $$
";
    assert_eq!(judged(&format!("{BALL}{place}"), text), "rprp");
}

const DISC: &str = r"
N is an inertial frame.
$x$, $y$, $z$ are the axes of N.
O is a point fixed in N.
The drum is a cylinder fixed in N, with the radius $R$ and its axis through O along $z$.
The disc is a uniform thin disc of mass $m$ and radius $r$.
A is a frame that turns relative to N about $z$ by the angle $\theta$.
$a$, $b$, $c$ are the axes of A.
C is the mass centre of the disc.
C lies at the distance $e$ from O along $a$.
The disc turns relative to N about $z$ at the rate $s$.
P is the point where the disc touches the drum.
$p$ is the position of P from O.
$v$ is the velocity of C relative to N.
";

const ROLLS: &str = r"
$$ p=R a $$
$$ v=(R+r)\dot\theta b $$
$$ v=(R-r)\dot\theta b $$
$$ r s=(R+r)\dot\theta $$
$$ r s=-(R-r)\dot\theta $$
";

#[test]
fn a_disc_rolls_on_either_side_of_a_cylinder() {
    let on = |side| format!("{DISC}The disc rolls on the {side} of the drum without slipping.\n");
    assert_eq!(judged(&on("outer surface"), ROLLS), "pprpr");
    assert_eq!(judged(&on("inside"), ROLLS), "prprp");
}

#[test]
fn a_disc_on_a_cylinder_may_be_on_either_side() {
    let on = format!("{DISC}The disc rolls on the drum without slipping.\n");
    assert_eq!(judged(&on, ROLLS), "uuuuu");
}
