//! Bodies and particles that letters name, and axes, planes and directions that only words tell.

use super::judged;

#[test]
fn a_body_may_be_called_by_a_letter_and_by_a_noun() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
$b_1$ is the main body, a rigid body.
$b_2$ is the wheel, a rigid body.
$c_1$ is a frame fixed in $b_1$.
C is the mass centre of $b_1$.
A is the wheel centre, a point fixed in $b_1$.
$c_1$ turns relative to N about y by the angle $\theta$.
C lies at the distance $l$ from A along the third axis of $c_1$.
$l$ is constant.
$J_x$, $J_y$, $J_z$ are the principal moments of $b_1$ about C on $c_1$.
The axes of $c_1$ are principal axes of $b_1$.
$M$ is the total moment on $b_1$ about C along y.
$u$ is the position of C from A in components on N.
";
    let text = r"
$$ M=J_y\ddot\theta $$
$$ M=J_x\ddot\theta $$
$$ u=\begin{bmatrix} l\sin\theta && 0 && l\cos\theta \end{bmatrix}^T $$
$$ u=\begin{bmatrix} l\cos\theta && 0 && l\sin\theta \end{bmatrix}^T $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn the_particles_of_a_list_are_numbered_by_their_names() {
    let sentences = r"
N is an inertial frame.
The rotor consists of the particles $p_1$ and $p_2$.
$i$ numbers the particles.
$m_i$ is the mass of particle $i$.
$r_i$ is the position of particle $i$ from O.
O is a point fixed in N.
$P$ is the momentum of the rotor relative to N.
";
    let text = r"
$$ P=m_1\dot r_1+m_2\dot r_2 $$
$$ P=m_1\dot r_1-m_2\dot r_2 $$
$$ P=\sum_i m_i\dot r_i $$
";
    assert_eq!(judged(sentences, text), "prp");
    let plain = sentences.replace("$p_1$ and $p_2$", "P1 and P2");
    assert_eq!(judged(&plain, text), "prp");
}

