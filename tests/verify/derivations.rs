//! Each document of `derivations/` is proved in full, and says no more in assumptions than it announces here.

use polhode::notation::{document::Format, read};
use polhode::verify::{Role, Verdict, check};
use std::{fs, path::Path};

/// Name, the lines it may assume, and those it defines. A claim that slid into either would not be proved.
const DOCUMENTS: &[(&str, usize, usize)] = &[
    ("01-inertia-tensor.md", 2, 6),
    ("02-euler-equations.md", 2, 0),
    ("03-energy-and-momentum.md", 3, 0),
    ("04-symmetric-body.md", 6, 1),
    ("05-quaternion-rate.md", 3, 0),
];

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations")
}

#[test]
fn every_line_is_proved_or_announced() {
    for &(name, assumed, defined) in DOCUMENTS {
        let text = fs::read_to_string(folder().join(name)).expect("a file of the repository");
        let (document, findings) = read(name, &text, Format::Markdown);
        assert!(findings.is_empty(), "{name}: {findings:?}");
        let report = check(&document);
        for finding in &report.findings {
            let fine = matches!(finding.verdict, Verdict::Proved(_) | Verdict::Accepted);
            let (line, source) = (finding.source_line, &finding.source);
            assert!(fine, "{name}:{line}: {:?} {source}", finding.verdict);
        }
        let accepted = |role: Role| {
            let of_role =
                |f: &&polhode::verify::Finding| f.verdict == Verdict::Accepted && f.role == role;
            report.findings.iter().filter(of_role).count()
        };
        let counts = (
            accepted(Role::Assume),
            accepted(Role::Define),
            accepted(Role::Given),
        );
        assert_eq!(counts, (assumed, defined, 0), "{name}");
    }
}

#[test]
fn no_document_is_forgotten() {
    let mut names: Vec<_> = fs::read_dir(folder())
        .expect("a folder of the repository")
        .map(|entry| {
            entry
                .expect("readable")
                .file_name()
                .into_string()
                .expect("ASCII")
        })
        .collect();
    names.sort();
    let listed: Vec<_> = DOCUMENTS.iter().map(|d| d.0).collect();
    assert_eq!(names, listed);
}
