//! The page of the class: marks, milestones, mistakes, and who waits for a person.

use crate::grade::{Graded, Key, Marks, Outcome};
use crate::report::html::{CLOSED, opened, prose};
use maud::{Markup, PreEscaped, html};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// The most bars of the distribution of marks, beside one for all of them.
const BARS: usize = 12;

/// So many different questions are counted each: nobody would read more, and a class of any size fits into memory.
const MOST_QUESTIONS: usize = 10_000;

/// What is counted of the students of a class.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    students: usize,
    /// How many have how many marks.
    marks: BTreeMap<Marks, usize>,
    /// How often which milestone came out how.
    outcomes: BTreeMap<String, [usize; OUTCOMES.len()]>,
    slips: BTreeMap<String, usize>,
    /// The questions, with the submissions in which each stands and the lines that wait for it.
    questions: BTreeMap<String, (usize, usize)>,
    /// Who waits for a person, by their places among the students.
    waiting: Vec<usize>,
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
    pub fn add(&mut self, student: &Graded) {
        *self.marks.entry(student.marks).or_default() += 1;
        for reached in &student.milestones {
            let counts = self.outcomes.entry(reached.label.clone()).or_default();
            let column = OUTCOMES.iter().position(|own| *own == reached.outcome);
            column.into_iter().for_each(|column| counts[column] += 1);
        }
        if let Some(slip) = &student.first_slip {
            *self.slips.entry(slip.kind.clone()).or_default() += 1;
        }
        for (text, lines) in &student.questions {
            self.ask(text, *lines);
        }
        if student.queue.is_some() {
            self.waiting.push(self.students);
        }
        self.students += 1;
    }

    /// Counts a question for which lines of a submission wait.
    fn ask(&mut self, text: &str, lines: usize) {
        if self.questions.len() >= MOST_QUESTIONS && !self.questions.contains_key(text) {
            return;
        }
        let (submissions, waiting) = self.questions.entry(text.to_owned()).or_default();
        *submissions += 1;
        *waiting += lines;
    }

    /// How many wait for a person.
    pub fn waiting(&self) -> usize {
        self.waiting.len()
    }

    /// The mean of all marks and their median, to a tenth.
    fn middle(&self) -> (f64, f64) {
        let tenths = |number: f64| (number * 10.0).round() / 10.0;
        let counts = self.marks.iter();
        // From zero, as the sum of no numbers is -0.
        let sum = counts.fold(0.0, |sum, (marks, n)| sum + marks.to_f64() * *n as f64);
        let at = |place: usize| {
            let mut counts = self.marks.iter().scan(0, |before, (marks, n)| {
                *before += n;
                Some((marks.to_f64(), *before))
            });
            let found = counts.find(|(_, up_to)| place < *up_to);
            found.map_or(0.0, |(marks, _)| marks)
        };
        let of = self.students.max(1);
        let median = (at((of - 1) / 2) + at(of / 2)) / 2.0;
        (tenths(sum / of as f64), tenths(median))
    }
}

/// Writes the page of a class, with those on the roster who handed in nothing. Who waits for a person is looked up by the
/// place among the students and written one by one: nothing of a large class is kept for it.
///
/// # Errors
///
/// Those of the writer, and of looking up a student.
pub fn page(
    key: &Key,
    tally: &Tally,
    student: impl Fn(usize) -> io::Result<Graded>,
    missing: &[String],
    mut to: impl Write,
) -> io::Result<()> {
    let mut put = |text: String| to.write_all(text.as_bytes());
    put(opened(&key.name))?;
    put(counted(key, tally).into_string())?;
    if tally.waiting() > 0 {
        let head = html! {
            h2 { "Who waits for a person" }
            (PreEscaped("<table>"))
            tr { th { "Student" } th { "Why" } }
        };
        put(head.into_string())?;
        for &place in &tally.waiting {
            let Graded { id, queue, .. } = student(place)?;
            let why = prose(&queue.unwrap_or_default());
            put(html! { tr { td { (id) } td { (why) } } }.into_string())?;
        }
        put("</table>".to_owned())?;
    }
    let absent = html! {
        @if !missing.is_empty() {
            h2 { "Who handed in nothing" }
            ul { @for id in missing { li { (id) } } }
        }
    };
    put(absent.into_string())?;
    put(CLOSED.to_owned())
}

/// What is counted of a class.
fn counted(key: &Key, tally: &Tally) -> Markup {
    let waiting = tally.waiting();
    let (mean, median) = tally.middle();
    html! {
        h1 { (key.name) }
        p { (number(tally.students, "submission", "submissions")) ", of which " (number(waiting, "waits", "wait")) " for a person." }
        p { (key.max()) " marks at most, mean " (mean) ", median " (median) "." @if waiting > 0 { " A milestone that waits counts as no marks." } }
        h2 { "Marks" }
        (bars(&distribution(key.max(), tally)))
        h2 { "Milestones" }
        (milestones(key, tally))
        @let slips = most_first(&tally.slips);
        @if !slips.is_empty() { h2 { "First slips" } (bars(&slips)) }
        (questions(tally))
    }
}

/// How many students have how many marks: in steps of one, two or five of a decimal place, and the most by itself.
fn distribution(most: Marks, tally: &Tally) -> Vec<(String, usize)> {
    let most = most.to_f64();
    let mut steps =
        (-3..6).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(power)));
    let step = steps.find(|step| most / step <= BARS as f64);
    let step = step.unwrap_or(most.max(1.0));
    let place = |marks: f64| (marks / step + 1e-9) as usize;
    let last = (most / step - 1e-9).ceil() as usize;
    let mut counts = vec![0; last + 1];
    let mut whole = true;
    for (marks, count) in &tally.marks {
        let marks = marks.to_f64();
        let at = if marks >= most { last } else { place(marks) };
        counts[at.min(last)] += count;
        whole &= marks >= most || (marks / step - place(marks) as f64).abs() < 1e-6;
    }
    let bound = |at: usize| (step * at as f64).min(most);
    let bound = |at: usize| (bound(at) * 1000.0).round() / 1000.0;
    let name = |at: usize| match whole || at == last {
        true => bound(at).to_string(),
        false => format!("{} to {}", bound(at), bound(at + 1)),
    };
    let counts = counts.into_iter().enumerate();
    counts.map(|(at, count)| (name(at), count)).collect()
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
                @if tally.questions.len() >= MOST_QUESTIONS { li { "No more questions are listed." } }
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
        svg role="img" viewBox=(format!("0 0 340 {height}")) width="340" height=(height) {
            @for (at, (name, count)) in numbers.iter().enumerate() {
                @let top = at * HEIGHT;
                text x="0" y=(top + 15) { (name) }
                rect x="130" y=(top + 3) width=(count * 170 / most) height=(HEIGHT - 6) {}
                text x=(136 + count * 170 / most) y=(top + 15) { (count) }
            }
        }
    }
}
