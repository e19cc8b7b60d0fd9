//! Both sides of a blow.

use super::judged;

const ROD: &str = "N is an inertial frame.
B is a frame fixed in the rod.
$e_1$, $e_2$, $e_3$ are the axes of B.
B turns relative to N about $e_3$ at the rate $\\omega$.
The rod is a rigid body of mass $m$.
The axes of B are principal axes of the rod.
G is the mass centre of the rod.
D lies at the distance $h$ from G along $e_1$.
$I$ is the moment of inertia of the rod about the axis through G along $e_3$.
$v$ is the velocity of G relative to N.
$u$ is the velocity of D relative to N.
$H$ is the angular momentum of the rod about G relative to N along $e_3$.
$p$ is the momentum of the rod relative to N.
$T$ is the kinetic energy of the rod relative to N.
The impulse $S e_2$ acts at D.
The impulse $S e_2$ is the only load on the rod.
";

const LABELS: &str =
    "The labels 0 and 1 mean the instants just before and just after the impulse.\n";

/// Routh, Elementary Rigid Dynamics, article 170: a blow on a free body that moves already.
#[test]
fn a_blow_on_a_moving_rod() {
    let text = r"
$$ p_1 - p_0 = S e_2 $$
$$ p_1 + p_0 = S e_2 $$
$$ H_1 - H_0 = h S $$
$$ H_1 = h S $$
$$ I(\omega_1 - \omega_0) = h S $$
$$ u_1 = v_1 + \omega_1 h\, e_2 $$
$$ T_1 - T_0 = \frac12 S (u_1 + u_0)\cdot e_2 $$
";
    for labels in [
        LABELS,
        "The labels 0 and 1 mean at the instants before and after the impulse.\n",
        "The label 0 means the moment before the impulse.\nThe label 1 means the moment right after the impulse.\n",
        "The labels 0 and 1 mean before the impact and after the impact.\n",
    ] {
        assert_eq!(judged(&format!("{ROD}{labels}"), text), "prprppp");
    }
}

/// What has no label is of no instant: it is neither of the values, and no line about it is denied.
#[test]
fn letters_without_labels_are_of_neither_side() {
    let text = r"
$$ v_1 = v $$
$$ m v = S e_2 $$
$$ u = v + \omega h\, e_2 $$
$$ \dot\omega_1 = 0 $$
$$ m\dot v = 0 $$
";
    assert_eq!(judged(&format!("{ROD}{LABELS}"), text), "uupuu");
}

#[test]
fn a_rod_at_rest_before_the_blow() {
    let text = r"
$$ v_0 = 0 $$
$$ m v_1 = S e_2 $$
$$ I\omega_1 = h S $$
$$ I\omega_1 = -h S $$
$$ T_1 = \frac12 S u_1\cdot e_2 $$
";
    for rest in [
        "The rod is at rest before the impulse.\n",
        "Just before the impulse the rod is at rest.\n",
    ] {
        let sentences = format!("{ROD}{LABELS}{rest}");
        assert_eq!(judged(&sentences, text), "ppprp");
    }
}

/// Letters of their own for what is so just before and just after.
#[test]
fn letters_of_one_side() {
    let sentences = format!(
        "{ROD}$w$ is the velocity of G relative to N just before the impulse.
Just after the impulse $w'$ is the velocity of G relative to N.
$K$ is the angular momentum of the rod about G relative to N immediately before the impulse.
$K'$ is the angular momentum of the rod about G relative to N immediately after the impulse.
"
    );
    let text = r"
$$ m(w' - w) = S e_2 $$
$$ m(w' + w) = S e_2 $$
$$ (K' - K)\cdot e_3 = h S $$
$$ (K' - K)\cdot e_3 = -h S $$
";
    assert_eq!(judged(&sentences, text), "prpr");
}

/// Several blows, or an event that is no blow, are not told apart.
#[test]
fn other_events_stay_unheard() {
    let text = "$$ p_1 - p_0 = S e_2 $$\n$$ p_1 + p_0 = S e_2 $$\n";
    for labels in [
        "The labels 0 and 1 mean the instants before and after the second impulse.\n",
        "The labels 0 and 1 mean the instants before and after the motion.\n",
    ] {
        let verdicts = judged(&format!("{ROD}{labels}"), text);
        assert!(!verdicts.contains(['p', 'r']), "{verdicts}");
    }
}

/// A letter that is told by velocities jumps as they do.
#[test]
fn letters_of_directions_may_jump() {
    let sentences = format!(
        "{ROD}{LABELS}$\\alpha$ is the angle between $v$ and $e_1$.
$n$ is the unit vector along $v$.
"
    );
    let text = "$$ \\alpha_1 = \\alpha_0 $$\n$$ n_1 = n_0 $$\n$$ I_1 = I_0 $$\n";
    assert_eq!(judged(&sentences, text), "urp");
}
