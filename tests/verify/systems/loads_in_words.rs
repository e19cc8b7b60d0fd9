//! Loads in the words of authors: moments of forces, motors and friction, what acts on something outside, lists of loads.

use super::{judged, verdicts};

#[test]
fn a_force_by_its_letter_has_a_moment_about_a_point_and_along_an_axis() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
$\mathbf r$ is the position of P from O.
$\mathbf v$ is the velocity of P relative to N.
The forces $\mathbf S$ and $\mathbf T$ are the only loads on P.
$\mathbf M$ is the moment of the force $\mathbf S$ about O.
$K$ is the moment of the force $\mathbf S$ about O along $z$.
A dot means the rate seen from N.
";
    let text = r"
$$ \mathbf M=\mathbf r\times\mathbf S $$
$$ \mathbf M=\mathbf S\times\mathbf r $$
$$ K=z\cdot(\mathbf r\times\mathbf S) $$
$$ K=x\cdot(\mathbf r\times\mathbf S) $$
$$ m\dot{\mathbf v}=\mathbf S+\mathbf T $$
$$ m\dot{\mathbf v}=\mathbf S-\mathbf T $$
";
    assert_eq!(judged(sentences, text), "prprpr");
}

#[test]
fn a_moment_of_what_the_list_leaves_open_is_zero_along_an_axis() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
P is a particle of mass $m$.
$\mathbf r$ is the position of P from O.
$\mathbf v$ is the velocity of P relative to N.
The moment of $\mathbf S$ about O along $z$ is zero.
The force $\mathbf S$ is the only load on P.
$H$ is the angular momentum of P about O relative to N along $z$.
$K$ is the angular momentum of P about O relative to N along $x$.
";
    let text = r"
$$ \dot H=0 $$
$$ \dot K=0 $$
";
    assert_eq!(judged(sentences, text), "pr");
}

const ROTOR: &str = r"
N is an inertial frame.
B is a frame fixed in the rotor.
$x, y, z$ are the axes of N.
O is a point fixed in N and in B.
B turns relative to N about $z$ by the angle $\theta$.
$I$ is the moment of inertia of the rotor about the axis through O along $z$.
";

const ROTOR_LINES: &str = r"
$$ I\ddot\theta=K-c\dot\theta $$
$$ I\ddot\theta=-K-c\dot\theta $$
$$ I\ddot\theta=K+c\dot\theta $$
";

#[test]
fn the_moments_of_a_motor_and_of_friction_are_listed_by_letter_and_by_noun() {
    for loads in [
        r"$K$ is the moment of the motor on the rotor along $z$.
The friction moment $-c\dot\theta$ along $z$ acts on the rotor.
The force at O, the moment $K$ and the friction moment are the only loads on the rotor.",
        r"A motor exerts a moment $K$ along $z$ on the rotor.
The force at O, the moment of the motor and the moment $-c\dot\theta$ along $z$ are the only loads on the rotor.",
        r"The motor exerts the moment $K$ on the rotor about $z$.
The moment $-c\dot\theta$ about $z$ acts on the rotor.
Only the force at O, the moment $K$ and the moment $-c\dot\theta$ along $z$ act on the rotor.",
    ] {
        let sentences = format!("{ROTOR}{loads}\n");
        assert_eq!(judged(&sentences, ROTOR_LINES), "puu", "{loads}");
    }
}

#[test]
fn no_moment_about_the_axis_is_one_about_the_only_axis_that_is_spoken_of() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
The body turns relative to N about the axis through O along $z$ by the angle $\theta$.
No external moment along the axis acts on the body.
$I$ is the moment of inertia of the body about the axis.
$L$ is the angular momentum of the body about O relative to N along the axis.
";
    let text = r"
$$ L=I\dot\theta $$
$$ L=2I\dot\theta $$
$$ \dot L=0 $$
$$ I\ddot\theta=0 $$
$$ \dot L=I $$
";
    assert_eq!(judged(sentences, text), "prppr");
}

#[test]
fn of_two_axes_none_is_the_axis() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
O is a point fixed in N.
A turns relative to N about $x$ by the angle $\psi$.
The body turns relative to A about $z$ by the angle $\theta$.
No moment along the axis acts on the body.
$L$ is the angular momentum of the body about O relative to N along $z$.
";
    assert_eq!(verdicts(sentences, "\n$$ \\dot L=0 $$\n").0, "u");
}

