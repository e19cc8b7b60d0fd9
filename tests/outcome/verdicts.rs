//! The verdicts of a small document, one letter for each line, so that a test can show what it expects.

use polhode::notation::{document::Format, read};
use polhode::verify::{Verdict, check};

/// The verdicts of a Markdown document's lines, in order: p, a, r, u, and ? for unreadable.
pub(crate) fn verdicts(text: &str) -> String {
    verdicts_in(text, Format::Markdown)
}

/// The same for another format.
pub(crate) fn verdicts_in(text: &str, format: Format) -> String {
    let (document, _) = read("a document", text, format);
    let letter = |verdict: &Verdict| match verdict {
        Verdict::Proved(_) => 'p',
        Verdict::Accepted => 'a',
        Verdict::Refuted => 'r',
        Verdict::Undecided => 'u',
        Verdict::Unreadable => '?',
    };
    let report = check(&document);
    report.findings.iter().map(|f| letter(&f.verdict)).collect()
}
