//! Documents with slips, each announced beside its line: `<!-- expect: refuted kind=sign "lost" -->`.
//!
//! The announcement stands on the line of the file on which the derivation's line begins, or on the one before. A kind
//! must be the diagnosis's; a text in quotes must stand in what is said. An announcement that finds no line fails, and so
//! does a line that is not proved or accepted and that nobody announced.

use polhode::notation::{document::Format, read};
use polhode::verify::{Finding, Verdict, check};
use std::fs;
use std::path::Path;

/// What a document says of one of its lines.
#[derive(Debug)]
struct Announcement<'a> {
    line: usize,
    verdict: &'a str,
    kind: Option<&'a str>,
    says: Option<&'a str>,
}

#[test]
fn each_slip_is_found_and_nothing_else_is_said() {
    let mut wrong = Vec::new();
    let mut announced = 0;
    for entry in fs::read_dir("tests/rejected").expect("the documents") {
        let path = entry.expect("readable").path();
        let text = fs::read_to_string(&path).expect("UTF-8");
        announced += announcements(&text).len();
        let misses = misses(&path, &text);
        wrong.extend(
            misses
                .into_iter()
                .map(|miss| format!("{}:{miss}", path.display())),
        );
    }
    assert!(announced > 0, "no announcement was read");
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn a_missing_and_an_unannounced_slip_are_both_seen() {
    let path = Path::new("here.md");
    let none = "Here <!-- expect: refuted -->\n$$\\vec L = I\\vec\\omega$$\n";
    assert_eq!(misses(path, none).len(), 1);
    let unannounced = "Here\n$$\\vec L = 2 I\\vec\\omega$$\n";
    assert_eq!(misses(path, unannounced).len(), 1);
    let kind = "Here <!-- expect: refuted kind=poem -->\n$$\\vec L = 2 I\\vec\\omega$$\n";
    assert_eq!(misses(path, kind).len(), 1);
    let announced = "Here <!-- expect: refuted -->\n$$\\vec L = 2 I\\vec\\omega$$\n";
    assert_eq!(misses(path, announced), Vec::<String>::new());
}

/// What does not agree between the announcements of a document and what is found.
fn misses(path: &Path, text: &str) -> Vec<String> {
    let (document, _) = read("document", text, Format::of_path(path));
    let mut open = check(&document).findings;
    open.retain(|f| !matches!(f.verdict, Verdict::Proved(_) | Verdict::Accepted));
    let mut misses = Vec::new();
    for announcement in announcements(text) {
        let lines = [announcement.line, announcement.line + 1];
        let mut at = lines
            .iter()
            .filter_map(|line| open.iter().position(|f| f.source_line == *line));
        match at.next() {
            None => misses.push(format!("{}: announced, and not found", announcement.line)),
            Some(at) => {
                let finding = open.remove(at);
                if !agrees(&announcement, &finding) {
                    misses.push(format!("{announcement:?}, but found {}", said(&finding)));
                }
            }
        }
    }
    let unannounced = open.iter();
    misses.extend(unannounced.map(|f| format!("{}: not announced: {}", f.source_line, said(f))));
    misses
}

fn agrees(announcement: &Announcement<'_>, finding: &Finding) -> bool {
    let kind = finding.diagnosis.as_ref().map(|d| d.kind);
    finding.verdict.name() == announcement.verdict
        && (announcement.kind.is_none() || announcement.kind == kind)
        && announcement
            .says
            .is_none_or(|text| said(finding).contains(text))
}

/// All that is said of a line.
fn said(finding: &Finding) -> String {
    let diagnosis = finding.diagnosis.as_ref();
    let kind = diagnosis.map_or("", |d| d.kind);
    let message = diagnosis.map_or("", |d| d.message.as_str());
    let suggestion = diagnosis
        .and_then(|d| d.suggestion.as_deref())
        .unwrap_or("");
    let reason = finding.reason.as_deref().unwrap_or("");
    let verdict = finding.verdict.name();
    format!(
        "{verdict} {kind}: {reason}; {message}; {suggestion}; in {}",
        finding.source
    )
}

fn announcements(text: &str) -> Vec<Announcement<'_>> {
    let lines = text.lines().enumerate();
    lines
        .filter_map(|(i, line)| announcement(i + 1, line))
        .collect()
}

fn announcement(line: usize, text: &str) -> Option<Announcement<'_>> {
    let (_, rest) = text.split_once("<!-- expect: ")?;
    let (rest, _) = rest.split_once("-->")?;
    let mut quoted = rest.split('"');
    let words = quoted.next()?;
    Some(Announcement {
        line,
        verdict: words.split_whitespace().next()?,
        kind: words
            .split_whitespace()
            .find_map(|word| word.strip_prefix("kind=")),
        says: quoted.next(),
    })
}
