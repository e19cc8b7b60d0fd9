//! Documents whose plain letters stand on axes of fixed orientation, and where a label puts the others on the body's.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

const OPENING: &str = "The rotation matrix $R$ takes body coordinates to world coordinates, and the inertia tensor is\n\n\
                       $$I = R\\,I_b\\,R^T .$$\n\n";

/// The verdicts of lines behind one that says what the inertia is on space axes.
fn behind_the_opening(lines: &[&str]) -> String {
    let shown: Vec<String> = lines.iter().map(|l| format!("$$\n{l}\n$$\n")).collect();
    let all = verdicts(&format!("{OPENING}Here we find\n\n{}", shown.join("\n")));
    all.strip_prefix('p')
        .expect("the opening is proved")
        .to_owned()
}

#[test]
fn on_fixed_axes_the_inertia_changes_with_the_attitude() {
    let lines = [
        r"\dot R = [\omega]_\times R",
        r"\dot I = [\omega]_\times I - I[\omega]_\times",
        r"\dot I = \dot R I_b R^T + R I_b \dot R^T",
        r"\operatorname{tr}\dot I = 0",
        r"\omega\cdot\dot I\omega = 0",
        r"L = I\omega",
        r"M = \dot L = \dot I\omega + I\dot\omega",
        r"M = I\dot\omega + \omega\times I\omega",
        r"\dot I = I[\omega]_\times - [\omega]_\times I",
        r"M = I\dot\omega - \omega\times I\omega",
    ];
    assert_eq!(behind_the_opening(&lines), "pppppppprr");
}

#[test]
fn labels_put_vectors_on_the_axes_of_the_body() {
    let lines = [
        r"\omega = R\,\omega_b",
        r"L = R\,I_b\,\omega_b",
        r"\dot\omega = R\,\dot\omega_b",
        r"\dot L = R\left(\dot L_b + \omega_b\times L_b\right)",
        r"M_b = R^T M",
        r"M_b = I_b\dot\omega_b + \omega_b\times I_b\omega_b",
        r"T = \tfrac12\,\omega^T I\,\omega = \tfrac12\,\omega_b^T I_b\,\omega_b",
        r"I^{-1} = R\,I_b^{-1} R^T",
        r"\dot L = R\,\dot L_b",
        r"\omega_b = R\,\omega",
    ];
    assert_eq!(behind_the_opening(&lines), "pppppppprr");
}

#[test]
fn a_moment_that_vanishes_vanishes_on_all_axes() {
    let text = format!(
        "{OPENING}No torque acts, $M = 0$. It follows that\n\n$$\\dot L = 0$$\n\nand on the axes of the body that\n\n\
         $$I_b\\dot\\omega_b + \\omega_b\\times I_b\\omega_b = 0 .$$\n\nThis is not the same as\n\n$$\\dot L_b = 0 .$$\n"
    );
    let found = verdicts(&text);
    assert!(found.starts_with("pa"), "{found}");
    assert!(found[2..].starts_with("pp"), "{found}");
    assert!(!found[4..].contains(['p', 'a']), "{found}");
}

#[test]
fn words_that_put_the_angular_velocity_on_the_body_stand() {
    let text = "The rotation matrix $R$ takes body coordinates to world coordinates. $\\omega$ has body components.\n\n\
                $$I = R\\,I_b\\,R^T$$\n\n$$\\dot R = R[\\omega]_\\times$$\n";
    assert!(verdicts(text).ends_with('p'));
}

#[test]
fn two_labels_tell_the_axes_apart_without_any_mark() {
    let text = |turn: &str| {
        format!(
            "The rotation matrix $Q$ maps body coordinates to world coordinates. The inertia on the body's axes is $J_b$, the torque \
             $\\tau_b$, the angular velocity $\\omega_b$; in the world\n\n\
             $$ J_w = {turn} $$\n\n$$ \\omega_w = Q\\,\\omega_b $$\n\n$$ \\dot Q = [\\omega_w]_\\times Q $$\n\n\
             $$ \\tau_b = J_b\\dot\\omega_b + \\omega_b\\times(J_b\\omega_b) $$\n"
        )
    };
    assert_eq!(verdicts(&text("Q J_b Q^T")), "pppp");
    assert_eq!(verdicts(&text("Q^T J_b Q")), "rppp");
}

