//! Formulas that names and signs make outside of their marks, remarks on how a text is set, and loads whose body is not named.

use super::{BODY, judged};

#[test]
fn names_and_signs_make_one_formula() {
    let said = "\
N is an inertial frame.
z is the upward vertical.
u is a horizontal unit vector fixed in N.
O is a point fixed in N.
A is placed from O by $x$ u + $y$ z.
C lies at the distance $\\ell$ from O along -u.
n is the unit vector along u × z.
$r$ is the position of A from C.
";
    let text = r"
$$ r = (x+\ell)u+y z $$

$$ r = (x-\ell)u+y z $$

$$ n\cdot u = 0 $$
";
    assert_eq!(judged(said, text), "prp");
}

#[test]
fn remarks_on_how_a_text_is_set_change_nothing() {
    let text = r"
$$ \vec L = \mathbf J\vec\omega $$

$$ \vec L = 2\mathbf J\vec\omega $$
";
    for remark in [
        "In the formulas a doubled backslash at the ends of rows is a single line break.",
        "Cross products are taken before dot products.",
        "All vectors are printed in bold type.",
        "We use SI units.",
        "The order of the factors matters.",
        "The formulas are from a lecture on gyroscopes.",
        "$m$ is not used from line 9 on.",
        "$L(x)$, $I(x)$ and the like are functions, not products.",
        "$\\approx$ means approximately equal.",
        "A vector beside a quaternion is the quaternion with that vector part and the scalar part $0$.",
    ] {
        let said = format!("{BODY}{remark}\n");
        assert_eq!(judged(&said, text), "pr", "{remark}");
    }
}

#[test]
fn a_line_may_go_on_from_one_that_is_named() {
    let said = format!(
        "{BODY}$m$ is the mass of the body.
$v$ is the velocity of G relative to N.
$p$ is the momentum of the body relative to N.
Line 6 continues line 2.
The formula of line 4 goes on in line 8.
"
    );
    let text = r"
$$ \vec L = \mathbf J\vec\omega $$

$$ p = m v $$

$$ = \mathbf J\vec\omega + \vec\omega\times\vec\omega $$

$$ = 2 m v $$
";
    assert_eq!(judged(&said, text), "pppr");
}

#[test]
fn a_load_without_a_body_is_that_on_the_one_with_the_mass_centre_there() {
    let text = r"
$$ \dot{\vec L} = \vec K $$

$$ \dot{\vec L} = 2\vec K $$
";
    for moment in [
        "$\\vec K$ is the total moment about G.",
        "$\\vec K$ is the total external moment about G.",
        "$\\vec K$ is the sum of the moments on the body about G.",
    ] {
        let said = format!("{BODY}A dot means the rate seen from N.\n{moment}\n");
        assert_eq!(judged(&said, text), "pr", "{moment}");
    }
}
