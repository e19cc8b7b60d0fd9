//! What was marked so far: one line for each student, so that a run that was stopped goes on where it was, and so that
//! another run marks only what changed.

use crate::cli::output;
use crate::grade::Graded;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A line of the journal: what was handed in, by its digest, and what came of it.
#[derive(Serialize, Deserialize)]
pub(super) struct Entry {
    stamp: u64,
    work: u64,
    pub(super) graded: Graded,
}

/// The line behind the last student of a part.
#[derive(Serialize, Deserialize)]
struct End {
    stamp: u64,
    students: usize,
}

/// A journal that is open.
pub(super) struct Journal {
    stamp: u64,
    file: Mutex<File>,
    known: HashMap<String, (u64, Graded)>,
    /// Whether it is of a part that was marked to its end.
    pub(super) is_whole: bool,
}

impl Journal {
    /// Opens a journal or begins one. Entries of another key, and a last one that was cut off, are left out.
    pub(super) fn open(path: &Path, stamp: u64) -> io::Result<Self> {
        let mut file = OpenOptions::new()
            .read(true)
            .append(true)
            .create(true)
            .open(path)?;
        let (mut known, mut whole, mut is_whole) = (HashMap::new(), 0, false);
        let mut reader = BufReader::new(&file);
        let mut line = vec![];
        while reader.read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
            whole += line.len() as u64;
            let entry = serde_json::from_slice::<Entry>(&line).ok();
            if let Some(entry) = entry.filter(|entry| entry.stamp == stamp) {
                known.insert(entry.graded.id.clone(), (entry.work, entry.graded));
            }
            let end = serde_json::from_slice::<End>(&line).ok();
            is_whole = end.is_some_and(|end| end.stamp == stamp && end.students == known.len());
            line.clear();
        }
        file.set_len(whole)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Self {
            stamp,
            file: Mutex::new(file),
            known,
            is_whole,
        })
    }

    /// What came of a student's work, if the same was marked before.
    pub(super) fn known(&self, id: &str, work: u64) -> Option<Graded> {
        let (known, graded) = self.known.get(id)?;
        (*known == work).then(|| graded.clone())
    }

    /// What is put down of a student.
    pub(super) fn entry(&self, work: u64, graded: Graded) -> Entry {
        Entry {
            stamp: self.stamp,
            work,
            graded,
        }
    }

    /// Adds a student.
    pub(super) fn append(&self, entry: &Entry) -> io::Result<()> {
        self.write(entry)
    }

    /// Says that all students of a part are there.
    pub(super) fn end(&self, students: usize) -> io::Result<()> {
        self.write(&End {
            stamp: self.stamp,
            students,
        })
    }

    fn write(&self, line: &impl Serialize) -> io::Result<()> {
        let line = line_of(line)?;
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(line.as_bytes())
    }

    /// All students.
    pub(super) fn into_graded(self) -> impl Iterator<Item = Graded> {
        self.known.into_values().map(|(_, graded)| graded)
    }
}

/// One line of a journal.
fn line_of(entry: &impl Serialize) -> io::Result<String> {
    serde_json::to_string(entry)
        .map_err(io::Error::other)
        .map(|line| line + "\n")
}

/// Puts a journal with these students alone in the place of one: the same whatever the order was in which they were marked.
pub(super) fn replace(path: &Path, entries: &[Entry]) -> io::Result<()> {
    output::replace_by(path, |file| {
        let mut lines = entries.iter();
        lines.try_for_each(|entry| file.write_all(line_of(entry)?.as_bytes()))
    })
}

/// The journals of all parts of a class.
///
/// # Errors
///
/// In words, where there is none, where one is missing, or where the class was cut in two ways.
pub(super) fn parts(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut found: Vec<(usize, usize, PathBuf)> = vec![];
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let numbers = name
            .strip_prefix("part-")
            .and_then(|rest| rest.strip_suffix(".jsonl"));
        let numbers = numbers.and_then(|rest| rest.split_once("-of-"));
        if let Some((Ok(number), Ok(of))) = numbers.map(|(i, n)| (i.parse(), n.parse())) {
            found.push((of, number, entry.path()));
        }
    }
    found.sort();
    let Some(&(of, ..)) = found.first() else {
        return Err(format!(
            "{}: there is no part in it to merge",
            folder.display()
        ));
    };
    let whole = found
        .iter()
        .map(|(of, number, _)| (*of, *number))
        .eq((1..=of).map(|number| (of, number)));
    if !whole {
        return Err(format!(
            "{}: parts are missing, or belong to another division",
            folder.display()
        ));
    }
    Ok(found.into_iter().map(|(_, _, path)| path).collect())
}

/// A digest of pieces of text, the same on every machine (FNV-1a, 64 bits; Fowler, Noll and Vo).
pub(super) fn digest<'t>(pieces: impl Iterator<Item = &'t [u8]>) -> u64 {
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    let mut digest: u64 = 0xcbf2_9ce4_8422_2325;
    for piece in pieces {
        let length = (piece.len() as u64).to_le_bytes();
        for byte in length.iter().chain(piece) {
            digest = (digest ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
    }
    digest
}
