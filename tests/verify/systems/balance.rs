//! Rotors in balance: where the mass centre is, and which products of inertia vanish.

use super::{judged, verdicts};

/// A rotor on a shaft of which no more is told.
const ROTOR: &str = r"N is an inertial frame.
B is a frame fixed in the rotor.
x, y, z are the axes of B.
B turns relative to N about z by the angle $\phi$.
O is a point fixed in N and in B.
G is the mass centre of the rotor.
$\vec r$ is the position of G from O.
$r_x$, $r_y$, $r_z$ are the components of $\vec r$ on B.
$\mathbf I$ is the inertia tensor of the rotor about O.
$I_{xx}$, $I_{yy}$, $I_{zz}$, $I_{xy}$, $I_{xz}$, $I_{yz}$ are entries of $\mathbf I$ on B.
$\vec M$ is the total moment on the rotor about O.
$M_x$, $M_y$, $M_z$ are the components of $\vec M$ on B.
$\vec F$ is the total force on the rotor.
$F_x$, $F_y$, $F_z$ are the components of $\vec F$ on B.
";

const LINES: &str = r"
$$ F_x = 0 $$

$$ r_y = 0 $$

$$ r_z = 0 $$

$$ M_x = 0 $$

$$ M_z = I_{zz}\ddot\phi $$

$$ I_{xz} = 0 $$

$$ I_{xy} = 0 $$
";

#[test]
fn static_balance_is_of_the_mass_centre_and_dynamic_balance_of_the_products_as_well() {
    let cases = [
        ("", "rrrrprr"),
        (
            "The rotor is balanced about the axis through O along z.",
            "pprpppr",
        ),
        ("The rotor is dynamically balanced about z.", "pprpppr"),
        (
            "$n$ is the unit vector along z.\nThe rotor is balanced about the axis through O along $n$.",
            "pprpppr",
        ),
        // The axis about which it turns.
        ("The rotor is balanced.", "pprpppr"),
        (
            "The rotor is statically balanced about the axis through O along z.",
            "pprrprr",
        ),
        ("The rotor is in static balance.", "pprrprr"),
        (
            "The rotor is statically balanced about the axis through O along x.",
            "rpprprr",
        ),
        // What is balanced statically alone may be out of balance.
        (
            "The rotor is statically balanced.\nThe rotor is unbalanced.",
            "pprrprr",
        ),
        ("The rotor is unbalanced.", "rrrrprr"),
        ("The rotor is not balanced.", "rrrrprr"),
    ];
    for (said, expected) in cases {
        assert_eq!(
            judged(&format!("{ROTOR}{said}\n"), LINES),
            expected,
            "{said}"
        );
    }
}

#[test]
fn a_rotor_that_is_balanced_is_turned_by_no_weight() {
    let said = r"N is an inertial frame.
X, Y, Z are the axes of N.
X is the upward vertical.
$g$ is the acceleration of gravity.
B is a rigid body.
x, y, Z are the axes of B.
B turns relative to N about Z by the angle $\phi$.
O is a point fixed in N and in B.
G is the mass centre of B.
$I$ is the moment of inertia of B about the axis through O along Z.
$V$ is the potential energy of B.
The potential energy is zero at O.
The weight and the force at O are the only loads on B.
";
    let text = r"
$$ I\ddot\phi = 0 $$

$$ V = 0 $$
";
    let cases = [
        ("", "rr"),
        (
            "B is statically balanced about the axis through O along Z.",
            "pp",
        ),
        // Which axis the letter is along no sentence tells.
        (
            "B is statically balanced about the axis through O along $n$.",
            "uu",
        ),
    ];
    for (balanced, expected) in cases {
        let said = format!("{said}{balanced}\n");
        assert_eq!(verdicts(&said, text).0, expected, "{balanced}");
    }
}

#[test]
fn what_is_balanced_and_unbalanced_tells_nothing() {
    let said = format!("{ROTOR}The rotor is balanced.\nThe rotor is unbalanced.\n");
    assert!(!verdicts(&said, LINES).0.contains('r'));
}

/// A disc that is out of balance has its mass centre elsewhere than in its middle, however uniform it is called.
#[test]
fn an_unbalanced_disc_is_no_uniform_one() {
    let said = r"N is an inertial frame.
B is a frame fixed in the disc.
x, y, z are the axes of B.
B turns relative to N about z by the angle $\phi$.
O is a point fixed in N and in B.
The disc is a uniform disc of mass $m$ and radius $a$.
z is the axis of the disc.
O is the centre of the disc.
$J$ is the moment of inertia of the disc about z through O.
$\vec F$ is the total force on the disc.
";
    let text = r"
$$ J = \frac12 m a^2 $$

$$ \vec F = 0 $$
";
    assert_eq!(judged(said, text), "pp");
    let unbalanced = format!("{said}The disc is unbalanced.\n");
    assert!(!verdicts(&unbalanced, text).0.contains('p'));
}
