//! Arms whose joints motors drive, pendulums on massless rods, plates with particles at their corners, and points that have
//! a word besides their letter.

use super::judged;

const ARM: &str = r"
N is an inertial frame with the axes $\mathbf i$, $\mathbf j$, $\mathbf k$, of which $\mathbf j$ is the upward vertical.
The leg consists of two links, the thigh and the shank.
H, the hip, is a point fixed in N and in the thigh.
K, the knee, is a point fixed in the thigh and in the shank.
A is a frame fixed in the thigh with the axes $\mathbf a$, $\mathbf b$, $\mathbf k$.
B is a frame fixed in the shank with the axes $\mathbf c$, $\mathbf d$, $\mathbf k$.
A turns relative to N about $\mathbf k$ by the angle $p$.
B turns relative to A about $\mathbf k$ by the angle $q$.
K lies at the distance $l$ from the hip along $\mathbf a$, and F, a point of the shank, lies at the distance $n$ from the knee along $\mathbf c$.
K is the mass centre of the thigh, and F is the mass centre of the shank.
$m$ and $M$ are the masses of the thigh and of the shank.
$I$ is the moment of inertia of the thigh about the axis through K along $\mathbf k$, and $J$ that of the shank about the axis through F along $\mathbf k$.
The motor at H acts on the thigh with the moment $\sigma\mathbf k$, and the motor at K acts on the shank with the moment $\tau\mathbf k$ and on the thigh with the opposite moment.
$g$ is the acceleration of gravity.
$T$ is the kinetic energy of the leg relative to N, and $V$ is its potential energy, which is zero at H.
";

const ARM_LINES: &str = r"
$$ V=mgl\sin p+Mg(l\sin p+n\sin(p+q)) $$
$$ V=mgl\sin p+Mg(l\sin p+n\sin q) $$
$$ \dot T+\dot V=\sigma\dot p+\tau\dot q $$
$$ \dot T+\dot V=\sigma\dot p+\tau(\dot p+\dot q) $$
$$ (J+Mn^2)(\ddot p+\ddot q)+Mln(\ddot p\cos q+\dot p^2\sin q)+Mgn\cos(p+q)=\tau $$
$$ (J+Mn^2)(\ddot p+\ddot q)+Mln(\ddot p\cos q-\dot p^2\sin q)+Mgn\cos(p+q)=\tau $$
";

#[test]
fn motors_at_the_joints_of_an_arm_act_on_the_next_link_and_back() {
    let lists = [
        "Apart from the moments of the motors only the weights and the forces of the frictionless joints at H and K act on the links.",
        "The moments of the motors, the weights and the forces at H and K are the only loads on the thigh and the shank.",
    ];
    for list in lists {
        let sentences = format!("{ARM}{list}\n");
        assert_eq!(judged(&sentences, ARM_LINES), "prprpr", "{list}");
    }
}

#[test]
fn a_massless_rod_pulls_along_itself_with_the_force_that_a_formula_tells() {
    let sentences = r"
N is an inertial frame.
$\hat i$, $\hat j$, $\hat k$ are the axes of N, and $\hat k$ is the upward vertical.
O is a point fixed in N.
P is a particle of mass $m$.
P is held at the constant distance $b$ from O by a massless rod.
A is a frame that turns relative to N about $\hat k$ by the angle $\psi$.
$\hat u$, $\hat v$, $\hat k$ are the axes of A.
$\vec r$ is the position of P from O, and $\vec r=b\sin\eta\,\hat u-b\cos\eta\,\hat k$.
$\eta$ lies between $0$ and $\pi$.
The rod exerts the force $-\frac{S}{b}\vec r$ on P.
The weight and the force of the rod are the only loads on P.
$g$ is the acceleration of gravity.
$L$ is the Lagrangian of P, with the potential energy zero at O.
$\eta$ and $\psi$ are the generalised coordinates.
$p$ is the generalised momentum that belongs to $\psi$.
$E$ is the sum of the kinetic energy of P relative to N and of its potential energy.
";
    let text = r"
$$ L=\frac12mb^2(\dot\eta^2+\dot\psi^2\sin^2\eta)+mgb\cos\eta $$
$$ L=\frac12mb^2(\dot\eta^2+\dot\psi^2\sin^2\eta)-mgb\cos\eta $$
$$ p=mb^2\dot\psi\sin^2\eta $$
$$ \dot p=0 $$
$$ \ddot\eta=\dot\psi^2\sin\eta\cos\eta-\frac gb\sin\eta $$
$$ \ddot\eta=\dot\psi^2\sin\eta\cos\eta+\frac gb\sin\eta $$
$$ \dot E=0 $$
$$ S=mg\cos\eta+mb(\dot\eta^2+\dot\psi^2\sin^2\eta) $$
$$ S=mg\cos\eta-mb(\dot\eta^2+\dot\psi^2\sin^2\eta) $$
";
    assert_eq!(judged(sentences, text), "pupppuppu");
}