const ON_WHEEL: &str = r"
N is an inertial frame.
The wheel is a rigid body of mass $m$.
B is a frame fixed in the wheel.
G is the mass centre of the wheel.
P is a point fixed in B.
$\vec v$ is the velocity of G relative to N.
A dot over a vector means the rate seen from N.
";

const OPPOSITES: &str = r"
$$ \vec F=-\vec E $$
$$ \vec F=\vec E $$
$$ \vec E=m\dot{\vec v} $$
$$ \vec F=m\dot{\vec v} $$
$$ \vec F=-m\dot{\vec v} $$
";

#[test]
fn what_a_body_does_to_something_outside_is_the_opposite_of_what_that_does_to_it() {
    let sentences = format!(
        "{ON_WHEEL}{}",
        r"$\vec E$ is the force of the base on the wheel.
$\vec F$ is the force of the wheel on the base.
The force of the base is the only load on the wheel.
"
    );
    assert_eq!(judged(&sentences, OPPOSITES), "prprp");
}

#[test]
fn a_force_on_something_outside_is_no_load_on_the_body() {
    for (force, list) in [
        (
            r"$\vec F$ is the force of the wheel on the base at P.",
            "The force at P is the only load on the wheel.",
        ),
        (
            r"The wheel exerts the force $\vec F$ on the base at P.",
            "The forces are the only loads on the wheel.",
        ),
        (
            r"$\vec F$ is the force on the base at P.",
            "The force at P is the only load on the wheel.",
        ),
        (
            r"The force $\vec F$ acts on the base at P.",
            "The force at P is the only load on the wheel.",
        ),
    ] {
        let sentences = format!("{ON_WHEEL}{force}\n{list}\n");
        let (judged, _) = verdicts(&sentences, "\n$$ m\\dot{\\vec v}=\\vec F $$\n");
        assert_ne!(judged, "p", "{force}");
    }
}

#[test]
fn where_a_force_acts_is_said_once_for_it_and_its_opposite() {
    let sentences = r"
N is an inertial frame.
$x, y, z$ are the axes of N.
The rod is a rigid body of mass $m$.
The disc is a rigid body of mass $M$.
B is a frame fixed in the rod.
C is a frame fixed in the disc.
G is the mass centre of the rod.
E is the mass centre of the disc.
A is a point fixed in B and in C.
$\mathbf v$ is the velocity of G relative to N.
$\mathbf w$ is the velocity of E relative to N.
The force of the disc on the rod acts at A.
$\mathbf F$ is the force of the disc on the rod.
$\mathbf T$ is the motor moment of the disc on the rod.
The force of the disc and the motor moment are the only loads on the rod.
The force of the rod and the motor moment are the only loads on the disc.
$\mathbf H$ is the angular momentum of the rod about G relative to N.
$\mathbf K$ is the angular momentum of the disc about E relative to N.
$\mathbf a$ is the position of A from G.
$\mathbf b$ is the position of A from E.
A dot means the rate seen from N.
";
    let text = r"
$$ m\dot{\mathbf v}=\mathbf F $$
$$ M\dot{\mathbf w}=-\mathbf F $$
$$ \dot{\mathbf H}=\mathbf T+\mathbf a\times\mathbf F $$
$$ \dot{\mathbf K}=-\mathbf T-\mathbf b\times\mathbf F $$
";
    assert_eq!(judged(sentences, text), "pppp");
    let wrong = r"
$$ m\dot{\mathbf v}=-\mathbf F $$
$$ \dot{\mathbf H}=\mathbf T-\mathbf a\times\mathbf F $$
$$ \dot{\mathbf K}=\mathbf T-\mathbf b\times\mathbf F $$
";
    assert!(!judged(sentences, wrong).contains('p'));
}

#[test]
fn lists_of_loads_in_other_words() {
    for list in [
        "The ball is subject only to the weight.",
        "The ball is acted on by the weight alone.",
        "Only the weight acts on the ball.",
    ] {
        let sentences = format!(
            r"
N is an inertial frame.
$z$ is the upward vertical.
$g$ is the acceleration of gravity.
The ball is a uniform ball of mass $m$.
G is the mass centre of the ball.
$\vec v$ is the velocity of G relative to N.
A dot over a vector means the rate seen from N.
{list}
"
        );
        let text = r"
$$ \dot{\vec v}=-g z $$
$$ \dot{\vec v}=g z $$
";
        assert_eq!(judged(&sentences, text), "pr", "{list}");
    }
}

