//! Rods and links: their ends, their hinges, the axis that a body has of its own.

use super::{judged, verdicts};

#[test]
fn a_rod_that_hangs_from_a_hinge_swings_as_a_physical_pendulum() {
    let said = "\
N is an inertial frame.
The rod is a uniform rigid body of mass $m$ and length $l$.
The rod is hinged at its end O, which is fixed in N.
The rod swings in a vertical plane.
$\\theta$ is the angle between the rod and the downward vertical.
$g$ is the acceleration of gravity.
The weight and the force at the hinge are the only loads on the rod.
$I$ is the moment of inertia of the rod about O.
$v$ is the speed of the free end E of the rod.
$T$ is the kinetic energy of the rod.
";
    let text = r"
$$ I = \frac{1}{3} m l^2 $$

$$ T = \frac{1}{6} m l^2 \dot\theta^2 $$

$$ v^2 = l^2 \dot\theta^2 $$

$$ \ddot\theta = -\frac{3g}{2l}\sin\theta $$

$$ \ddot\theta = -\frac{g}{l}\sin\theta $$
";
    assert_eq!(verdicts(said, text).0, "ppppr");
}

#[test]
fn a_rod_between_a_support_and_another_body_has_its_ends_there() {
    let said = "\
N is an inertial frame.
The rod is a uniform thin rod of mass $m$ and length $l$.
The rod is pinned at its upper end O to a fixed support.
The rod swings in a vertical plane.
$\\theta$ is the angle between the rod and the vertical.
G is the mass centre of the rod.
$h$ is the height of G above O.
";
    let text = "$$ h = -\\frac{l}{2}\\cos\\theta $$\n\n$$ h = \\frac{l}{2}\\cos\\theta $$\n";
    assert_eq!(verdicts(said, text).0, "pr");
}

#[test]
fn where_an_axis_of_the_plane_has_a_name_the_side_of_an_angle_is_not_known() {
    let said = "\
N is an inertial frame.
x, y, z are the axes of N.
The rod is a uniform thin rod of mass $m$ and length $l$.
The rod is pinned at its end O to a fixed support.
The rod swings in a vertical plane.
$\\theta$ is the angle between the rod and the downward vertical.
G is the mass centre of the rod.
$a$ is the component along x of the position of G from O.
";
    let text = "$$ a = \\frac{l}{2}\\sin\\theta $$\n\n$$ a = -\\frac{l}{2}\\sin\\theta $$\n";
    assert_eq!(verdicts(said, text).0, "uu");
}

#[test]
fn a_link_points_as_it_does_where_its_angles_are_zero() {
    let said = "\
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
The arm consists of link 1 and link 2.
A is a frame fixed in link 1.
B is a frame fixed in link 2.
S is a point fixed in N and in A.
E is a point fixed in A and in B.
A turns relative to N about z by the angle $\\alpha$.
B turns relative to A about z by the angle $\\beta$.
At $\\alpha=0$ link 1 points along $-y$.
At $\\alpha=0$ and $\\beta=0$ link 2 points along $-y$.
E lies at the distance $l$ from S along link 1.
The mass centre of link 2 lies at the distance $r$ from E along link 2.
$p$ and $q$ are the components along x and y of the position of the mass centre of link 2 from S.
$T$ is the kinetic energy of link 2 as a particle at its mass centre.
$m$ is the mass of link 2.
";
    let text = r"
$$ p = l\sin\alpha + r\sin(\alpha+\beta) $$

$$ q = -l\cos\alpha - r\cos(\alpha+\beta) $$

$$ q = -l\cos\alpha + r\cos(\alpha+\beta) $$

$$ T = \frac12 m (\dot p^2 + \dot q^2) $$
";
    assert_eq!(verdicts(said, text).0, "pprp");
}

#[test]
fn a_body_has_moments_about_its_own_axis_and_across_it() {
    let said = "\
N is an inertial frame.
The wheel is a disc of mass $m$ and radius $r$.
G is the mass centre of the wheel.
$J$ is the moment of inertia of the wheel about its axis.
$I$ is the moment of inertia of the wheel about the axis through G perpendicular to the wheel.
$A$ is the transverse moment of inertia of the wheel.
$C$ is the axial moment of inertia of the wheel.
";
    let text = "$$ J = \\frac12 m r^2 $$\n\n$$ I = J $$\n\n$$ C = 2 A $$\n\n$$ A = C $$\n";
    assert_eq!(verdicts(said, text).0, "pppr");
}