const PLATE: &str = r"
N is an inertial frame.
The plate is a uniform thin rectangular plate of mass $M$ with the sides $a$ and $b$.
B is a frame fixed in the plate with the axes $\hat x$, $\hat y$, $\hat z$.
O is a corner of the plate and a point fixed in N.
C is the mass centre of the plate.
A particle of mass $m$ is fixed in the plate at D, and a particle of mass $n$ at S.
The body consists of the plate and the two particles.
$\hat u$ is the unit vector from O to D.
The body turns relative to N about the axis through O along $\hat u$ at the constant rate $w$.
$\vec\omega$ is the angular velocity of the body relative to N.
$[J]$ is the inertia tensor of the body about O in components on B.
$\vec v$ is the velocity of S relative to N.
";

const PLATE_LINES: &str = r"
$$ \vec\omega=\frac{w}{\sqrt{a^2+b^2}}(a\hat x+b\hat y) $$
$$ \vec\omega=\frac{w}{\sqrt{a^2+b^2}}(b\hat x+a\hat y) $$
$$ \vec v=-\frac{wab}{\sqrt{a^2+b^2}}\hat z $$
$$ \vec v=\frac{wab}{\sqrt{a^2+b^2}}\hat z $$
$$ J_{12}=-\frac14Mab-mab $$
$$ J_{12}=\frac14Mab+mab $$
";

#[test]
fn sides_run_from_a_corner_and_the_opposite_corner_lies_across_both() {
    let sides = [
        r"The side of length $a$ extends from O along $\hat x$, and the side of length $b$ from O along $\hat y$.",
        r"The side of length $a$ extends from O along $\hat x$.
The side of length $b$ extends from O along $\hat y$.",
        r"From O the side $a$ runs along $\hat x$ and the side $b$ along $\hat y$.",
        r"$\hat x$ and $\hat y$ point from O along the sides of the plate with the lengths $a$ and $b$.",
    ];
    let corners = [
        r"D is the corner of the plate opposite O, and S is the corner that lies at the distance $a$ from O along $\hat x$.",
        r"S is the corner of the plate at $a\,\hat x$ from O, and the corner diagonally opposite O is D.",
    ];
    for (side, corner) in sides.iter().flat_map(|s| corners.map(|c| (s, c))) {
        let sentences = format!("{PLATE}{side}\n{corner}\n");
        assert_eq!(judged(&sentences, PLATE_LINES), "prprpr", "{side} {corner}");
    }
}

#[test]
fn the_axis_of_a_turn_leads_to_the_point_that_another_sentence_tells() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the casting with the axes $x$, $y$, $z$.
O is a point fixed in the casting and in N.
D is a point fixed in the casting.
D is placed from O by $ax+by$.
$a$ and $b$ are positive constants.
$u$ is the unit vector from O to D.
The casting turns relative to N about the axis through O along $u$ at the constant rate $s$.
$w$ is the angular velocity of the casting relative to N.
";
    let text = r"
$$ w=\frac{s}{\sqrt{a^2+b^2}}(ax+by) $$
$$ w=\frac{s}{\sqrt{a^2+b^2}}(ax-by) $$
$$ w=-\frac{s}{\sqrt{a^2+b^2}}(ax+by) $$
";
    assert_eq!(judged(sentences, text), "pur");
}

#[test]
fn a_word_for_a_point_is_its_letter_wherever_it_stands() {
    let told = [
        "H, the hip, is a point fixed in N and in the leg.",
        "The hip H is a point fixed in N and in the leg.",
        "H (the hip) is a point fixed in N and in the leg.",
        "H is the hip, a point fixed in N and in the leg.",
        "H, the frobnik, is a point fixed in N and in the leg.",
    ];
    for said in told {
        let word = if said.contains("hip") {
            "hip"
        } else {
            "frobnik"
        };
        let sentences = format!(
            r"
N is an inertial frame with the axes $i$, $j$, $k$.
A is a frame fixed in the leg with the axes $a$, $b$, $k$.
A turns relative to N about $k$ by the angle $q$.
{said}
F lies at the distance $l$ from the {word} along $a$.
F is a point fixed in the leg.
$v$ is the velocity of F relative to N.
"
        );
        let text = r"
$$ v=l\dot q\,b $$
$$ v=-l\dot q\,b $$
";
        assert_eq!(judged(&sentences, text), "pr", "{said}");
    }
}
