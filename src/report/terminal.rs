//! A check as text for a terminal, in the manner of a compiler.
//!
//! A line that is refuted, undecided or unreadable gets a drawing of its place; the others stand in a list.

use crate::diagnostic::{Diagnostic, Severity};
use crate::report::{Checked, Place};
use crate::source::Span;
use crate::verify::{Counterexample, Finding, Role, Summary, Verdict};
use annotate_snippets::{
    Annotation, AnnotationKind, Group, Level, Origin, Renderer, Snippet, normalize_untrusted_str,
};
use std::fmt::Write;
use std::ops::Range;

/// Bytes that are shown before and after a place on an overlong line.
const MARGIN: usize = 240;
/// Bytes of a place that are underlined at most.
const UNDERLINED: usize = 4_000;

/// What is said of a document, with terminal colours (strip them where they are not wanted). `verbose` also quotes the
/// lines that hold and lists what was not taken as a line.
pub fn check(checked: &Checked, verbose: bool) -> String {
    let mut text = String::new();
    for diagnostic in news(checked) {
        text.push_str(&draw(&of_diagnostic(checked, diagnostic)));
    }
    for finding in &checked.report.findings {
        if !matches!(finding.verdict, Verdict::Proved | Verdict::Accepted) {
            text.push_str(&draw(&of_finding(checked, finding)));
        }
    }
    text.push_str(&good_lines(checked, verbose));
    text.push_str(&background(checked));
    if verbose {
        text.push_str(&passed(checked));
    }
    let path = normalize_untrusted_str(&checked.report.path);
    let _ = writeln!(text, "{path}: {}", summary(checked.report.summary()));
    text
}

/// The reader's diagnostics, without those that an unreadable line repeats.
fn news(checked: &Checked) -> impl Iterator<Item = &Diagnostic> {
    let repeated = |diagnostic: &Diagnostic| {
        let findings = checked.report.findings.iter();
        let mut unreadable = findings.filter(|f| f.verdict == Verdict::Unreadable);
        unreadable.any(|finding| {
            finding.place == diagnostic.primary.span
                && finding.reason.as_ref() == Some(&diagnostic.message)
        })
    };
    let diagnostics = checked.diagnostics.iter();
    diagnostics.filter(move |diagnostic| !repeated(diagnostic))
}

/// One drawing: a fact, its place, and what else there is to say.
struct Drawing<'a> {
    checked: &'a Checked,
    level: Level<'static>,
    code: Option<&'static str>,
    title: String,
    primary: (Span, String),
    others: Vec<(Span, String)>,
    notes: Vec<String>,
    helps: Vec<String>,
}

fn of_diagnostic<'a>(checked: &'a Checked, diagnostic: &Diagnostic) -> Drawing<'a> {
    let others = diagnostic.others.iter();
    Drawing {
        checked,
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
        checked,
        level: base.with_name(finding.verdict.name()),
        code: diagnosis.map(|d| d.kind),
        title: match &finding.label {
            Some(label) => format!("{label} {said}"),
            None => said,
        },
        primary: (place, beside.to_owned()),
        others: vec![],
        notes: notes(finding),
        helps: match (finding.verdict, suggestion) {
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

fn draw(drawing: &Drawing<'_>) -> String {
    let document = &drawing.checked.document;
    let (span, beside) = &drawing.primary;
    let place = Place::of(document, *span);
    let path = normalize_untrusted_str(&document.source.name);
    let path = match place.cell {
        Some(cell) => format!("{path}, cell {cell}"),
        None => path,
    };
    let excerpt = Excerpt::around(&document.source.text, *span);
    let others = drawing.others.iter();
    let annotations = others.filter_map(|(span, text)| {
        let range = excerpt.inside(*span)?;
        Some(annotation(AnnotationKind::Context, range, text))
    });
    let snippet = Snippet::source(excerpt.text)
        .line_start(place.line)
        .annotation(annotation(
            AnnotationKind::Primary,
            excerpt.range.clone(),
            beside,
        ))
        .annotations(annotations);
    let mut title = drawing.level.clone().primary_title(&drawing.title);
    if let Some(code) = drawing.code {
        title = title.id(code);
    }
    // The renderer counts columns from where the snippet begins, so a window of a line needs its origin said.
    let group = if excerpt.whole_lines {
        title.element(snippet.path(path))
    } else {
        let origin = Origin::path(path).line(place.line);
        title
            .element(origin.char_column(place.column))
            .element(snippet)
    };
    let message = |level: &Level<'static>, text: &String| {
        level.clone().message(normalize_untrusted_str(text))
    };
    let notes = drawing.notes.iter().map(|text| message(&Level::NOTE, text));
    let helps = drawing.helps.iter().map(|text| message(&Level::HELP, text));
    let group: Group<'_> = group.elements(notes).elements(helps);
    Renderer::styled().render(&[group]) + "\n\n"
}

fn annotation<'a>(kind: AnnotationKind, range: Range<usize>, text: &str) -> Annotation<'a> {
    let annotation = kind.span(range);
    match text {
        "" => annotation,
        text => annotation.label(normalize_untrusted_str(text)),
    }
}

/// The part of a text that is shown around a place: whole lines, or a window of an overlong one.
struct Excerpt<'a> {
    text: &'a str,
    offset: usize,
    /// Whether `text` begins at the beginning of a line.
    whole_lines: bool,
    /// The place, within `text`.
    range: Range<usize>,
}