#[test]
fn a_point_fixed_in_what_the_model_has_not_is_not_free_of_it() {
    let said = "\
N is an inertial frame.
The rod is a uniform thin rod of mass $m$ and length $l$.
O is a point fixed in the rod and in the strut.
$T$ is the kinetic energy of the rod.
$u$ is the velocity of O relative to N.
";
    assert_eq!(verdicts(said, "$$ u = 0 $$\n").0, "u");
}

#[test]
fn the_mass_matrix_is_that_of_the_kinetic_energy() {
    let said = "\
N is an inertial frame.
x, y, z are the axes of N.
P is a particle of mass $m$.
O is a point fixed in N.
$r$, $s$ and $0$ are the components of the position of P from O on N.
$M$ is the mass matrix of P in the coordinates $r$, $s$.
";
    let text = "$$ M = \\begin{bmatrix} m & 0 \\\\ 0 & m \\end{bmatrix} $$\n\n$$ M = \\begin{bmatrix} m & 0 \\\\ 0 & 2m \\end{bmatrix} $$\n";
    assert_eq!(verdicts(said, text).0, "pr");
}

#[test]
fn components_that_are_formulas_or_zero_are_premises() {
    let said = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
S is a point fixed in B.
The position of S from G has the components $-l$, $b$, $0$ on B.
$\\omega$ is the angular velocity of B relative to N.
$p$, $q$, $r$ are the components of $\\omega$ on B.
$u$ is the velocity of S relative to N, and $v$ is that of G.
$a$ is the third component on B of $u - v$.
";
    let text = "$$ u - v = \\omega \\times \\begin{bmatrix} -l \\\\ b \\\\ 0 \\end{bmatrix} $$\n\n$$ u - v = \\omega \\times \\begin{bmatrix} l \\\\ b \\\\ 0 \\end{bmatrix} $$\n";
    assert_eq!(verdicts(said, text).0, "pr");
}

#[test]
fn angles_and_what_they_make_are_disturbed_together() {
    let said = "\
N is an inertial frame.
B is a frame fixed in the aircraft.
x, y, z are the axes of B.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to N in the order z, y, x.
$P$, $Q$, $R$ are the components on B of the angular velocity of B relative to N.
$P_0$, $Q_0$, $R_0$ are the reference values of $P$, $Q$, $R$, and $p$, $q$, $r$ their small disturbances.
$\\theta_0$ is the reference value of $\\theta$, and $\\epsilon$ its small disturbance.
$s$ is the small disturbance of $P$.
";
    let text = r"
$$ P_0 = Q_0 = R_0 = 0 $$

$$ P_0 + p = \dot\phi - \dot\psi \sin(\theta_0+\epsilon) $$

$$ P_0 + p = \dot\phi + \dot\psi \sin(\theta_0+\epsilon) $$
";
    assert_eq!(verdicts(said, text).0, "apr");
}

#[test]
fn mass_centres_lie_on_the_axis_of_symmetry_that_is_told() {
    let said = "\
N is an inertial frame.
The spacecraft consists of the platform and the rotor.
P is a frame fixed in the platform.
R is a frame fixed in the rotor.
$b_1$, $b_2$, $b_3$ are the axes of P.
R turns relative to P about $b_3$ at the rate $\\Omega$.
The platform and the rotor are symmetric about $b_3$.
The mass centres of the platform and of the rotor lie on the axis of symmetry and are fixed in P.
G is the mass centre of the spacecraft.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on P of the angular velocity of P relative to N.
$A$, $A$, $C$ are the principal moments of the spacecraft about G on P.
$J$ is the moment of inertia of the rotor about the axis through G along $b_3$.
$H_1$, $H_2$, $H_3$ are the components on P of the angular momentum of the spacecraft about G relative to N.
";
    let text =
        "$$ H_1 = A\\omega_1 $$\n\n$$ H_3 = C\\omega_3 + J\\Omega $$\n\n$$ H_3 = C\\omega_3 $$\n";
    assert_eq!(verdicts(said, text).0, "ppr");
}

