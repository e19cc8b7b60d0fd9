//! Shapes whose axis is told by points of them or by a vector, whose sides lie along axes, and wholes of bodies.

use super::{judged, verdicts};

const PLANE: &str = "N is an inertial frame.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of N.
$\\mathbf j$ is the upward vertical.
O is a point fixed in N.
B is a frame fixed in the beam.
The beam is a uniform thin rod of mass $m$ and length $2b$.
B turns relative to N about $\\mathbf k$ by the angle $\\theta$.
";

#[test]
fn a_rod_lies_along_the_way_between_its_ends() {
    let said = format!(
        "{PLANE}P is placed from O by $2b\\sin\\theta\\,\\mathbf i$.
Q is placed from O by $2b\\cos\\theta\\,\\mathbf j$.
P and Q are the ends of the beam.
G is the mass centre of the beam.
$r$ is the position of G from O.
$I$ is the moment of inertia of the beam about the axis through G along $\\mathbf k$.
$J$ is the moment of inertia of the beam about the axis through P along $\\mathbf k$.
$T$ is the kinetic energy of the beam relative to N.
"
    );
    let text = r"
$$ r = b\sin\theta\, \mathbf i + b\cos\theta\, \mathbf j $$

$$ r = b\sin\theta\, \mathbf i - b\cos\theta\, \mathbf j $$

$$ I = \frac{1}{3} m b^2 $$

$$ I = \frac{1}{12} m b^2 $$

$$ J = \frac{4}{3} m b^2 $$

$$ T = \frac{2}{3} m b^2 \dot\theta^2 $$

$$ T = \frac{1}{6} m b^2 \dot\theta^2 $$
";
    assert_eq!(judged(&said, text), "prprppr");
}

#[test]
fn ends_that_are_not_as_far_apart_as_the_rod_is_long_tell_no_line() {
    let said = format!(
        "{PLANE}P is placed from O by $b\\sin\\theta\\,\\mathbf i$.
Q is placed from O by $b\\cos\\theta\\,\\mathbf j$.
P and Q are the ends of the beam.
G is the mass centre of the beam.
$I$ is the moment of inertia of the beam about the axis through G along $\\mathbf k$.
"
    );
    let text = r"
$$ I = \frac{1}{3} m b^2 $$

$$ I = \frac{1}{12} m b^2 $$
";
    assert_eq!(verdicts(&said, text).0, "uu");
}

#[test]
fn the_mass_centre_of_a_rod_is_between_its_ends_however_it_turns() {
    let said = "N is an inertial frame.
O is a point fixed in N.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of N.
The beam is a uniform thin rod of mass $m$ and length $L$.
P and Q are the ends of the beam.
P is placed from O by $x\\mathbf i$.
Q is placed from O by $y\\mathbf j$.
G is the mass centre of the beam.
$r$ is the position of G from O.
";
    let text = r"
$$ r = \frac{1}{2} (x \mathbf i + y \mathbf j) $$

$$ x^2 + y^2 = L^2 $$
";
    let found = verdicts(said, text).0;
    assert!(["pu", "uu"].contains(&found.as_str()), "{found}");
}

#[test]
fn a_rod_that_turns_otherwise_than_its_ends_tells_no_line() {
    let said = format!(
        "{PLANE}P is placed from O by $2b\\sin 2\\theta\\,\\mathbf i$.
Q is placed from O by $2b\\cos 2\\theta\\,\\mathbf j$.
P and Q are the ends of the beam.
G is the mass centre of the beam.
$I$ is the moment of inertia of the beam about the axis through G along $\\mathbf k$.
"
    );
    let text = r"
$$ I = \frac{1}{3} m b^2 $$

$$ I = \frac{1}{12} m b^2 $$
";
    assert_eq!(verdicts(&said, text).0, "uu");
}