#[test]
fn which_number_a_particle_without_one_has_is_not_known() {
    let sentences = r"
N is an inertial frame.
The rotor consists of the particles A and B.
$i$ numbers the particles.
$m_i$ is the mass of particle $i$.
$r_i$ is the position of particle $i$ from O.
O is a point fixed in N.
$P$ is the momentum of the rotor relative to N.
";
    let text = r"
$$ P=\sum_i m_i\dot r_i $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn a_disc_that_lies_in_a_plane_turns_about_what_stands_on_it() {
    let sentences = r"
S is an inertial frame.
$x$, $y$, $z$ are the axes of S.
x points down the incline.
y is the unit normal of the incline, away from it.
The incline is a plane fixed in S.
The downward vertical lies in the plane of x and y, turned from the direction against y towards x by $\beta$.
The disc is a uniform thin disc of mass $m$ and radius $r$.
The disc lies in the plane of x and y.
G is the mass centre of the disc.
The disc rolls on the incline at C without slipping.
$a$ is the acceleration of G relative to S along x.
$g$ is the acceleration of gravity.
The weight and the force at C are the only loads on the disc.
$J$ is the moment of inertia of the disc about the axis through C along z.
";
    let text = r"
$$ a=\frac23 g\sin\beta $$
$$ a=\frac12 g\sin\beta $$
$$ J=\frac32 mr^2 $$
$$ J=\frac54 mr^2 $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn the_vertical_is_turned_from_one_direction_towards_another() {
    let sentences = r"
S is an inertial frame.
$x$, $y$, $z$ are the axes of S.
VERTICAL
P is a particle of mass $m$.
$g$ is the acceleration of gravity.
$W$ is the weight of P.
";
    let text = r"
$$ W=mg(\sin\beta\,x-\cos\beta\,y) $$
$$ W=mg(-\sin\beta\,x-\cos\beta\,y) $$
";
    for vertical in [
        "The downward vertical is turned from $-y$ towards x by the angle $\\beta$.",
        "The upward vertical is turned from y towards $-x$ by the angle $\\beta$.",
        "The upward vertical is turned relative to y about z by the angle $\\beta$.",
    ] {
        let told = sentences.replace("VERTICAL", vertical);
        assert_eq!(judged(&told, text), "pr", "{vertical}");
    }
    let other = "The downward vertical is turned from $-y$ towards $-x$ by the angle $\\beta$.";
    assert_eq!(judged(&sentences.replace("VERTICAL", other), text), "rp");
    let unheard = "The downward vertical is turned from y about x towards z by the angle $\\beta$.";
    assert_eq!(judged(&sentences.replace("VERTICAL", unheard), text), "uu");
}

#[test]
fn a_fixed_axis_needs_no_letter() {
    let sentences = r"
S is an inertial frame.
O is a point fixed in S.
The body is a rigid body that turns about a fixed axis through O.
The body consists of particles.
$i$ numbers the particles.
$m_i$ is the mass of particle $i$.
$r_i$ is the position of particle $i$ from O.
$s_i$ is the distance of particle $i$ from the axis.
$w$ is the angular velocity of the body relative to S.
$\omega$ is the component of $w$ along the axis.
$H$ is the angular momentum of the body about O relative to S.
$h$ is the component of $H$ along the axis.
$I$ is the moment of inertia of the body about the axis.
";
    let text = r"
$$ h=I\omega $$
$$ I=\sum_i m_i s_i^2 $$
$$ I=2\sum_i m_i s_i^2 $$
$$ H=w\sum_i m_i s_i^2 $$
";
    assert_eq!(judged(sentences, text), "ppru");
}

#[test]
fn the_particles_of_a_dumb_bell_turn_with_it() {
    let sentences = r"
N is an inertial frame.
O is a point fixed in N.
The dumb-bell consists of two particles of mass $m$.
The first particle is placed from O by $\vec r$ and the second by $-\vec r$.
The dumb-bell turns about O with the angular velocity $\vec w$ relative to N.
$\vec v$ is the velocity of the first particle relative to N.
$\vec H$ is the angular momentum of the dumb-bell about O relative to N.
";
    let text = r"
$$ \vec v=\vec w\times\vec r $$
$$ \vec v=\vec r\times\vec w $$
$$ \vec H=2m\vec r\times(\vec w\times\vec r) $$
$$ \vec H=m\vec r\times(\vec w\times\vec r) $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn the_other_components_are_those_that_the_sentence_before_does_not_name() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
$w$ is the angular velocity of B relative to N.
$\omega$ is the second component of $w$ on B, and the other two components are zero.
$a$, $b$, $c$ are the components of $w$ on B.
";
    let text = r"
$$ a=0 $$
$$ c=0 $$
$$ b=\omega $$
$$ b=0 $$
";
    assert_eq!(judged(sentences, text), "pppr");
    let two = sentences.replace("and the other two components", "first and third");
    let (first, third) = (
        "on B, first and third are zero.",
        "on B.\nThe first and third components of $w$ on B are zero.",
    );
    assert_eq!(judged(&two.replace(first, third), text), "pppr");
}

#[test]
fn gravity_as_a_vector_is_as_great_as_its_letter_says() {
    let sentences = r"
N is an inertial frame.
x, y, z are the axes of N.
z is the upward vertical.
$\vec G$ is the acceleration of gravity in components on N.
$g$ is the magnitude of the acceleration of gravity.
";
    let text = r"
$$ \vec G=\begin{bmatrix}0\\0\\-g\end{bmatrix} $$
$$ \vec G=\begin{bmatrix}0\\0\\g\end{bmatrix} $$
$$ \vec G\cdot\vec G=g^2 $$
";
    assert_eq!(judged(sentences, text), "prp");
    let nowhere = sentences.replace("z is the upward vertical.\n", "");
    assert_eq!(&judged(&nowhere, text)[2..], "p");
}
