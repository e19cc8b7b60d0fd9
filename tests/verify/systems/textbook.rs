//! Systems of the textbooks: each by its declarations, with its equations from elsewhere and slips in them.

use super::judged;

/// Landau and Lifshitz, Mechanics, section 14, with θ from the downward vertical.
#[test]
fn a_spherical_pendulum() {
    let sentences = "N is an inertial frame.
$Z$ is the upward vertical.
E turns relative to N about Z by the angle $\\phi$.
A turns relative to E about y by the angle $\\theta$.
$\\vec e$, $\\vec f$, $\\vec n$ are the axes of A.
O is a point fixed in N.
P is a particle of mass $m$.
P lies at the distance $-l$ from O along $\\vec n$.
$g$ is the acceleration of gravity.
The weight and the force $\\vec S$ at O are the only loads on P.
$L$ is the Lagrangian of P.
The potential energy is zero at O.
$\\vec H$ is the angular momentum of P about O relative to N.
";
    let text = r"
$$ L = \tfrac12 m l^2(\dot\theta^2 + \dot\phi^2\sin^2\theta) + m g l\cos\theta $$
$$ L = \tfrac12 m l^2(\dot\theta^2 + \dot\phi^2\sin^2\theta) - m g l\cos\theta $$
$$ \ddot\theta = \dot\phi^2\sin\theta\cos\theta - \frac gl\sin\theta $$
$$ \ddot\theta = -\dot\phi^2\sin\theta\cos\theta - \frac gl\sin\theta $$
$$ \frac{d}{dt}(\dot\phi\sin^2\theta) = 0 $$
$$ \frac{d}{dt}(\dot\phi\sin\theta) = 0 $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

/// Den Hartog, Mechanical Vibrations, 1956, section 6.3: a shaft out of balance in its plane needs these moments.
#[test]
fn an_unbalanced_shaft() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the shaft.
x, y, z are the axes of B.
B turns relative to N about z by the angle $\\phi$.
O is a point fixed in N and in B.
G is the mass centre of the shaft.
G lies at the distance $e$ from O along x.
$m$ is the mass of the shaft.
$\\mathbf I$ is the inertia tensor of the shaft about O.
$I_{xx}$, $I_{yy}$, $I_{zz}$, $I_{xy}$, $I_{xz}$, $I_{yz}$ are entries of $\\mathbf I$ on B.
The products of inertia are integrals.
$\\vec M$ is the total moment on the shaft about O.
$M_x$, $M_y$, $M_z$ are the components of $\\vec M$ on B.
$\\vec F$ is the total force on the shaft.
$F_x$, $F_y$, $F_z$ are the components of $\\vec F$ on B.
";
    let text = r"
$$ M_x = I_{yz}\dot\phi^2 - I_{xz}\ddot\phi $$
$$ M_y = -I_{xz}\dot\phi^2 - I_{yz}\ddot\phi $$
$$ M_z = I_{zz}\ddot\phi $$
$$ F_x = -m e\dot\phi^2 $$
$$ M_x = -I_{yz}\dot\phi^2 - I_{xz}\ddot\phi $$
$$ M_y = I_{xz}\dot\phi^2 - I_{yz}\ddot\phi $$
$$ F_x = m e\dot\phi^2 $$
$$ F_y = m e\dot\phi $$
";
    assert_eq!(judged(sentences, text), "pppprrrr");
}

/// Meriam and Kraige, Dynamics, chapter 7: two point masses on a light rod that is inclined to its axis.
#[test]
fn a_dumb_bell_of_point_masses() {
    let sentences = "N is an inertial frame.
A is a frame that turns relative to N about z at the rate $\\Omega$.
x, y, z are the axes of A.
$\\vec i$, $\\vec j$, $\\vec k$ are the axes of A.
O is a point fixed in N and in A.
$\\beta$ is constant.
The dumb-bell consists of the ball and the bob.
The ball is a particle of mass $m$.
The bob is a particle of mass $m$.
The ball is placed from O by $l\\sin\\beta\\,\\vec i + l\\cos\\beta\\,\\vec k$.
The bob is placed from O by $-l\\sin\\beta\\,\\vec i - l\\cos\\beta\\,\\vec k$.
$l$ is constant.
$\\vec H$ is the angular momentum of the dumb-bell about O relative to N.
$\\vec M$ is the total moment on the dumb-bell about O.
";
    let text = r"
$$ \vec H = 2 m l^2\Omega\sin\beta(\sin\beta\,\vec k - \cos\beta\,\vec i) $$
$$ \vec M\cdot\vec j = -2 m l^2\Omega^2\sin\beta\cos\beta $$
$$ \vec H = 2 m l^2\Omega\sin\beta(\sin\beta\,\vec k + \cos\beta\,\vec i) $$
$$ \vec M\cdot\vec j = 2 m l^2\Omega^2\sin\beta\cos\beta $$
";
    assert_eq!(judged(sentences, text), "pprr");
}

