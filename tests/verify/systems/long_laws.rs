//! Systems whose laws are long in the letters of the model, and premises that leave it open which factor vanishes.

use super::judged;

/// The moments of the whole stay as they are called: the masses and places of its parts are told by them.
#[test]
fn the_moments_of_a_whole_stay_letters() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the hub.
x, y, z are the axes of B.
The craft consists of the hub and the wheel.
The wheel turns relative to B about x at the rate $s$.
The wheel is symmetric about x, and its mass centre is fixed in B.
C is the mass centre of the craft.
The axes of B are principal axes of the craft.
$A$, $B$, $D$ are the principal moments of the craft about C on B.
$J$ is the moment of inertia of the wheel about x.
$\\omega_x$, $\\omega_y$, $\\omega_z$ are the components on B of the angular velocity of B relative to N.
No moment acts on the craft about C.
$s$ is constant.
";
    let text = r"
$$ B\dot\omega_y = (D - A)\omega_z\omega_x - J s\omega_z $$
$$ D\dot\omega_z = (A - B)\omega_x\omega_y + J s\omega_y $$
$$ A\dot\omega_x = (B - D)\omega_y\omega_z $$
$$ B\ddot\omega_y = (D - A)(\dot\omega_z\omega_x + \omega_z\dot\omega_x) - J s\dot\omega_z $$
$$ \ddot\omega_y = \frac{(D - A)\omega_x - J s}{B}\dot\omega_z + \frac{(D - A)(B - D)}{A B}\omega_y\omega_z^2 $$
$$ \ddot\omega_y = \frac{(D - A)\omega_x - J s}{B}\cdot\frac{(A - B)\omega_x + J s}{D}\omega_y + \frac{(D - A)(B - D)}{A B}\omega_y\omega_z^2 $$
$$ \ddot\omega_y = \frac{(D - A)\omega_x - J s}{B}\cdot\frac{(A - B)\omega_x - J s}{D}\omega_y + \frac{(D - A)(B - D)}{A B}\omega_y\omega_z^2 $$
";
    assert_eq!(judged(sentences, text), "ppppppr");
}

/// Where the products of inertia vanish about two points, the way between these lies along an axis.
#[test]
fn a_line_that_fails_in_each_case_is_denied() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
O is a point fixed in N and in B.
The axes of B are principal axes of the body about G.
$A$, $B$, $C$ are the principal moments of the body about O on B.
$\\omega_x$, $\\omega_y$, $\\omega_z$ are the components on B of the angular velocity of B relative to N.
$M_x$, $M_y$, $M_z$ are the components on B of the total moment on the body about O.
";
    let text = r"
$$ M_x = A\dot\omega_x - (B - C)\omega_y\omega_z $$
$$ M_x = A\dot\omega_x + (B - C)\omega_y\omega_z $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn mass_centres_on_an_axis_have_no_way_across_it() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the hub.
x, y, z are the axes of B.
The craft consists of the hub and the wheel.
C is the mass centre of the craft.
The wheel turns relative to B about z at the rate $s$.
The mass centres of the hub and of the wheel are fixed in B.
The mass centres of the hub and of the wheel lie on the axis through C along z.
The hub is symmetric about z.
The wheel is symmetric about z.
$A$ is the moment of inertia of the craft about the axis through C along x.
$B$ is the moment of inertia of the craft about the axis through C along y.
$D$ is the moment of inertia of the craft about the axis through C along z.
$J$ is the moment of inertia of the wheel about the axis through C along z.
$\\omega_x$, $\\omega_y$, $\\omega_z$ are the components on B of the angular velocity of B relative to N.
No moment acts on the craft about C.
$s$ is constant.
";
    let text = r"
$$ A = B $$
$$ A\dot\omega_x = (A - D)\omega_y\omega_z - J s\omega_y $$
$$ A\dot\omega_y = (D - A)\omega_z\omega_x + J s\omega_x $$
$$ A\dot\omega_y = (D - A)\omega_z\omega_x - J s\omega_x $$
$$ \dot\omega_z = 0 $$
";
    assert_eq!(judged(sentences, text), "ppprp");
}

/// What is said of a reference motion is said of its components: as a vector that stays in space it would be none.
#[test]
fn a_constant_reference_value_has_constant_components() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
$A$, $B$, $C$ are the principal moments of the body about its mass centre on B.
$\\omega$ is the angular velocity of B relative to N, and $\\omega_x$, $\\omega_y$, $\\omega_z$ are its components on B.
No moment acts on the body about its mass centre.
$\\omega_0$ is the reference value of $\\omega$, and $w$ its small disturbance.
$n$ is the component x of $\\omega_0$ on B.
$w_x$, $w_y$, $w_z$ are the components of $w$ on B.
$\\omega_0$ is constant.
Line 1 is assumed.
Lines 2 to 5 hold to first order in $w$.
$\\hat\\imath$ is the axis x of B.
";
    let text = r"$$ \omega_0 = n\hat\imath $$
$$ \dot w_x = 0 $$
$$ B\dot w_y = (C - A) n w_z $$
$$ C\dot w_z = (A - B) n w_y $$
$$ C\dot w_z = (B - A) n w_y $$
";
    assert_eq!(judged(sentences, text), "apppr");
}