#[test]
fn what_exerts_a_moment_along_an_axis_is_what_the_list_of_loads_names() {
    let sentences = |brake: &str| {
        format!(
            r"N is an inertial frame with the axes x, y and z, of which z points upward.
The flywheel is a uniform disc of mass $m$ and radius $R$, and it is symmetric about z.
The flywheel turns relative to N about z by the angle $\phi$.
C is the centre of the flywheel and is fixed in N.
{brake}
The weight, the force at C and the brake moment are the only loads on the flywheel.
$E$ is the kinetic energy of the flywheel.
"
        )
    };
    let text = r"
$$ \tfrac12 m R^2\ddot\phi = -b\dot\phi $$
$$ \dot E = -b\dot\phi^2 $$
$$ \dot E = -b\dot\phi $$
";
    for brake in [
        r"A brake exerts the moment $-b\dot\phi$ along z on the flywheel.",
        r"The brake applies a torque $-b\dot\phi$ along z to the flywheel.",
    ] {
        assert_eq!(judged(&sentences(brake), text), "ppr", "{brake}");
    }
}

#[test]
fn letters_called_as_axes_are_unit_vectors_in_formulas_of_sentences() {
    let sentences = r"
N is an inertial frame whose axis z points vertically upward.
A is a frame.
i, j, k are the axes of A.
A turns relative to N about z at the constant rate $w$.
k coincides with z.
O is a point of z fixed in N.
$u$ is a unit vector fixed in A.
$u$ is $\sin\beta\,\mathbf i + \cos\beta\,\mathbf k$.
$\beta$ is constant.
The bead P is a particle of mass $m$.
P lies at the distance $s$ from O along $u$.
$v$ is the velocity of P relative to N.
$T$ is the kinetic energy of the bead relative to N.
";
    let text = r"
$$ v = \dot s u + w s\sin\beta\,\mathbf j $$
$$ T = \tfrac12 m(\dot s^2 + w^2 s^2\sin^2\beta) $$
$$ \dot u = w\sin\beta\,\mathbf j $$
$$ v = \dot s u - w s\sin\beta\,\mathbf j $$
$$ T = \tfrac12 m(\dot s^2 + w^2 s^2) $$
$$ \dot u = w\cos\beta\,\mathbf j $$
";
    assert_eq!(judged(sentences, text), "ppprrr");
}

const ROD: &str = r"
N is an inertial frame.
i, j, k are the axes of N.
i is the downward vertical.
The rod is a uniform thin rod of mass $m$ and length $l$.
A and B are the ends of the rod.
R is a frame fixed in the rod.
$e$, $f$, k are the axes of R.
$e$ points from A to B.
R turns relative to N about k by the angle $\theta$.
The weight and the force at A are the only loads on the rod.
$g$ is the acceleration of gravity.
";

#[test]
fn what_hangs_from_a_ceiling_is_hinged_at_rest() {
    let text = r"
$$ \ddot\theta = -\frac{3g}{2l}\sin\theta $$
$$ \ddot\theta = \frac{3g}{2l}\sin\theta $$
";
    for hinge in [
        "The rod is hinged to the ceiling at A.",
        "The rod is hinged at A to a point fixed in N.",
        "A is fixed in N.",
    ] {
        assert_eq!(judged(&format!("{ROD}{hinge}\n"), text), "pr", "{hinge}");
    }
}

#[test]
fn loads_of_a_list_are_not_counted_twice() {
    let wheel = r"
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
The wheel is a uniform disc of mass $m$ and radius $r$.
G is the mass centre of the wheel.
The wheel turns relative to N about $-z$ by the angle $\varphi$.
The wheel rolls on the floor at C without slipping.
At C the floor acts on the wheel with the normal force $N$ along y and the friction $F$ along $-x$.
The hand pulls the wheel at G with the force $P$ along x.
$g$ is the acceleration of gravity.
$s$ is the coordinate of G along x.
";
    let text = r"
$$ m\ddot s = P - F $$
$$ N = m g $$
$$ m\ddot s = P + F $$
";
    for list in [
        "The weight, the force of the floor and $P$ are the only loads on the wheel.",
        "Apart from these forces only the weight acts on the wheel.",
        "The only other load on the wheel is its weight.",
    ] {
        assert_eq!(judged(&format!("{wheel}{list}\n"), text), "ppr", "{list}");
    }
    let twice =
        "No further loads act on the wheel than the weight, the force of the floor and $P$.";
    let found = verdicts(&format!("{wheel}{twice}\n"), text).0;
    assert!(!found[..2].contains('r'), "{found}");
}
