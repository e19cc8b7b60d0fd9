//! Which frame a label means, from the words, from the other labels and by custom.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// The rule of the transport theorem with two labels, behind some words about them.
fn transport(words: &str, still: &str, turning: &str) -> String {
    verdicts(&format!(
        "{words} The angular velocity of the latter in the former is $\\vec\\Omega$. For any vector $\\vec U$,\n\n\
         $$ \\left.\\frac{{d\\vec U}}{{dt}}\\right|_{{{still}}} = \
         \\left.\\frac{{d\\vec U}}{{dt}}\\right|_{{{turning}}} + \\vec\\Omega\\times\\vec U $$\n"
    ))
}

#[test]
fn words_say_which_frame_turns() {
    let two = "The frame $P$ is fixed. The frame $Q$ has the origin $A$.";
    assert_eq!(transport(two, "P", "Q"), "p");
    assert_eq!(
        transport("$P$ is an inertial frame, and $Q$ rotates.", "P", "Q"),
        "p"
    );
    assert_eq!(
        transport("$P$ is an inertial frame, and $Q$ rotates.", "Q", "P"),
        "r"
    );
    assert_eq!(
        transport(
            "Take the inertial frame $B$ and the body frame $A$.",
            "B",
            "A"
        ),
        "p"
    );
    assert_eq!(
        transport("$P$ is fixed in the body, $Q$ does not rotate.", "Q", "P"),
        "p"
    );
    let craft = "$P$ is an inertial frame and $Q$ is fixed in the spacecraft.";
    assert_eq!(transport(craft, "P", "Q"), "p");
    let ground = "$P$ is fixed to the ground and $Q$ is fixed to the drum.";
    assert_eq!(transport(ground, "P", "Q"), "p");
    assert_eq!(transport(ground, "Q", "P"), "r");
}

#[test]
fn labels_say_it_by_custom_and_by_each_other() {
    assert_eq!(transport("Take two frames.", "R_0", "R"), "p");
    assert_eq!(transport("Take two frames.", "S", "S'"), "p");
    assert_eq!(transport("Take two frames.", "N", "P"), "p");
    assert_eq!(transport("Take two frames.", "P", "N"), "r");
    assert_eq!(transport("Take two frames.", "P", "Q"), "u");
}

#[test]
fn the_arrow_between_two_points_needs_no_introduction() {
    let text = r"For any vectors,

$$ \vec\Omega\wedge(\vec\Omega\wedge\overrightarrow{OM}) = (\vec\Omega\cdot\overrightarrow{OM})\,\vec\Omega + \Omega^2\,\overrightarrow{OM} $$
";
    assert_eq!(verdicts(text), "r");
}

#[test]
fn a_tilde_makes_a_vector_the_matrix_of_its_cross_product() {
    let text = r"With the inertia tensor $[J]$ and the torque $\vec T$,

$$ [J]\dot{\vec\omega} = \vec T - [\tilde\omega][J]\vec\omega $$

$$ [\tilde\omega] = \begin{bmatrix} 0 & -\omega_3 & \omega_2 \\ \omega_3 & 0 & -\omega_1 \\ -\omega_2 & \omega_1 & 0 \end{bmatrix} $$

$$ [J]\dot{\vec\omega} = \vec T + [\tilde\omega][J]\vec\omega $$
";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn a_point_may_rest_in_the_body_and_no_word_says_so() {
    let rate = |line: &str| {
        verdicts(&format!(
            "The body has the angular velocity $\\vec\\omega$; $\\vec r$ is a position.\n\n$$ {line} $$\n"
        ))
    };
    assert_eq!(
        rate(r"\frac{{}^{N}d\vec r}{dt} = \vec\omega\times\vec r"),
        "u"
    );
    assert_eq!(
        rate(r"\frac{{}^{N}d\vec r}{dt} = \vec r\times\vec\omega"),
        "r"
    );
}

