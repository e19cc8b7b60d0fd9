//! Bodies on planes that fall: the vertical is told by an angle.

use super::judged;

const ROLLER: &str = "E is an inertial frame, and x, y, z are the axes of E.
The roller is a uniform cylinder of mass $m$ and radius $R$.
G is the mass centre of the roller.
The incline is a plane fixed in E, and y is its normal.
x points down the incline.
The incline is inclined at an angle $\\alpha$ to the horizontal.
The roller turns relative to E about the axis through G along z.
The roller rolls on the incline at C without slipping.
The weight and the force of the incline at C are the only loads on the roller.
$g$ is the acceleration of gravity.
$v$ is the component along x of the velocity of G relative to E.
$\\omega$ is the component along $-z$ of the angular velocity of the roller relative to E.
$N$ is the component along y of the force of the incline at C, and $f$ its component along $-x$.
$I$ is the moment of inertia of the roller about the axis through G along z.
";

#[test]
fn a_cylinder_rolls_down_an_incline() {
    let text = r"
$$ v = R\omega $$
$$ m\dot v = m g\sin\alpha - f $$
$$ 0 = N - m g\cos\alpha $$
$$ I\dot\omega = f R $$
$$ I = \frac{1}{2} m R^2 $$
$$ \dot v = \frac{2}{3} g\sin\alpha $$
";
    assert_eq!(judged(ROLLER, text), "pppppp");
}

#[test]
fn slips_on_an_incline_are_denied() {
    let text = r"
$$ m\dot v = m g\cos\alpha - f $$
$$ 0 = N - m g\sin\alpha $$
$$ I\dot\omega = -f R $$
$$ \dot v = \frac{1}{2} g\sin\alpha $$
";
    assert_eq!(judged(ROLLER, text), "rrrr");
}

/// An axis that points into the slope: the weight and the force of the slope keep their signs.
#[test]
fn the_normal_may_point_into_the_slope() {
    let sentences = r"
S is an inertial frame.
$i$, $j$, $k$ are the axes of S.
The slope is a plane fixed in S.
$i$ points down the slope, and $j$ is perpendicular to the slope and points into it.
$b$ is the angle of the slope with the horizontal.
The roller is a uniform solid cylinder of mass $m$ and radius $r$.
G is the mass centre of the roller.
The axis of the roller is parallel to $k$.
C is the point where the roller touches the slope.
C is placed from G by $r j$.
The roller rolls on the slope at C without slipping.
$x$ is the coordinate of G along $i$.
$g$ is the acceleration of gravity.
The weight and the force of the slope at C are the only loads on the roller.
The force of the slope on the roller at C is $-F i-N j$.
";
    let text = r"
$$ m\ddot x=m g\sin b-F $$
$$ N=m g\cos b $$
$$ N=-m g\cos b $$
$$ \ddot x=\tfrac23 g\sin b $$
$$ \ddot x=-\tfrac23 g\sin b $$
";
    assert_eq!(judged(sentences, text), "pprpr");
    let outward = sentences
        .replace("points into it", "points away from it")
        .replace("$r j$", "$-r j$")
        .replace("$-F i-N j$", "$-F i+N j$");
    assert_eq!(judged(&outward, text), "pprpr");
}