#[test]
fn a_label_of_the_world_on_the_inertia_alone_tells_nothing_apart() {
    let text = |sign: &str| {
        format!(
            "The rotation matrix $R$ takes body components to world components. The inertia on body axes is $J_b$. The matrix obeys $\\dot R = [\\omega]_\\times R$ with $\\omega$ on world axes.\n\n\
             $$ J_w = R\\,J_b\\,R^T $$\n\n$$ J_w\\dot\\omega {sign} \\omega\\times J_w\\omega = \\tau $$\n\n\
             # Step\n\nWe solve it on body axes. With $e(\\omega) = J_b\\omega + h\\,\\omega\\times J_b\\omega$,\n\n\
             $$ \\frac{{\\partial e}}{{\\partial\\omega}} = J_b + h([\\omega]_\\times J_b - [J_b\\omega]_\\times) $$\n"
        )
    };
    assert_eq!(verdicts(&text("+")), "pppap");
    assert_eq!(verdicts(&text("-")), "pprap");
}

#[test]
fn two_letters_are_one_tensor_on_two_sets_of_axes() {
    let text = |first: &str, second: &str| {
        format!(
            "The matrix $R$ turns components on the body axes into components on the fixed axes. \
             The inertia matrix on the body axes is the constant matrix $\\mathsf J$. On the fixed axes it is\n\n\
             $$ \\mathsf I = R\\,\\mathsf J\\,R^\\top $$\n\nLet $\\omega$ be the angular velocity on the fixed axes and \
             $\\widetilde\\omega$ its skew matrix.\n\n\
             $$ \\dot R = \\widetilde\\omega R $$\n\n$$ \\dot{{\\mathsf I}} = {first} - {second} $$\n\n\
             $$ \\tau = \\mathsf I\\,\\dot\\omega + \\omega\\times\\mathsf I\\,\\omega $$\n"
        )
    };
    let [one, other] = [
        "\\widetilde\\omega\\,\\mathsf I",
        "\\mathsf I\\,\\widetilde\\omega",
    ];
    assert_eq!(verdicts(&text(one, other)), "pppp");
    assert_eq!(verdicts(&text(other, one)), "pprp");
}

#[test]
fn a_momentum_without_a_label_is_turned_into_space_beside_its_components_in_the_body() {
    let text = |momentum: &str, sign: &str| {
        format!(
            r"Let $R$ be the rotation matrix that takes body components to lab components:

$$ {momentum} $$

$$ \mathbf L = R\,\mathbf L_b $$

$$ \dot{{\mathbf L}} = R(\mathbf I\dot{{\boldsymbol\omega}} {sign} \boldsymbol\omega\times\mathbf I\boldsymbol\omega) $$
"
        )
    };
    let body = r"\mathbf L_b = \mathbf I\boldsymbol\omega";
    assert_eq!(verdicts(&text(body, "+")), "ppp");
    assert_eq!(verdicts(&text(body, "-")), "ppr");
    let space = r"\mathbf L = \mathbf I\boldsymbol\omega";
    assert_eq!(verdicts(&text(space, "+"))[..2], *"pp");
}

