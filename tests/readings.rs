//! What an index, a prime, a bracket and a second moment stand for, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::{verdicts, verdicts_in};
use polhode::notation::document::Format;

#[test]
fn moments_that_are_added_act_together() {
    let text = |row: &str| {
        verdicts(&format!(
            r"A rotor of inertia $I$ on principal axes feels the torque $\mathbf M$ and the drag $\mathbf M_f$:

$$ I\dot{{\boldsymbol\omega}} + \boldsymbol\omega\times I\boldsymbol\omega = \mathbf M + \mathbf M_f $$

$$ {row} $$
"
        ))
    };
    let right = r"I_2\dot\omega_2 = (I_3-I_1)\omega_3\omega_1 + M_2 + M_{f2}";
    let wrong = r"I_2\dot\omega_2 = (I_1-I_3)\omega_3\omega_1 + M_2 + M_{f2}";
    let single = r"I_2\dot\omega_2 = (I_3-I_1)\omega_3\omega_1 + M_2";
    assert_eq!(text(right), "pp");
    assert_eq!(text(wrong), "pr");
    assert_ne!(text(single), "pp");
}

#[test]
fn a_number_under_a_bold_letter_tells_vectors_apart() {
    let text = |row: &str| {
        verdicts(&format!(
            r"For two points of the body

$$ \mathbf w = \boldsymbol\omega\times(\mathbf r_1 - \mathbf r_2) $$

$$ {row} $$
"
        ))
    };
    assert_eq!(
        text(
            r"\boldsymbol\omega\cdot\mathbf w = \boldsymbol\omega\cdot(\boldsymbol\omega\times\mathbf r_1)"
        ),
        "ap"
    );
    assert_ne!(
        text(r"\mathbf r_1\cdot\mathbf w = \mathbf r_1\cdot(\boldsymbol\omega\times\mathbf r_2)"),
        "ap"
    );
}

#[test]
fn the_rates_before_and_after_a_step_are_vectors() {
    let text = |row: &str| {
        verdicts(&format!(
            r"Set $c = \omega_0\times(I\omega_0)$ and $\omega_1 = \omega_0 - h\,I^{{-1}}c$. Then

$$ {row} $$
"
        ))
    };
    assert_eq!(text(r"\omega_0\cdot c = 0"), "aap");
    assert_eq!(text(r"I\omega_1 = I\omega_0 - h\,c"), "aap");
    assert_eq!(text(r"I\omega_1 = I\omega_0 + h\,c"), "aar");
}

#[test]
fn a_prime_may_be_the_rate() {
    let said = r"No torque acts, and a prime is a derivative in time. On principal axes

$$ I_1 \omega_1' = (I_2 - I_3)\omega_2\omega_3 $$

$$ I_2 \omega_2' = (I_1 - I_3)\omega_3\omega_1 $$
";
    assert_eq!(verdicts(said), "pr");
    let shown = said.replace(", and a prime is a derivative in time", "");
    assert_eq!(verdicts(&shown), "pr");
}

#[test]
fn a_bracket_may_make_the_matrix_of_a_cross_product() {
    let text = r"We write $[a]$ with $[a]\,b = a\times b$. Then

$$ [\omega]^2 b = \omega\times(\omega\times b) $$

$$ [a]\,b = [b]\,a $$
";
    assert_eq!(verdicts(text), "apr");
}

#[test]
fn the_dot_behind_a_cross_applies_the_tensor() {
    let text = r"Without torque

$$ I\cdot\dot\omega = -\omega\times I\cdot\omega $$
";
    assert_eq!(verdicts(text), "p");
}

#[test]
fn a_document_without_a_moment_may_speak_of_a_free_body() {
    let text = r"In the free part of the step

$$ I\dot\omega = -\omega\times(I\omega) $$
";
    assert_eq!(verdicts(text), "p");
    assert_eq!(verdicts(&text.replace("= -", "= ")), "r");
}

#[test]
fn a_vector_may_get_names_for_its_components() {
    let text = r"Let $\mathbf m = \mathbf s_b\times\boldsymbol\omega$, and $\mathbf s_b = (u, v, w)$ is where the mass sits.

$$ m_x = v\,\omega_z - w\,\omega_y $$
";
    assert_eq!(verdicts(text), "aap");
    assert_ne!(verdicts(&text.replace("- w", "+ w")), "aap");
}

#[test]
fn an_unknown_factor_of_the_difference_does_not_save_a_line() {
    let text = r"Let $p = k\,\omega_x\omega_y$.

$$ p^2 = k^2\,\omega_x^2\,\omega_y $$
";
    assert_eq!(verdicts(text), "ar");
}

#[test]
fn the_front_matter_gives_letters_a_meaning() {
    let head = "---\nsymbols:\n  W: momentum\n  u: angular velocity\n  Q: moment\n---\n";
    let text = |line: &str| format!("{head}On body axes\n\n$$ {line} $$\n");
    let line = r"Q_x = \dot W_x - W_y u_z + W_z u_y";
    assert_eq!(verdicts(&text(line)), "p");
    assert_eq!(verdicts(&text(&line.replace("\\dot ", ""))), "r");
    let latex = "% polhode: symbol W: momentum\n% polhode: symbol u: angular velocity\n\
                 % polhode: symbol Q: torque\n\\begin{document}On body axes $Q_x = \\dot W_x - W_y u_z + W_z u_y$.\n\
                 \\end{document}\n";
    assert_eq!(verdicts_in(latex, Format::Latex), "p");
}

#[test]
fn the_force_of_a_bearing_without_a_mark_is_a_number() {
    let text = r"The shaft turns with $\vec\omega = \omega\,\vec k$ at constant $\omega$. The bearings A and B sit at the distance $h$ on either side, and
their forces along $x$ give the moment

$$ M_y = h\,(F_A - F_B) $$

As the mass centre does not move,

$$ F_A + F_B = 0 $$

so that

$$ F_A = -\frac{I_{xz}\,\omega^2}{2h} $$

$$ F_A = -\frac{I_{xz}\,\omega^2}{h} $$
";
    assert_eq!(verdicts(text), "aaapr");
}