/// Beer and Johnston, Vector Mechanics, chapter 18: a square plate that turns about a corner.
#[test]
fn a_plate_about_a_corner() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the plate.
$\\vec i$, $\\vec j$, $\\vec k$ are the axes of B.
The plate is a body of mass $m$.
O is a point fixed in N and in B.
G is the mass centre of the plate.
$a$ is constant.
G is placed from O by $\\tfrac a2\\vec i + \\tfrac a2\\vec j$.
$A$, $A$, $D$ are the principal moments of the plate about G on B.
$A = \\tfrac1{12}m a^2$.
$D = \\tfrac16 m a^2$.
$\\vec\\omega$ is the angular velocity of B relative to N.
$p$, $q$, $r$ are the components of $\\vec\\omega$ on B.
$\\vec H$ is the angular momentum of the plate about O relative to N.
$T$ is the kinetic energy of the plate relative to N.
";
    let text = r"
$$ \vec H\cdot\vec i = m a^2(\tfrac13 p - \tfrac14 q) $$
$$ \vec H\cdot\vec k = \tfrac23 m a^2 r $$
$$ T = \tfrac16 m a^2(p^2 + q^2 + 2 r^2) - \tfrac14 m a^2 p q $$
$$ \vec H\cdot\vec i = m a^2(\tfrac13 p + \tfrac14 q) $$
$$ T = \tfrac16 m a^2(p^2 + q^2 + r^2) - \tfrac14 m a^2 p q $$
";
    assert_eq!(judged(sentences, text), "ppprr");
}

/// Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, section 7.3: the planar elbow manipulator.
#[test]
fn two_links_of_a_robot_arm() {
    let sentences = "N is an inertial frame.
B turns relative to N about z by the angle $q_1$.
C turns relative to B about z by the angle $q_2$.
x1, y1, z1 are the axes of B.
x2, y2, z2 are the axes of C.
B is a frame fixed in the link.
C is a frame fixed in the hand.
The robot consists of the link and the hand.
O is a point fixed in N and in B.
K lies at the distance $l$ from O along x1.
G is the mass centre of the link.
G lies at the distance $b$ from O along x1.
H is the mass centre of the hand.
H lies at the distance $c$ from K along x2.
$m_1$ is the mass of the link.
$m_2$ is the mass of the hand.
$A_1$, $B_1$, $I_1$ are the principal moments of the link about G on B.
$A_2$, $B_2$, $I_2$ are the principal moments of the hand about H on C.
$T$ is the kinetic energy of the robot relative to N.
$\\vec H$ is the angular momentum of the robot about O relative to N.
$h$ is the component of $\\vec H$ along z1.
";
    let text = r"
$$ T = \tfrac12(m_1 b^2 + I_1)\dot q_1^2 + \tfrac12 I_2(\dot q_1 + \dot q_2)^2 + \tfrac12 m_2\left(l^2\dot q_1^2 + c^2(\dot q_1 + \dot q_2)^2 + 2 l c\cos q_2\,\dot q_1(\dot q_1 + \dot q_2)\right) $$
$$ T = \tfrac12(m_1 b^2 + I_1)\dot q_1^2 + \tfrac12 I_2(\dot q_1 + \dot q_2)^2 + \tfrac12 m_2\left(l^2\dot q_1^2 + c^2(\dot q_1 + \dot q_2)^2 + 2 l c\sin q_2\,\dot q_1(\dot q_1 + \dot q_2)\right) $$
$$ h = \frac{\partial T}{\partial\dot q_1} $$
$$ h = \frac{\partial T}{\partial\dot q_2} $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

/// Hughes, Spacecraft Attitude Dynamics, 1986, section 8.1: M = 3 (μ/R³) u × I u, u downward.
#[test]
fn a_satellite_in_a_gravity_gradient() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the satellite.
G is the mass centre of the satellite.
$\\mathbf I$ is the inertia tensor of the satellite about G.
$A$, $B$, $C$ are the principal moments of the satellite about G on B.
$\\vec M$ is the total moment on the satellite about G.
$\\vec u$ is a unit vector.
$u_1$, $u_2$, $u_3$ are the components of $\\vec u$ on B.
$\\kappa$ is constant.
$\\vec M = 3\\kappa\\,\\vec u\\times\\mathbf I\\vec u$.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
";
    let text = r"
$$ A\dot p = (B - C)q r + 3\kappa(C - B)u_2 u_3 $$
$$ B\dot q = (C - A)r p + 3\kappa(A - C)u_3 u_1 $$
$$ A\dot p = (B - C)q r - 3\kappa(C - B)u_2 u_3 $$
$$ B\dot q = (C - A)r p + 3\kappa(A - C)u_2 u_1 $$
";
    assert_eq!(judged(sentences, text), "pprr");
}

