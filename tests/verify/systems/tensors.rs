//! What is said of an inertia tensor in words: products that vanish, symmetry.

use super::judged;

const AIRCRAFT: &str = "E is an inertial frame, and B is a frame fixed in the aircraft.
C is the mass centre of the aircraft.
x, y, z are the axes of B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to E.
$I_x$, $I_y$, $I_z$ are the moments of inertia of the aircraft about the axes of B through C.
$L$ is the component x on B of the total moment on the aircraft about C.
The products of inertia are integrals.
";

const ROLL: &str = r"
$$ L = I_x \dot p - J_{xz}(\dot r + p q) - (I_y - I_z) q r $$
$$ L = I_x \dot p + J_{xz}(\dot r + p q) - (I_y - I_z) q r $$
";

#[test]
fn the_other_products_are_those_that_no_letter_names() {
    for others in [
        "The other products of inertia are zero.",
        "The remaining products of inertia vanish.",
    ] {
        let sentences = format!(
            "{AIRCRAFT}$J_{{xz}}$ is the product of inertia of the aircraft about C in the axes x and z of B.\n{others}\n"
        );
        assert_eq!(judged(&sentences, ROLL), "pr", "{others}");
    }
}

#[test]
fn without_a_letter_for_one_there_are_no_other_products() {
    let sentences = format!("{AIRCRAFT}The other products of inertia are zero.\n");
    assert_eq!(
        judged(&sentences, "$$ L = I_x \\dot p - (I_y - I_z) q r $$\n"),
        "u"
    );
}

#[test]
fn all_products_may_vanish() {
    let sentences =
        format!("{AIRCRAFT}The products of inertia of the aircraft about C on B are zero.\n");
    let text = "$$ L = I_x \\dot p - (I_y - I_z) q r $$\n$$ L = I_x \\dot p + (I_y - I_z) q r $$\n";
    assert_eq!(judged(&sentences, text), "pr");
}

#[test]
fn a_body_is_symmetric_about_a_letter_of_an_axis() {
    let sentences = "N is an inertial frame, and B is a frame fixed in the body.
G is the mass centre of the body.
The axes of B are principal axes of the body.
$a$ and $b$ are the first and third axes of B.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.
The body is symmetric about $b$.
";
    assert_eq!(
        judged(sentences, "$$ I_1 = I_2 $$\n$$ I_1 = I_3 $$\n"),
        "pr"
    );
}

#[test]
fn a_total_force_may_be_said_to_vanish() {
    let sentences = "N is an inertial frame.
G is the mass centre of the body.
The total force on the body is zero.
$v$ is the velocity of G relative to N.
";
    assert_eq!(judged(sentences, "$$ \\dot v = 0 $$\n$$ v = 0 $$\n"), "pr");
}

#[test]
fn axes_that_are_not_those_of_the_label_tell_no_product() {
    let sentences = format!(
        "{AIRCRAFT}$J_{{xz}}$ is the product of inertia of the aircraft about C in the axes x and y of B.\nThe other products of inertia are zero.\n"
    );
    assert_eq!(judged(&sentences, ROLL), "uu");
}

const CUBE: &str = "N is an inertial frame.
The cube is a uniform solid cube of mass $M$ and side $a$.
B is a frame fixed in the cube.
x, y, z are the axes of B.
$J$ is the inertia tensor of the cube about O in components on B.
$I_p$ is the moment of inertia of the cube about the axis through O along $(1,1,1)$.
";

/// The edges at a corner lie on the positive sides of their axes; a direction by numbers has no length.
#[test]
fn a_corner_is_where_the_edges_meet() {
    let text = r"
$$ J_{11} = \frac23Ma^2 $$
$$ J_{12} = -\frac14Ma^2 $$
$$ J_{12} = \frac14Ma^2 $$
$$ I_p = \frac16Ma^2 $$
$$ I_p = \frac12Ma^2 $$
";
    for said in [
        "The edges of the cube at O lie along x, y and z.",
        "O is the corner of the cube from which its edges run along x, y and z.",
    ] {
        assert_eq!(judged(&format!("{CUBE}{said}\n"), text), "pprpr", "{said}");
    }
}

