//! Lines that one edit makes false, where a premise, a letter or another reading would have carried them.

use super::{BODY, judged};

#[test]
fn a_distance_of_several_letters_changes_with_each_of_which_a_rate_is_written() {
    let said = r"N is an inertial frame.
O is a point fixed in N.
A is a frame that turns relative to N.
$\vec e$ is a unit vector fixed in A.
P lies at the distance $R+z$ from O along $\vec e$.
$\vec v$ is the velocity of P relative to N.
";
    let text = r"
$$ \vec v = \dot z\,\vec e + (R+z)\,\dot{\vec e} $$

$$ \vec v = (R+z)\,\dot{\vec e} $$

$$ \vec v\cdot\vec e = \dot z $$
";
    assert_eq!(judged(said, text), "prp");
    assert_eq!(
        judged(said, "\n$$ \\vec v = (R+z)\\,\\dot{\\vec e} $$\n"),
        "p"
    );
}

#[test]
fn what_is_assumed_tells_nothing_of_lines_before() {
    let said = format!("{BODY}Line 5 is assumed.\n");
    let with = |right: &str| {
        format!(
            r"
$$ \dot{{\vec L}}\cdot\vec s = {right}\vec M\cdot\vec s $$

Here $\vec s = 2\vec\omega$, and
$$ \vec M = 0 $$

$$ \dot{{\vec L}}\cdot\vec s = {right}\vec M\cdot\vec s $$
"
        )
    };
    assert_eq!(judged(&said, &with("")), "paap");
    assert_eq!(judged(&said, &with("-")), "raap");
}

#[test]
fn the_letter_d_of_a_place_is_no_differential() {
    let said = r"N is an inertial frame.
O is a point fixed in N and in B.
B is a frame fixed in the body.
$\hat\imath$, $\hat\jmath$, $\hat k$ are the axes of B.
U is placed from O by $d\hat\imath+e\hat k$.
V is placed from O by $-d\hat\imath-e\hat k$.
U and V are particles of mass $\mu$.
The body consists of U and V.
$K_{13}$ is entry (1, 3) of the inertia tensor of the body about O on B.
";
    let text = r"
$$ K_{13} = -2\mu\,d\,e $$

$$ K_{13} = -4\mu\,d\,e $$
";
    assert_eq!(judged(said, text), "pr");
}

#[test]
fn a_line_that_is_false_of_axes_does_not_define_their_names() {
    let said = r"N is an inertial frame.
n, w, u are the axes of N.
F is a frame that turns relative to N about u by the angle $\alpha$.
a, b, u are the axes of F.
";
    let text = r"
$$ b = -\sin\alpha\,n + \cos\alpha\,w $$

$$ b = \sin\alpha\,n + \cos\alpha\,w $$
";
    assert_eq!(judged(said, text), "pu");
}
