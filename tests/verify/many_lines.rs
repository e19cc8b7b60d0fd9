//! Documents of many lines: what is done for each does not grow with their number.

use polhode::algebra::products_of_terms;
use polhode::notation::{document::Format, read};
use polhode::verify::{Report, Verdict, check, check_declared, declarations};

const OPENING: &str = "The axes are attached to the body.\n\n";

fn checked(text: &str) -> Report {
    check(&read("many.md", text, Format::Markdown).0)
}

#[test]
fn the_mistakes_of_so_many_false_lines_are_searched_for_and_no_more() {
    let line = "$$L_x = I_{xx}\\omega_x + I_{xy}\\omega_y - I_{xz}\\omega_z$$\n\n";
    let report = checked(&format!("{OPENING}{}", line.repeat(210)));
    let (searched, others) = report.findings.split_at(200);
    for finding in searched {
        let kind = finding.diagnosis.as_ref().map(|d| d.kind);
        assert_eq!(kind, Some("sign"), "line {}", finding.source_line);
    }
    assert_eq!(others.len(), 10);
    for finding in others {
        // With hardly a line that holds, a false one is left open unless a slip explains it.
        assert_eq!(finding.verdict, Verdict::Undecided);
        assert!(finding.diagnosis.is_none(), "{:?}", finding.diagnosis);
        let said = finding.remarks.iter().any(|r| r.contains("not searched"));
        assert!(said, "{:?}", finding.remarks);
    }
}

/// What a rotor is, in sentences.
const ROTOR: &str = "---
polhode:
- N is an inertial frame.
- The rotor is a rigid body.
- B is a frame fixed in the rotor.
- x, y, z are the axes of B.
- G is the mass centre of the rotor.
- $\\vec\\omega$ is the angular velocity of the rotor relative to N.
- $\\omega_x$, $\\omega_y$, $\\omega_z$ are the components of $\\vec\\omega$ on B.
- $\\vec L$ is the angular momentum of the rotor about G relative to N.
- $L_x$, $L_y$, $L_z$ are the components of $\\vec L$ on B.
- $I$ is the inertia tensor of the rotor about G.
---
";

/// The products of terms that a document of so many lines takes whose meaning is declared, all in one paragraph or not.
fn effort(lines: usize, end: &str) -> u64 {
    let line = "So $$L_x = I_{xx}\\omega_x - I_{xy}\\omega_y - I_{xz}\\omega_z$$";
    let text = format!("{ROTOR}{}", format!("{line}{end}").repeat(lines));
    let (document, _) = read("many.md", &text, Format::Markdown);
    let declared = declarations(&document, &[]);
    let before = products_of_terms();
    let report = check_declared(&document, &declared);
    assert_eq!(report.summary().proved, lines);
    products_of_terms() - before
}

#[test]
fn a_declared_line_takes_as_much_behind_a_thousand_as_behind_ten() {
    for end in ["\n", "\n\n"] {
        let [none, ten, thousand] = [0, 10, 1_000].map(|lines| effort(lines, end));
        println!("{none}, {ten}, {thousand}");
        assert!(
            thousand - none <= 100 * (ten - none),
            "{none}, {ten}, {thousand}"
        );
    }
}

#[test]
fn many_bodies_with_ends_are_placed_one_after_the_other() {
    let bodies = (0..1_000).map(|i| {
        format!(
            "- The rod R{i} is a uniform thin rod of length $l_{{{i}}}$.\n- E{i} is an end of R{i}.\n- P{i} is a point fixed in R{i}.\n"
        )
    });
    let said: String = bodies.collect();
    let text = format!("---\npolhode:\n- N is an inertial frame.\n{said}---\n\n$$ 1 = 2 $$\n");
    let (document, _) = read("bodies.md", &text, Format::Markdown);
    let report = check_declared(&document, &declarations(&document, &[]));
    assert_eq!(report.findings.len(), 1);
    assert_eq!(report.findings[0].verdict, Verdict::Refuted);
}
