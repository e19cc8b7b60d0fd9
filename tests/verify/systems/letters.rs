//! Letters that labels or lines of the document tell of.

use super::{judged, judged_in_any_order, verdicts};

#[test]
fn labels_name_frames_that_no_sentence_introduces() {
    let sentences = "$R_{XY}$ takes components on X to components on Y, for any frames X and Y.
$\\omega_{XY}$ is the angular velocity of X relative to Y, for any frames X and Y.
A frame at the upper left means components on that frame.
A tilde means the cross-product matrix.
A dot means the rate, entry by entry.
";
    let text = r"
$$ R_{CB} = R_{AB} R_{CA} $$
$$ R_{CB} = R_{CA} R_{AB} $$
$$ R_{CB} = R_{BA}^T R_{CA} $$
$$ {}^C\omega_{CA} = {}^C\omega_{CB} + R_{BC}\,{}^B\omega_{BA} $$
$$ {}^C\omega_{CA} = {}^C\omega_{CB} + {}^B\omega_{BA} $$
$$ \dot R_{BA} = R_{BA}\,{}^B\tilde\omega_{BA} $$
$$ \dot R_{BA} = {}^B\tilde\omega_{BA} R_{BA} $$
";
    assert_eq!(judged(sentences, text), "prpprpr");
}

#[test]
fn labels_say_which_angular_velocity_is_meant() {
    let sentences = "N is an inertial frame.
B is a frame that turns relative to N.
$w_{X/Y}$ is the angular velocity of Y relative to X, for any frames X and Y.
$\\omega$ is the angular velocity of B relative to N.
";
    let text = "$$ w_{N/B} = \\omega $$\n$$ w_{B/N} = \\omega $$\n";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_letter_that_is_constant_is_still_what_another_sentence_says() {
    let sentences = [
        "N is an inertial frame.",
        "B is a frame fixed in the plate.",
        "$i$, $j$ and $k$ are the axes of N.",
        "$u$, $v$ and $k$ are the axes of B.",
        "B turns relative to N about $k$ by the angle $\\theta$.",
        "P is a point fixed in B.",
        "O is a point fixed in N and in B.",
        "$r$ is the position of P from O.",
        "$x$ and $y$ are the components of $r$ along $u$ and $v$.",
        "$e$ is the same as $k$.",
        "$r$ is perpendicular to $e$.",
        "$x$ and $y$ are constant.",
        "$\\omega$ is the angular velocity of B relative to N along $k$.",
        "$w$ is the velocity of P relative to N.",
    ];
    let text = "$$ w = \\omega (x v - y u) $$\n$$ w = \\omega (x v + y u) $$\n";
    judged_in_any_order(&sentences, text, "pr");
}

#[test]
fn a_definition_may_use_what_a_later_one_says() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the craft, and D is a frame that turns relative to N.
$R$ takes components on B to components on N.
$S$ takes components on D to components on N.
$w$ is the angular velocity of B relative to N, in components on B.
A dot means the rate, entry by entry.
A wedge at the upper right means the cross-product matrix.
A vee at the upper right means the vector of which the matrix is the cross-product matrix.
";
    let text = r"
The error is
$$ e := w - R^T S d $$
where
$$ d = (S^T \dot S)^\vee. $$
$$ R e = R w - S d $$
$$ R e = R w + S d $$
";
    assert_eq!(judged(sentences, text), "aapr");
}

#[test]
fn rotations_about_axes_are_functions_of_any_angle() {
    let sentences = "N is an inertial frame.
$\\psi$, $\\theta$, $\\phi$ are the Euler angles of B relative to N in the order z, y, x.
$R$ takes components on B to components on N.
$R_z(a)$ is the rotation matrix about z by $a$, for any angle $a$.
$R_x(a)$ and $R_y(a)$ are the rotation matrices by $a$ about x and y, for any angle $a$.
$C_1(a)$ is the passive rotation matrix about x by the angle $a$, for any angle $a$.
";
    let text = r"
$$ R = R_z(\psi) R_y(\theta) R_x(\phi) $$
$$ R = R_x(\phi) R_y(\theta) R_z(\psi) $$
$$ C_1(\phi) = R_x(\phi)^T $$
$$ C_1(\phi) = R_x(-\phi) $$
$$ C_1(\phi) = R_x(\phi) $$
$$ R_y(\theta) = \begin{bmatrix} \cos\theta & 0 & \sin\theta \\ 0 & 1 & 0 \\ -\sin\theta & 0 & \cos\theta \end{bmatrix} $$
$$ R_z(\psi)^2 = R_z(2\psi) $$
";
    assert_eq!(judged(sentences, text), "prpprpp");
}

