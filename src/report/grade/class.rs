//! The page of the class: marks, milestones, mistakes, and who waits for a person.

use crate::grade::{Graded, Key, Outcome};
use crate::report::html::{document, prose};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// Bars of the distribution of marks.
const BARS: usize = 10;

/// What is counted of the students of a class.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    students: usize,
    /// How many have how many marks.
    marks: [usize; BARS],
    /// How often which milestone came out how.
    outcomes: BTreeMap<String, [usize; OUTCOMES.len()]>,
    slips: BTreeMap<String, usize>,
    /// The questions, with the submissions in which each stands and the lines that wait for it.
    questions: BTreeMap<String, (usize, usize)>,
    /// Who waits for a person, and why.
    queue: Vec<(String, String)>,
}

/// The outcomes of milestones in the order of the columns.
const OUTCOMES: [Outcome; 4] = [
    Outcome::Full,
    Outcome::FollowThrough,
    Outcome::None,
    Outcome::Human,
];

impl Tally {
    /// Counts a student.
    pub fn add(&mut self, key: &Key, student: &Graded) {
        self.students += 1;
        let most = key.max().to_f64();
        let part = if most > 0.0 {
            student.marks.to_f64() / most
        } else {
            0.0
        };
        self.marks[((part * BARS as f64) as usize).min(BARS - 1)] += 1;
        for reached in &student.milestones {
            let counts = self.outcomes.entry(reached.label.clone()).or_default();
            let column = OUTCOMES.iter().position(|own| *own == reached.outcome);
            column.into_iter().for_each(|column| counts[column] += 1);
        }
        if let Some(slip) = &student.first_slip {
            *self.slips.entry(slip.kind.clone()).or_default() += 1;
        }
        for (text, lines) in &student.questions {
            let (submissions, waiting) = self.questions.entry(text.clone()).or_default();
            *submissions += 1;
            *waiting += lines;
        }
        let why = student.queue.as_ref();
        self.queue
            .extend(why.map(|why| (student.id.clone(), why.clone())));
    }

    /// How many wait for a person.
    pub fn waiting(&self) -> usize {
        self.queue.len()
    }
}

/// The page of a class, with those on the roster who handed in nothing.
pub fn page(key: &Key, tally: &Tally, missing: &[String]) -> String {
    let waiting = tally.waiting();
    let body = html! {
        h1 { (key.name) }
        p { (number(tally.students, "submission", "submissions")) ", of which " (number(waiting, "waits", "wait")) " for a person. " (key.max()) " marks at most." }
        h2 { "Marks" }
        (bars(&distribution(key, tally)))
        h2 { "Milestones" }
        (milestones(key, tally))
        @let slips = most_first(&tally.slips);
        @if !slips.is_empty() { h2 { "First slips" } (bars(&slips)) }
        (questions(tally))
        @if waiting > 0 {
            h2 { "Who waits for a person" }
            table {
                tr { th { "Student" } th { "Why" } }
                @for (id, why) in &tally.queue { tr { td { (id) } td { (prose(why)) } } }
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
fn distribution(key: &Key, tally: &Tally) -> Vec<(String, usize)> {
    let most = key.max().to_f64();
    let name = |at: usize| {
        let bound = |n: usize| (most * n as f64 / BARS as f64 * 100.0).round() / 100.0;
        format!("{} to {}", bound(at), bound(at + 1))
    };
    let counts = tally.marks.iter().enumerate();
    counts.map(|(at, count)| (name(at), *count)).collect()
}

fn milestones(key: &Key, tally: &Tally) -> Markup {
    html! {
        div.wide {
            table {
                tr { th { "Milestone" } th { "Marks" } th { "Reached" } th { "Carried" } th { "Not reached" } th { "Waiting" } }
                @for (label, marks) in key.milestones() {
                    tr {
                        td { (label) } td.number { (marks) }
                        @for count in tally.outcomes.get(label).copied().unwrap_or_default() { td.number { (count) } }
                    }
                }
            }
        }
    }
}

/// What is asked of letters over the class, that for which most lines wait first.
fn questions(tally: &Tally) -> Markup {
    let mut asked: Vec<_> = tally.questions.iter().collect();
    asked.sort_by_key(|(_, (_, waiting))| std::cmp::Reverse(*waiting));
    html! {
        @if !asked.is_empty() {
            h2 { "Questions of the class" }
            p { "An answer is a sentence under " code { "polhode:" } " in the key, or for one student a file in the folder of " code { "--answers" } "." }
            ul {
                @for (text, (submissions, waiting)) in asked {
                    li { (prose(text)) " It stands in " (number(*submissions, "submission", "submissions")) "; " (number(*waiting, "line waits", "lines wait")) "." }
                }
            }
        }
    }
}

fn number(count: usize, one: &str, several: &str) -> String {
    let what = if count == 1 { one } else { several };
    format!("{count} {what}")
}

fn most_first(counts: &BTreeMap<String, usize>) -> Vec<(String, usize)> {
    let counts = counts.iter().map(|(name, count)| (name.clone(), *count));
    let mut counts: Vec<_> = counts.collect();
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