#[test]
fn labels_put_vectors_on_axes_and_a_pair_of_them_names_the_matrix_between() {
    let text = r"The attitude of a body is the matrix $\mathbf A_{NB}$, which takes components on its own axes $B$ to the fixed axes $N$. With
the angular velocity $\boldsymbol\omega_B$ we have

$$ \dot{\mathbf A}_{NB} = \mathbf A_{NB}\,[\boldsymbol\omega_B]_\times $$

The angular momentum is

$$ \mathbf h_N = \mathbf A_{NB}\,\mathbf h_B $$

$$ \dot{\mathbf h}_N = \mathbf A_{NB}\left(\dot{\mathbf h}_B + [\boldsymbol\omega_B]_\times\mathbf h_B\right) $$

$$ \dot{\mathbf h}_N = \mathbf A_{NB}\left(\dot{\mathbf h}_B - [\boldsymbol\omega_B]_\times\mathbf h_B\right) $$
";
    assert_eq!(verdicts(text), "pppr");
}

#[test]
fn frames_may_be_named_in_plain_words() {
    let text = r"Frame 1 is inertial, frame 2 is welded to the body.

$$ \left.\frac{d\mathbf L_C}{dt}\right|_1 = \left.\frac{d\mathbf L_C}{dt}\right|_2 + \boldsymbol\omega_{2/1}\times\mathbf L_C $$

$$ \mathbf L_C = \mathbf I_C\,\boldsymbol\omega_{2/1} $$

$$ \left.\frac{d\mathbf L_C}{dt}\right|_1 = \mathbf I_C\,\dot{\boldsymbol\omega}_{2/1} $$
";
    assert_eq!(verdicts(text), "ppr");
}

#[test]
fn what_tells_nothing_apart_is_dropped() {
    let text = r"With the inertia tensor $\mathbf I_0$,

$$ \mathbf M_0 = \mathbf I_0\,\dot{\boldsymbol\omega} + \boldsymbol\omega\times\mathbf I_0\,\boldsymbol\omega $$

$$ \mathbf M_0 = \mathbf I_0\,\dot{\boldsymbol\omega} - \boldsymbol\omega\times\mathbf I_0\,\boldsymbol\omega $$
";
    assert_eq!(verdicts(text), "pr");
}

#[test]
fn velocities_carry_the_name_of_their_frame() {
    let text = |last: &str| {
        format!(
            "$A$ is inertial and $B$ turns in it with ${{}}^A\\vec\\omega^B$. From $O$ the particle has the position $\\vec r$; \
             ${{}}^A\\vec v$ and ${{}}^B\\vec v$ are its rates.\n\n\
             $$ \\frac{{{{}}^A d\\vec r}}{{dt}} = \\frac{{{{}}^B d\\vec r}}{{dt}} + {{}}^A\\vec\\omega^B\\times\\vec r $$\n\n\
             $$ {{}}^B\\vec\\omega^A = -{{}}^A\\vec\\omega^B $$\n\n\
             $$ {{}}^A\\vec v = {{}}^B\\vec v - {{}}^B\\vec\\omega^A\\times\\vec r $$\n\n\
             $$ {{}}^A\\vec a = {{}}^B\\vec a + {last}\\,{{}}^A\\vec\\omega^B\\times{{}}^B\\vec v \
             + {{}}^A\\dot{{\\vec\\omega}}^B\\times\\vec r + {{}}^A\\vec\\omega^B\\times({{}}^A\\vec\\omega^B\\times\\vec r) $$\n"
        )
    };
    assert_eq!(verdicts(&text("2")), "pppp");
    assert_eq!(verdicts(&text("")), "pppr");
}

#[test]
fn a_frame_turned_round_turns_the_other_way() {
    let text = "$A$ is inertial, $B$ is fixed in the body.\n\n\
                $$ \\frac{{}^A d\\vec L}{dt} = \\frac{{}^B d\\vec L}{dt} + {}^A\\vec\\omega^B\\times\\vec L $$\n\n\
                $$ {}^B\\vec\\omega^A = {}^A\\vec\\omega^B $$\n";
    assert_eq!(verdicts(text), "pr");
}