#[test]
fn a_rod_lies_along_the_way_from_its_end_to_its_mass_centre() {
    let sentences = [
        "N is an inertial frame.",
        "A is a frame that turns relative to N about $\\mathbf k$ at the constant rate $\\Omega$.",
        "$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of A.",
        "O is a point fixed in N and in A.",
        "S is a point fixed in A.",
        "S lies at the distance $e$ from O along $\\mathbf i$.",
        "B is a frame fixed in the flap.",
        "B turns relative to A about $-\\mathbf j$ by the angle $\\beta$.",
        "$\\mathbf u$, $\\mathbf j$, $\\mathbf w$ are the axes of B.",
        "The flap is a uniform thin rod of mass $m$ and length $l$.",
        "S is an end of the flap.",
        "G is the mass centre of the flap.",
        "G lies at the distance $l/2$ from S along $\\mathbf u$.",
        "$J$ is the moment of inertia of the flap about the axis through S along $\\mathbf j$.",
        "$K$ is the moment of inertia of the flap about the axis through G along $\\mathbf u$.",
        "$v$ is the velocity of G relative to N.",
    ];
    let text = r"
$$ J = \frac{1}{3} m l^2 $$

$$ J = \frac{1}{12} m l^2 $$

$$ K = 0 $$

$$ K = \frac{1}{12} m l^2 $$

$$ v\cdot \mathbf j = \Omega (e + \frac{l}{2}\cos\beta) $$
";
    assert_eq!(judged(&sentences.join("\n"), text), "prprp");
}

#[test]
fn a_disc_may_be_round_about_a_vector_that_its_frame_carries() {
    let said = "N is an inertial frame.
O is a point fixed in N and in B.
B is a frame fixed in the plate.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of B.
B turns relative to N about $\\mathbf k$ at the constant rate $\\nu$.
The plate is a uniform thin disc of mass $m$ and radius $r$.
The plate is symmetric about $\\hat n$.
$\\hat n$ is the unit vector along $\\sin\\beta\\,\\mathbf i+\\cos\\beta\\,\\mathbf k$.
O is the mass centre of the plate.
$H$ is the angular momentum of the plate about O relative to N.
$T$ is the kinetic energy of the plate relative to N.
";
    let text = r"
$$ H = \frac{1}{4} m r^2 \nu (\sin\beta\cos\beta\, \mathbf i + (1 + \cos^2\beta)\, \mathbf k) $$

$$ H = \frac{1}{4} m r^2 \nu (-\sin\beta\cos\beta\, \mathbf i + (1 + \cos^2\beta)\, \mathbf k) $$

$$ T = \frac{1}{8} m r^2 \nu^2 (1 + \cos^2\beta) $$

$$ T = \frac{1}{8} m r^2 \nu^2 (1 + \sin^2\beta) $$
";
    assert_eq!(judged(said, text), "prpr");
}

#[test]
fn a_disc_is_not_round_about_a_vector_that_moves_in_it() {
    let said = "N is an inertial frame.
O is a point fixed in N and in B.
B is a frame fixed in the plate.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of N.
B turns relative to N about $\\mathbf k$ at the constant rate $\\nu$.
The plate is a uniform thin disc of mass $m$ and radius $r$.
The plate is symmetric about $\\hat n$.
$\\hat n$ is the unit vector along $\\sin\\beta\\,\\mathbf i+\\cos\\beta\\,\\mathbf k$.
O is the mass centre of the plate.
$T$ is the kinetic energy of the plate relative to N.
";
    let text = r"
$$ T = \frac{1}{8} m r^2 \nu^2 (1 + \cos^2\beta) $$

$$ T = \frac{1}{8} m r^2 \nu^2 $$
";
    assert_eq!(verdicts(said, text).0, "uu");
}

#[test]
fn an_ellipsoid_has_its_semi_axes_along_those_of_its_frame() {
    let body = "N is an inertial frame.
E is a frame fixed in the stone.
x, y, z are the axes of E.
G is the mass centre of the stone.
$I_1$, $I_2$, $I_3$ are the moments of inertia of the stone about the axes of E through G.
";
    let text = r"
$$ I_1 = \frac{m}{5}(b^2 + c^2) $$

$$ I_2 = \frac{m}{5}(b^2 + c^2) $$
";
    let told = [
        (
            "The stone is a uniform ellipsoid of mass $m$ and semi-axes $a$, $b$, $c$.
The axes of E are principal axes of the stone.",
            "pr",
        ),
        (
            "The stone is a uniform ellipsoid of mass $m$ with the semi-axes $a$, $b$, $c$ along x, y, z.",
            "pr",
        ),
        (
            "The stone is a uniform ellipsoid of mass $m$.
$a$, $b$, $c$ are the semi-axes of the stone along y, x, z.",
            "rp",
        ),
        (
            "The stone is a uniform ellipsoid of mass $m$ and semi-axes $a$, $b$, $c$.
The semi-axes $a$, $b$, $c$ of the stone lie along the axes y, x and z of E.
The axes of E are principal axes of the stone.",
            "rp",
        ),
        // Which of them is along which axis no sentence tells.
        (
            "The stone is a uniform ellipsoid of mass $m$ and semi-axes $a$, $b$, $c$.",
            "uu",
        ),
    ];
    for (sentences, expected) in told {
        let said = format!("{body}{sentences}\n");
        assert_eq!(verdicts(&said, text).0, expected, "{sentences}");
    }
}