#[test]
fn labels_alone_put_vectors_without_a_mark_on_both_axes() {
    let text = |rate: &str, moment: &str, tensor: &str, turn: &str| {
        format!(
            r"Let $\mathbf Q$ be the rotation matrix which takes components on body axes into components on space axes, with the
skew matrix $[\omega_s]_\times$ of the angular velocity on space axes. Let $L_s = \mathbf J_s\omega_s$ and $L_b = \mathbf J_b\omega_b$.

$$ \dot{{\mathbf Q}} = {rate}\mathbf Q $$

$$ \mathbf J_s = {turn} $$

$$ \dot{{\mathbf J}}_s = {tensor} $$

$$ \tau_s = \mathbf J_s\dot\omega_s {moment} \omega_s\times\mathbf J_s\omega_s $$

As an example take a rotation through $\theta$ about the third axis,

$$ \mathbf Q = \begin{{bmatrix}} \cos\theta & -\sin\theta & 0 \\ \sin\theta & \cos\theta & 0 \\ 0 & 0 & 1 \end{{bmatrix}} $$

$$ \omega_s = \dot\theta\begin{{bmatrix}} 0 \\ 0 \\ 1 \end{{bmatrix}} $$

With $\mathbf J_b = \operatorname{{diag}}(A, B, C)$ the first entry is

$$ (\mathbf J_s)_{{11}} = A\cos^2\theta + B\sin^2\theta $$
"
        )
    };
    let turn = r"\mathbf Q\,\mathbf J_b\,\mathbf Q^T";
    let [one, other] = [
        r"[\omega_s]_\times\mathbf J_s",
        r"\mathbf J_s[\omega_s]_\times",
    ];
    let rate = r"[\omega_s]_\times";
    let tensor = format!("{one} - {other}");
    assert_eq!(verdicts(&text(rate, "+", &tensor, turn)), "ppppppapap");
    let turned = r"\mathbf Q^T\mathbf J_b\,\mathbf Q";
    let tensor = format!("{one} + {other}");
    assert_eq!(
        verdicts(&text(r"[\omega_b]_\times", "-", &tensor, turned)),
        "pprrrrapap"
    );
}

#[test]
fn a_matrix_that_is_written_out_tells_how_the_body_turns() {
    let text = |sine: [&str; 2], lines: [&str; 2]| {
        let ([above, below], [rate, entry]) = (sine, lines);
        format!(
            r"The rotation matrix $R$ takes components on body axes to components on space axes, $\dot R = R[\omega_b]_\times$, and $I_s = R I_b R^T$.

# A turn about the first axis

For a turn through $\theta$ about the first axis

$$ R = \begin{{bmatrix}} 1 & 0 & 0 \\ 0 & \cos\theta & {above} \\ 0 & {below} & \cos\theta \end{{bmatrix}} $$

$$ \omega_b = {rate} $$

With $I_b = \operatorname{{diag}}(A, B, C)$ we have

$$ (I_s)_{{33}} = {entry} $$

# Any turn

$$ \dot R = R[\omega_b]_\times $$
"
        )
    };
    let right = [r"-\sin\theta", r"\sin\theta"];
    let rate = r"\dot\theta\begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix}";
    let entry = r"B\sin^2\theta + C\cos^2\theta";
    assert_eq!(verdicts(&text(right, [rate, entry])), "ppapapp");
    let wrong = r"\dot\theta\begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}";
    let other = r"B\cos^2\theta + C\sin^2\theta";
    assert_eq!(verdicts(&text(right, [wrong, other])), "ppararp");
    let turned = [r"\sin\theta", r"-\sin\theta"];
    assert!(verdicts(&text(turned, [rate, entry])).starts_with("ppu"));
}

#[test]
fn what_changes_by_itself_times_a_skew_matrix_is_the_attitude() {
    let text = |first: &str| {
        verdicts(&format!(
            "The attitude is stored as a unit quaternion with the scalar part first, which takes body components to inertial components; $\\omega_x, \\omega_y, \\omega_z$ are body rates. \
             The third column of $\\mathbf R$ is the body $z$ axis in inertial components,\n\n\
             $$ R_{{13}} = 2(q_1 q_3 {first} q_0 q_2) $$\n\nand the matrix obeys\n\n\
             $$ \\dot{{\\mathbf R}} = \\mathbf R\\,[\\boldsymbol\\omega]_\\times $$\n"
        ))
    };
    assert_eq!(text("+"), "pp");
    assert_eq!(text("-"), "rp");
}

#[test]
fn the_matrix_of_the_turn_may_have_a_plain_letter() {
    let rate = |sides: &str| {
        let text = format!(
            "Let $R$ be the rotation matrix from body to space and $\\Omega = R^T\\dot R$. Then\n\n$$ {sides} $$\n"
        );
        verdicts(&text).chars().last()
    };
    assert_eq!(rate(r"\Omega^T = -\Omega"), Some('p'));
    assert_eq!(rate(r"\dot R = R\,\Omega"), Some('p'));
    assert_eq!(rate(r"\dot R = \Omega R"), Some('r'));
}

