//! Bodies with two equal moments, in the words and signs that people use for them.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const ENERGY: &str = r"$$ T = \tfrac12 I_1(\omega_1^2 + \omega_2^2) + \tfrac12 I_3\,\omega_3^2 $$";

#[test]
fn equal_moments_are_heard_in_lists_and_words() {
    for words in [
        r"The principal moments at the tip are $I_1$, $I_1$, $I_3$.",
        r"Its principal moments are $(I_1, I_1, I_3)$.",
        r"Consider a symmetric top with the third axis as the axis of symmetry.",
        r"The body has rotational symmetry, so two of its principal moments coincide.",
        r"The inertia tensor is $\mathrm{diag}(I_1, I_1, I_3)$.",
    ] {
        assert_eq!(verdicts(&format!("{words}\n\n{ENERGY}\n")), "p", "{words}");
    }
    // Three moments of their own.
    let text = format!("The principal moments are $I_1$, $I_2$, $I_3$.\n\n{ENERGY}\n");
    assert_eq!(verdicts(&text), "r");
}

#[test]
fn a_matrix_of_the_body_says_which_moments_are_equal() {
    let text = format!(
        r"$$ I = \begin{{pmatrix}} I_1 & 0 & 0 \\ 0 & I_1 & 0 \\ 0 & 0 & I_3 \end{{pmatrix}} $$

{ENERGY}
"
    );
    assert_eq!(verdicts(&text), "pp");
}

#[test]
fn a_chain_may_mix_equality_with_other_relations() {
    let text = format!(
        r"For a symmetric top, $I_1 = I_2 \ne I_3$.

{ENERGY}

$$ 2T = I_1\omega_1^2 + I_1\omega_2^2 + I_3\,\omega_3^2 > 0 $$
"
    );
    assert_eq!(verdicts(&text), "apu");
}

#[test]
fn the_axes_of_a_rotor_have_an_angular_velocity_of_their_own() {
    let text = r"The rotor is symmetric about the $z$ axis, with the moments $A$, $A$, $C$ at its centre. The axes follow the axle and not the spin. Their angular velocity is $\boldsymbol\Omega$, and that of the rotor is

$$ \boldsymbol\omega = \boldsymbol\Omega + s\,\hat{\mathbf k} $$

$$ \omega_x = \Omega_x $$

The angular momentum of the rotor is $\mathbf L$,

$$ L_z = C\,\omega_z $$

and the moment on it

$$ M_x = A\,\dot\omega_x + C\,\omega_z\Omega_y - A\,\omega_y\Omega_z $$

$$ M_x = A\,\dot\omega_x + C\,\omega_y\Omega_z - A\,\omega_y\Omega_z $$
";
    assert_eq!(verdicts(text), "apppr");
}

#[test]
fn an_energy_in_euler_angles_needs_no_components() {
    let text = r"The tip of the top is fixed; $\phi$ is the precession, $\theta$ the inclination to the vertical and $\psi$ the spin. Its principal moments at the tip are $I_1$, $I_1$, $I_3$.

$$ L_3 = I_3\left(\dot\psi + \dot\phi\cos\theta\right) $$

$$ T = \tfrac12 I_1\left(\dot\theta^2 + \dot\phi^2\sin^2\theta\right) + \tfrac12 I_3\left(\dot\psi + \dot\phi\cos\theta\right)^2 $$

$$ T = \tfrac12 I_1\left(\dot\theta^2 + \dot\phi^2\cos^2\theta\right) + \tfrac12 I_3\left(\dot\psi + \dot\phi\cos\theta\right)^2 $$
";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn the_spin_beside_that_of_the_axes_is_about_the_axis_of_symmetry() {
    let text = |rate: &str, last: &str| {
        format!(
            r"The axes are fixed to the mount. The mount turns at

$$ \vec\Omega = q\,\vec j + r\,\vec k $$

while the propeller spins about its shaft at the rate $n$ besides:

$$ \vec\omega = {rate} $$

Let $J$ be the moment of inertia about the shaft and $K$ the moment about any diameter. So

$$ \vec L = J n\,\vec i + K q\,\vec j + K r\,\vec k $$

$$ \vec M = \dot{{\vec L}}_{{rel}} + \vec\Omega\times\vec L $$

$$ M_z = K\dot r {last} $$
"
        )
    };
    let rate = r"n\,\vec i + q\,\vec j + r\,\vec k";
    assert_eq!(verdicts(&text(rate, "- J n q")), "aappp");
    assert_eq!(verdicts(&text(rate, "+ J n q")), "aappr");
    assert_eq!(
        verdicts(&text(r"\vec\Omega + n\,\vec i", "- J n q")),
        "aappp"
    );
}

#[test]
fn a_flat_body_obeys_the_theorem_of_perpendicular_axes() {
    let text = |more: &str| {
        verdicts(&format!(
            "The lamina lies in the plane of axes 1 and 2, all principal. The perpendicular axis theorem says\n\n\
             $$ I_1 + I_2 = I_3 $$\n\n$$ \\dot\\omega_1 = -\\omega_2\\omega_3 + M_1/I_1 $$\n\n{more}\n"
        ))
    };
    assert_eq!(text(""), "ap");
    assert_eq!(text("$$ I_1 - I_2 = I_3 $$"), "apr");
    let disc = |sum: &str, own: &str| {
        verdicts(&format!(
            "A thin disc has $I_3 = \\frac12mR^2$. The perpendicular axis theorem says ${sum}$ and by symmetry\n\n\
             $$ I_1 = I_2 = {own}mR^2 $$\n"
        ))
    };
    assert_eq!(disc("I_1 + I_2 = I_3", r"\frac14"), "aap");
    assert_eq!(disc("I_1 + I_2 = I_3", r"\frac12"), "aar");
    assert!(!disc("I_1 + I_2 = 2I_3", r"\frac14").starts_with("aa"));
}
