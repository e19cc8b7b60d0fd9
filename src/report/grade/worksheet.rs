//! The offline worksheet of a Moodle assignment: grades are put into the file as it was downloaded.

use crate::grade::{Graded, Key};
use crate::report::grade::gradebook::{cell, feedback};
use crate::report::grade::table::{Row, rows};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// A worksheet that is filled in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Filled {
    /// Its text: that of the download, but for the cells of grades and of feedback.
    pub text: String,
    /// The students who are not in it.
    pub unknown: Vec<String>,
}

/// Columns that tell who a student is.
const WHO: [&str; 6] = [
    "identifier",
    "id number",
    "email address",
    "username",
    "full name",
    "identity",
];

/// Puts marks and feedback into a worksheet, of what students are told. Who waits for a person gets no grade yet.
///
/// # Errors
///
/// In words, where a column is not there, or where the worksheet has another maximum than the key.
pub fn fill(text: &str, key: &Key, told: &[Graded]) -> Result<Filled, String> {
    let mut rows = rows(text);
    let titles = rows.next().map(|row| row.values(text)).unwrap_or_default();
    let titles: Vec<String> = titles.iter().map(|t| t.trim().to_lowercase()).collect();
    let column = |names: &[&str]| titles.iter().position(|t| names.contains(&t.as_str()));
    let grade = column(&["grade"]).ok_or("no column of it is called Grade")?;
    let comments = column(&["feedback comments", "feedback"]);
    let most = column(&["maximum grade"]);
    let who: Vec<usize> = WHO.iter().filter_map(|name| column(&[name])).collect();
    if who.is_empty() {
        return Err("no column of it says who a student is, such as Identifier".to_owned());
    }
    let students: BTreeMap<&str, &Graded> = told.iter().map(|s| (s.id.as_str(), s)).collect();
    let mut known: BTreeSet<&str> = BTreeSet::new();
    let mut put: Vec<(Range<usize>, String)> = vec![];
    for row in rows {
        let values = row.values(text);
        let Some(student) = who
            .iter()
            .filter_map(|&at| values.get(at))
            .find_map(|value| named(&students, value))
        else {
            continue;
        };
        known.insert(&student.id);
        fits(key, most.and_then(|at| values.get(at)))?;
        if student.queue.is_none() {
            put.extend(at(&row, grade).map(|cell| (cell, student.marks.to_string())));
        }
        let said = cell(&feedback(student));
        put.extend(comments.and_then(|c| at(&row, c)).map(|cell| (cell, said)));
    }
    let unknown = told.iter().filter(|s| !known.contains(s.id.as_str()));
    Ok(Filled {
        unknown: unknown.map(|s| s.id.clone()).collect(),
        text: spliced(text, put),
    })
}

fn at(row: &Row, column: usize) -> Option<Range<usize>> {
    row.cells.get(column).cloned()
}

/// The student whom a cell names: by the id, or by the number behind a word, as in `Participant 123`.
fn named<'s>(students: &BTreeMap<&str, &'s Graded>, value: &str) -> Option<&'s Graded> {
    let value = value.trim();
    let number = value.rsplit(char::is_whitespace).next().unwrap_or("");
    let number = Some(number).filter(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    let found = students.get(value);
    found.or_else(|| students.get(number?)).copied()
}

/// Whether a maximum of the worksheet is that of the key.
fn fits(key: &Key, most: Option<&String>) -> Result<(), String> {
    let Some(most) = most.map(|most| most.trim()).filter(|most| !most.is_empty()) else {
        return Ok(());
    };
    let number: Option<f64> = most.replace(',', ".").parse().ok();
    match number {
        Some(number) if (number - key.max().to_f64()).abs() > 1e-9 => Err(format!(
            "its maximum grade is {most} and the key gives {} marks; make them the same",
            key.max()
        )),
        _ => Ok(()),
    }
}

/// A text with other cells in the place of some.
fn spliced(text: &str, mut put: Vec<(Range<usize>, String)>) -> String {
    put.sort_by_key(|(cell, _)| cell.start);
    let (mut filled, mut at) = (String::with_capacity(text.len()), 0);
    for (cell, value) in put {
        filled.push_str(&text[at..cell.start]);
        filled.push_str(&value);
        at = cell.end;
    }
    filled.push_str(&text[at..]);
    filled
}