#[test]
fn a_velocity_that_turns_the_attitude_from_the_left_stands_in_space() {
    let text = |words: &str, rate: &str| {
        verdicts(&format!(
            "The attitude matrix $\\mathbf R$ takes body components to space components. {words}\n\n$$ \\dot{{\\mathbf R}} = {rate} $$\n"
        ))
    };
    let (left, right) = (
        "[\\boldsymbol\\omega]_\\times\\mathbf R",
        "\\mathbf R[\\boldsymbol\\omega]_\\times",
    );
    assert_eq!(text("", left), "p");
    assert_eq!(text("", right), "p");
    assert_eq!(text("The body rates are $\\boldsymbol\\omega$.", left), "r");
    let momentum = "On body axes $\\mathbf L = \\mathbf I\\boldsymbol\\omega$.";
    assert!(text(momentum, left).ends_with('r'));
}

#[test]
fn a_prime_may_be_the_label_of_turned_axes() {
    let text = |times: &str| {
        verdicts(&format!(
            "Let $R$ be the matrix that takes body components to primed ones, $\\boldsymbol\\omega' = R\\boldsymbol\\omega$ and \
             $\\mathbf I' = R\\mathbf IR^T$.\n\n\
             $$ \\boldsymbol\\omega'\\cdot\\mathbf I'\\boldsymbol\\omega' = {times}\\boldsymbol\\omega\\cdot\\mathbf I\\boldsymbol\\omega $$\n\n\
             $$ \\mathbf I'\\boldsymbol\\omega' = R\\mathbf I\\boldsymbol\\omega $$\n"
        ))
    };
    assert_eq!(text(""), "pppp");
    assert_eq!(text("2"), "pprp");
}

#[test]
fn entries_of_a_turned_tensor_are_those_of_its_definition() {
    let text = |new: &str, entry: &str, value: &str| {
        verdicts(&format!(
            "For a rotation by $\\theta$ about $z$\n\n\
             $$ R = \\begin{{pmatrix}} \\cos\\theta & \\sin\\theta & 0 \\\\ -\\sin\\theta & \\cos\\theta & 0 \\\\ 0 & 0 & 1 \\end{{pmatrix}} $$\n\n\
             With $\\mathbf I = \\operatorname{{diag}}(A, B, C)$ the new tensor is\n\n$$ {new} = R\\mathbf IR^T $$\n\n\
             $$ {entry}_{{xx}} = {value} $$\n"
        ))
    };
    let (right, wrong) = (
        "A\\cos^2\\theta + B\\sin^2\\theta",
        "A\\sin^2\\theta + B\\cos^2\\theta",
    );
    for (new, entry) in [("\\mathbf I'", "I'"), ("\\mathbf J", "J")] {
        assert_eq!(text(new, entry, right), "aaap", "{new}");
        assert!(!text(new, entry, wrong).ends_with(['a', 'p']), "{new}");
    }
    assert_eq!(text("\\mathbf I'", "I'", wrong), "aaar");
}

#[test]
fn a_matrix_that_is_written_out_turns_vectors() {
    let text = |zz: &str| {
        verdicts(&format!(
            "Under a rotation $R$ the components transform as $\\omega' = R\\omega$ and $L' = RL$. From $L = I\\omega$\n\n\
             $$ L' = RIR^T\\omega' $$\n\nFor a rotation by $\\theta$ about $z$\n\n\
             $$ R = \\begin{{pmatrix}} \\cos\\theta & \\sin\\theta & 0 \\\\ -\\sin\\theta & \\cos\\theta & 0 \\\\ 0 & 0 & 1 \\end{{pmatrix}} $$\n\n\
             With $I = \\operatorname{{diag}}(A, B, C)$:\n\n$$ L'_z = {zz}\\omega'_z $$\n"
        ))
    };
    assert_eq!(text("C"), "aappaap");
    assert!(!text("A").ends_with(['a', 'p']));
}
