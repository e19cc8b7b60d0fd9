//! Pages: the frame around all of them, lines with their verdicts, and a check as a page. No script, and nothing from
//! elsewhere.

use crate::grade::{Line, Numbers};
use crate::report::Checked;
use maud::{DOCTYPE, Markup, PreEscaped, html};

mod elements;
mod formula;

pub(super) use formula::{formula, is_drawn};

/// How pages look: narrow screens, paper, light and dark.
const STYLE: &str = "
:root { color-scheme: light dark; --line: #8886; --good: #1a7f37; --bad: #cf222e; --wait: #9a6700; --bar: #4a7ebb }
@media (prefers-color-scheme: dark) { :root { --good: #3fb950; --bad: #ff7b72; --wait: #d29922; --bar: #6f9fd8 } }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 46rem; margin: 0 auto; padding: 1rem; overflow-wrap: anywhere }
h1 { line-height: 1.2 } h2 { margin: 2rem 0 .5rem } .total { font-size: 1.25rem; margin: 0 }
.wide { overflow-x: auto } table { border-collapse: collapse; width: 100% } th, td { text-align: left; padding: .3rem .8rem .3rem 0; border-bottom: 1px solid var(--line); vertical-align: top; overflow-wrap: normal }
.number { white-space: nowrap; font-variant-numeric: tabular-nums } td small { display: block; color: CanvasText }
.good { color: var(--good) } .bad { color: var(--bad) } .wait { color: var(--wait) }
.line { border-left: 4px solid var(--line); padding-left: .7rem; margin: 1rem 0; break-inside: avoid } .line p { margin: .3rem 0 } .line.good { border-color: var(--good); color: inherit }
.line.bad { border-color: var(--bad); color: inherit } .line.wait { border-color: var(--wait); color: inherit }
.formula { overflow-x: auto; overflow-y: hidden; padding: .3rem 0 } math { font-size: 1.1em } math[display=block] { width: max-content; margin: 0 } code { white-space: pre-wrap; overflow-wrap: anywhere }
svg { max-width: 100%; height: auto; display: block } svg rect { fill: var(--bar) } svg text { fill: CanvasText; font: 13px system-ui, sans-serif } small { opacity: .85 }
@media (max-width: 30rem) { th, td { padding-right: .4rem } .wide { font-size: .78rem } }
@media print { :root { color-scheme: only light; --good: #1a7f37; --bad: #cf222e; --wait: #9a6700 } body { max-width: none; font-size: 11pt; padding: 0 } .formula, .wide { overflow: visible } h2 { break-after: avoid } tr { break-inside: avoid } .line, svg rect { print-color-adjust: exact } }
";

/// A page up to where its body begins; [`CLOSED`] ends it.
pub(super) fn opened(title: &str) -> String {
    let page = html! {
        (DOCTYPE)
        (PreEscaped("<html lang=\"en\">"))
        head {
            meta charset="utf-8";
            meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'";
            meta name="viewport" content="width=device-width, initial-scale=1";
            title { (title) }
            style { (PreEscaped(STYLE)) }
        }
        (PreEscaped("<body>"))
    };
    page.into_string()
}

/// What stands behind the body of a page.
pub(super) const CLOSED: &str = "</body></html>\n";

/// A whole page around what is in it.
pub(super) fn document(title: &str, body: &Markup) -> String {
    opened(title) + &body.0 + CLOSED
}

/// The verdict of a line in words for its author.
pub(super) fn verdict(line: &Line) -> &'static str {
    match line.verdict.as_str() {
        "proved" => "holds",
        "accepted" => "taken as given",
        "refuted" if line.carried => "does not hold, and only carries on an earlier slip",
        "refuted" => "does not hold",
        "unreadable" => "could not be read",
        "withdrawn" => "is not counted",
        _ => "was not decided",
    }
}

/// A line with its verdict and with what is told of it.
pub(super) fn line(line: &Line) -> Markup {
    let class = match line.verdict.as_str() {
        "proved" | "accepted" => "line good",
        "refuted" => "line bad",
        "withdrawn" => "line",
        _ => "line wait",
    };
    html! {
        div class=(class) {
            small { (line.place) ": " (verdict(line)) }
            div.formula { (formula(&line.source)) }
            @if let Some(said) = line.mistake.as_ref().or(line.reason.as_ref()) { p { (prose(said)) } }
            @if let Some(repair) = &line.repair {
                p { "Write instead:" }
                div.formula { (formula(repair)) }
            }
            @if let Some(numbers) = &line.counterexample { (fails(numbers)) }
        }
    }
}

/// A clause as a sentence.
pub(super) fn sentence(clause: &str) -> String {
    let mut letters = clause.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    let end = if clause.ends_with(['.', '!', '?']) {
        ""
    } else {
        "."
    };
    format!("{}{}{end}", first.unwrap_or_default(), letters.as_str())
}

/// A clause as a sentence, in which formulas between backticks are drawn.
pub(super) fn prose(clause: &str) -> Markup {
    let said = sentence(clause);
    html! {
        @for (at, part) in said.split('`').enumerate() {
            @if at % 2 == 1 { (formula::inline(part)) } @else { (part) }
        }
    }
}

/// The numbers in which a line fails.
fn fails(numbers: &Numbers) -> Markup {
    html! {
        p {
            "With "
            @for (at, (symbol, value)) in numbers.symbols.iter().enumerate() {
                @if at > 0 { ", " }
                span.number { (formula::inline(symbol)) " = " (value) }
            }
            @if let Some(component) = &numbers.component { " the component " (component) " of" }
            " the left side is " (numbers.left) " and the right side is " (numbers.right) "."
        }
    }
}

/// Documents that were checked, as one page.
pub fn check(checked: &[Checked]) -> String {
    let names: Vec<&str> = checked.iter().map(|c| c.report.path.as_str()).collect();
    let body = html! { @for one in checked { (checked_document(one)) } };
    document(&names.join(", "), &body)
}

fn checked_document(checked: &Checked) -> Markup {
    let report = &checked.report;
    let count = report.summary();
    let counts = [
        ("hold", count.proved, "good"),
        ("are taken as given", count.accepted, "good"),
        ("do not hold", count.refuted, "bad"),
        ("were not decided", count.undecided, "wait"),
        ("could not be read", count.unreadable, "wait"),
    ];
    let counts: Vec<_> = counts.into_iter().filter(|(_, n, _)| *n > 0).collect();
    html! {
        h1 { (report.path) }
        p.total {
            @if counts.is_empty() { "There is no line in it." } @else { "Lines: " }
            @for (at, (what, n, class)) in counts.iter().enumerate() {
                @if at > 0 { ", " }
                span class=(class) { (n) " " (what) }
            }
        }
        @if !report.questions.is_empty() {
            h2 { "Questions" }
            ul { @for question in &report.questions { li { (prose(&question.text)) } } }
        }
        h2 { "Lines" }
        @for finding in &report.findings { (line(&Line::of(finding, None))) }
    }
}