#[test]
fn a_pyramid_has_the_sides_of_its_base_along_two_axes_and_its_height_along_the_third() {
    let body = "N is an inertial frame.
E is a frame fixed in the block.
x, y, z are the axes of E.
G is the mass centre of the block.
$I_1$, $I_2$, $I_3$ are the moments of inertia of the block about the axes of E through G.
$\\rho$ is the density of the block.
";
    let text = r"
$$ I_1 = m\left(\frac{b^2}{20} + \frac{3h^2}{80}\right) $$

$$ I_1 = m\left(\frac{a^2}{20} + \frac{3h^2}{80}\right) $$

$$ I_3 = \frac{m}{20}(a^2 + b^2) $$

$$ m = \frac13\rho a b h $$

$$ m = \rho a b h $$
";
    let told = [
        (
            "The block is a uniform solid right pyramid of mass $m$ and height $h$ with the base edges $a$ and $b$ along x and y.",
            "prppr",
        ),
        (
            "The block is a uniform pyramid of mass $m$ and height $h$.
The sides $a$ and $b$ of the base of the block lie along y and x.",
            "rpppr",
        ),
        // Which of its axes has the height no sentence tells.
        (
            "The block is a uniform pyramid of mass $m$ and height $h$.
$a$ is the side of the block along x.",
            "uuuuu",
        ),
    ];
    for (sentences, expected) in told {
        let said = format!("{body}{sentences}\n");
        assert_eq!(verdicts(&said, text).0, expected, "{sentences}");
    }
    // The centre of its base, or of what else it has, is not its mass centre.
    let said = "N is an inertial frame.
E is a frame fixed in the block.
x, y, z are the axes of E.
O is the centre of the block.
G is the mass centre of the block.
$r$ is the position of G from O.
The block is a uniform pyramid of mass $m$ and height $h$ with the base edges $a$ and $b$ along x and y.
";
    assert_ne!(verdicts(said, "$$ r = 0 $$\n").0, "p");
}

#[test]
fn sides_lie_along_axes_from_a_corner() {
    let said = "N is an inertial frame.
B is a frame fixed in the plate.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of B.
O is a point fixed in N and in B.
The plate is a uniform thin rectangular plate of mass $M$ and sides $a$ and $b$.
The sides $a$ and $b$ of the plate lie along the axes $\\mathbf i$ and $\\mathbf j$ of B from O.
G is the mass centre of the plate.
$r$ is the position of G from O.
$J$ is the moment of inertia of the plate about the axis through O along $\\mathbf i$.
$K$ is the moment of inertia of the plate about the axis through G along $\\mathbf k$.
";
    let text = r"
$$ r = \frac{a}{2} \mathbf i + \frac{b}{2} \mathbf j $$

$$ r = \frac{b}{2} \mathbf i + \frac{a}{2} \mathbf j $$

$$ J = \frac{1}{3} M b^2 $$

$$ J = \frac{1}{3} M a^2 $$

$$ K = \frac{1}{12} M (a^2 + b^2) $$
";
    assert_eq!(judged(said, text), "prprp");
}

#[test]
fn named_rods_lie_along_axes_in_turn() {
    let said = "N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of B.
G is a point fixed in N and in B.
The body consists of rod 1 and rod 2.
Rod 1 and rod 2 are uniform thin rods of mass $m$ and length $2l$.
Rod 1 and rod 2 lie along the axes x and y of B with their middles at G.
$I_x$ is the moment of inertia of rod 1 about the axis through G along x.
$J_x$ is the moment of inertia of rod 2 about the axis through G along x.
$K$ is the moment of inertia of the body about the axis through G along z.
";
    let text = r"
$$ I_x = 0 $$

$$ J_x = \frac{1}{3} m l^2 $$

$$ J_x = 0 $$

$$ K = \frac{2}{3} m l^2 $$

$$ K = \frac{1}{3} m l^2 $$
";
    assert_eq!(judged(said, text), "pprpr");
}

