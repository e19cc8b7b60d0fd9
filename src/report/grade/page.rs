//! The page of one student: marks, lines with their verdicts, the first slip. No script and nothing from elsewhere.

use crate::grade::{Graded, Key, Line, Numbers, Outcome};
use crate::report::grade::formula::{formula, inline};
use maud::{DOCTYPE, Markup, html};

/// How much a student is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// The marks alone.
    Marks,
    /// Also which line holds and which does not.
    Place,
    /// Also why, with numbers in which a false line fails.
    Full,
}

/// How pages look: narrow screens, paper, light and dark.
const STYLE: &str = "
:root { color-scheme: light dark; --line: #8886; --good: #1a7f37; --bad: #cf222e; --wait: #9a6700 }
@media (prefers-color-scheme: dark) { :root { --good: #3fb950; --bad: #ff7b72; --wait: #d29922 } }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 46rem; margin: 0 auto; padding: 1rem }
table { border-collapse: collapse; width: 100% } th, td { text-align: left; padding: .3rem .5rem .3rem 0; border-bottom: 1px solid var(--line); vertical-align: top }
td.number { white-space: nowrap } .good { color: var(--good) } .bad { color: var(--bad) } .wait { color: var(--wait) }
.line { border-left: 4px solid var(--line); padding-left: .7rem; margin: 1rem 0; break-inside: avoid } .line.good { border-color: var(--good); color: inherit }
.line.bad { border-color: var(--bad); color: inherit } .line.wait { border-color: var(--wait); color: inherit }
.formula { overflow-x: auto; padding: .2rem 0 } code { overflow-wrap: anywhere } svg { max-width: 100%; height: auto } small { opacity: .8 }
@media print { body { max-width: none; font-size: 11pt } .formula { overflow: visible } }
";

/// A whole page around what is in it.
pub(super) fn document(title: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (maud::PreEscaped(STYLE)) }
            }
            body { (body) }
        }
    };
    page.into_string() + "\n"
}

/// The page of a student.
pub fn student(key: &Key, graded: &Graded, detail: Detail) -> String {
    let body = html! {
        h1 { (graded.id) }
        p { strong { (graded.marks) } " of " (key.max()) " marks" }
        @if graded.queue.is_some() {
            p.wait { "A person will look at this work; the marks may change." }
        }
        (milestones(graded, detail))
        @if detail >= Detail::Place {
            (slip(graded, detail))
            (assumptions(graded))
            @if !graded.lines.is_empty() {
                h2 { "Your lines" }
                @for line in &graded.lines { (shown(line, detail)) }
            }
        }
    };
    document(
        &format!("{}: {} of {}", graded.id, graded.marks, key.max()),
        &body,
    )
}

fn milestones(graded: &Graded, detail: Detail) -> Markup {
    html! {
        h2 { "Marks" }
        table {
            tr { th { "Milestone" } th { "Marks" } th { "Result" } }
            @for reached in &graded.milestones {
                tr {
                    td { (reached.label) }
                    td.number { (reached.marks) " of " (reached.max) }
                    td class=(colour(reached.outcome)) {
                        (in_words(reached.outcome))
                        @if detail >= Detail::Place { br; small { (reached.reason) } }
                    }
                }
            }
        }
    }
}

/// The class by which an outcome is coloured.
pub(super) fn colour(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Full | Outcome::FollowThrough => "good",
        Outcome::None => "bad",
        Outcome::Human => "wait",
    }
}

fn in_words(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Full => "reached",
        Outcome::FollowThrough => "follows from an earlier slip",
        Outcome::None => "not reached",
        Outcome::Human => "waits for a person",
    }
}

fn slip(graded: &Graded, detail: Detail) -> Markup {
    html! {
        @if let Some(slip) = &graded.first_slip {
            h2 { "The first slip" }
            p {
                "It is in " (slip.place) "."
                @if detail == Detail::Full { " The mistake: " (slip.message) "." }
            }
        }
    }
}

fn assumptions(graded: &Graded) -> Markup {
    html! {
        @if graded.assumptions.iter().any(|assumption| !assumption.in_key) {
            h2 { "What you assume and the task does not" }
            ul {
                @for assumption in graded.assumptions.iter().filter(|assumption| !assumption.in_key) {
                    li { (assumption.place) ": " (formula(&assumption.text)) }
                }
            }
        }
    }
}

fn shown(line: &Line, detail: Detail) -> Markup {
    let class = match line.verdict.as_str() {
        "proved" | "accepted" => "line good",
        "refuted" => "line bad",
        _ => "line wait",
    };
    let verdict = match line.verdict.as_str() {
        "proved" => "holds",
        "accepted" => "taken as given",
        "refuted" if line.carried => "does not hold, and only carries on an earlier slip",
        "refuted" => "does not hold",
        "unreadable" => "could not be read",
        _ => "was not decided",
    };
    html! {
        div class=(class) {
            small { (line.place) ": " (verdict) }
            div.formula { (formula(&line.source)) }
            @if detail == Detail::Full {
                @if let Some(reason) = &line.reason { p { (reason) } }
                @if let Some(numbers) = &line.counterexample { (fails(numbers)) }
            }
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
                (inline(symbol)) " = " (value)
            }
            " the left side is " (numbers.left) " and the right side is " (numbers.right) "."
        }
    }
}
