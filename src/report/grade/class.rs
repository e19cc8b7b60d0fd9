//! The page of the class: marks, milestones, mistakes, and who waits for a person.

use crate::grade::{Graded, Key, Outcome};
use crate::report::html::{document, prose};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// Bars of the distribution of marks.
const BARS: usize = 10;

/// The page of a class, with those on the roster who handed in nothing.
pub fn page(key: &Key, students: &[Graded], missing: &[String]) -> String {
    let waiting: Vec<&Graded> = students.iter().filter(|s| s.queue.is_some()).collect();
    let body = html! {
        h1 { (key.name) }
        p { (number(students.len(), "submission", "submissions")) ", of which " (number(waiting.len(), "waits", "wait")) " for a person. " (key.max()) " marks at most." }
        h2 { "Marks" }
        (bars(&distribution(key, students)))
        h2 { "Milestones" }
        (milestones(key, students))
        @let slips = counted(students.iter().filter_map(|s| s.first_slip.as_ref().map(|slip| slip.kind.clone())));
        @if !slips.is_empty() { h2 { "First slips" } (bars(&slips)) }
        (questions(students))
        @if !waiting.is_empty() {
            h2 { "Who waits for a person" }
            table {
                tr { th { "Student" } th { "Why" } }
                @for student in waiting { tr { td { (student.id) } td { (prose(student.queue.as_deref().unwrap_or(""))) } } }
            }
        }
        @if !missing.is_empty() {
            h2 { "Who handed in nothing" }
            ul { @for id in missing { li { (id) } } }
        }
    };
    document(&key.name, &body)
}

/// How many students have how many marks.
fn distribution(key: &Key, students: &[Graded]) -> Vec<(String, usize)> {
    let most = key.max().to_f64();
    let mut counts = [0; BARS];
    for student in students {
        let part = if most > 0.0 {
            student.marks.to_f64() / most
        } else {
            0.0
        };
        counts[((part * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let name = |at: usize| {
        let bound = |n: usize| (most * n as f64 / BARS as f64 * 100.0).round() / 100.0;
        format!("{} to {}", bound(at), bound(at + 1))
    };
    counts
        .into_iter()
        .enumerate()
        .map(|(at, count)| (name(at), count))
        .collect()
}

fn milestones(key: &Key, students: &[Graded]) -> Markup {
    let count = |label: &str, outcome: Outcome| {
        let reached = students.iter().flat_map(|s| &s.milestones);
        reached
            .filter(|m| m.label == label && m.outcome == outcome)
            .count()
    };
    html! {
        div.wide {
            table {
                tr { th { "Milestone" } th { "Marks" } th { "Reached" } th { "Carried" } th { "Not reached" } th { "Waiting" } }
                @for (label, marks) in key.milestones() {
                    tr {
                        td { (label) } td.number { (marks) }
                        @for outcome in [Outcome::Full, Outcome::FollowThrough, Outcome::None, Outcome::Human] {
                            td.number { (count(label, outcome)) }
                        }
                    }
                }
            }
        }
    }
}

/// What is asked of letters over the class, that for which most lines wait first.
fn questions(students: &[Graded]) -> Markup {
    let mut asked: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for (text, lines) in students.iter().flat_map(|s| &s.questions) {
        let (submissions, waiting) = asked.entry(text).or_default();
        *submissions += 1;
        *waiting += lines;
    }
    let mut asked: Vec<_> = asked.into_iter().collect();
    asked.sort_by_key(|(_, (_, waiting))| std::cmp::Reverse(*waiting));
    html! {
        @if !asked.is_empty() {
            h2 { "Questions of the class" }
            p { "An answer is a sentence under " code { "polhode:" } " in the key, or for one student a file in the folder of " code { "--answers" } "." }
            ul {
                @for (text, (submissions, waiting)) in asked {
                    li { (prose(text)) " It stands in " (number(submissions, "submission", "submissions")) "; " (number(waiting, "line waits", "lines wait")) "." }
                }
            }
        }
    }
}

fn number(count: usize, one: &str, several: &str) -> String {
    let what = if count == 1 { one } else { several };
    format!("{count} {what}")
}

fn counted(names: impl Iterator<Item = String>) -> Vec<(String, usize)> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in names {
        *counts.entry(name).or_default() += 1;
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}

/// A bar for each number.
fn bars(numbers: &[(String, usize)]) -> Markup {
    const HEIGHT: usize = 22;
    let most = numbers
        .iter()
        .map(|(_, count)| *count)
        .max()
        .unwrap_or(0)
        .max(1);
    let height = numbers.len() * HEIGHT;
    html! {
        svg role="img" viewBox=(format!("0 0 460 {height}")) width="460" height=(height) {
            @for (at, (name, count)) in numbers.iter().enumerate() {
                @let top = at * HEIGHT;
                text x="0" y=(top + 15) { (name) }
                rect x="130" y=(top + 3) width=(count * 280 / most) height=(HEIGHT - 6) {}
                text x=(136 + count * 280 / most) y=(top + 15) { (count) }
            }
        }
    }
}