#[test]
fn a_potential_energy_is_zero_for_values_of_angles() {
    let said = "\
N is an inertial frame.
The rod is a uniform thin rod of mass $m$ and length $l$.
The rod is hinged at its upper end O, which is fixed in N.
The rod swings in a vertical plane.
$\\theta$ is the angle between the rod and the vertical.
$g$ is the acceleration of gravity.
$V$ is the potential energy of the rod.
$V$ is zero at $\\theta = 0$.
";
    let text =
        "$$ V = \\frac12 m g l (1 - \\cos\\theta) $$\n\n$$ V = -\\frac12 m g l \\cos\\theta $$\n";
    assert_eq!(verdicts(said, text).0, "pr");
}

#[test]
fn which_way_a_rod_hangs_is_told_by_its_ends_alone() {
    let said = |end: &str| {
        format!(
            "N is an inertial frame.
The rod is a uniform thin rod of mass $m$ and length $l$.
The rod is hinged at its {end}O, which is fixed in N.
The rod swings in a vertical plane.
$\\theta$ is the angle between the rod and the vertical.
E is the free end of the rod.
$h$ is the height of E above O.
"
        )
    };
    let text = "$$ h = l\\cos\\theta $$\n\n$$ h = -l\\cos\\theta $$\n";
    assert_eq!(verdicts(&said("lower end "), text).0, "pr");
    assert_eq!(verdicts(&said("upper end "), text).0, "rp");
    assert_eq!(verdicts(&said("end "), text).0, "uu");
}

#[test]
fn a_plane_or_a_hinge_that_moves_is_not_at_rest() {
    let said = |sentence: &str| {
        format!(
            "N is an inertial frame.
A is a frame that turns relative to N.
The rod is a uniform thin rod of mass $m$ and length $l$.
The rod is hinged at its end O.
{sentence}
$\\theta$ is the angle between the rod and the downward vertical.
$T$ is the kinetic energy of the rod.
"
        )
    };
    let text = "$$ T = \\frac16 m l^2 \\dot\\theta^2 $$\n";
    let swings = "The rod swings in a vertical plane.";
    assert_eq!(verdicts(&said(swings), text).0, "p");
    for sentence in [
        "The rod swings in a vertical plane fixed in A.",
        "The rod swings in a vertical plane.\nThe vertical plane turns about the vertical through O at the rate $w$.",
        "The rod swings in a vertical plane.\nO moves relative to N.",
    ] {
        assert_ne!(verdicts(&said(sentence), text).0, "p", "{sentence}");
    }
}

#[test]
fn a_unit_vector_along_a_rod_goes_from_the_one_point_to_the_other() {
    let said = "\
N is an inertial frame.
The rod is a uniform thin rod of mass $m$ and length $l$.
A and B are the ends of the rod.
$u$ is the unit vector along the rod from B to A.
$r$ is the position of B from A.
";
    let text = "$$ r = -l u $$\n\n$$ r = l u $$\n";
    assert_eq!(verdicts(said, text).0, "pr");
}

#[test]
fn columns_of_two_hold_the_first_components() {
    let said = "\
N is an inertial frame.
P is a particle of mass $m$.
O is a point fixed in N.
$r$, $s$ and $0$ are the components of the position of P from O on N.
$\\vec v$ is the velocity of P relative to N.
Columns of two hold the first two components on N.
";
    let text = "$$ \\vec v = \\begin{bmatrix} \\dot r \\\\ \\dot s \\end{bmatrix} $$\n\n$$ \\vec v = \\begin{bmatrix} \\dot s \\\\ \\dot r \\end{bmatrix} $$\n";
    assert_eq!(verdicts(said, text).0, "pr");
}

#[test]
fn a_rod_from_a_point_has_its_mass_centre_half_of_its_length_away() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
B is a frame fixed in the bar.
u, v, z are the axes of B.
A is a point fixed in N and in B.
B turns relative to N about z by the angle $\alpha$.
The bar is a uniform thin rod of mass $m$ and length $l$ from A along u.
$J$ is the moment of inertia of the bar about the axis through A along z.
$T$ is the kinetic energy of the bar.
";
    let text = r"
