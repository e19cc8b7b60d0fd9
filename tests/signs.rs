//! Inequalities that follow from an order of the moments, and what is dropped where a spin hardly changes.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn signs_follow_from_the_order_of_the_moments() {
    let text = r"Let the principal moments obey $I_1 > I_2 > I_3$.

$$ I_2 - I_1 < 0 $$

$$ \frac{(I_1 - I_2)(I_2 - I_3)}{I_1 I_3} > 0 $$

$$ (I_1 - I_2)(I_3 - I_1) > 0 $$

$$ I_1 - I_2 - I_3 > 0 $$

$$ I_1 + I_3 - 2 I_2 > 0 $$
";
    // No moment exceeds the sum of the others; of the last nothing is known.
    assert_eq!(verdicts(text), "apprru");
}

#[test]
fn an_order_ends_with_its_section() {
    let text = r"## Oblate

Let $C > A$, where $A$, $A$, $C$ are the moments of inertia.

$$ \frac{C - A}{A} > 0 $$

## Any body

$$ \frac{C - A}{C} > 0 $$
";
    assert_eq!(verdicts(text), "apu");
}

#[test]
fn a_spin_that_hardly_changes_leaves_linear_equations() {
    let text = r"No torque acts on the body, with principal moments $I_1$, $I_2$, $I_3$.

$$ I_1\dot\omega_1 = (I_2 - I_3)\,\omega_2\omega_3 $$

The other components are small, so $\dot\omega_1$ is very small and the change of $\omega_1$ is left out.

$$ I_2 I_3\,\ddot\omega_2 = (I_3 - I_1)(I_1 - I_2)\,\omega_1^2\,\omega_2 $$

$$ I_2 I_3\,\ddot\omega_2 = (I_1 - I_3)(I_1 - I_2)\,\omega_1^2\,\omega_2 $$
";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn the_wheels_of_a_satellite_have_a_momentum_and_its_torques_labels() {
    let text = r"Let $\mathbf J$ be the inertia matrix of the spacecraft and $\mathbf h_w$ the angular momentum of the wheels relative to the body. With the external torque $\mathbf T_{ext}$,

$$ \mathbf J\dot{\boldsymbol\omega} + \dot{\mathbf h}_w + \boldsymbol\omega\times(\mathbf J\boldsymbol\omega + \mathbf h_w) = \mathbf T_{ext} $$

$$ \mathbf J\dot{\boldsymbol\omega} + \dot{\mathbf h}_w + \boldsymbol\omega\times(\mathbf J\boldsymbol\omega - \mathbf h_w) = \mathbf T_{ext} $$
";
    assert_eq!(verdicts(text), "pr");
}

#[test]
fn a_frequency_may_be_called_omega_beside_rates_called_capital_omega() {
    let text = r"For a symmetrical top, $I_1 = I_2$, that turns freely with the angular velocity $\boldsymbol\Omega$,

$$ I_1\dot\Omega_1 = (I_1 - I_3)\,\Omega_2\Omega_3 $$

$$ \dot\Omega_3 = 0 $$

We write $\omega = \Omega_3(I_3 - I_1)/I_1$:

$$ \dot\Omega_1 = -\omega\,\Omega_2, \qquad \dot\Omega_2 = \omega\,\Omega_1 $$
";
    assert_eq!(verdicts(text), "appapp");
}

#[test]
fn equations_are_taken_to_first_order_where_words_say_so() {
    let small = r"A free body spins about axis 3. Perturb the motion: $\boldsymbol\omega = (\epsilon_1, \epsilon_2, \Omega + \epsilon_3)$, where the $\epsilon_i$ are small. Neglecting products of small quantities,

$$ I_1\dot\epsilon_1 = (I_2 - I_3)\,\Omega\,\epsilon_2 $$

$$ I_2\dot\epsilon_2 = (I_1 - I_3)\,\Omega\,\epsilon_1 $$

$$ I_3\dot\epsilon_3 = 0 $$

## Exactly

$$ I_3\dot\epsilon_3 = 0 $$
";
    assert_eq!(verdicts(small), "aprpr");
    let varied = r"A free body. Consider $\omega_1 = \Omega + \delta\omega_1$, $\omega_2 = \delta\omega_2$, $\omega_3 = \delta\omega_3$, with $\Omega$ constant. Linearizing,

$$ I_2\,\delta\dot\omega_2 = (I_3 - I_1)\,\Omega\,\delta\omega_3 $$

$$ I_3\,\delta\dot\omega_3 = (I_1 - I_2)\,\Omega\,\delta\omega_2 $$
";
    assert_eq!(verdicts(varied), "aaapp");
}

#[test]
fn sums_over_particles_tell_the_sign_of_the_products() {
    let text = r"$$ I_{xx} = \sum_i m_i(y_i^2 + z_i^2), \qquad I_{xy} = -\sum_i m_i x_i y_i $$

$$ L_x = I_{xx}\omega_x + I_{xy}\omega_y + I_{xz}\omega_z $$
";
    assert_eq!(verdicts(text), "ppp");
}

#[test]
fn words_call_a_letter_the_identity() {
    let text = r"The Jacobian of the step $\omega_{k+1} = \omega_k - h\,I^{-1}(\omega_k\times I\omega_k)$ is

$$ \frac{\partial\omega_{k+1}}{\partial\omega_k} = E + h\,I^{-1}\left([I\omega_k]_\times - [\omega_k]_\times I\right) $$

where $E$ is the identity matrix.
";
    assert_eq!(verdicts(text), "ap");
}

#[test]
fn squares_and_possible_bodies_have_signs() {
    let text = r"A body with inertia $J$, principal axes, is subject to a drag torque $\tau = -c\,\omega$ with $c > 0$. The energy is $E = \frac12\omega^TJ\omega$.

$$ \dot E = -c\,\omega^T\omega \le 0 $$

$$ \dot E = -c\,\omega^T\omega \ge 0 $$

The moments satisfy

$$ J_1 + J_2 \ge J_3 $$

$$ J_1 + J_2 > J_3 $$

$$ J_1 + J_2 \le J_3 $$
";
    let verdicts = verdicts(text);
    assert!(verdicts.ends_with("prpur"), "{verdicts}");
}

#[test]
fn a_given_quantity_hands_no_bounds_over() {
    let bounds = |words: &str, relations: [&str; 2]| {
        let [first, second] = relations;
        verdicts(&format!(
            "The principal moments of a free body obey $I_1 < I_2 < I_3$; $L$ is the length of its angular momentum $\\vec L$.\n\n\
             {words}\n\n$$ \\frac{{L^2}}{{2I_1}} {first} T {second} \\frac{{L^2}}{{2I_3}} $$\n\n\
             $$ T = \\frac{{L_1^2}}{{2I_1}} + \\frac{{L_2^2}}{{2I_2}} + \\frac{{L_3^2}}{{2I_3}} $$\n"
        ))
    };
    for words in [
        "For a given $L$ the energy satisfies",
        "At given $L$ the energy obeys",
        "Let us suppose that",
    ] {
        assert_eq!(bounds(words, [r"\le", r"\le"]), "arp", "{words}");
    }
    assert_eq!(
        bounds("For given $L$ the energy is", [r"\ge", r"\ge"]),
        "app"
    );
}
