//! Turns about one fixed axis, values at one instant, and tensors about several points, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn a_turn_about_one_axis_may_change_its_moment_of_inertia() {
    let text = r"A ring of mass $m$ slides out along a rod that turns about a fixed axis at the rate $\Omega$; $x(t)$ is its distance.

$$ J = J_0 + m x^2 $$

$$ \dot J = 2 m x\,\dot x $$

The angular momentum about the axis is

$$ h = J\,\Omega $$

and the torque $Q$ about it

$$ Q = \dot h $$

$$ Q = J\,\dot\Omega $$

$$ Q = J\,\dot\Omega + 2 m x\,\dot x\,\Omega $$

Suppose $Q = 0$, with $\Omega(0) = \Omega_0$ at the beginning.

$$ \dot\Omega = -\frac{\dot J}{J}\,\Omega $$
";
    assert_eq!(verdicts(text), "apppr paap".replace(' ', ""));
}

#[test]
fn a_one_behind_a_number_of_vectors_is_the_unit_matrix() {
    let text = r"The tensor about the corner is, with the inertia tensor $I_G$ about the mass centre and $\mathbf c$ the vector between them,

$$ I_K = I_G + m\left(\mathbf c^T\mathbf c\,1 - \mathbf c\,\mathbf c^T\right) $$

$$ I_K = I_G - m\,\tilde{\mathbf c}\,\tilde{\mathbf c} $$

$$ \operatorname{tr} I_K = \operatorname{tr} I_G + 2 m\,\mathbf c\cdot\mathbf c $$

$$ \operatorname{tr} I_K = \operatorname{tr} I_G + m\,\mathbf c\cdot\mathbf c $$
";
    assert_eq!(verdicts(text), "appr");
}
