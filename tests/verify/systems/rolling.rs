//! Bodies that roll: discs, wheels and balls on planes that rest or turn.

use super::judged;

const DISC: &str = "N is an inertial frame.
$Z$ is the upward vertical.
F turns relative to N about Z by the angle $\\phi$.
A turns relative to F about x by the angle $\\theta$.
The disc turns relative to A about z by the angle $\\psi$.
$\\vec i$, $\\vec j$, $\\vec k$ are the axes of A.
The floor is a horizontal plane fixed in N.
The disc is a uniform thin disc of mass $m$ and radius $r$.
G is the mass centre of the disc.
C is the point where the disc touches the floor.
The disc rolls on the floor at C without slipping.
$\\vec\\omega$ is the angular velocity of the disc relative to N.
$s$ is the component of $\\vec\\omega$ along $\\vec k$.
";

#[test]
fn the_point_of_the_disc_at_the_contact_rests_and_the_place_of_contact_moves() {
    let sentences = format!(
        "{DISC}$\\vec u$ is the velocity of the disc at C relative to N.
$\\vec c$ is the velocity of C relative to N.
$\\vec v$ is the velocity of G relative to N.
$\\vec a$ is the acceleration of the point of the disc at C relative to N.
$\\vec d$ is the position of G from C.
"
    );
    let text = r"
$$ \vec u = 0 $$
$$ \vec c = -r\dot\psi\,\vec i $$
$$ \vec c = 0 $$
$$ \vec d = r\vec j $$
$$ \vec v = \vec\omega\times\vec d $$
$$ \vec v = \vec d\times\vec\omega $$
$$ \vec a = 0 $$
$$ \vec a = r\dot\psi\,\vec\omega\times\vec i $$
$$ \vec a = r\dot\psi\,\vec i\times\vec\omega $$
";
    assert_eq!(judged(&sentences, text), "pprpprrpr");
}

/// The equations are those of the example "rolling disc" of the manual of SymPy's mechanics, with θ a right angle more
/// than its lean and s opposite to its spin.
#[test]
fn a_disc_on_a_rough_floor() {
    let sentences = format!(
        "{DISC}$g$ is the acceleration of gravity.
The weight and the force of the floor at C are the only loads on the disc.
"
    );
    let text = r"
$$ 5\ddot\theta = -4\frac gr\cos\theta - 6 s\dot\phi\sin\theta + \dot\phi^2\sin\theta\cos\theta $$
$$ 3\dot s = 2\dot\theta\dot\phi\sin\theta $$
$$ \ddot\phi\sin\theta + 2\dot\phi\dot\theta\cos\theta = 2 s\dot\theta $$
$$ 5\ddot\theta = -4\frac gr\cos\theta + 6 s\dot\phi\sin\theta + \dot\phi^2\sin\theta\cos\theta $$
$$ 3\dot s = \dot\theta\dot\phi\sin\theta $$
$$ \ddot\phi\sin\theta + \dot\phi\dot\theta\cos\theta = 2 s\dot\theta $$
";
    assert_eq!(judged(&sentences, text), "ppprrr");
}

/// Den Hartog, Mechanics, 1948, section 61: the mill presses on its floor with more than its weight.
#[test]
fn an_edge_runner_mill() {
    let sentences = "N is an inertial frame.
The floor is a horizontal plane fixed in N.
A is a frame that turns relative to N about z at the rate $\\Omega$.
x, y, z are the axes of A.
$\\Omega$ is constant.
The wheel is a uniform thin disc of mass $m$ and radius $a$.
x is the axis of the wheel.
The wheel turns relative to A about x at the rate $\\sigma$.
O is a point fixed in N and in A.
G is the mass centre of the wheel.
G lies at the distance $b$ from O along x.
The wheel rolls on the floor without slipping.
$\\vec M$ is the total moment on the wheel about O.
$M_1$, $M_2$, $M_3$ are the components of $\\vec M$ on A.
$T$ is the kinetic energy of the wheel relative to N.
";
    let text = r"
$$ \sigma = -\frac ba\,\Omega $$
$$ \sigma = \frac ba\,\Omega $$
$$ M_2 = -\tfrac12 m a b\,\Omega^2 $$
$$ M_2 = \tfrac12 m a b\,\Omega^2 $$
$$ M_1 = M_3 = 0 $$
$$ T = \tfrac34 m b^2\Omega^2 + \tfrac18 m a^2\Omega^2 $$
$$ T = \tfrac12 m b^2\Omega^2 + \tfrac18 m a^2\Omega^2 $$
";
    assert_eq!(judged(sentences, text), "prprppr");
}

