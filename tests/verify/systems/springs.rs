//! Linear springs between points: the force, its moment, the potential energy, and the motions with them.

use super::{judged, verdicts};

/// A particle below or above the fixed point to which a spring ties it.
fn on_a_spring(more: &str) -> String {
    format!(
        r"N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
$g$ is the acceleration of gravity.
P is a particle of mass $m$.
Q is a point fixed in N.
P lies at the distance $s$ from Q along y.
$s$ is positive.
$V$ is the potential energy of the spring.
$\vec F$ is the force of the spring on P.
$L$ is the Lagrangian of P.
$E$ is the total energy of P relative to N.
{more}"
    )
}

const MOTION: &str = r"
$$ V = \frac12 k (s-b)^2 $$

$$ V = \frac12 k s^2 $$

$$ \vec F = -k(s-b)y $$

$$ \vec F = k(s-b)y $$

$$ L = \frac12 m\dot s^2 - m g s - \frac12 k (s-b)^2 $$

$$ L = \frac12 m\dot s^2 - m g s + \frac12 k (s-b)^2 $$

$$ L = \frac12 m\dot s^2 - m g s $$

$$ m\ddot s = -m g - k(s-b) $$

$$ m\ddot s = -m g + k(s-b) $$

$$ \dot E = 0 $$

$$ E = \frac12 m\dot s^2 $$
";

#[test]
fn a_particle_on_a_spring_moves_by_its_force_and_has_its_energy() {
    let joined = [
        "A spring of stiffness $k$ and natural length $b$ joins P to Q.",
        "P is connected to Q by a spring of stiffness $k$ and unstretched length $b$.",
        "$k$ is the stiffness of the spring between P and Q.\n$b$ is the natural length of the spring.",
    ];
    let loads = [
        "The weight and the force of the spring are the only loads on P.",
        "The weight and the spring force are the only loads on P.",
        "The spring force and the weight are the only loads that do work on P.",
    ];
    for (joined, loads) in joined.iter().zip(loads) {
        let said = on_a_spring(&format!("{joined}\n{loads}\n"));
        assert_eq!(judged(&said, MOTION), "prprprrprpr", "{joined} {loads}");
    }
}

#[test]
fn each_of_two_springs_has_its_own_law() {
    let said = on_a_spring(
        r"The left spring of stiffness $k$ and natural length $b$ joins P and Q.
The right spring of stiffness $c$ and natural length $h$ joins P and Q.
The weight and the forces of the left spring and of the right spring are the only loads on P.
",
    );
    let said = said.replace("of the spring", "of the left spring");
    let text = r"
$$ V = \frac12 k (s-b)^2 $$

$$ m\ddot s = -m g - k(s-b) - c(s-h) $$

$$ m\ddot s = -m g - k(s-b) $$

$$ L = \frac12 m\dot s^2 - m g s - \frac12 k (s-b)^2 - \frac12 c (s-h)^2 $$
";
    assert_eq!(judged(&said, text), "pprp");
}

#[test]
fn of_a_spring_that_is_not_told_in_full_nothing_is_known() {
    let lines = r"
$$ V = \frac12 k s^2 $$

$$ L = \frac12 m\dot s^2 - m g s $$
";
    let said = [
        "A spring of stiffness $k$ joins P to Q.",
        "$k$ is the stiffness of the spring.\n$b$ is the natural length of the spring.",
        // What twists is another thing.
        "A spring of stiffness $k$ and natural length $b$ joins P to Q.\n$c$ is the stiffness of the torsion spring.",
    ];
    for said in said {
        assert_eq!(verdicts(&on_a_spring(said), lines).0, "uu", "{said}");
    }
    // An energy that is zero elsewhere is another one.
    let shifted =
        "A spring of stiffness $k$ and natural length $b$ joins P to Q.\n$V$ is zero at $s=0$.";
    let law = r"
$$ V = \frac12 k (s-b)^2 $$
";
    assert_eq!(verdicts(&on_a_spring(shifted), law).0, "u");
}