#[test]
fn a_rotation_by_another_angle_than_the_argument_is_not_read() {
    let sentences = "$R_z(a)$ is the rotation matrix about z by $b$, for any angle $a$.\n";
    let text = "$$ R_z(c) = R_z(-c)^T $$\n";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn products_of_inertia_by_their_labels_follow_the_convention_that_is_said() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
O is a point fixed in N and in B.
$I_{xy}$, $I_{xz}$ and $I_{yz}$ are the products of inertia of the body about O on B.
$I_{xx}$, $I_{yy}$, $I_{zz}$ are the moments of inertia of the body about the axes of B through O.
$p$, $q$, $r$ are the components on B of the angular velocity of the body relative to N.
$L$ is the component along x of the angular momentum of the body about O.
$x$, $y$, $z$ are the axes of B.
";
    let text =
        "$$ L = I_{xx} p - I_{xy} q - I_{xz} r $$\n$$ L = I_{xx} p + I_{xy} q + I_{xz} r $$\n";
    let with = |said: &str| judged(&format!("{sentences}{said}\n"), text);
    assert_eq!(with("The products of inertia are integrals."), "pr");
    assert_eq!(with("The products of inertia are entries."), "rp");
    assert_eq!(with("$a$ is a constant."), "uu");
}

#[test]
fn an_axis_that_is_said_to_be_a_unit_vector_is_still_the_axis() {
    let sentences = "N is an inertial frame.
$i$, $j$ and $k$ are the axes of N.
$i$, $j$ and $k$ are unit vectors.
";
    let text = "$$ i \\times j = k $$\n$$ j \\times i = k $$\n";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn the_imaginary_unit_has_the_square_minus_one() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the body.
G is the mass centre of the body.
No moment acts on the body about G.
$I$, $I$ and $J$ are the principal moments of the body about G on B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
$i$ is the imaginary unit.
$\\eta = p + i q$.
$\\Omega = \\frac{J - I}{I} r$.
";
    let text = r"
$$ \dot\eta = i \Omega \eta $$
$$ \dot\eta = -i \Omega \eta $$
$$ \dot\eta = \Omega \eta $$
$$ i^3 = -i $$
$$ i^3 = i $$
$$ (p + i q)(p - i q) = p^2 + q^2 $$
";
    assert_eq!(judged(sentences, text), "puupup");
}

#[test]
fn parts_of_a_document_that_are_not_understood_may_be_anywhere() {
    let sentences = "N is an inertial frame.
$p$ is the mass of P.
P is a particle.
$q$ is the mass of Q.
Q is a particle.
On line 9 and in the first formula of line 1 $p$ is the foot of G.
";
    assert_eq!(verdicts(sentences, "$$ p = q $$\n").0, "u");
}

/// `\frac{d v}{dt^B}`: the frame may stand above the time.
#[test]
fn a_frame_may_be_written_at_the_time() {
    let sentences = "N is an inertial frame.
B is a frame that turns relative to N.
O is a point fixed in N and in B.
$r$ is the position of P from O.
$\\omega$ is the angular velocity of B relative to N.
$\\omega$ is constant.
$\\frac{d}{dt^N}$ is the rate seen from N.
$\\frac{d}{dt^B}$ is the rate seen from B.
";
    let text = r"
$$ \frac{dr}{dt^N} = \frac{dr}{dt^B} + \omega\times r $$
$$ \frac{dr}{dt^N} = \frac{dr}{dt^B} - \omega\times r $$
$$ \frac{d^2r}{(dt^N)^2} = \frac{d^2r}{(dt^B)^2} + 2\omega\times\frac{dr}{dt^B} + \omega\times(\omega\times r) $$
";
    assert_eq!(judged(sentences, text), "prp");
}
