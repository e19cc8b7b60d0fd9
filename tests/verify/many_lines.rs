//! Documents of many lines: what is done for each does not grow with their number.

use polhode::notation::{document::Format, read};
use polhode::verify::{Report, Verdict, check};

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
