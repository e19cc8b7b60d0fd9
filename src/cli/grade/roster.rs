//! The roster: who is expected to hand in.

use crate::cli::grade::folder::Pending;
use crate::cli::grade::names::composed;
use crate::cli::input;
use crate::report::grade::table;
use std::collections::BTreeSet;
use std::path::Path;

/// Titles of the column of ids, the likeliest first.
const TITLES: [&str; 9] = [
    "id",
    "student id",
    "student_id",
    "sid",
    "username",
    "sis login id",
    "login",
    "student",
    "email",
];

/// The ids of a class.
#[derive(Debug, Default)]
pub(super) struct Roster {
    ids: BTreeSet<String>,
}

impl Roster {
    /// Reads a table with one student in a row. A first row with a title such as `id` says which column has the ids; without
    /// titles it is the first.
    ///
    /// # Errors
    ///
    /// In words, where the file can't be read or has nobody in it.
    pub(super) fn read(path: &Path) -> Result<Self, String> {
        let name = input::name(path);
        let text = input::read(path).map_err(|error| format!("{name}: {error}"))?;
        let mut rows = table::rows(&text).peekable();
        let titles = rows.peek().map(|row| row.values(&text)).unwrap_or_default();
        let titles: Vec<String> = titles.iter().map(|t| t.trim().to_lowercase()).collect();
        let column = TITLES
            .iter()
            .find_map(|title| titles.iter().position(|t| t == title));
        let ids = rows
            .skip(usize::from(column.is_some()))
            .filter_map(|row| row.values(&text).get(column.unwrap_or(0)).cloned());
        let ids: BTreeSet<String> = ids
            .map(|id| composed(id.trim()))
            .filter(|id| !id.is_empty())
            .collect();
        match ids.is_empty() {
            true => Err(format!("{name}: there is no student in it")),
            false => Ok(Self { ids }),
        }
    }

    /// Sends a student who is not on the roster to a person.
    pub(super) fn mark_unknown(&self, one: &mut Pending) {
        if !self.ids.contains(&one.id) {
            one.complain("this id is not on the roster".to_owned());
        }
    }

    /// The ids of whom nothing is there. The students come in the order of their ids.
    pub(super) fn missing(&self, students: impl Iterator<Item = String>) -> Vec<String> {
        let mut students = students.peekable();
        let missing = self.ids.iter().filter(|id| {
            while students.next_if(|known| known < *id).is_some() {}
            students.peek() != Some(*id)
        });
        missing.cloned().collect()
    }
}
