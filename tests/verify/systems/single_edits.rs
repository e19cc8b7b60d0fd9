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
