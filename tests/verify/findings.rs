//! What stands beside a verdict: the role of a line, its repair, and how letters were read.

use polhode::notation::{document::Format, read};
use polhode::verify::{Report, check};

fn checked(text: &str, format: Format) -> Report {
    check(&read("a document", text, format).0)
}

fn verdicts(report: &Report) -> Vec<&'static str> {
    report.findings.iter().map(|f| f.verdict.name()).collect()
}

#[test]
fn words_of_a_latex_paragraph_reach_the_display_below_it() {
    let text = "No torque acts on a body with the principal moments $I_1$, $I_2$, $I_3$.\n\nChoose the angle such that\n\n\
                $$ \\tan 2\\theta = \\frac{2 I_2}{I_1} $$\n";
    for format in [Format::Markdown, Format::Latex] {
        let found = checked(text, format).findings;
        assert_eq!(found[0].role.name(), "assume", "{format:?}");
    }
}

#[test]
fn false_lines_are_put_right_in_their_indices() {
    let text = r"Repeated indices are summed; the axes are fixed in the body, with the angular velocity $\omega_i$, the angular momentum $H_i$ about the centre of mass and the torque $Q_i$ about it.


The kinetic energy is

$$ T = I_{ij}\,\omega_i\omega_j $$

and the law of motion

$$ Q_i = I_{ij}\dot\omega_j + \epsilon_{ijk}\,\omega_k I_{jl}\,\omega_l $$
";
    let report = checked(text, Format::Markdown);
    let suggested: Vec<&str> = report
        .findings
        .iter()
        .filter_map(|f| f.diagnosis.as_ref()?.suggestion.as_deref())
        .collect();
    assert_eq!(verdicts(&report), ["refuted", "refuted"]);
    assert_eq!(
        suggested,
        [
            r"T = \tfrac{1}{2}I_{ij}\,\omega_i\omega_j",
            r"Q_i = I_{ij}\dot\omega_j - \epsilon_{ijk}\,\omega_k I_{jl}\,\omega_l"
        ]
    );
}

#[test]
fn a_list_of_symbols_in_plain_text_names_them() {
    let text = "Symbols\n\n  w    angular velocity of the body\n  J    inertia matrix\n  k    momentum stored in the rotors\n  \
                N    external torque\n  T    torque of the motors\n\n    H = J w + k\n\n    dH/dt + w x H = N\n\n    \
                dH/dt = w x H + N\n\n    J dw/dt + dk/dt + w x (J w + k) = N\n";
    let report = checked(text, Format::Text);
    assert_eq!(verdicts(&report), ["proved", "proved", "refuted", "proved"]);
    assert!(report.readings.iter().any(|r| r == "N: moment"));
    assert!(report.readings.iter().all(|r| !r.starts_with("T:")));
}