#[test]
fn the_whole_is_the_sum_of_its_parts_where_a_sentence_says_of_which() {
    let said = "N is an inertial frame.
O is a point fixed in N.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of N.
P is a particle of mass $m$.
Q is a particle of mass $2m$.
P lies at the distance $s$ from O along $\\mathbf i$.
Q lies at the distance $u$ from O along $\\mathbf j$.
The whole consists of P and Q.
$T$ is the kinetic energy of the whole.
$p$ is the momentum of the whole relative to N.
";
    let text = r"
$$ T = \frac{1}{2} m \dot s^2 + m \dot u^2 $$

$$ T = \frac{1}{2} m \dot s^2 $$

$$ p = m \dot s\, \mathbf i + 2 m \dot u\, \mathbf j $$
";
    assert_eq!(judged(said, text), "prp");
    let unknown = said.replace("The whole consists of P and Q.\n", "");
    assert_eq!(verdicts(&unknown, text).0, "uuu");
}

#[test]
fn a_point_from_which_another_is_placed_is_one() {
    let said = "N is an inertial frame.
B is a frame fixed in the block.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of B.
The block is a uniform box of mass $M$ with the edges $a$, $b$, $c$ along $\\mathbf i$, $\\mathbf j$, $\\mathbf k$.
G is the mass centre of the block.
G is placed from Q by $\\frac a2 \\mathbf i+\\frac b2 \\mathbf j+\\frac c2 \\mathbf k$.
$J$ is the inertia tensor of the block about Q in components on B.
$J_{jk}$ is entry (j, k) of $J$ on B.
";
    let text = r"
$$ J_{12} = -\frac{1}{4} M a b $$

$$ J_{12} = \frac{1}{4} M a b $$
";
    assert_eq!(judged(said, text), "pr");
}

#[test]
fn named_particles_are_summed_by_their_numbers() {
    let said = "N is an inertial frame.
B is a frame fixed in the rotor.
$\\mathbf i$, $\\mathbf j$, $\\mathbf k$ are the axes of B.
$i$ numbers the particles.
$P_1$ and $P_2$ are particles of mass $m$.
The rotor consists of $P_1$ and $P_2$.
A is a point fixed in N and in B.
$P_1$ is placed from A by $r\\,\\mathbf i+l\\,\\mathbf k$.
$P_2$ is placed from A by $-r\\,\\mathbf i+2l\\,\\mathbf k$.
$s_i$ is the position of particle $i$ from A.
$b$ is the position of $P_1$ from A.
$I$ is the moment of inertia of the rotor about the axis through A along $\\mathbf i$.
";
    let text = r"
$$ I = 5 m l^2 $$

$$ I = 10 m l^2 $$

$$ \sum_i s_i = 3 l \mathbf k $$

$$ \sum_i s_i = 3 l \mathbf i $$

$$ \sum_{i=1}^{2} m s_i\cdot s_i = m (2 r^2 + 5 l^2) $$

$$ \sum_i m = 2 m $$

$$ \sum_i m = 3 m $$

$$ \sum_i b_i = 0 $$
";
    assert_eq!(judged(said, text), "prprppru");
}

#[test]
fn a_rate_by_a_rule_is_that_of_the_vector_whose_components_a_rule_takes() {
    let said = "N is an inertial frame.
O is a point fixed in N and in B.
B is a frame fixed in the body.
$\\hat x$, $\\hat y$, $\\hat z$ are the axes of B.
B turns relative to N about $\\hat z$ at the constant rate $\\nu$.
P is a point fixed in B.
P lies at the distance $a$ from O along $\\hat x$.
$\\mathbf r$ is the position of P from O.
A dot means the rate seen from N.
A vector or tensor without a label has components on B.
";
    let text = r"
$$ \dot{\mathbf r} = a \nu \hat y $$

$$ \dot{\mathbf r} = 0 $$
";
    assert_eq!(judged(said, text), "pr");
}
