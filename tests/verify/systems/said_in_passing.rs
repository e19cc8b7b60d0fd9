//! What a sentence leaves for others to say: whose a weight is, which way an axis points, how large a moment is.

use super::judged;

#[test]
fn the_weight_is_that_of_the_body_whose_loads_are_listed() {
    let sentences = r"
N is an inertial frame.
A is a frame fixed in the shaft.
B is a frame fixed in the rod.
O is a point fixed in N and in B.
$i$, $j$, $k$ are the axes of A.
$k$ is the upward vertical.
A turns relative to N about $k$ at the constant rate $\Omega$.
B turns relative to A about $i$ by the angle $q$.
G is the mass centre of the rod.
$m$ is the mass of the rod.
$r$ is the position of G from O.
$g$ is the acceleration of gravity.
The weight and the force at O are the only loads on the rod.
$M$ is the moment of the weight about O.
";
    let text = r"
$$ M = - m g\, r\times k $$
$$ M = m g\, r\times k $$
";
    assert_eq!(judged(sentences, text), "pu");
    let both = [
        sentences,
        "The weight and the force at P are the only loads on the shaft.\nP is a point fixed in N and in A.\n",
    ]
    .concat();
    assert_eq!(judged(&both, text), "uu");
}

const ROTOR: &str = r"N is an inertial frame.
B is a frame fixed in the rotor.
$x$, $y$, $z$ are the axes of B.
A and D are points fixed in N and in B.
D is placed from A by $l z$.
B turns relative to N about the axis through A along $z$ at the rate $w$.
G is the mass centre of the rotor.
G is placed from A by $e x + c z$.
$e$, $c$ and $l$ are constant.
$m$ is the mass of the rotor.
$I_{xz}$ and $I_{yz}$ are the products of inertia of the rotor about A on B.
The products of inertia are integrals.
";

#[test]
fn a_moment_along_an_axis_has_any_size() {
    let text = r"
$$ a + d = - m e w^2 $$
$$ d = -\frac{I_{xz} w^2 + I_{yz}\dot w}{l} $$
$$ d = -\frac{I_{xz} w^2 - I_{yz}\dot w}{l} $$
$$ \dot w = 0 $$
";
    for moment in ["a driving moment along $z$", "a moment along $z$"] {
        let loads = format!(
            "{ROTOR}$a$ is the component along $x$ of the force of the bearing on the rotor at A.
$d$ is the component along $x$ of the force of the bearing on the rotor at D.
The force of the bearing at A, the force of the bearing at D and {moment} are the only loads on the rotor.
"
        );
        assert_eq!(judged(&loads, text), "pprr", "{moment}");
    }
}

#[test]
fn what_has_its_like_as_a_part_is_another_body() {
    let sentences = [
        ROTOR,
        r"K is a particle of mass $\mu$.
K is placed from A by $b x + h z$.
$b$ and $h$ are constant.
The balanced rotor consists of the rotor and K.
$I'_{xz}$ is the product of inertia of the balanced rotor about A for the axes $x$ and $z$.
$s$ is the position of the mass centre of the balanced rotor from A.
",
    ]
    .concat();
    let text = r"
$$ I'_{xz} = I_{xz} + \mu b h $$
$$ I'_{xz} = I_{xz} - \mu b h $$
$$ (m + \mu)s = (me + \mu b)x + (mc + \mu h)z $$
$$ m s = (me + \mu b)x + (mc + \mu h)z $$
";
    assert_eq!(judged(&sentences, text), "prpr");
}

#[test]
fn a_plural_of_several_words_is_one_part() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the rigid body.
$\omega$ is the angular velocity of B relative to N in components on B.
$\frac{d}{dt}$ is the rate entry by entry.
The spacecraft consists of the rigid body and the internal components.
C is the mass centre of the spacecraft.
C is fixed in B.
$H$ is the angular momentum of the spacecraft about C with velocities relative to C in components on B.
$h$ is the angular momentum of the internal components about C with velocities relative to C in components on B.
$b$ is the angular momentum of the rigid body about C with velocities relative to C in components on B.
$T$ is the total external moment on the spacecraft about C in components on B.
";
    let text = r"
$$ H = h + b $$
$$ T = \frac{d}{dt}H + \omega\times H $$
$$ T = \frac{d}{dt}H + \omega\times b $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_column_of_new_letters_defines_each_beside_what_is_not_taken_in() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the drone.
G is the mass centre of the drone.
$\omega$ is the angular velocity of B relative to N in components on B.
The weight and the thrusts of the rotors are the only forces on the drone.
Line 2 is a definition.
";
    let text = r"
$$ \omega = \begin{bmatrix} p \\ q \\ r \end{bmatrix} $$
$$ \omega\cdot\omega = p^2 + q^2 + r^2 $$
$$ \omega\cdot\omega = p^2 + q^2 - r^2 $$
";
    assert_eq!(judged(sentences, text), "apu");
}

#[test]
fn members_are_placed_in_any_order() {
    let sentences = r"E is an inertial frame.
D is a frame fixed in the drone.
C is the mass centre of the drone.
x, y, z are the axes of D.
Rotors 1 and 3 lie on x at the distances $b$ and $-b$ from C.
Rotors 4 and 2 lie on y at the distances $b$ and $-b$ from C.
The thrust of rotor $i$ acts at rotor $i$ and is $k w_i^2$ along z.
The thrusts of the rotors are the only loads on the drone.
$L$, $M$, $N$ are the components on D of the moment of the thrusts about C.
";
    let text = r"
$$ L = kb(w_4^2 - w_2^2) $$
$$ L = kb(w_2^2 - w_4^2) $$
$$ M = kb(w_3^2 - w_1^2) $$
";
    assert_eq!(judged(sentences, text), "prp");
}

#[test]
fn an_axis_points_from_the_apex_to_the_base() {
    let sentences = r"N is an inertial frame.
B is a frame fixed in the cone.
Z is the upward vertical.
x, y, z are the axes of B.
The cone is a uniform solid cone of density $\rho$, mass $M$, height $h$ and base radius $R$.
O is the apex of the cone.
O is fixed in N and in B.
z points from O to the centre of the base.
$\phi$, $\theta$, $\psi$ are the Euler angles of B relative to N in the order Z, x, z.
$g$ is the acceleration of gravity.
$V$ is the potential energy of the cone.
The potential energy is zero at O.
";
    let text = r"
$$ V = \frac34 M g h\cos\theta $$
$$ V = -\frac34 M g h\cos\theta $$
$$ M = \frac13\pi\rho R^2 h $$
$$ M = \frac13\pi R^2 h $$
";
    assert_eq!(judged(sentences, text), "prpr");
}
