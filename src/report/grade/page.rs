//! The page of one student: marks, the first slip, lines with their verdicts.

use crate::grade::{Graded, Key, Outcome};
use crate::report::html::{self, formula, prose};
use maud::{Markup, html};

/// The page of a student, of what is told.
pub fn student(key: &Key, told: &Graded) -> String {
    let body = html! {
        h1 { (told.id) }
        p.total { strong { (told.marks) } " of " (key.max()) " marks" }
        @if told.queue.is_some() {
            p.wait { "A person will look at this work; the marks may change." }
        }
        (milestones(told))
        @for note in &told.notes { p { (prose(note)) } }
        (slip(told))
        (assumptions(told))
        @if !told.lines.is_empty() {
            h2 { "Your lines" }
            @for line in &told.lines { (html::line(line)) }
        }
    };
    html::document(
        &format!("{}: {} of {}", told.id, told.marks, key.max()),
        &body,
    )
}

fn milestones(told: &Graded) -> Markup {
    html! {
        h2 { "Marks" }
        table {
            tr { th { "Milestone" } th { "Marks" } th { "Result" } }
            @for reached in &told.milestones {
                tr {
                    td { (reached.label) }
                    td.number { (reached.marks) " of " (reached.max) }
                    td class=(colour(reached.outcome)) {
                        (in_words(reached.outcome))
                        @if !reached.reason.is_empty() { small { (prose(&reached.reason)) } }
                    }
                }
            }
        }
    }
}

/// The class by which an outcome is coloured.
fn colour(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Full | Outcome::FollowThrough => "good",
        Outcome::None => "bad",
        Outcome::Human => "wait",
    }
}

/// An outcome for a student.
pub(super) fn in_words(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Full => "reached",
        Outcome::FollowThrough => "follows from an earlier slip",
        Outcome::None => "not reached",
        Outcome::Human => "waits for a person",
    }
}

fn slip(told: &Graded) -> Markup {
    html! {
        @if let Some(slip) = &told.first_slip {
            h2 { "The first slip" }
            p {
                "It is in " (slip.place) "."
                @if !slip.message.is_empty() { " " (prose(&slip.message)) }
            }
            @if let Some(repair) = &slip.repair {
                p { "Write instead:" }
                div.formula { (formula(repair)) }
            }
        }
    }
}

fn assumptions(told: &Graded) -> Markup {
    html! {
        @if told.assumptions.iter().any(|assumption| !assumption.in_key) {
            h2 { "What you assume and the task does not" }
            @for assumption in told.assumptions.iter().filter(|assumption| !assumption.in_key) {
                div.line { small { (assumption.place) } div.formula { (formula(&assumption.text)) } }
            }
        }
    }
}
