//! What strikes a body that hangs, and sticks in it.

use super::judged;

const GATE: &str = "N is an inertial frame with the axes $a$, $b$, $c$, and $b$ is the upward vertical.
The bar is a uniform thin rod of mass $m_1$ and length $h$.
P is the upper end of the bar and a point fixed in N.
The bar turns relative to N about the axis through P along $c$, without friction.
The pellet is a particle of mass $m_2$.
Just before the impact the bar hangs at rest vertically below P.
Just before the impact the velocity of the pellet relative to N is $v\\,a$.
$s\\,c$ is the angular velocity of the bar relative to N just after the impact.
$K\\,a$ is the impulse of the pellet on the bar, and $Q\\,a$ is the impulse of the hinge at P on the bar.
$H_0c$ and $H_1c$ are the angular momenta of the bar and the pellet together about P relative to N just before and just after the impact.
$E_0$ and $E_1$ are the kinetic energies of the bar and the pellet together relative to N just before and just after the impact.
After the impact the weights and the force at P are the only loads on the bar and the pellet.
";

const STICKS: &str = "The pellet strikes the bar at the point C, which lies at the distance $d$ below P, and sticks in it.\n";

#[test]
fn a_pellet_sticks_in_a_bar_that_hangs() {
    let sentences = format!("{GATE}{STICKS}");
    let text = r"
$$ H_0 = m_2 v d $$
$$ H_1 = H_0 $$
$$ H_1 = -H_0 $$
$$ s = \frac{3m_2vd}{m_1h^2+3m_2d^2} $$
$$ s = \frac{12m_2vd}{m_1h^2+12m_2d^2} $$
$$ K = m_2(v-ds) $$
$$ K = m_2(v+ds) $$
$$ Q + K = \frac12m_1hs $$
$$ Q - K = \frac12m_1hs $$
$$ E_0 = E_1 $$
$$ E_0 = \frac12m_2v^2 $$
$$ E_1 = \frac12H_1s $$
";
    assert_eq!(judged(&sentences, text), "pprprprprrpp");
}

/// What flies off after it has struck brings no less angular momentum, but how fast it is then no sentence tells.
#[test]
fn a_pellet_that_does_not_stick() {
    let sentences = format!(
        "{GATE}C is the point of the bar at the distance $d$ below P.
The pellet strikes the bar at C.
$w\\,a$ is the velocity of the pellet relative to N just after the impact.
"
    );
    let text = r"
$$ H_1 = H_0 $$
$$ H_1 = 2H_0 $$
$$ m_2d(v-w) = \frac13m_1h^2s $$
$$ m_2d(v-w) = \frac1{12}m_1h^2s $$
$$ K = m_2(v-w) $$
$$ w = ds $$
";
    let verdicts = judged(&sentences, text);
    assert_eq!(&verdicts[..5], "prprp");
    assert_ne!(&verdicts[5..], "p");
}

/// Another impulse, or another body, may change what the impact leaves as it is: nothing is made of it then.
#[test]
fn other_impulses_are_left_open() {
    for besides in [
        "D is a point fixed in the bar.\nThe impulse $Z a$ acts at D.\n",
        "The ball is a uniform ball of mass $m_3$ and radius $r$.\n",
    ] {
        let sentences = format!("{GATE}{STICKS}{besides}");
        let text = "$$ H_1 = H_0 $$\n$$ H_1 = 2H_0 $$\n$$ K = m_2(v-ds) $$\n$$ K = m_2v $$\n";
        let verdicts = judged(&sentences, text);
        assert!(!verdicts.contains(['p', 'r']), "{verdicts}");
    }
}