$$ J=\tfrac13 m l^2 $$
$$ J=\tfrac1{12} m l^2 $$
$$ T=\tfrac16 m l^2\dot\alpha^2 $$
";
    assert_eq!(judged(sentences, text), "prp");
    let placed = sentences.replace(
        " from A along u.",
        " along u.\nThe mass centre of the bar lies at the distance $c$ from A along u.",
    );
    let text = r"
$$ J=\tfrac1{12} m l^2+m c^2 $$
$$ J=\tfrac13 m l^2 $$
";
    assert_eq!(judged(&placed, text), "pr");
}

#[test]
fn a_rod_turns_as_the_way_between_its_ends() {
    let sentences = r"
N is an inertial frame.
$X$, $Y$, $Z$ are the axes of N.
Y is the upward vertical.
O is a point fixed in N.
The beam is a uniform thin rod of mass $m$ and length $b$.
D is the lower end of the beam. E is the upper end of the beam.
D lies at the distance $b\sin q$ from O along X.
E lies at the distance $b\cos q$ from O along Y.
$T$ is the kinetic energy of the beam relative to N.
$w$ is the angular velocity of the beam relative to N.
";
    let text = r"
$$ w = \dot q Z $$
$$ w = -\dot q Z $$
$$ T = \tfrac16 m b^2 \dot q^2 $$
$$ T = \tfrac12 m b^2 \dot q^2 $$
";
    assert_eq!(judged(sentences, text), "prpr");
    // Of another length than the way between its ends it is not known how it lies.
    let longer = sentences.replace("length $b$", "length $a$");
    assert!(!judged(&longer, text).contains('p'));
}

#[test]
fn a_rod_along_a_unit_vector_hangs_where_the_angle_of_that_is_zero() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
The bar is a uniform thin rod of mass $m$ and length $b$.
B is a frame fixed in the bar.
A is a point fixed in N and in B.
A is an end of the bar.
S is the mass centre of the bar.
n is the unit vector from A to S.
B turns relative to N about the axis through A along z by the angle $q$.
The angle between n and the downward vertical is $q$.
$T$ is the kinetic energy of the bar relative to N.
$u$, $v$ are the components along x and y of the position of S from A.
";
    let text = r"
$$ T = \tfrac16 m b^2\dot q^2 $$
$$ T = \tfrac18 m b^2\dot q^2 $$
$$ u = \tfrac{b}{2}\sin q $$
$$ v = -\tfrac{b}{2}\cos q $$
$$ v = \tfrac{b}{2}\cos q $$
";
    assert_eq!(judged(sentences, text), "prppr");
    let up = sentences.replace("downward", "upward");
    let text = r"
$$ v = \tfrac{b}{2}\cos q $$
$$ u = \tfrac{b}{2}\sin q $$
";
    assert_eq!(judged(&up, text), "pr");
}

#[test]
fn a_rod_from_one_point_to_another_has_these_for_its_ends() {
    let sentences = r"
N is an inertial frame.
$k$ is the vertical, pointing up.
A is a frame fixed in the mast and has the axes $e$, $t$, $k$.
A turns relative to N about $k$ at the constant rate $w$.
B is a frame fixed in the jib and has the axes $b$, $c$, $d$.
$c$ and $t$ are the same vector.
$a$ is the angle from $e$ to $b$, positive about $-t$.
The jib's foot O is a point fixed in N, A and B.
The jib is a slender uniform rod (mass $m$, length $l$) reaching from O to P along $b$.
$r$ is the position of P from O.
$T$ is the kinetic energy of the jib relative to N.
";
    let text = r"
$$ r = l\cos a\, e + l\sin a\, k $$
$$ r = l\cos a\, e - l\sin a\, k $$
$$ T = \tfrac16 m l^2(\dot a^2 + w^2\cos^2 a) $$
$$ T = \tfrac16 m l^2(\dot a^2 + w^2\sin^2 a) $$
";
    assert_eq!(judged(sentences, text), "prpr");
}
