//! The offline worksheet of a Moodle assignment: grades are put into the file as it was downloaded.

use crate::grade::{Graded, Key};
use crate::report::grade::gradebook::{cell, feedback};
use crate::report::grade::table::{Row, rows};
use std::io::Write;
use std::ops::Range;

/// Columns that tell who a student is.
const WHO: [&str; 6] = [
    "identifier",
    "id number",
    "email address",
    "username",
    "full name",
    "identity",
];

/// Puts marks and feedback into a worksheet and writes it, row by row: every other byte stays. `ids` are in their order, and
/// `told` is what one of them is told, by its place there. Who waits for a person gets no grade yet. Returns the ids that are
/// not in the worksheet.
///
/// # Errors
///
/// In words, where a column is not there, where the worksheet has another maximum than the key, and those of `told` and of
/// the writer.
pub fn fill<'i>(
    text: &str,
    key: &Key,
    ids: &'i [String],
    told: impl Fn(usize) -> Result<Graded, String>,
    mut to: impl Write,
) -> Result<Vec<&'i str>, String> {
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
    let (mut known, mut from) = (vec![false; ids.len()], 0);
    for row in rows {
        let values = row.values(text);
        let mut names = who.iter().filter_map(|&at| values.get(at));
        let Some(place) = names.find_map(|value| named(ids, value)) else {
            continue;
        };
        known[place] = true;
        fits(key, most.and_then(|at| values.get(at)))?;
        let student = told(place)?;
        let mut put: Vec<(Range<usize>, String)> = vec![];
        if student.queue.is_none() {
            put.extend(at(&row, grade).map(|cell| (cell, student.marks.to_string())));
        }
        let said = cell(&feedback(&student));
        put.extend(comments.and_then(|c| at(&row, c)).map(|cell| (cell, said)));
        put.sort_by_key(|(cell, _)| cell.start);
        for (cell, value) in put {
            write(&mut to, &text[from..cell.start])?;
            write(&mut to, &value)?;
            from = cell.end;
        }
    }
    write(&mut to, &text[from..])?;
    let unknown = ids.iter().zip(known).filter(|(_, known)| !known);
    Ok(unknown.map(|(id, _)| id.as_str()).collect())
}

fn write(to: &mut impl Write, text: &str) -> Result<(), String> {
    let done = to.write_all(text.as_bytes());
    done.map_err(|error| error.to_string())
}

fn at(row: &Row, column: usize) -> Option<Range<usize>> {
    row.cells.get(column).cloned()
}

/// The place of the student whom a cell names: by the id, or by the number behind a word, as in `Participant 123`.
fn named(ids: &[String], value: &str) -> Option<usize> {
    let place = |name: &str| ids.binary_search_by(|id| id.as_str().cmp(name)).ok();
    let value = value.trim();
    let number = value.rsplit(char::is_whitespace).next().unwrap_or("");
    let number = Some(number).filter(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    place(value).or_else(|| place(number?))
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
