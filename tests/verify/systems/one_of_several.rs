//! One axis of three, one member of many, one frame of two.

use super::judged;

#[test]
fn one_principal_axis_leaves_the_product_of_the_others() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$x, y, z$ are the axes of B.
G is the mass centre of the body.
z is a principal axis of the body.
$I$ is the inertia tensor of the body about G.
$\omega$ is the angular velocity of the body relative to N.
$p$, $q$, $r$ are the components of $\omega$ on B.
$a$, $b$, $c$ are the moments of inertia of the body about the axes through G along x, y, z.
$H$ is the angular momentum of the body about G relative to N.
";
    let text = r"
$$ H\cdot z = c r $$
$$ H\cdot x = a p $$
$$ I x = a x $$
$$ I z = c z $$
";
    assert_eq!(judged(sentences, text), "prrp");
}

#[test]
fn two_principal_axes_tell_the_third() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$x, y, z$ are the axes of B.
G is the mass centre of the body.
x and z are principal axes of the body.
$I$ is the inertia tensor of the body about G.
$b$ is the moment of inertia of the body about the axis through G along y.
";
    let text = r"
$$ I y = b y $$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn a_line_about_any_member_is_one_about_each() {
    let sentences = r"
N is an inertial frame.
The system consists of the particles $P_1$ and $P_2$.
$i$ numbers the particles.
$P_i$ has the mass $m_i$.
O is a point fixed in N.
$r_i$ is the position of $P_i$ from O.
$v_i$ is the velocity of $P_i$ relative to N.
$p_i$ is the momentum of $P_i$ relative to N.
";
    let text = r"
$$ v_i = -\dot r_i $$
$$ v_i = \dot r_i $$
$$ p_i = m_i r_i $$
$$ p_i = m_i v_i $$
";
    assert_eq!(judged(sentences, text), "rprp");
}

#[test]
fn an_index_of_axes_stands_for_each_of_their_numbers() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$b_1, b_2, b_3$ are the axes of B.
$i$ numbers the axes of B.
$w$ is the angular velocity of B relative to N.
$w_i$ is the component of $w$ along $b_i$.
";
    let text = r"
$$ \dot b_i = w\times b_i $$
$$ \dot b_i = b_i\times w $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn rates_go_with_their_frames_in_order() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle $a$.
$F$ is any vector.
$D$ and $E$ are the rates of $F$ seen from N and from A.
";
    let text = r"
$$ D = E $$
$$ D = E+\dot a z\times F $$
";
    assert_eq!(judged(sentences, text), "rp");
}

#[test]
fn components_go_with_their_frames_in_order() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z by the angle $a$.
$i, j, z$ are the axes of A.
$F$ is any vector.
$f_1$, $f_2$, $f_3$ and $F_1$, $F_2$, $F_3$ are the components of $F$ on A and on N, respectively.
";
    let text = r"
$$ f_1 = \cos a F_1+\sin a F_2 $$
$$ f_1 = F_1 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn turns_about_fixed_axes_go_from_the_last_to_the_first() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
$i, j, k$ are the axes of B.
B is turned relative to N about z by $a$ and then about the fixed axis x by $b$.
";
    let text = r"
$$ k = \cos b z - \sin b y $$
$$ k = \cos b z + \sin a\sin b x - \cos a\sin b y $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_place_along_two_axes_is_on_neither() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
G lies at the distance $a$ from O along x and at the distance $b$ along y.
$q$ is the position of G from O.
";
    let text = r"
$$ q = a x $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_velocity_relative_to_a_point_is_the_rate_of_the_way_from_there() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
A turns relative to N about z at the rate $\Omega$.
$i, j, z$ are the axes of A.
O is a point fixed in N and in A.
P is placed from O by $s i$.
Q is placed from O by $u j$.
$d$ is the velocity of P relative to Q seen from N.
";
    let text = r"
$$ d = (\dot s+\Omega u) i + (\Omega s-\dot u) j $$
$$ d = \dot s i+\Omega s j $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_mass_centre_told_anew_in_a_part_is_another_point_there() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the aircraft.
$x, y, z$ are the axes of B.
G is the mass centre of the aircraft.
On lines 7 to 12 G is the mass centre of the hull.
On lines 7 to 12 the aircraft consists of the hull and S.
S is a particle of mass $m$ fixed in B.
$\rho$ is the position of S from G in components on B.
$D$ is the inertia tensor of S about G in components on B.
$J$ is the inertia tensor of the hull about G in components on B.
$K$ is the inertia tensor of the aircraft about G in components on B.
$[\rho]_\times$ is the cross-product matrix of $\rho$.
";
    let text = r"
$$ K = K^T $$



$$ D = -m [\rho]_\times^2 $$
$$ K = J + D $$
";
    assert_eq!(judged(sentences, text), "ppp");
    assert_ne!(judged(sentences, &text.replace("J + D", "J - D")), "ppp");
}

#[test]
fn axes_by_one_letter_with_an_index_are_three() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$b_i$ are the axes of B.
$j$ and $k$ number the axes of B.
$w$ is the angular velocity of B relative to N.
$w_i$ is the component of $w$ along $b_i$.
";
    let text = r"
$$ w = \sum_i (w\cdot b_i) b_i $$
$$ b_i\cdot b_1 = 1 $$
$$ \dot b_i = w\times b_i $$
$$ w_2 = w\cdot b_2 $$
$$ w_2 = w\cdot b_1 $$
";
    assert_eq!(judged(sentences, text), "prppr");
    let by_number = sentences.replace("$b_i$ are the axes", "$b_i$ is the axis $i$");
    assert_eq!(judged(&by_number, text), "prppr");
}

#[test]
fn a_direction_that_a_part_of_the_document_names_is_none_elsewhere() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$w$ is the angular velocity of B relative to N.
On line 1 $v$ is a vector along $e$.
$e_i$ are the axes of B.
$w_i$ is component $i$ of $w$ on B.
A repeated index is summed.
";
    let text = r"

$$ w = w_i e_i $$
";
    assert_eq!(judged(sentences, text), "p");
}

#[test]
fn a_line_holds_where_it_holds_in_both_cases_that_a_sentence_leaves_open() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
O is the mass centre of the body or a point fixed in N and in B.
$\mathbf w$ is the angular velocity of B relative to N.
$\mathbf I$ is the inertia tensor of the body about O.
$\mathbf L$ is the angular momentum of the body about O relative to N.
$\mathbf M$ is the total moment on the body about O.
$\dot{\mathbf L}$ is the rate of $\mathbf L$ seen from N.
$T$ is the kinetic energy of the body.
";
    let text = r"
$$ \mathbf L = \mathbf I\mathbf w $$
$$ \dot{\mathbf L} = \mathbf M $$
$$ \dot{\mathbf L} = -\mathbf M $$
$$ T = \frac12\mathbf w\cdot\mathbf I\mathbf w $$
";
    assert_eq!(judged(sentences, text), "ppru");
}
