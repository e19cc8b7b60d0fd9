//! Lines that suppose something, and letters that words give a meaning, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_the_words_say_of_a_rate_is_no_name_of_the_letter_behind() {
    let text = r"The angular momentum is $\vec P = I\vec\omega$. The couple is the rate of change of $\vec P$ in space,

$$ \vec K = \left(\frac{d\vec P}{dt}\right)_{\rm body} + \vec\omega\times\vec P $$
";
    assert_eq!(verdicts(text), "pp");
    let text = r"With the kinetic moment $\vec\sigma$ and the couple $\vec M$, writing $\dot{\vec\omega}$ for the angular acceleration,

$$ \vec\sigma = I\vec\omega $$

$$ \vec M = I\dot{\vec\omega} + \vec\omega\times\vec\sigma $$
";
    assert_eq!(verdicts(text), "pp");
}

#[test]
fn a_moment_that_nothing_determines_is_supposed_to_be_zero() {
    let free = r"If $\mathbf M$ vanishes, the energy does not change:

$$ \mathbf M = 0 $$

$$ \dot T = 0 $$
";
    assert_eq!(verdicts(free), "ap");
    let steady = r"On principal axes the body turns steadily, $\omega_x = p$ and $\omega_y = s$ and $\omega_z = 0$, with constant $p$ and $s$.

$$ M_z = 0 $$
";
    assert!(!verdicts(steady).ends_with('a'));
}

#[test]
fn a_load_that_is_given_derives_nothing() {
    let text = r"On principal axes, the jets give a torque about one axis only,

$$ M_1 = 0, \qquad M_2 = 0, \qquad M_3 = \mu $$

so that

$$ I_1\dot\omega_1 = (I_2 - I_3)\,\omega_2\omega_3 $$

$$ I_3\dot\omega_3 = (I_1 - I_2)\,\omega_1\omega_2 - \mu $$
";
    assert_eq!(verdicts(text), "aaapr");
}

#[test]
fn a_plane_of_symmetry_may_have_a_hyphen() {
    let text = |plane: &str| {
        verdicts(&format!(
            "The {plane} plane is a plane of symmetry, so\n\n$$ I_{{xy}} = I_{{yz}} = 0 $$\n"
        ))
    };
    assert_eq!(text("x-z"), "p");
    assert_eq!(text("y-z"), "r");
}

#[test]
fn a_flat_body_with_two_equal_moments_has_twice_their_size_about_the_third_axis() {
    let text = r"The principal moments of inertia are $A$, $A$, $C$, and no torque acts.

$$ C\dot\omega_3 = 0 $$

so we write

$$ \omega_3 = n $$

## A plate

$$ A\dot\omega_1 = (A - C)\,n\,\omega_2 $$

For a thin plate

$$ C = 2A $$

$$ \dot\omega_1 = -n\,\omega_2 $$
";
    assert_eq!(verdicts(text), "papap");
}

#[test]
fn moments_about_numbered_axes_are_named_in_words() {
    let text = |behind: &str| {
        verdicts(&format!(
            "The body has the moment of inertia $K$ about axis 3 and $J_t$ about the principal axes 1 and 2. There is \
             no torque.\n\n$$ J_t\\,\\dot\\omega_1 = {behind}\\,\\omega_2\\omega_3 $$\n"
        ))
    };
    assert_eq!(text("(J_t - K)"), "p");
    assert_eq!(text("(K - J_t)"), "r");
}

#[test]
fn the_momentum_of_a_wheel_may_have_the_letter_of_the_whole_with_a_label() {
    let text = r"The momentum of the wheel relative to the body is $h_s$; its axis is the third principal axis. The total angular momentum is

$$ \mathbf h = I_1\omega_1\,\mathbf e_1 + I_2\omega_2\,\mathbf e_2 + (I_3\omega_3 + h_s)\,\mathbf e_3 $$

and the torque

$$ \mathbf T = \dot{\mathbf h} + \boldsymbol\omega\times\mathbf h $$

$$ T_1 = I_1\dot\omega_1 + (I_3 - I_2)\,\omega_2\omega_3 + \omega_2 h_s $$

$$ T_3 = I_3\dot\omega_3 + (I_2 - I_1)\,\omega_1\omega_2 + \dot h_s $$
";
    assert_eq!(verdicts(text), "appp");
    let lost = text.replace(r" + \dot h_s", "");
    assert!(!verdicts(&lost).ends_with(['a', 'p']));
}

#[test]
fn a_lone_vertical_beside_numbered_axes_is_a_direction_of_its_own() {
    let text = r"The upward vertical is $\mathbf k$, and the torque has no component along $\mathbf e_3$. The moments at $O$ are $A$, $A$ and $C$. Let

$$ \mathbf k = \sin\theta\,\mathbf e_2 + \cos\theta\,\mathbf e_3 $$

$$ \mathbf e_1\cdot\mathbf k = 0 $$

$$ L_z = \mathbf L\cdot\mathbf k = L_2\sin\theta + L_3\cos\theta $$

The axes need not turn with the spin, so

$$ A\,\dot\omega_1 = M_1 + \sin\theta $$
";
    assert_eq!(verdicts(text), "aapu");
}