/// Earnshaw, Dynamics, 1844: the ball runs in a circle, with two sevenths of the rate of the table.
#[test]
fn a_ball_on_a_turntable() {
    let sentences = "N is an inertial frame.
T is a frame that turns relative to N about z at the rate $\\Omega$.
$\\Omega$ is constant.
$\\vec\\Omega$ is the angular velocity of T relative to N.
The table is a horizontal plane fixed in T.
O is a point fixed in N and in T.
The ball is a uniform sphere of mass $m$ and radius $a$.
G is the mass centre of the ball.
The ball rolls on the table at C without slipping.
$g$ is the acceleration of gravity.
The weight and the force at C are the only loads on the ball.
$\\vec r$ is the position of G from O.
$\\frac{d}{dt}$ is the rate seen from N.
";
    let text = r"
$$ \frac{d^2\vec r}{dt^2} = \tfrac27\,\vec\Omega\times\frac{d\vec r}{dt} $$
$$ \frac{d^2\vec r}{dt^2} = \tfrac25\,\vec\Omega\times\frac{d\vec r}{dt} $$
";
    assert_eq!(judged(sentences, text), "pr");
}

/// Routh, Advanced Rigid Dynamics, 1905, article 244: a disc whose axle meets the floor at a fixed point.
#[test]
fn a_leaning_disc_whose_axle_meets_the_floor() {
    let sentences = "N is an inertial frame.
$k$ is the upward vertical.
The table is a horizontal plane fixed in N.
The coin is a uniform thin disc of mass $m$ and radius $b$.
G is the mass centre of the coin.
C is the point where the coin touches the table.
The coin rolls on the table at C without slipping.
Q is a point of the table fixed in N.
The axis of the coin passes through Q.
e is the unit vector from Q to G.
D is a frame that turns relative to N about $k$.
e is fixed in D.
The angle between e and $k$ is $\\beta$.
$\\beta$ lies between $0$ and $\\pi/2$.
$g$ is the acceleration of gravity.
The weight and the force of the table at C are the only loads on the coin.
$s$ is the angular velocity of the coin relative to N along e.
$\\Omega$ is the angular velocity of D relative to N along $k$.
$M$ is the magnitude of the moment of the weight of the coin about C.
$H$ is the magnitude of the angular momentum of the coin about C relative to N.
";
    let text = r"
$$ \Omega\sin\beta = - s\cot\beta\sin\beta\tan\beta $$
$$ M = m g b\cos\beta $$
$$ M = m g b\sin\beta $$
$$ H = \tfrac32 m b^2 s $$
$$ s^2 b = \frac{4g\sin^3\beta}{1+5\sin^2\beta} $$
$$ s^2 b = \frac{4g\sin^2\beta}{1+5\sin^2\beta} $$
";
    assert_eq!(judged(sentences, text), "rprrpr");
}