#[test]
fn words_may_give_the_axes_an_angular_velocity_without_a_letter() {
    let text = |line: &str| {
        format!(
            "The upward vertical is $\\mathbf{{k}} = \\sin\\theta\\,\\mathbf{{e}}_2 + \\cos\\theta\\,\\mathbf{{e}}_3$, with the constant angle \
             $\\theta$. The unit vectors turn with the angular velocity $\\Omega\\,\\mathbf{{k}}$.\n\n$$ {line} $$\n"
        )
    };
    let last = |line: &str| verdicts(&text(line)).pop();
    assert_eq!(
        last("\\dot{\\mathbf e}_3 = \\Omega\\sin\\theta\\,\\mathbf{e}_1"),
        Some('p')
    );
    assert_eq!(
        last("\\dot{\\mathbf e}_3 = \\Omega\\cos\\theta\\,\\mathbf{e}_1"),
        Some('r')
    );
}

#[test]
fn a_rotor_gives_its_letter_to_a_frame() {
    let text = |at: &str| {
        format!(
            "In the inertial frame $F$ the law is $\\underline M = \\left.\\frac{{d\\underline L}}{{dt}}\\right|_F$. \
             The triad is fixed in the rotor $R$, which turns with $\\underline\\omega$.\n\n\
             $$ \\left.\\frac{{d\\underline L}}{{dt}}\\right|_F = \\left.\\frac{{d\\underline L}}{{dt}}\\right|_{at} + \\underline\\omega\\times\\underline L $$\n"
        )
    };
    assert_eq!(verdicts(&text("R")), "pp");
    assert_eq!(verdicts(&text("F")), "pr");
}

#[test]
fn letters_of_two_frames_are_initials() {
    let words = "The letters $F$ and $R$ mark the fixed and the rotating frame.";
    let line = |still: &str, turning: &str| {
        verdicts(&format!(
            "{words} The rotating frame has the angular velocity $\\vec\\Omega$. For any vector $\\vec U$,\n\n\
             $$ \\left(\\frac{{d\\vec U}}{{dt}}\\right)_{{{still}}} = \\left(\\frac{{d\\vec U}}{{dt}}\\right)_{{{turning}}} + \\vec\\Omega\\times\\vec U $$\n"
        ))
    };
    assert_eq!(line("F", "R"), "p");
    assert_eq!(line("R", "F"), "r");
}

#[test]
fn axes_that_the_body_turns_ahead_of_are_not_attached_to_it() {
    let rates = |words: &str| {
        verdicts(&format!(
            r"{words} The axes turn at $\vec\Omega$ and the body at $\vec\omega$, faster by the spin $s$:

$$ \vec\omega = \vec\Omega + s\,\vec e_3 $$

With the angular momentum $\vec L$ and the torque $\vec M$,

$$ \vec M = \left(\frac{{d\vec L}}{{dt}}\right)_{{rel}} + \vec\omega\times\vec L $$

$$ \vec M = \left(\frac{{d\vec L}}{{dt}}\right)_{{rel}} + \vec\Omega\times\vec L $$
"
        ))
    };
    assert_eq!(
        rates("Euler's equations hold in axes carried by the body."),
        "arp"
    );
    assert_eq!(rates("So far the axes were fixed in the body."), "arp");
    let attached = r"The axes, fixed in the body, turn at $\vec\Omega$ and the body at $\vec\omega$.

$$ \vec\Omega = \vec\omega $$
";
    assert_eq!(verdicts(attached), "p");
}

#[test]
fn a_tensor_changes_in_space_as_it_turns() {
    let text = |sign: &str| {
        format!(
            "The inertia tensor $\\mathbf I$ of a rigid body with the angular velocity $\\vec\\omega$.\n\n\
             $$ \\left(\\frac{{d\\mathbf I}}{{dt}}\\right)_{{\\text{{space}}}} = [\\vec\\omega]_\\times\\,\\mathbf I {sign} \\mathbf I\\,[\\vec\\omega]_\\times $$\n"
        )
    };
    assert_eq!(verdicts(&text("-")), "p");
    assert_eq!(verdicts(&text("+")), "r");
}