/// Kane and Levinson, Dynamics, 1985: about a point that is moved the moment has m r × a besides.
#[test]
fn a_body_whose_point_is_accelerated() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
P is a point fixed in B.
G is the mass centre of the body.
$m$ is the mass of the body.
$\\vec r$ is the position of G from P.
$\\vec a$ is the acceleration of P relative to N.
$\\mathbf J$ is the inertia tensor of the body about P.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\vec M$ is the total moment on the body about P.
$\\vec F$ is the total force on the body.
";
    let text = r"
$$ \vec M = \mathbf J\dot{\vec\omega} + \vec\omega\times\mathbf J\vec\omega + m\vec r\times\vec a $$
$$ \vec F = m\vec a + m\dot{\vec\omega}\times\vec r + m\vec\omega\times(\vec\omega\times\vec r) $$
$$ \vec M = \mathbf J\dot{\vec\omega} + \vec\omega\times\mathbf J\vec\omega $$
$$ \vec M = \mathbf J\dot{\vec\omega} + \vec\omega\times\mathbf J\vec\omega - m\vec r\times\vec a $$
$$ \vec F = m\vec a + m\dot{\vec\omega}\times\vec r - m\vec\omega\times(\vec\omega\times\vec r) $$
";
    assert_eq!(judged(sentences, text), "pprrr");
}

/// Schaub and Junkins, Analytical Mechanics of Space Systems, section 4.5: a wheel of variable speed in a gimbal.
#[test]
fn a_control_moment_gyro_of_variable_speed() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the craft.
A turns relative to B about y by the angle $\\gamma$.
$\\vec s$, $\\vec g$, $\\vec t$ are the axes of A.
W turns relative to A about x by the angle $\\beta$.
W is a frame fixed in the wheel.
A is a frame fixed in the gimbal.
G is the mass centre of the wheel.
K is the mass centre of the gimbal.
$J_s$, $J_t$, $J_t$ are the principal moments of the wheel about G on A.
$\\vec\\omega$ is the angular velocity of B relative to N.
$a$, $b$, $c$ are the components of $\\vec\\omega$ on A.
$\\Omega$ is the rate of $\\beta$.
$\\vec h$ is the angular momentum of the wheel about G relative to N.
$\\vec M$ is the total moment on the wheel about G.
";
    let text = r"
$$ \vec h = J_s(a + \Omega)\vec s + J_t(b + \dot\gamma)\vec g + J_t c\,\vec t $$
$$ \vec M\cdot\vec s = J_s(\dot a + \dot\Omega) $$
$$ \vec M\cdot\vec g = J_t(\dot b + \ddot\gamma) + J_s(a + \Omega) c - J_t a c $$
$$ \vec h = J_s(a - \Omega)\vec s + J_t(b + \dot\gamma)\vec g + J_t c\,\vec t $$
$$ \vec M\cdot\vec s = J_s(\dot a + \dot\Omega) + J_t c\dot\gamma $$
$$ \vec M\cdot\vec g = J_t(\dot b + \ddot\gamma) + J_s(a + \Omega) c $$
";
    assert_eq!(judged(sentences, text), "ppprrr");
}
