//! Loads of each of a family: the thrusts of rotors, the moments of their drag, and what sentences say of all of them.

use super::judged;

#[test]
fn the_thrust_of_each_acts_where_it_is() {
    let sentences = r"E is an inertial frame.
D is a frame fixed in the drone.
C is the mass centre of the drone.
x, y, z are the axes of D.
The rotors lie at the distance $b$ from C along x, y, -x and -y in this order.
$S_i$ is the thrust of rotor $i$ along z.
The thrusts of the rotors are the only loads on the drone.
$L$, $M$, $N$ are the components on D of the moment of the thrusts about C.
$F$ is the sum of the thrusts.
";
    let text = r"
$$ L = b(S_2 - S_4) $$
$$ L = b(S_4 - S_2) $$
$$ M = b(S_3 - S_1) $$
$$ N = 0 $$
$$ F = S_1 + S_2 + S_3 + S_4 $$
$$ F = S_1 + S_2 + S_3 $$
";
    assert_eq!(judged(sentences, text), "prpppr");
}

#[test]
fn moments_that_alternate_by_the_power_of_a_number() {
    let sentences = r"E is an inertial frame.
D is a frame fixed in the drone.
C is the mass centre of the drone.
x, y, z are the axes of D.
Rotors 1, 2, 3 and 4 lie at the distance $b$ from C along x, y, -x and -y.
Each rotor exerts the thrust $S_i$ along z.
$(-1)^{i}q_i$ is the drag moment of rotor $i$ on the drone along z.
The thrusts and the drag moments of the rotors are the only loads on the drone.
$L$, $M$, $N$ are the components on D of the total moment on the drone about C.
";
    let text = r"
$$ N = q_2 + q_4 - q_1 - q_3 $$
$$ N = q_1 + q_3 - q_2 - q_4 $$
$$ L = b(S_2 - S_4) $$
$$ L = b(S_2 - S_3) $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn magnitudes_of_forces_that_point_against_an_axis() {
    let sentences = r"E is an inertial frame.
D is a frame fixed in the drone.
C is the mass centre of the drone.
x, y, z are the axes of D.
U and V are the centres of the propellers.
U is placed from C by $b$ along x.
V is placed from C by $-b$ along x.
$p$ and $q$ are the magnitudes of the forces of the air on the propellers.
The force of the air on each propeller acts at its centre and points against z.
The forces of the air on the propellers are the only loads on the drone.
$S$ is the magnitude of the sum of the forces of the air on the propellers.
$L$, $M$, $N$ are the components on D of the total moment on the drone about C.
";
    let text = r"
$$ S = p + q $$
$$ S = p - q $$
$$ M = b(p - q) $$
$$ M = b(q - p) $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn forces_by_how_many_they_are() {
    let sentences = r"E is an inertial frame.
D is a frame fixed in the plate.
C is the mass centre of the plate.
x, y, z are the axes of D.
U is placed from C by $b$ along x.
V is placed from C by $b$ along y.
The force $P z$ acts at U.
The force $Q z$ acts at V.
These two forces are the only loads on the plate.
$L$, $M$, $N$ are the components on D of the moment of these two forces about C.
";
    let text = r"
$$ L = b Q $$
$$ L = b P $$
$$ M = -b P $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn what_is_told_of_some_is_not_taken_for_all() {
    let sentences = r"E is an inertial frame.
D is a frame fixed in the drone.
C is the mass centre of the drone.
x, y, z are the axes of D.
The rotors lie at the distance $b$ from C along x, y and -x.
$S_1$ is the thrust of rotor 1 along z.
$S_2$ is the thrust of rotor 2 along z.
The thrusts of the rotors are the only loads on the drone.
$S$ is the sum of the thrusts of the rotors.
$L$, $M$, $N$ are the components on D of the total moment on the drone about C.
";
    let text = r"
$$ L = b S_2 $$
$$ S = S_1 + S_2 $$
";
    assert_eq!(judged(sentences, text), "uu");
}

#[test]
fn products_in_words_take_their_factors_whole() {
    let sentences = r"$a$, $b$ and $c$ are constant.
$k$ is $a+b$ times $c$.
$h$ is half of $a+b$.
$d$ is $a$ less $b-c$.
$f$ is $a+b$ divided by $c$.
";
    let text = r"
$$ k = a c + b c $$
$$ k = a + b c $$
$$ h = \frac{a + b}{2} $$
$$ d = a - b + c $$
$$ d = a - b - c $$
$$ f c = a + b $$
";
    assert_eq!(judged(sentences, text), "prpprp");
}

#[test]
fn what_is_told_of_one_thrust_is_not_told_of_all() {
    let sentences = "\
N is an inertial frame.
D is a frame fixed in the drone.
C is the mass centre of the drone.
x, y, z are the axes of D.
The rotors lie at the distance $b$ from C along x, y, -x and -y in this order.
$S_i$ is the thrust of rotor $i$ along z.
The thrusts of the rotors are the only loads on the drone.
$L$ is the component along x of the total moment on the drone about C.
";
    let text = r"
$$ L=b(S_2-S_4) $$
";
    assert_eq!(judged(sentences, text), "p");
    let other = [sentences, "The thrust of rotor 2 points along $-z$.\n"].concat();
    assert_eq!(judged(&other, text), "u");
    // A letter that is no label is no index.
    let coefficient = sentences.replace(
        "$S_i$ is the thrust of rotor $i$ along z.",
        "$k w^2$ is the thrust of each rotor along z.",
    );
    assert_eq!(judged(&coefficient, "$$ L=0 $$\n"), "u");
}