#[test]
fn a_moment_about_an_axis_is_expanded_in_the_components_of_its_unit_vector() {
    let moment = |letter: &str, unit: &str, double: &str| {
        let all = verdicts(&format!(
            "The inertia tensor is $\\mathbf I$. About the axis along the unit vector ${unit}$ the moment of inertia is\n\n\
             $$ {letter} = {unit}\\cdot\\mathbf I{unit} $$\n\nand, written out,\n\n\
             $$ {letter} = I_{{xx}}n_x^2 + I_{{yy}}n_y^2 + I_{{zz}}n_z^2 - {double}I_{{xy}}n_xn_y - {double}I_{{yz}}n_yn_z - {double}I_{{zx}}n_zn_x $$\n"
        ));
        all.chars().last()
    };
    for letter in ["J", "I_n", "K"] {
        for unit in [r"\mathbf n", r"\hat n", r"\hat{\mathbf n}"] {
            assert_eq!(moment(letter, unit, "2"), Some('p'), "{letter} {unit}");
            assert_eq!(moment(letter, unit, ""), Some('r'), "{letter} {unit}");
        }
    }
}

#[test]
fn what_carries_the_axes_names_their_frame() {
    let text = |rate: &str| {
        verdicts(&format!(
            "The platform turns with $\\boldsymbol\\Omega$, the body on it with $\\boldsymbol\\omega$, and $\\mathbf H = \\mathbf I\\boldsymbol\\omega$.\n\n\
             $$ \\mathbf M = \\left(\\frac{{d\\mathbf H}}{{dt}}\\right)_{{\\text{{platform}}}} + {rate}\\times\\mathbf H $$\n"
        ))
    };
    assert_eq!(text("\\boldsymbol\\Omega"), "pp");
    assert_eq!(text("\\boldsymbol\\omega"), "pr");
}

#[test]
fn what_turns_relative_to_the_other_frame_is_the_moving_one() {
    let text = |one: &str, other: &str| {
        verdicts(&format!(
            "Let $F$ be the frame of a sensor ring and $H$ the frame of the hull. The angular velocity of $F$ relative to $H$ \
             is $\\boldsymbol\\sigma$. For any vector $\\mathbf u$\n\n\
             $$ \\left(\\frac{{d\\mathbf u}}{{dt}}\\right)_{one} = \
             \\left(\\frac{{d\\mathbf u}}{{dt}}\\right)_{other} + \\boldsymbol\\sigma\\times\\mathbf u $$\n"
        ))
    };
    assert_eq!(text("H", "F"), "p");
    assert_eq!(text("F", "H"), "r");
}

#[test]
fn a_momentum_on_body_axes_has_its_rate_there() {
    let text = |words: &str| {
        verdicts(&format!(
            "Write the angular momentum about the mass centre {words}, $\\mathbf h = J\\boldsymbol\\omega$, with a constant $J$. \
             The moment equation reads\n\n$$ \\dot{{\\mathbf h}} = \\boldsymbol\\tau $$\n\n\
             $$ \\dot{{\\mathbf h}} + \\boldsymbol\\omega\\times\\mathbf h = \\boldsymbol\\tau $$\n"
        ))
    };
    assert_eq!(text("on body axes"), "prp");
    assert_eq!(text("as usual"), "ppp");
}

#[test]
fn of_two_labels_one_turns() {
    let law = |labels: [&str; 2], sign: char| {
        let [still, turning] = labels;
        verdicts(&format!(
            "Any vector $\\mathbf A$ is looked at from a frame that turns with $\\boldsymbol\\Omega$. Then\n\n$$ \
             \\left(\\frac{{d\\mathbf A}}{{dt}}\\right)_{{{still}}} = \\left(\\frac{{d\\mathbf A}}{{dt}}\\right)_{{{turning}}} \
             {sign} \\boldsymbol\\Omega\\times\\mathbf A $$\n"
        ))
    };
    for labels in [["S", "R"], ["I", "R"], ["N", "A"], ["A", "B"], ["S", "B"]] {
        assert!(law(labels, '+').ends_with('p'), "{labels:?}");
        assert!(law(labels, '-').ends_with('r'), "{labels:?}");
    }
}
