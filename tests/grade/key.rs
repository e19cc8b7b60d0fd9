//! Keys that are refused, each with its reason.

use super::{KEY, key, marked_by};
use polhode::grade::Key;
use polhode::notation::document::Format;

fn refused(text: &str) -> String {
    let wrong = Key::read("key.md", text, Format::Markdown)
        .err()
        .unwrap_or_default();
    wrong.iter().map(|reason| format!("{reason}\n")).collect()
}

#[test]
fn a_key_says_what_it_gives() {
    let key = key(KEY);
    let told: Vec<String> = key
        .milestones()
        .map(|(label, marks)| format!("{label} {marks}"))
        .collect();
    assert_eq!(told, ["(1) 1", "(2) 2", "(4) 3", "(5) 2"]);
    assert_eq!(key.max().to_string(), "8");
}

#[test]
fn a_key_with_a_false_line_or_an_open_milestone_is_refused() {
    let wrong = KEY.replacen("L_y &= I_{yy}\\omega_y", "L_y &= -I_{yy}\\omega_y", 1);
    assert!(
        refused(&wrong).contains("is refuted"),
        "{}",
        refused(&wrong)
    );
    let open = KEY.replacen(
        "+ \\omega_y L_z - \\omega_z L_y \\tag{2}",
        "+ \\eta\\zeta \\tag{2}",
        1,
    );
    assert!(
        refused(&open).contains("is not proved"),
        "{}",
        refused(&open)
    );
    let misread = KEY.replacen("- B is a frame", "- B is a frumble", 1);
    assert!(!refused(&misread).is_empty());
}

#[test]
fn a_policy_that_is_not_understood_is_refused() {
    let cases = [
        (
            "marks: {\"(1)\": 1,",
            "marks: {\"(1)\": -1,",
            "no number of marks",
        ),
        (
            "marks: {\"(1)\": 1,",
            "marks: {\"(9)\": 1,",
            "no line has the label (9)",
        ),
        (
            "follow_through: full",
            "follow_through: maybe",
            "full, half or none",
        ),
        ("working: required", "working: 3", "required or optional"),
        ("working: required", "shown: [\"(7)\"]", "carries no marks"),
    ];
    for (from, to, reason) in cases {
        let text = KEY.replacen(from, to, 1);
        assert!(refused(&text).contains(reason), "{to}: {}", refused(&text));
    }
}

#[test]
fn a_milestone_that_anything_would_reach_is_refused() {
    let text = KEY.replacen(
        "M_x = \\dot L_x + \\omega_y L_z - \\omega_z L_y \\tag{2}",
        "M_x = M_x \\tag{2}",
        1,
    );
    assert!(
        refused(&text).contains("any line would reach it"),
        "{}",
        refused(&text)
    );
}

#[test]
fn marks_may_stand_beside_a_line() {
    let text = KEY
        .replacen(
            "marks: {\"(1)\": 1, \"(2)\": 2, \"(4)\": 3, \"(5)\": 2}\n",
            "",
            1,
        )
        .replacen("$$M_x = \\dot", "<!-- marks: 2.5 -->\n\n$$M_x = \\dot", 1);
    let key = key(&text);
    assert_eq!(key.max().to_string(), "2.5");
}

#[test]
fn a_key_whose_meaning_is_not_declared_is_held_against_what_is_written() {
    let text = "---\nmarks: {\"(1)\": 2, \"(2)\": 1}\nworking: optional\n---\nOn principal axes fixed in the body\n\
                $$\\Sigma M_x = I_x\\dot\\omega_x - (I_y - I_z)\\omega_y\\omega_z \\tag{1}$$\n\
                and the momentum is $$L_x = I_x\\omega_x. \\tag{2}$$\n";
    let good = "On principal axes $$L_x = I_x\\omega_x$$ and \
                $$\\Sigma M_x = I_x\\dot\\omega_x + (I_z - I_y)\\omega_y\\omega_z$$";
    assert_eq!(
        marked_by(text, good).marks.to_string(),
        "3",
        "{:?}",
        marked_by(text, good)
    );
    let wrong =
        "On principal axes $$\\Sigma M_x = I_x\\dot\\omega_x + (I_y - I_z)\\omega_y\\omega_z$$";
    assert_eq!(marked_by(text, wrong).marks.to_string(), "0");
}

/// A body of which sentences tell all that is needed for its motion.
const BODY: &str = r"
polhode:
- N is an inertial frame.
- The body is a rigid body.
- B is a frame fixed in the body.
- 1, 2, 3 are the axes of B.
- G is the mass centre of the body.
- $I_1, I_2, I_3$ are the principal moments of the body about G on B.
- $\vec\omega$ is the angular velocity of the body relative to N.
- $\omega_1, \omega_2, \omega_3$ are the components of $\vec\omega$ on B.
- No moment acts on the body about G.
";
const PENDULUM: &str = r"
polhode:
- N is an inertial frame.
- $Y$ is the upward vertical.
- B is a frame fixed in the pendulum.
- $x, y, z$ are the axes of B.
- B turns relative to N about $z$ by the angle $\theta$.
- The pendulum is a rigid body of mass $m$.
- O is a point fixed in N and in B.
- G is the mass centre of the pendulum.
- G lies at the distance $a$ from O along $-y$.
- $I$ is the moment of inertia of the pendulum about the axis through O along $z$.
- $g$ is the acceleration of gravity.
- $\omega$ is the angular velocity of the pendulum relative to N along $z$.
- The weight and the force at O are the only loads on the pendulum.
";

#[test]
fn a_key_may_ask_for_what_its_sentences_tell() {
    let cases = [
        (
            BODY,
            r"$$I_1\dot\omega_1 = (I_2 - I_3)\omega_2\omega_3 \tag{1}$$",
            r"$$\omega_1 = 0$$",
        ),
        (
            PENDULUM,
            r"$$I\ddot\theta = -mga\sin\theta \tag{1}$$",
            r"$$\omega = \dot\theta$$",
        ),
        (
            PENDULUM,
            r"$$\omega = \dot\theta \tag{1}$$",
            r"$$I\ddot\theta = -mga\sin\theta$$",
        ),
    ];
    for (told, line, other) in cases {
        let text = format!("---\nmarks: {{\"(1)\": 2}}{told}---\n{line}\n");
        let line = line.replace("\\tag{1}", "");
        assert_eq!(marked_by(&text, &line).marks.to_string(), "2", "{line}");
        assert_eq!(marked_by(&text, other).marks.to_string(), "0", "{other}");
    }
}

#[test]
fn a_setting_that_is_not_known_is_refused_with_what_is_near() {
    for (setting, why) in [
        ("follow_trough: half", "did you mean `follow_through`?"),
        ("round: 0.5", "did you mean `rounding`?"),
        ("colour: red", "the settings are marks, follow_through"),
    ] {
        let said = refused(&KEY.replacen("working:", &format!("{setting}\nworking:"), 1));
        assert!(said.contains(why), "{setting}: {said}");
    }
    // What other programs read there is none of its business.
    let titled = KEY.replacen("working:", "title: The rotor\nauthor: A. B.\nworking:", 1);
    assert_eq!(refused(&titled), "");
    let latex = "% polhode: follow_trough: half\n\\begin{document}$$a = a$$\\end{document}";
    assert!(Key::read("key.tex", latex, Format::Latex).is_err());
}