#[test]
fn a_wheel_with_a_radius_rolls_unless_its_mass_centre_is_aside() {
    let sentences = r"
N is an inertial frame.
$i, j, k$ are the axes of N.
j is the upward vertical.
The floor is a horizontal plane fixed in N.
The wheel moves in the plane of i and j.
B is a frame fixed in the wheel.
$a, b, k$ are the axes of B.
The wheel turns relative to N about $-k$ by the angle $\phi$.
G is the mass centre of the wheel.
P is the point where the wheel touches the floor.
The wheel rolls on the floor at P without slipping.
$r$ is the radius of the wheel.
$v$ is the velocity of G relative to N.
";
    let text = r"
$$ v = r\dot\phi\, i $$
";
    assert_eq!(judged(sentences, text), "p");
    let aside = "C is a point fixed in the wheel.\nG lies at the distance $e$ from C along a.\n";
    assert_eq!(judged(&[sentences, aside].concat(), text), "u");
}

#[test]
fn a_point_of_the_body_does_not_stay_where_the_body_touches() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
The floor is a horizontal plane fixed in N.
The ball is a uniform ball of mass $m$ and radius $r$.
The ball rolls on the floor at C without slipping.
C is a point fixed in the ball.
$a$ is the acceleration of C relative to N.
";
    let text = r"
$$ a = 0 $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn the_mass_centre_of_what_is_made_up_of_parts_may_be_aside() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
z is the upward vertical.
The floor is a horizontal plane fixed in N.
The ball consists of a uniform ball of mass $m$ and radius $r$ and the particle P.
P is a particle of mass $M$.
G is the mass centre of the ball.
The ball rolls on the floor at C without slipping.
$w$ is the angular velocity of the ball relative to N.
$u$ is the velocity of G relative to N.
";
    let text = r"
$$ u = r w\times z $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_wheel_with_its_axis_along_one_of_space_turns_about_that() {
    let text = r"
$$ v = R w\times e_3 $$
$$ v\cdot e_2 = 0 $$
$$ v\cdot e_1 = 0 $$
";
    for said in [
        "The wheel is a uniform thin disc of mass $m$ and radius $R$ with its axis along y.",
        "The wheel is a uniform thin disc of mass $m$ and radius $R$.\nThe axis of the wheel is along y.",
        "The wheel is a uniform thin disc of mass $m$ and radius $R$.\ny is the axis of the wheel.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
x, y, z are the axes of N.
$e_1, e_2, e_3$ are the unit vectors along x, y, z.
z is the upward vertical.
The floor is a horizontal plane fixed in N.
G is the mass centre of the wheel.
$v$ is the velocity of G relative to N.
$w$ is the angular velocity of the wheel relative to N.
The wheel rolls on the floor at Q without slipping.
{said}"
        );
        assert_eq!(judged(&sentences, text), "ppr", "{said}");
    }
}

/// It touches the floor with its lowest point: the axis of its frame that is neither its own nor the one to its centre is level.
#[test]
fn a_round_body_that_touches_the_floor_has_a_level_axis() {
    let sentences = r"
N is an inertial frame.
$k$ is the upward vertical.
The floor is a horizontal plane fixed in N.
The wheel is a uniform thin disc of mass $M$ and radius $b$.
D is the mass centre of the wheel.
P is the point where the wheel touches the floor.
The wheel rolls on the floor at P without slipping.
E is a frame that turns relative to N about $k$ at the constant rate $q$.
$e_1$, $e_2$, $e_3$ are the axes of E.
$e_2$ is the unit vector from P to D.
The wheel is symmetric about $e_3$.
The wheel turns relative to E about $e_3$ at the rate $p$.
The angle between $e_3$ and $k$ is $\beta$.
$v$ is the velocity of D relative to N.
";
    let text = r"
$$ k=\sin\beta\,e_2+\cos\beta\,e_3 $$
$$ k=\cos\beta\,e_2+\sin\beta\,e_3 $$
$$ k\cdot e_1=0 $$
$$ v=-b(p+q\cos\beta)\,e_1 $$
$$ v=b(p+q\cos\beta)\,e_1 $$
";
    assert_eq!(judged(sentences, text), "prppr");
    let unknown = sentences.replace("The wheel is symmetric about $e_3$.\n", "");
    assert_eq!(judged(&unknown, text), "uuuuu");
}
