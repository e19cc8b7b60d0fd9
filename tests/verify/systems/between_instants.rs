//! Lines that speak of values at instants, and of what happens between two of them.

use super::{judged, judged_in_any_order};

/// A rigid body on which one force acts, and labels that mean two instants.
const PUSHED: &str = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
P is a point fixed in B.
$m$ is the mass of the body.
$J$ is the inertia tensor of the body about G.
$\\vec\\rho$ is the position of P from G.
$\\vec F$ is the force at P on the body.
The force at P is the only load on the body.
$\\vec v$ and $\\vec u$ are the velocities of G and of P relative to N.
$\\vec\\omega$ is the angular velocity of the body relative to N.
$\\vec p$ is the momentum of the body relative to N.
$\\vec H$ is the angular momentum of the body about G relative to N.
The labels 0 and 1 mean at the instants $t_0$ and $t_1$.
";

#[test]
fn what_holds_at_one_instant_holds_at_any_time() {
    let text = r"
$$ \vec u_0 = \vec v_0 + \vec\omega_0 \times \vec\rho_0 $$
$$ \vec u_0 = \vec v_0 - \vec\omega_0 \times \vec\rho_0 $$
$$ \vec H_1 = J_1 \vec\omega_1 $$
$$ \vec p_0 = m \vec v_0 $$
";
    assert_eq!(judged(PUSHED, text), "prpp");
}

#[test]
fn differences_are_integrals_of_rates() {
    let text = r"
$$ \vec p_1 - \vec p_0 = \int_{t_0}^{t_1} \vec F \, dt $$
$$ \vec p_1 + \vec p_0 = \int_{t_0}^{t_1} \vec F \, dt $$
$$ \vec H_1 - \vec H_0 = \int_{t_0}^{t_1} \vec\rho \times \vec F \, dt $$
$$ \vec H_1 - \vec H_0 = \int_{t_0}^{t_1} \vec F \times \vec\rho \, dt $$
$$ \vec H_1 = J_0 \vec\omega_1 $$
$$ \vec p_1 = \vec p_0 $$
";
    assert_eq!(judged(PUSHED, text), "prprrr");
}

#[test]
fn a_letter_that_changes_needs_the_label_of_its_instant() {
    let text = r"
$$ \vec p_0 = m \vec v $$
$$ \vec p_1 = \vec p $$
$$ \dot{\vec p}_0 = \vec F_0 $$
";
    assert!(!judged(PUSHED, text).contains(['p', 'r']));
}

#[test]
fn what_is_conserved_is_the_same_at_both_instants() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
The axes of B are principal axes of the body.
G is the mass centre of the body.
No moment acts on the body about G.
$R$ takes components on B to components on N.
$J_x$, $J_y$, $J_z$ are the principal moments of the body about G on B.
$p$, $q$, $r$ are the components on B of the angular velocity of B relative to N.
$T$ is the kinetic energy of rotation of the body relative to N.
On lines 2 to 12 $h$ is the angular momentum of the body about G relative to N in components on B.
From line 14 on $h$ is the angular momentum of the body about G relative to N in components on N.
The labels 0 and 1 mean at the instants $t_0$ and $t_1$.
";
    let text = r"
$$ T_1 = T_0 $$

$$ h_1 = h_0 $$

$$ \left| h_1 \right| = \left| h_0 \right| $$

$$ \left| h_1 \right| = 2 \left| h_0 \right| $$

$$ R_1 h_1 = R_0 h_0 $$

$$ q_1 = q_0 $$

$$ h_1 = h_0 $$

$$ R_1 h_1 = R_0 h_0 $$
";
    assert_eq!(judged(sentences, text), "prprprpr");
}

#[test]
fn labels_as_instants_are_told_in_any_order() {
    let text = r"
$$ \vec p_1 - \vec p_0 = \int_{t_0}^{t_1} \vec F \, dt $$
$$ \vec p_1 - \vec p_0 = m (\vec v_1 + \vec v_0) $$
";
    let sentences: Vec<&str> = PUSHED.lines().collect();
    judged_in_any_order(&sentences, text, "pr");
}

#[test]
fn an_integral_runs_from_the_other_instant_to_the_present_one() {
    let text = r"
$$ \int_{t_0}^{t_0} \vec v \, dt = 0 $$
$$ \vec p_1 - \vec p_0 = \int_{0}^{t_1} \vec F \, dt $$
$$ \vec p_1 - \vec p_0 = \int_{2 t_0}^{t_1} \vec F \, dt $$
$$ \int_{t_1}^{t_1} \vec F \, dt = \vec p_1 - \vec p_0 $$
";
    let verdicts = judged(PUSHED, text);
    assert!(
        verdicts.starts_with(['p', 'u']) && !verdicts[1..].contains('p'),
        "{verdicts}"
    );
}

#[test]
fn what_is_given_of_one_instant_tells_nothing_of_another() {
    let given = format!("{PUSHED}Line 2 is given.\n");
    let text = r"
$$ \vec p_0 = 0 $$
$$ \vec p_1 = 0 $$
$$ \vec v = 0 $$
";
    assert!(!judged(&given, text).contains('p'));
    let declared = format!("{PUSHED}$\\vec p_0 = 0$.\n");
    let text = r"
$$ \vec p_0 = 0 $$
$$ \vec p_1 = \int_{t_0}^{t_1} \vec F \, dt $$
";
    assert!(!judged(&declared, text).contains('r'));
}

#[test]
fn letters_with_labels_of_instants_tell_the_letter_itself() {
    let sentences = r"
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
P is a point fixed in B.
$m$ is the mass of the body.
$\vec F$ is the force at P on the body.
$\vec\rho$ is the position of P from G.
The force at P is the only load on the body.
The labels 1 and 2 mean at the instants $t_1$ and $t_2$.
$\vec p_1$ and $\vec p_2$ are the momentum of the body relative to N at $t_1$ and $t_2$.
$\vec v_2$ is the velocity of G relative to N at $t_2$.
";
    let text = r"
$$ \vec p_2 = m \vec v_2 $$
$$ \vec p_1 = m \vec v_2 $$
$$ \vec p_2 - \vec p_1 = \int_{t_1}^{t_2} \vec F \, dt $$
$$ \vec p_2 + \vec p_1 = \int_{t_1}^{t_2} \vec F \, dt $$
";
    assert_eq!(judged(sentences, text), "prpr");
}