impl<'a> Excerpt<'a> {
    fn around(text: &'a str, span: Span) -> Self {
        let start = boundary(text, span.range().start);
        let end = boundary(text, span.range().end.min(start + UNDERLINED)).max(start);
        let (before, after) = text.split_at(start);
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let rest = after.split_at(end - start).1;
        let line_end = rest.find('\n').map_or(text.len(), |at| end + at);
        let offset = line_start.max(boundary(text, start.saturating_sub(MARGIN)));
        let last = line_end.min(boundary(text, end + MARGIN));
        Self {
            text: text.get(offset..last).unwrap_or_default(),
            offset,
            whole_lines: offset == line_start,
            range: start - offset..end - offset,
        }
    }

    /// A span as a range of the shown text, where it lies inside.
    fn inside(&self, span: Span) -> Option<Range<usize>> {
        let start = span.range().start.checked_sub(self.offset)?;
        let end = span.range().end.checked_sub(self.offset)?;
        self.text.get(start..end).map(|_| start..end)
    }
}

/// The last character boundary at or before an offset.
fn boundary(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// The lines that hold, one row each.
fn good_lines(checked: &Checked, verbose: bool) -> String {
    let findings = checked.report.findings.iter();
    let good: Vec<_> = findings
        .filter(|f| matches!(f.verdict, Verdict::Proved | Verdict::Accepted))
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

/// `line 8`, or `cell 2, line 8` in a notebook.
fn line_name(cell: Option<usize>, line: usize) -> String {
    match cell {
        Some(cell) => format!("cell {cell}, line {line}"),
        None => format!("line {line}"),
    }
}

/// The verdict of a line that holds, and what it rests on.
fn verdict(finding: &Finding) -> String {
    let mut text = match (finding.verdict, finding.role) {
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
fn background(checked: &Checked) -> String {
    let report = &checked.report;
    let mut text = String::new();
    for premise in &report.from_prose {
        let cell = Place::of(&checked.document, premise.span).cell;
        let place = line_name(cell, premise.source_line);
        let _ = writeln!(
            text,
            "  {place}  from the words: {}",
            normalize_untrusted_str(&premise.premise)
        );
    }
    for reading in &report.readings {
        let _ = writeln!(text, "  read as {}", normalize_untrusted_str(reading));
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
fn passed(checked: &Checked) -> String {
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
fn summary(summary: Summary) -> String {
    let counts = [
        (summary.proved, Verdict::Proved),
        (summary.accepted, Verdict::Accepted),
        (summary.refuted, Verdict::Refuted),
        (summary.undecided, Verdict::Undecided),
        (summary.unreadable, Verdict::Unreadable),
    ];
    let said: Vec<_> = counts
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, verdict)| format!("{count} {}", verdict.name()))
        .collect();
    if said.is_empty() {
        return "no line to check".to_owned();
    }
    said.join(", ")
}
