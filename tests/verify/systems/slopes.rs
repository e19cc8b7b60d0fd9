//! Bodies that touch planes: how these lie, and the normal force and the friction with which they act.

use super::judged;

/// A wheel on a ramp, in the words of a book: forces by their vectors and magnitudes.
const WHEEL: &str = "N is an inertial frame, with x pointing down the ramp.
y is normal to the ramp, away from it.
x, y, z are the axes of N.
The ramp is a plane fixed in N.
The angle between the ramp and the horizontal is $\\beta$.
The wheel is a uniform thin ring of mass $m$ and radius $b$.
The wheel is symmetric about z.
G is the mass centre of the wheel.
Q is the point where the wheel touches the ramp.
The wheel rolls on the ramp at Q without slipping.
$g$ is the magnitude of the acceleration of gravity.
The weight $\\vec W$ at G, the normal force $\\vec N$ at Q and the friction $\\vec f$ at Q are the only loads on the wheel.
$W$, $N$ and $f$ are the magnitudes of $\\vec W$, $\\vec N$ and $\\vec f$, and the friction points up the ramp.
$\\vec\\alpha$ is the angular acceleration of the wheel relative to N, and $\\alpha$ is its magnitude.
$a$ is the component of the acceleration of G relative to N along x.
$X$ and $Y$ are the components of the total force on the wheel along x and y.
$\\vec q$ is the position of Q from G.
$\\vec\\tau_f$ is the moment of $\\vec f$ about G.
$\\vec\\tau_W$ is the moment of $\\vec W$ about Q, and $\\tau_W$ is its magnitude.
$\\hat k$ is the unit vector along z.
$J$ is the moment of inertia of the wheel about the axis through Q along z.
";

#[test]
fn forces_on_a_wheel_on_a_ramp_by_their_magnitudes() {
    let text = r"
$$ X = W\sin\beta - f $$
$$ Y = N - W\cos\beta = 0 $$
$$ \vec\tau_f = \vec q\times\vec f = -b f\hat k $$
$$ \vec\tau_W = -m g b\sin\beta\,\hat k $$
$$ \tau_W = J\alpha $$
$$ J = 2 m b^2 $$
$$ a = b\alpha $$
$$ m g\sin\beta - f = m b\alpha $$
$$ \alpha = \frac{g\sin\beta}{2b} $$
$$ f = \tfrac12 m g\sin\beta $$
";
    assert_eq!(judged(WHEEL, text), "pppppppppp");
}

#[test]
fn slips_of_forces_on_a_ramp_are_denied() {
    let text = r"
$$ X = W\sin\beta + f $$
$$ Y = N - W\sin\beta $$
$$ \vec\tau_f = b f\hat k $$
$$ \vec\tau_W = m g b\sin\beta\,\hat k $$
$$ a = -b\alpha $$
$$ \alpha = \frac{2g\sin\beta}{3b} $$
";
    assert_eq!(judged(WHEEL, text), "rrrrrr");
}

/// A body of any moment of inertia, the friction as a number up the slope, and the whole force at the contact among the
/// loads.
const ROLLER: &str = "E is an inertial frame, and x, y, z are the axes of E.
The slope is a plane fixed in E, and y is the upward normal of the slope.
x points up the slope.
The slope is inclined to the horizontal by the angle $\\gamma$.
The roller is a solid body of mass $m$ and radius $r$.
The roller is symmetric about the axis through C along z.
C is the mass centre of the roller.
P is the point where the roller touches the slope.
The roller rolls on the slope at P without slipping.
$I$ is the moment of inertia of the roller about the axis through C along z.
$u$ is the component of the velocity of C relative to E along x.
$N$ is the normal force of the slope on the roller.
$F$ is the friction on the roller at P, up the slope.
$g$ is the acceleration of gravity.
The weight and the force of the slope at P are the only loads on the roller.
";

#[test]
fn a_roller_of_any_moment_of_inertia() {
    let text = r"
$$ N = m g\cos\gamma $$
$$ m\dot u = F - m g\sin\gamma $$
$$ F r^2 = -I\dot u $$
$$ \dot u\left(1 + \frac{I}{m r^2}\right) = -g\sin\gamma $$
$$ m\dot u = -F - m g\sin\gamma $$
$$ F r^2 = I\dot u $$
$$ N = m g\sin\gamma $$
";
    assert_eq!(judged(ROLLER, text), "pppprrr");
}

