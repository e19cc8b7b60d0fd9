//! Energies of a potential, frequencies of small oscillations and the gradient of gravity, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn the_energy_is_that_of_motion_and_that_of_the_potential() {
    let text = |row: &str| {
        verdicts(&format!(
            r"A rod of moment of inertia $I$ swings about a fixed axis, mass $m$, centre of mass at $l$ from the axis, angle $\theta$ from the vertical.
The kinetic energy is

$$ T = \tfrac12 I\omega^2 $$

and the potential energy is

$$ V = -m g l\cos\theta $$

The energy of the motion, which is conserved, is

$$ {row} $$
"
        ))
    };
    assert!(text(r"E = \tfrac12 I\omega^2 - m g l\cos\theta").ends_with('p'));
    assert!(!text(r"E = \tfrac12 I\omega^2 + m g l\cos\theta").ends_with(['p', 'a']));
}

#[test]
fn the_equation_of_an_oscillation_gives_its_frequency() {
    let text = |row: &str| {
        verdicts(&format!(
            r"Given for small angles is the equation of motion

$$ I_3\ddot\alpha + k\,\alpha = 0 $$

which describes an oscillation with the natural frequency

$$ {row} $$
"
        ))
    };
    assert!(text(r"\nu = \sqrt{\frac{k}{I_3}}").ends_with('a'));
    assert!(!text(r"\nu = \sqrt{\frac{I_3}{k}}").ends_with(['p', 'a']));
    assert!(!text(r"\nu = \sqrt{\frac{2k}{I_3}}").ends_with(['p', 'a']));
}

#[test]
fn the_moment_of_the_gradient_of_gravity_is_given() {
    let text = |moment: &str, row: &str| {
        verdicts(&format!(
            r"Principal axes at the mass centre of a satellite with the angular velocity $\boldsymbol\omega$. The vector from the centre of the planet is $\mathbf r_c$.
The moment of the gradient of gravity, to lowest order, is

$$ \mathbf M = {moment} $$

so that on the axes of the body

$$ {row} $$
"
        ))
    };
    let moment = r"3n^2\,\hat{\mathbf c}\times(I\,\hat{\mathbf c})";
    assert_eq!(text(moment, r"M_1 = 3n^2(I_3 - I_2)c_2c_3"), "ap");
    assert_eq!(text(moment, r"M_1 = 3n^2(I_2 - I_3)c_2c_3"), "ar");
    let turned = r"3n^2\,(I\,\hat{\mathbf c})\times\hat{\mathbf c}";
    assert!(!text(turned, r"M_1 = 0").starts_with('a'));
}

#[test]
fn what_is_kept_constant_in_a_condition_is_a_supposition() {
    let text = |row: &str| {
        verdicts(&format!(
            r"A satellite carries a wheel. On principal axes its angular momentum is

$$ \mathbf H = J\boldsymbol\omega + \mathbf h $$

with the momentum $\mathbf h$ of the wheel relative to the body, $\mathbf h = (0, 0, h)$. Suppose $\mathbf M = \mathbf 0$. If now the wheel runs at constant $h$, that is ${row}$,
then

$$ J_3\dot\omega_3 = (J_1 - J_2)\,\omega_1\omega_2 $$
"
        ))
    };
    assert!(text(r"\dot h = 0").ends_with("ap"));
}

#[test]
fn the_arm_between_two_points_has_a_sense() {
    let text = |row: &str| {
        verdicts(&format!(
            r"The angular momenta about a point $A$ and about the mass centre $G$ of a body of mass $m$, with positions $\mathbf r_A$, $\mathbf r_G$ and the velocity $\mathbf v_G$ of $G$, are related by

$$ {row} $$
"
        ))
    };
    let wrong = r"\mathbf L_A = \mathbf L_G + (\mathbf r_A - \mathbf r_G)\times m\mathbf v_G";
    assert!(!text(wrong).ends_with(['p', 'a']));
}

#[test]
fn what_is_called_the_lagrangian_gives_the_equations_of_motion() {
    let text = |letter: &str, gyroscopic: &str, steady: &str| {
        let text = format!(
            r"A symmetric top turns about a fixed point. Its moment of inertia is $C$ about the axis of figure and $A$ across it, the mass is $m$, the centre of mass lies at the distance $h$ from the point, and $\theta$ is the inclination of the axis to the upward vertical.
With the precession angle $\phi$ and the spin angle $\psi$ the Lagrangian is

$$ {letter} = \tfrac12 A(\dot\theta^2 + \dot\phi^2\sin^2\theta) + \tfrac12 C(\dot\psi + \dot\phi\cos\theta)^2 - mgh\cos\theta $$

and Lagrange's equation for the inclination is

$$ A\,\ddot\theta = A\,\dot\phi^2\sin\theta\cos\theta {gyroscopic} C(\dot\psi + \dot\phi\cos\theta)\,\dot\phi\sin\theta + mgh\sin\theta $$

Let $\dot\theta = \ddot\theta = 0$. Dividing by $\sin\theta$ we obtain

$$ A\cos\theta\,\dot\phi^2 - C(\dot\psi + \dot\phi\cos\theta)\,\dot\phi {steady} mgh = 0 $$
"
        );
        verdicts(&text)
    };
    for letter in ["L", r"\mathcal L"] {
        assert_eq!(text(letter, "-", "+"), "apap", "{letter}");
        assert_eq!(text(letter, "+", "+"), "arap", "{letter}");
        assert_eq!(text(letter, "-", "-"), "apar", "{letter}");
    }
}

#[test]
fn what_changes_in_the_motion_is_not_the_total_energy() {
    let text = |potential: &str| {
        verdicts(&format!(
            r"The top spins with its tip $O$ in a cup. Its mass is $m$ and the mass centre lies at the distance $l$ from $O$ on the axis. The moments of inertia at $O$ are $C$ about the axis and $A$ about any line across it. We use axes that follow the tilt $\theta$ and the precession $\phi$ of the top but not the spin $\psi$. The top turns with

$$ \boldsymbol\omega = \dot\theta\,\mathbf e_1 + \dot\phi\sin\theta\,\mathbf e_2 + s\,\mathbf e_3, \qquad s = \dot\psi + \dot\phi\cos\theta $$

The weight has the moment

$$ \mathbf N = m g l\sin\theta\,\mathbf e_1 $$

When the axis is horizontal, $\theta = \pi/2$, this is greatest. The total energy is

$$ E = \tfrac12 A\left(\dot\theta^2 + \dot\phi^2\sin^2\theta\right) + \tfrac12 C s^2 {potential} m g l\cos\theta. $$
"
        ))
    };
    assert!(text("+").ends_with('a'));
    assert!(text("-").ends_with('u'));
}