#[test]
fn a_supposed_value_keeps_what_was_supposed_of_its_rate() {
    let text = "A wheel stores $\\mathbf g$ along its axis. About the mass centre\n\n\
                $$ \\mathbf H = J\\boldsymbol\\omega + c\\,\\mathbf g $$\n\n\
                $$ \\boldsymbol\\tau_e = \\dot{\\mathbf H} + \\boldsymbol\\omega\\times\\mathbf H $$\n\n\
                with the dot on body axes. Suppose $\\boldsymbol\\tau_e = \\mathbf 0$, and suppose that \
                $\\boldsymbol\\omega = \\mathbf 0$. Then\n\n$$ c\\,\\dot{\\mathbf g} = \\mathbf 0 $$\n";
    assert_eq!(verdicts(text), "apaap");
}

#[test]
fn what_is_put_is_supposed() {
    let text = |put: &str| {
        format!(
            r"Principal axes, no torque. {put}

$$ \omega_1 = \varepsilon_1, \qquad \omega_2 = \Omega, \qquad \omega_3 = \varepsilon_3 $$

with small $\varepsilon_1$, $\varepsilon_3$, of which we keep the first order only; then $\Omega$ is constant. The remaining equations are

$$ I_1\dot\varepsilon_1 = (I_2 - I_3)\,\Omega\,\varepsilon_3 $$

$$ I_3\dot\varepsilon_3 = (I_2 - I_1)\,\Omega\,\varepsilon_1 $$
"
        )
    };
    for put in ["Put", "We put", "Set"] {
        assert_eq!(verdicts(&text(put)), "aaapr", "{put}");
    }
}

#[test]
fn one_of_eulers_equations_may_stand_for_the_three() {
    let text = |moment: &str| {
        verdicts(&format!(
            "Given Euler's equations $I_1\\dot\\omega_1 = (I_2 - I_3)\\omega_2\\omega_3$ and cyclic, with the energy \
             $T = \\frac12(I_1\\omega_1^2 + I_2\\omega_2^2 + I_3\\omega_3^2)$.\n\n\
             $$ I_2\\dot\\omega_2 = (I_3 - {moment})\\omega_3\\omega_1 $$\n\n$$ \\frac{{dT}}{{dt}} = 0 $$\n"
        ))
    };
    assert!(text("I_1").ends_with("pp"), "{}", text("I_1"));
    assert!(text("I_2").ends_with("rp"), "{}", text("I_2"));
}

#[test]
fn a_simpler_law_takes_the_place_of_the_law_before() {
    let text = |more: &str| {
        verdicts(&format!(
            "The body obeys $I\\dot{{\\vec\\omega}} + \\vec\\omega\\times I\\vec\\omega = \\vec u$ with the control torque $\\vec u$. \\
             Choose, with a gain $k$ greater than zero,\n\n\
             $$ \\vec u = \\vec\\omega\\times I\\vec\\omega - kI\\vec\\omega $$\n\nso that\n\n\
             $$ \\dot{{\\vec\\omega}} = -k\\vec\\omega $$\n\n{more}\n"
        ))
    };
    let simpler = r"With the simpler law without cancellation, that is $\vec u = -kI\vec\omega$, one has

$$ I\dot{\vec\omega} = -kI\vec\omega - \vec\omega\times I\vec\omega $$
";
    assert!(text(simpler).ends_with("apap"), "{}", text(simpler));
    let claimed = r"Therefore

$$ \vec u = -kI\vec\omega $$
";
    assert!(text(claimed).ends_with("r"), "{}", text(claimed));
}

/// The verdict on the momentum across the axis of a body of which words say about what it turns.
fn turns(words: &str) -> String {
    verdicts(&format!(
        "{words} The product of inertia is $I_{{xz}} = \\int xz\\,dm$. The momentum across is\n\n$$ H_x = -I_{{xz}}\\omega_z $$\n\n$$ H_x = I_{{xz}}\\omega_z $$\n"
    ))
}

#[test]
fn words_say_which_components_of_the_turn_vanish() {
    for words in [
        "The body turns about $z$ only.",
        "The rig is driven about the $z$ axis alone.",
        "The body turns steadily ($\\omega_x$ and $\\omega_y$ are zero).",
        "Let $\\omega_z$ be given; $\\omega_x$ and $\\omega_y$ vanish.",
    ] {
        let found = turns(words);
        assert!(found.ends_with("pr"), "{words}: {found}");
    }
    for words in [
        "The body turns about $z$.",
        "We want to show that $\\omega_x$ and $\\omega_y$ vanish.",
    ] {
        let found = turns(words);
        assert!(!found.ends_with("pr"), "{words}: {found}");
    }
}

#[test]
fn principal_axes_at_the_end_are_not_taken_before() {
    let text = "I keep all products of inertia and go to principal axes only at the end. On body axes\n\n$$ H_x = I_{xx}\\omega_x - \
                I_{xy}\\omega_y - I_{xz}\\omega_z $$\n\n$$ H_x = I_{xx}\\omega_x $$\n";
    assert!(verdicts(text).ends_with("pr"), "{}", verdicts(text));
}