/// A point of the rim that is at the contact now moves as the disc does there.
#[test]
fn a_point_of_the_rim_at_the_contact() {
    let sentences = "E is an inertial frame, and x, y, z are the axes of E.
The ground is a plane fixed in E, and y is its normal.
The disc is a uniform thin disc of mass $m$ and radius $b$.
The disc turns relative to E about z.
G is the mass centre of the disc.
S is a frame that has its origin at G and does not turn relative to E.
C is the point where the disc touches the ground.
The disc rolls on the ground at C without slipping.
P is a point fixed in the disc at the distance $b$ from G.
Up to line 4 $\\vec r$ is the position of P from G, on lines 8 to 9 it is the position of P from C.
$\\vec v$ and $\\vec u$ are the velocities of P relative to E and relative to S.
$\\vec w$ is the velocity of G relative to E.
$\\vec\\omega$ is the angular velocity of the disc relative to E; its component along $-z$ is $\\omega$, which is positive.
$w$ and $a$ are the components along x of the velocity and the acceleration of G relative to E.
On lines 5 to 7 P is at C.
";
    let text = r"$$ \vec u = \vec\omega\times\vec r $$
$$ \vec u = \vec r\times\vec\omega $$
$$ \vec v = \vec u + \vec w $$
$$ w = b\omega $$
$$ \vec v = 0 $$
$$ \vec u = \vec w $$
$$ a = b\dot\omega $$
$$ \vec v = \vec\omega\times\vec r $$
$$ \vec v = \vec r\times\vec\omega $$
";
    assert_eq!(judged(sentences, text), "prppprppr");
}

/// A slope whose axes no sentence names: what rolls there is told by words alone.
const UNNAMED: &str = "E is an inertial frame.
The slope is fixed in E.
The slope makes the angle $\\beta$ with the horizontal.
The hoop is a uniform thin ring of mass $m$ and radius $b$.
The hoop rolls down the slope without slipping.
C is the mass centre of the hoop.
$a$ is the acceleration of C down the slope.
$\\omega$ is the angular velocity of the hoop.
$J$ is the moment of inertia of the hoop about its axis.
$F$ is the friction on the hoop.
$N$ is the normal force on the hoop.
$g$ is the acceleration of gravity.
The weight, the friction and the normal force are the only loads on the hoop.
";

#[test]
fn what_rolls_down_a_slope_turns_forward_about_its_level_axis() {
    let text = r"
$$ m a = m g\sin\beta - F $$
$$ J\dot\omega = F b $$
$$ a = b\dot\omega $$
$$ F = \tfrac12 m g\sin\beta $$
$$ N = m g\cos\beta $$
$$ a = -b\dot\omega $$
$$ m a = F - m g\sin\beta $$
$$ N = m g\sin\beta $$
$$ a = \tfrac23 g\sin\beta $$
";
    assert_eq!(judged(UNNAMED, text), "ppppprrrr");
}

#[test]
fn what_is_counted_up_the_slope_leaves_the_sense_of_rolling_open() {
    let sentences = UNNAMED.replace("acceleration of C down", "acceleration of C up");
    let text = r"
$$ a = -\tfrac12 g\sin\beta $$
$$ a = b\dot\omega $$
$$ a = -b\dot\omega $$
";
    assert_eq!(super::verdicts(&sentences, text).0, "puu");
}

#[test]
fn a_pull_leaves_the_sense_of_the_friction_open() {
    let pull = "The force $P$ along the uphill direction of the slope acts on the hoop at C.\n";
    let sentences = format!("{UNNAMED}{pull}").replace("The weight, the", "The weight, $P$, the");
    let text = r"
$$ F = \tfrac12(m g\sin\beta - P) $$
$$ F = \tfrac12(P - m g\sin\beta) $$
";
    assert_eq!(super::verdicts(&sentences, text).0, "uu");
}

#[test]
fn heights_and_distances_are_counted_from_the_release() {
    let sentences = "E is an inertial frame.
The ramp is fixed in E and inclined at the angle $\\beta$ to the horizontal.
The ball is a uniform sphere of mass $m$ and radius $R$.
The ball rolls down the ramp without slipping.
The ball is released from rest.
C is the mass centre of the ball.
$s$ is the distance that C has moved down the ramp since the release.
$h$ is the height through which C has fallen.
$v$ is the velocity of C down the ramp.
$t$ is the time since the release.
$g$ is the acceleration of gravity.
P is the point where the ball touches the ramp.
The weight and the force at P are the only loads on the ball.
";
    let text = r"
$$ h = s\sin\beta $$
$$ \dot s = v $$
$$ v^2 = \frac{10}{7} g h $$
$$ v = \sqrt{\frac{10}{7} g s\sin\beta} $$
$$ s = \frac{5}{14} g t^2\sin\beta $$
$$ h = s\cos\beta $$
$$ \dot s = -v $$
$$ v^2 = \frac{4}{3} g h $$
";
    assert_eq!(judged(sentences, text), "pppuprrr");
}
