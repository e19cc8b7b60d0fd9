//! What was marked so far: one line for each student, so that a run that was stopped goes on where it was, and so that
//! another run marks only what changed.

use crate::cli::output;
use crate::grade::Graded;
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A line of the journal: what was handed in, by its digest, and what came of it.
#[derive(Serialize, Deserialize)]
struct Entry<G> {
    stamp: u64,
    work: u64,
    graded: G,
}

/// The line behind the last student of a part.
#[derive(Serialize, Deserialize)]
struct End {
    stamp: u64,
    students: usize,
}

/// The line of a student in a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    start: u64,
    length: usize,
}

/// A journal that is open. What came of each student stands in the file alone.
pub(super) struct Journal {
    stamp: u64,
    file: Mutex<Lines>,
    known: HashMap<String, (u64, Place)>,
    /// Whether it is of a part that was marked to its end.
    pub(super) is_whole: bool,
}

/// A file of lines that is read anywhere and written at its end.
struct Lines {
    file: File,
    end: u64,
}

impl Lines {
    fn add(&mut self, line: &[u8]) -> io::Result<Place> {
        self.file.write_all(line)?;
        let start = self.end;
        self.end += line.len() as u64;
        Ok(Place {
            start,
            length: line.len(),
        })
    }

    fn read(&mut self, at: Place) -> io::Result<Vec<u8>> {
        let mut line = vec![0; at.length];
        self.file.seek(SeekFrom::Start(at.start))?;
        self.file.read_exact(&mut line)?;
        Ok(line)
    }

    fn graded(&mut self, at: Place) -> io::Result<Graded> {
        let entry: Entry<Graded> = serde_json::from_slice(&self.read(at)?)?;
        Ok(entry.graded)
    }
}

impl Journal {
    /// Opens a journal or begins one. Entries of another key, and a last one that was cut off, are left out.
    pub(super) fn open(path: &Path, stamp: u64) -> io::Result<Self> {
        let mut file = opened(path)?;
        let (mut known, mut whole, mut is_whole) = (HashMap::new(), 0, false);
        let mut reader = BufReader::new(&file);
        let mut line = vec![];
        while reader.read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
            let place = Place {
                start: whole,
                length: line.len(),
            };
            whole += line.len() as u64;
            let entry = serde_json::from_slice::<Entry<Graded>>(&line).ok();
            if let Some(entry) = entry.filter(|entry| entry.stamp == stamp) {
                known.insert(entry.graded.id, (entry.work, place));
            }
            let end = serde_json::from_slice::<End>(&line).ok();
            is_whole = end.is_some_and(|end| end.stamp == stamp && end.students == known.len());
            line.clear();
        }
        file.set_len(whole)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Self {
            stamp,
            file: Mutex::new(Lines { file, end: whole }),
            known,
            is_whole,
        })
    }

    /// What came of a student's work, if the same was marked before.
    pub(super) fn known(&self, id: &str, work: u64) -> Option<(Place, Graded)> {
        let (known, place) = *self.known.get(id)?;
        let graded = (known == work).then(|| self.lines().graded(place))?;
        Some((place, graded.ok()?))
    }

    /// Adds a student.
    pub(super) fn append(&self, work: u64, graded: &Graded) -> io::Result<Place> {
        let entry = Entry {
            stamp: self.stamp,
            work,
            graded,
        };
        let line = line_of(&entry)?;
        self.lines().add(line.as_bytes())
    }

    fn lines(&self) -> MutexGuard<'_, Lines> {
        self.file.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The students at these places, in their order.
    pub(super) fn students(self, places: Vec<Place>) -> Students {
        Students {
            lines: RefCell::new(
                self.file
                    .into_inner()
                    .unwrap_or_else(PoisonError::into_inner),
            ),
            places,
        }
    }
}

/// A journal that is read and written at its end, made if it is not there.
fn opened(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).append(true).create(true).open(path)
}

/// Says at the end of a journal that all students of a part are there.
pub(super) fn end(path: &Path, stamp: u64, students: usize) -> io::Result<()> {
    let line = line_of(&End { stamp, students })?;
    opened(path)?.write_all(line.as_bytes())
}

/// Students that were marked. Each is read when it is looked at, so that a class of any size takes little memory.
pub(super) struct Students {
    lines: RefCell<Lines>,
    places: Vec<Place>,
}

impl Students {
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// The student at a place in their order.
    pub(super) fn at(&self, place: usize) -> io::Result<Graded> {
        let at = self.places.get(place);
        let at = at.ok_or_else(|| io::Error::other("there is no such student"))?;
        self.lines.borrow_mut().graded(*at)
    }

    /// Shows all of them in their order.
    pub(super) fn show<T>(
        &self,
        to: impl FnOnce(&mut dyn Iterator<Item = Graded>) -> io::Result<T>,
    ) -> io::Result<T> {
        let mut failed = None;
        let mut lines = self.lines.borrow_mut();
        let mut each = self.places.iter().map_while(|&place| {
            let read = lines.graded(place);
            read.map_err(|error| failed = Some(error)).ok()
        });
        let shown = to(&mut each);
        failed.map_or(shown, Err)
    }

    /// The students of all parts in the order of their ids, with these: what stands in several files is put into one.
    ///
    /// # Errors
    ///
    /// Those of files, in words; and where a student stands in two parts.
    pub(super) fn of_parts(
        parts: impl Iterator<Item = Journal>,
        folder: &Path,
    ) -> Result<(Self, Vec<String>), String> {
        let in_words = |error: io::Error| format!("{}: {error}", folder.display());
        let file = output::builder().tempfile_in(folder).map_err(in_words)?;
        let file = file.into_file();
        let mut lines = Lines { file, end: 0 };
        let mut all: BTreeMap<String, Place> = BTreeMap::new();
        for part in parts {
            let mut own = part.lines();
            let known = part.known.iter().map(|(id, (_, place))| (id, *place));
            let mut known: Vec<(&String, Place)> = known.collect();
            known.sort_by_key(|(_, place)| place.start);
            for (id, place) in known {
                let line = own.read(place).map_err(in_words)?;
                let place = lines.add(&line).map_err(in_words)?;
                if all.insert(id.clone(), place).is_some() {
                    return Err(format!("{id} stands in two parts; mark the parts anew"));
                }
            }
        }
        let (ids, places) = all.into_iter().unzip();
        let lines = RefCell::new(lines);
        Ok((Self { lines, places }, ids))
    }
}

/// One line of a journal.
fn line_of(entry: &impl Serialize) -> io::Result<String> {
    serde_json::to_string(entry)
        .map_err(io::Error::other)
        .map(|line| line + "\n")
}

/// Puts a journal with these students alone in the place of one: the same whatever the order was in which they were marked.
pub(super) fn replace(path: &Path, students: &Students) -> io::Result<()> {
    output::replace_by(path, |file| {
        let mut lines = students.lines.borrow_mut();
        let mut places = students.places.iter();
        places.try_for_each(|&place| file.write_all(&lines.read(place)?))
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
