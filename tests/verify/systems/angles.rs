//! Sines and cosines of parts of π.

use super::judged;

#[test]
fn parts_of_pi_have_the_values_that_they_have() {
    let sentences = "N is an inertial frame.
B turns relative to N about z by the angle $\\gamma$.
";
    let text = r"
$$ \cos(\pi/2) = 0 $$
$$ \sin(-\pi/2) = -1 $$
$$ \sin(\pi/6) = \tfrac12 $$
$$ \cos(\pi/3) = -\tfrac12 $$
$$ \cos(2\pi/3) = -\tfrac12 $$
$$ \sin(\pi/4)^2 = \tfrac12 $$
$$ \sin 30^\circ = \tfrac12 $$
$$ \sin(\gamma + \pi/2) = \cos\gamma $$
$$ \cos(\gamma - \pi) = -\cos\gamma $$
$$ \cos(\gamma + \pi/2) = \sin\gamma $$
";
    assert_eq!(judged(sentences, text), "ppprpppppr");
}

#[test]
fn of_other_parts_of_pi_nothing_is_said() {
    let sentences = "N is an inertial frame.\n";
    let text = "$$ \\cos(\\pi/5) = 0 $$\n$$ \\cos(\\pi/5) > 0 $$\n";
    assert_eq!(judged(sentences, text), "uu");
}
