//! Lines that one edit makes false, where a premise, a letter or another reading would have carried them.

use super::judged;

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
