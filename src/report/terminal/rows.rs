//! The lines that need no drawing, and what the verdicts rest on, one row each.

use crate::notation::document::line_name;
use crate::report::Checked;
use crate::verify::{Finding, Role, Summary, Verdict};
use annotate_snippets::normalize_untrusted_str;
use std::fmt::Write;

/// The lines that hold, one row each.
pub(super) fn good_lines(checked: &Checked, verbose: bool) -> String {
    let findings = checked.report.findings.iter();
    let good: Vec<_> = findings
        .filter(|f| matches!(f.verdict, Verdict::Proved(_) | Verdict::Accepted))
        .collect();
    let width = |texts: &mut dyn Iterator<Item = String>| {
        texts.map(|text| text.chars().count()).max().unwrap_or(0)
    };
    let places = width(&mut good.iter().map(|f| line_name(f.cell, f.source_line)));
    let labels = width(&mut good.iter().map(|f| f.label.clone().unwrap_or_default()));
    let mut text = String::new();
    for finding in good {
        let place = line_name(finding.cell, finding.source_line);
        let label = normalize_untrusted_str(finding.label.as_deref().unwrap_or(""));
        let row = format!("  {place:<places$}  {label:<labels$}  {}", verdict(finding));
        let _ = writeln!(text, "{}", normalize_untrusted_str(row.trim_end()));
        for remark in &finding.remarks {
            let _ = writeln!(text, "    note: {}", normalize_untrusted_str(remark));
        }
        if verbose {
            for row in finding.source.lines() {
                let _ = writeln!(text, "    {}", normalize_untrusted_str(row.trim()));
            }
        }
    }
    text
}

/// Questions that are shown; one answer may settle many others.
const ASKED: usize = 20;

/// What is not known, each with the lines that wait and how to answer.
pub(super) fn questions(checked: &Checked) -> String {
    let questions = &checked.report.questions;
    let mut text = String::new();
    for question in questions.iter().take(ASKED) {
        let wait = match question.lines.as_slice() {
            [_] => "1 line waits for it".to_owned(),
            lines => format!("{} lines wait for it", lines.len()),
        };
        let first = line_name(question.cell, question.source_line);
        let asked = normalize_untrusted_str(&question.text);
        let _ = writeln!(text, "question: {asked} {wait}, the first is {first}");
        let could = question.answers.iter().map(|answer| {
            format!(
                "{} ({} of the lines then hold)",
                answer.sentence,
                answer.holds.len()
            )
        });
        let could: Vec<String> = could.collect();
        if !could.is_empty() {
            let could = could.join(", ");
            let _ = writeln!(text, "  = it could be: {}", normalize_untrusted_str(&could));
        }
        if let Some(answer) = question.answers.first() {
            let sentence = normalize_untrusted_str(&answer.sentence);
            let _ = writeln!(text, "  = answer with: polhode: [\"{sentence}\"]");
        }
    }
    match questions.len().saturating_sub(ASKED) {
        0 => {}
        left => {
            let _ = writeln!(text, "{left} more questions are in `--format json`");
        }
    }
    if !questions.is_empty() {
        let help = "answer with a sentence under `polhode:` in the front matter, such as \
                    \"$m$ is the mass of the body.\"; polhode help language";
        let _ = writeln!(text, "  = {help}\n");
    }
    text
}

/// The verdict of a line that holds, and what it rests on.
fn verdict(finding: &Finding) -> String {
    let mut text = match (&finding.verdict, finding.role) {
        (Verdict::Accepted, Role::Given) => "accepted as given",
        (Verdict::Accepted, Role::Assume) => "accepted as an assumption",
        (Verdict::Accepted, Role::Define) => "accepted as a definition",
        (verdict, _) => verdict.name(),
    }
    .to_owned();
    if !finding.uses.is_empty() {
        let _ = write!(text, " by {}", finding.uses.join(", "));
    }
    if !finding.conditions.is_empty() {
        let _ = write!(text, " where {}", finding.conditions.join(", "));
    }
    text
}

/// What the verdicts rest on beside the lines themselves.
pub(super) fn background(checked: &Checked) -> String {
    let report = &checked.report;
    let mut text = String::new();
    for premise in &report.from_prose {
        let cell = checked.document.place(premise.span.start).cell;
        let place = line_name(cell, premise.source_line);
        let _ = writeln!(
            text,
            "  {place}  from the words: {}",
            normalize_untrusted_str(&premise.premise)
        );
    }
    if !report.readings.is_empty() {
        let readings = normalize_untrusted_str(&report.readings.join(", "));
        let _ = writeln!(text, "  read as {readings}");
    }
    if !report.findings.is_empty() {
        let meaning = match report.products.name {
            "entries" => "I_xy is the tensor's entry",
            _ => "I_xy = ∫xy dm",
        };
        let _ = writeln!(
            text,
            "  products of inertia: {}, {meaning} ({})",
            report.products.name, report.products.decided_by
        );
    }
    text
}

/// What stands in the document and was not taken as a line.
pub(super) fn passed(checked: &Checked) -> String {
    let mut text = String::new();
    for passed in &checked.report.passed {
        let place = line_name(passed.cell, passed.source_line);
        let words = checked.document.source.slice(passed.span);
        let words = normalize_untrusted_str(words.lines().next().unwrap_or("").trim());
        let _ = writeln!(text, "  {place}  not a line, {}: {words}", passed.what);
    }
    text
}

/// `11 proved, 2 accepted, 1 refuted`.
pub(super) fn summary(summary: Summary) -> String {
    let counts = [
        (summary.proved, "proved"),
        (summary.accepted, "accepted"),
        (summary.refuted, "refuted"),
        (summary.undecided, "undecided"),
        (summary.unreadable, "unreadable"),
    ];
    let said: Vec<_> = counts
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, verdict)| format!("{count} {verdict}"))
        .collect();
    if said.is_empty() {
        return "no line to check".to_owned();
    }
    said.join(", ")
}