#[test]
fn a_box_has_corners_where_its_sides_are_told() {
    let sentences = "N is an inertial frame.
The block is a uniform box of mass $M$.
B is a frame fixed in the block.
x, y, z are the axes of B.
$a$, $b$, $c$ are the sides of the block along x, y, z.
The edges of the block at O lie along x, y and z.
$J$ is the inertia tensor of the block about O in components on B.
";
    let text = r"
$$ J_{11} = \frac13M(b^2+c^2) $$
$$ J_{23} = -\frac14Mbc $$
$$ J_{23} = -\frac14Mab $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn principal_moments_may_be_those_of_a_sum() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$J$ is the inertia tensor of the body about G.
$K$ is the inertia tensor of the body about G.
$A$, $D$, $C$ are the principal moments of $J+K$ on B.
$\\omega$ is the angular velocity of B relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\omega$ on B.
";
    let text = r"
$$ \omega\cdot(J\omega) = \frac12(A\omega_1^2+D\omega_2^2+C\omega_3^2) $$
$$ \omega\cdot(J\omega) = A\omega_1^2+D\omega_2^2+C\omega_3^2 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_convention_of_signs_holds_where_it_is_said() {
    let sentences = r"N is an inertial frame.
K is a frame fixed in the body.
O is a point fixed in N and in K.
$\vec\omega$ is the angular velocity of the body relative to N.
$\omega_j$ is the component $j$ of $\vec\omega$ on K.
On lines 1 to 5 $\vec L$ is the angular momentum of the body about O relative to N.
On lines 6 to 9 $\vec L$ is the angular momentum of the body about G relative to N.
G is the mass centre of the body.
On lines 1 to 5 $\Theta$ is the inertia tensor of the body about O in components on K.
On lines 6 to 9 $\Theta$ is the inertia tensor of the body about G in components on K.
On lines 1 to 9 $\Theta_{ij}$ is entry (i, j) of $\Theta$.
On lines 1 to 9 $L_i$ is the component $i$ of $\vec L$ on K.
$i$ and $j$ number the axes of K.
A repeated axis index is summed.
On lines 20 to 30 products of inertia are integrals.
";
    let text = r"
$$ L_i = \Theta_{ij}\omega_j $$
$$ L_1 = \Theta_{11}\omega_1 + \Theta_{12}\omega_2 + \Theta_{13}\omega_3 $$
$$ L_1 = \Theta_{11}\omega_1 - \Theta_{12}\omega_2 - \Theta_{13}\omega_3 $$
$$ \Theta = (\Theta_{ij}) $$

$$ L_i = \Theta_{ij}\omega_j $$
";
    assert_eq!(judged(sentences, text), "pprup");
}

#[test]
fn what_is_symmetric_about_a_plane_has_no_products_across_it() {
    let text = r"
$$ I_{xy} = 0 $$
$$ I_{xz} = 0 $$
";
    for said in [
        "The aircraft is symmetric about the plane of x and z.",
        "The aircraft is symmetric about the x-z plane.",
        "The plane of symmetry of the aircraft is the plane of x and z.",
        "The xz plane is a plane of symmetry of the aircraft.",
    ] {
        let sentences = format!(
            r"N is an inertial frame.
B is a frame fixed in the aircraft.
x, y, z are the axes of B.
G is the mass centre of the aircraft.
$I$ is the inertia tensor of the aircraft about G in components on B.
{said}"
        );
        assert_eq!(judged(&sentences, text), "pr", "{said}");
    }
}

#[test]
fn a_line_of_principal_axes_is_open_where_nobody_tells_the_products() {
    let text = r"
$$ L = I_x \dot p - (I_y - I_z) q r $$
$$ L = I_x \dot p + (I_y - I_z) q r $$
";
    assert_eq!(judged(AIRCRAFT, text), "ur");
    let told = format!(
        "{AIRCRAFT}$J_{{xz}}$ is the product of inertia of the aircraft about C in the axes x and z of B.\nThe other products of inertia are zero.\n"
    );
    assert_eq!(judged(&told, text), "rr");
}

#[test]
fn a_part_of_which_one_moment_is_told_may_have_others() {
    let sentences = r"N is an inertial frame.
The gyroscope consists of the ring and the rotor.
A is a frame fixed in the ring.
B is a frame fixed in the rotor.
$b_1$, $b_2$, $b_3$ are the axes of B.
A turns relative to N about $n_3$ by the angle $\alpha$.
$n_1$, $n_2$, $n_3$ are the axes of N.
B turns relative to A about $b_1$ by the angle $\beta$.
O is the mass centre of the ring and of the rotor.
O is fixed in N.
$K$ is the moment of inertia of the ring about $n_3$.
$I$, $I$, $J$ are the principal moments of the rotor about O on B.
$H$ is the angular momentum of the gyroscope about O relative to N.
";
    let text = r"
$$ H\cdot b_1 = I\dot\beta $$
$$ H\cdot b_1 = J\dot\beta $$
$$ H\cdot n_3 = (K + I\sin^2\beta + J\cos^2\beta)\dot\alpha $$
";
    assert_eq!(judged(sentences, text), "urp");
}
