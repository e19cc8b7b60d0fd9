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
