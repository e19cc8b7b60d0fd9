//! Rates that are told behind a turn, frames by what they are fixed in, and vectors by sums over axes.

use super::judged;

#[test]
fn a_rate_behind_a_turn_is_its_rate() {
    let sentences = r"
N is an inertial frame.
O is a point fixed in N.
x, y, z are the axes of N.
The rotor turns relative to N about z. The spin rate is $w$ and is constant.
The rotor is symmetric about z.
$C$ is the moment of inertia of the rotor about the axis through O along z.
$H$ is the component along z of the angular momentum of the rotor about O relative to N.
O is the mass centre of the rotor.
";
    let text = r"
$$ H = C w $$
$$ \dot H = 0 $$
$$ H = 2 C w $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn a_frame_is_fixed_in_what_its_adjective_names() {
    let sentences = r"
N is an inertial frame.
K is a hull-fixed frame.
$a$, $b$, $c$ are the axes of K.
D is the mass centre of the hull.
K turns relative to N with the angular velocity $p a+q b+r c$.
$J$ is the inertia tensor of the hull about D.
$\mathbf h$ is the angular momentum of the hull about D relative to N.
$A$, $B$, $C$ are the principal moments of the hull about D on K.
";
    let text = r"
$$ \mathbf h = A p\,a+B q\,b+C r\,c $$
$$ \mathbf h = B p\,a+A q\,b+C r\,c $$
";
    assert_eq!(judged(sentences, text), "pr");
}
