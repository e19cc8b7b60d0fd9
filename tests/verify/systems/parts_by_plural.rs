//! Parts that a sentence lists behind their plural, angles of frames, and letters that a line defines.

use super::judged;

const DRONE: &str = r"N is an inertial frame.
B is a frame fixed in the drone.
$i$, $j$, $k$ are the axes of B.
$e$ is the upward vertical.
G is the mass centre of the drone.
The drone consists of the motors P and Q.
P and Q are particles of mass $m/2$.
$m$ is the mass of the drone.
P is placed from G by $d i$.
Q is placed from G by $-d i$.
$d$ is the distance of the motors from G.
The thrust of motor P is $c u^2 k$ and acts at P.
The thrust of motor Q is $c v^2 k$ and acts at Q.
$c$ is constant.
The moment $\tau$ acts on the drone.
$g$ is the acceleration of gravity.
The weight, the thrusts of the motors and the moment $\tau$ are the only loads on the drone.
$M$ is the moment of the thrusts about G.
$H$ is the angular momentum of the drone about G relative to N.
$a$ is the acceleration of G relative to N.
$w$ is the angular velocity of B relative to N.
$d/dt$ is the rate seen from N.
";

#[test]
fn loads_of_parts_are_told_by_their_plural() {
    let text = r"
$$ M = c d (v^2 - u^2) j $$
$$ M = c d (u^2 - v^2) j $$
$$ \frac{dH}{dt} = M + \tau $$
$$ \frac{dH}{dt} = M $$
$$ m a = c (u^2 + v^2) k - m g e $$
$$ m a = c (u^2 + v^2) k + m g e $$
";
    assert_eq!(judged(DRONE, text), "prprpr");
}

#[test]
fn the_distance_of_parts_of_a_rigid_body_does_not_change() {
    let text = r"
$$ H = m d^2 (w - (w\cdot i)\, i) $$
$$ \dot d = 0 $$
$$ \dot d = d $$
";
    assert_eq!(judged(DRONE, text), "ppr");
}

const TURNING: &str = r"N is an inertial frame.
$e$, $f$, $n$ are the axes of N.
A is a frame that turns relative to N about $n$.
$w$ is the angular velocity of A relative to N.
";

#[test]
fn a_frame_turns_by_its_angle_relative_to_another_one() {
    let wordings = [
        "$b$ is the angle of A relative to N about $n$.",
        "$b$ is the angle of A from N about $n$.",
    ];
    let text = r"
$$ w = \dot b n $$
$$ w = -\dot b n $$
$$ w = \dot b e $$
";
    for wording in wordings {
        let sentences = format!("{TURNING}{wording}\n");
        assert_eq!(judged(&sentences, text), "prr", "{wording}");
    }
}

const FREE: &str = r"N is an inertial frame.
B is a frame fixed in the body.
$w$ is the angular velocity of B relative to N in components on B.
$u$ is a vector in components on B.
$a$, $b$ and $c$ are constant.
$t$ is the time.
";

#[test]
fn a_vector_is_what_a_line_defines_it_as() {
    let text = r"
$$ u := w + w $$
$$ u = 2 w $$
$$ u = 3 w $$
";
    assert_eq!(judged(FREE, text), "apr");
}

#[test]
fn fractions_with_over_and_brackets_in_braces() {
    let text = r"
$$ {a \over 2} + {1 \over {b \over c}} = \frac{a}{2} + \frac{c}{b} $$
$$ {a \over 2} + {1 \over {b \over c}} = \frac{a}{2} + \frac{b}{c} $$
$$ \cos{\left(a{\left(t \right)} \right)} = \cos a $$
$$ \cos{\left(a{\left(t \right)} \right)} = \sin a $$
";
    assert_eq!(judged(FREE, text), "prpr");
}
