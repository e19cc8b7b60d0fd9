//! A check as text for a terminal, in the manner of a compiler.
//!
//! A line that is refuted, undecided or unreadable gets a drawing of its place; the others stand in a list.

use crate::diagnostic::{Diagnostic, Severity};
use crate::notation::Macros;
use crate::notation::document::{Document, Format, FrontMatter};
use crate::report::Checked;
use crate::report::terminal::drawing::{Drawing, draw};
use crate::report::terminal::rows::{background, good_lines, passed, questions, summary};
use crate::source::Source;
use crate::verify::{Counterexample, Finding, Verdict};
use annotate_snippets::{Level, normalize_untrusted_str};
use std::collections::HashSet;
use std::fmt::Write;

mod drawing;
mod rows;

/// Findings of one document that are drawn; a file of a million unreadable formulas needs no million drawings.
const DRAWN: usize = 1_000;

/// What is said of a document, with terminal colours (strip them where they are not wanted). `verbose` also quotes the
/// lines that hold and lists what was not taken as a line.
pub fn check(checked: &Checked, verbose: bool) -> String {
    let open =
        |finding: &&Finding| !matches!(finding.verdict, Verdict::Proved(_) | Verdict::Accepted);
    let findings = checked.report.findings.iter().filter(open);
    let mut drawings = news(checked)
        .map(|diagnostic| of_diagnostic(&checked.document, diagnostic))
        .chain(findings.map(|finding| of_finding(checked, finding)));
    let mut text: String = drawings
        .by_ref()
        .take(DRAWN)
        .map(|drawing| draw(&drawing))
        .collect();
    let left = drawings.count();
    if left > 0 {
        let _ = writeln!(
            text,
            "{left} more are not drawn; `--format json` has them all\n"
        );
    }
    text.push_str(&questions(checked));
    text.push_str(&good_lines(checked, verbose));
    text.push_str(&background(checked));
    if verbose {
        text.push_str(&passed(checked));
    }
    let path = normalize_untrusted_str(&checked.report.path);
    let _ = writeln!(text, "{path}: {}", summary(checked.report.summary()));
    text
}

/// Diagnostics of a text that is no document, with terminal colours.
pub fn diagnostics(source: &Source, diagnostics: &[Diagnostic]) -> String {
    let document = Document {
        format: Format::Text,
        source: source.clone(),
        cells: vec![],
        front_matter: FrontMatter::default(),
        macros: Macros::default(),
        items: vec![],
    };
    of_document(&document, diagnostics)
}

/// Diagnostics of a document that is not checked, with terminal colours.
pub fn of_document(document: &Document, diagnostics: &[Diagnostic]) -> String {
    let drawn = diagnostics.iter().take(DRAWN);
    drawn
        .map(|diagnostic| draw(&of_diagnostic(document, diagnostic)))
        .collect()
}

/// The reader's diagnostics, without those that an unreadable line repeats.
fn news(checked: &Checked) -> impl Iterator<Item = &Diagnostic> {
    let findings = checked.report.findings.iter();
    let unreadable = findings.filter(|f| f.verdict == Verdict::Unreadable);
    let said: HashSet<_> = unreadable
        .map(|finding| (finding.place, finding.reason.as_deref()))
        .collect();
    let diagnostics = checked.diagnostics.iter();
    diagnostics.filter(move |d| !said.contains(&(d.primary.span, Some(d.message.as_str()))))
}

fn of_diagnostic<'a>(document: &'a Document, diagnostic: &Diagnostic) -> Drawing<'a> {
    let others = diagnostic.others.iter();
    Drawing {
        document,
        level: match diagnostic.severity {
            Severity::Note => Level::NOTE,
            Severity::Warning => Level::WARNING,
            Severity::Error => Level::ERROR,
        },
        code: Some(diagnostic.code),
        title: diagnostic.message.clone(),
        primary: (diagnostic.primary.span, diagnostic.primary.text.clone()),
        others: others.map(|l| (l.span, l.text.clone())).collect(),
        notes: diagnostic.notes.clone(),
        helps: diagnostic.helps.clone(),
    }
}

fn of_finding<'a>(checked: &'a Checked, finding: &Finding) -> Drawing<'a> {
    let diagnosis = finding.diagnosis.as_ref();
    let reason = finding.reason.clone().unwrap_or_default();
    let said = diagnosis.map_or_else(|| reason.clone(), |d| d.message.clone());
    let place = diagnosis.and_then(|d| d.place).unwrap_or(finding.place);
    let beside = if said == reason { "" } else { &reason };
    let base = match finding.verdict {
        Verdict::Undecided => Level::WARNING,
        _ => Level::ERROR,
    };
    let suggestion = diagnosis.and_then(|d| d.suggestion.as_ref());
    Drawing {
        document: &checked.document,
        level: base.with_name(finding.verdict.name()),
        code: diagnosis.map(|d| d.kind),
        title: match &finding.label {
            Some(label) => format!("{label} {said}"),
            None => said,
        },
        primary: (place, beside.to_owned()),
        others: vec![],
        notes: notes(finding),
        helps: match (&finding.verdict, suggestion) {
            (Verdict::Unreadable, _) => finding.remarks.clone(),
            (_, Some(suggestion)) => vec![format!("write `{suggestion}`")],
            (_, None) => vec![],
        },
    }
}

/// What stands below the drawing of a finding.
fn notes(finding: &Finding) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(residual) = &finding.residual {
        notes.push(format!("left side less right side is `{residual}`"));
    }
    notes.extend(finding.counterexample.as_ref().map(numbers));
    if !finding.uses.is_empty() {
        notes.push(format!("by {}", finding.uses.join(", ")));
    }
    if !finding.conditions.is_empty() {
        notes.push(format!("where {}", finding.conditions.join(", ")));
    }
    if let Some(line) = finding.follows_from {
        notes.push(format!(
            "carries the error of line {line} forward, and is right otherwise"
        ));
    }
    // Beside what could not be read, the remarks are the way to write it.
    if finding.verdict != Verdict::Unreadable {
        notes.extend(finding.remarks.iter().cloned());
    }
    notes
}

/// A counterexample as a sentence.
fn numbers(counterexample: &Counterexample) -> String {
    let symbols = counterexample.symbols.iter();
    let values: Vec<_> = symbols
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    let with = match values.as_slice() {
        [] => String::new(),
        values => format!("with {} ", values.join(", ")),
    };
    let of = match &counterexample.component {
        Some(component) => format!(", component {component},"),
        None => String::new(),
    };
    let Counterexample { left, right, .. } = counterexample;
    format!("{with}the left side{of} is {left} and the right side is {right}")
}