#[test]
fn a_rod_with_a_spring_turns_by_its_moment() {
    let said = r"N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
$g$ is the acceleration of gravity.
B is a frame fixed in the rod.
$i$, $j$, $k$ are the axes of B.
B turns relative to N about z by the angle $\theta$.
O is a point fixed in N and in B.
The rod is a uniform thin rod of mass $m$ and length $2a$ along the first axis of B.
G is the mass centre of the rod.
G lies at the distance $a$ from O along $i$.
P is a point fixed in B.
P lies at the distance $2a$ from O along $i$.
Q is a point fixed in N.
Q lies at the distance $b$ from O along x.
A spring of stiffness $c$ and natural length $L$ joins P to Q.
$d$ is the distance of P from Q.
$V$ is the potential energy of the spring.
$M$ is the moment of the spring about O.
The weight, the force of the spring and the force at O are the only loads on the rod.
$T$ is the Lagrangian of the rod.
$E$ is the total energy of the rod relative to N.
";
    let text = r"
$$ d = \sqrt{4a^2+b^2-4ab\cos\theta} $$

$$ V = \frac12 c(d-L)^2 $$

$$ M = -c\left(1-\frac{L}{d}\right)2ab\sin\theta\, k $$

$$ \frac43ma^2\ddot\theta = -m g a\cos\theta - 2abc\left(1-\frac Ld\right)\sin\theta $$

$$ T = \frac23ma^2\dot\theta^2 - m g a\sin\theta - \frac12c(d-L)^2 $$

$$ \dot E = 0 $$
";
    assert_eq!(judged(said, text), "pppppp");
    let wrong = r"
$$ M = c\left(1-\frac{L}{d}\right)2ab\sin\theta\, k $$

$$ \frac43ma^2\ddot\theta = -m g a\cos\theta $$

$$ T = \frac23ma^2\dot\theta^2 - m g a\sin\theta $$
";
    let found = judged(said, wrong);
    assert!(!found.contains('p'), "{found}");
    let law = "$$ M = -2abc(1-L/d)\\sin\\theta $$\n";
    for axis in ["z", "the axis through O along z", "O along z"] {
        let about = format!("moment of the spring about {axis}");
        let said = said.replace("moment of the spring about O", &about);
        assert_eq!(judged(&said, law), "p", "{axis}");
    }
}

#[test]
fn a_spring_between_two_particles_pulls_both() {
    let said = r"N is an inertial frame.
x, y, z are the axes of N.
O is a point fixed in N.
A is a particle of mass $m$.
C is a particle of mass $M$.
$p$ is positive.
$q$ is positive.
A is placed from O by $p\,x$.
C is placed from O by $(p+q)\,x$.
The pair consists of A and C.
A spring of stiffness $k$ and natural length $b$ joins A and C.
$\vec F$ is the force of the spring on A.
$\vec H$ is the force of the spring on C.
$L$ is the Lagrangian of the pair.
The force of the spring is the only load on A.
The force of the spring is the only load on C.
";
    let text = r"
$$ \vec F = k(q-b)x $$

$$ \vec H = -\vec F $$

$$ L = \frac12 m\dot p^2 + \frac12 M(\dot p+\dot q)^2 - \frac12 k(q-b)^2 $$

$$ L = \frac12 m\dot p^2 + \frac12 M(\dot p+\dot q)^2 $$

$$ m\ddot p = k(q-b) $$

$$ M(\ddot p+\ddot q) = -k(q-b) $$

$$ M(\ddot p+\ddot q) = k(q-b) $$
";
    assert_eq!(judged(said, text), "ppprppr");
    // What it does is the work of both: of one alone no Lagrangian is known.
    let alone = said.replace("Lagrangian of the pair", "Lagrangian of A");
    assert_eq!(verdicts(&alone, "$$ L = \\frac12 m\\dot p^2 $$\n").0, "u");
}

#[test]
fn nothing_is_known_of_springs_that_change_or_are_told_twice() {
    let sentences = "\
N is an inertial frame.
x, y, z are the axes of N.
y is the upward vertical.
$g$ is the acceleration of gravity.
P is a particle of mass $m$.
Q is a point fixed in N.
P lies at the distance $s$ from Q along y.
$s$ is positive.
A spring of stiffness $k$ and natural length $b$ joins P to Q.
The weight and the force of the spring are the only loads on P.
";
    let text = r"
$$ m\ddot s=-mg-k(s-b) $$
$$ \frac{d}{dt}\left(\frac12m\dot s^2+mgs+\frac12k(s-b)^2\right)=0 $$
";
    assert_eq!(judged(sentences, text), "pp");
    let changing = [sentences, "$k$ is a function of the time.\n"].concat();
    assert_eq!(judged(&changing, text), "uu");
    let other = "A spring of stiffness $c$ and natural length $h$ joins P to Q.\n";
    let twice = [sentences, other].concat();
    assert_eq!(judged(&twice, text), "uu");
}
