//! What was marked so far: one line for each student, so that a run that was stopped goes on where it was, and so that
//! another run marks only what changed. Before the students stands what the key said by which they were marked: where it
//! only tells of more letters now, those keep their marks who write none of them. Each line ends with its own digest: one
//! that was cut off, or into which another was written, does not count.

use crate::cli::output;
use crate::grade::{Difference, Graded, Key, Told, Work};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A line of the journal: what was handed in, by its digest, and what came of it.
#[derive(Serialize, Deserialize)]
struct Entry<G> {
    stamp: u64,
    work: u64,
    graded: G,
}

/// The line before the students that were marked by a key.
#[derive(Serialize, Deserialize)]
struct Head {
    stamp: u64,
    told: Told,
}

/// What came of a student by an older key.
struct Older {
    work: u64,
    place: Place,
    difference: Arc<Difference>,
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
    /// Those that were marked by keys which only told of fewer letters, or of more.
    older: HashMap<String, Older>,
    /// The line before the students, and whether it stands there.
    head: Option<(String, bool)>,
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
        let line = self.read(at)?;
        let line = whole(&line).ok_or_else(|| {
            io::Error::other("a line of the journal was changed by another program; mark again")
        })?;
        let entry: Entry<Graded> = serde_json::from_slice(line)?;
        Ok(entry.graded)
    }
}

impl Journal {
    /// Opens a journal or begins one. Entries of a key that differs in more than letters, and those that are not as they were
    /// written, are left out.
    pub(super) fn open(path: &Path, stamp: u64, key: &Key) -> io::Result<Self> {
        let mut file = opened(path)?;
        let head = key.told().map(|told| line_of(&Head { stamp, told }));
        let mut found = Self {
            stamp,
            file: Mutex::new(Lines {
                file: file.try_clone()?,
                end: 0,
            }),
            known: HashMap::new(),
            older: HashMap::new(),
            head: head.transpose()?.map(|line| (line, false)),
            is_whole: false,
        };
        let (mut differences, mut end) = (HashMap::new(), 0);
        let mut reader = BufReader::new(&file);
        let mut line = vec![];
        while reader.read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
            let place = Place {
                start: end,
                length: line.len(),
            };
            end += line.len() as u64;
            match whole(&line) {
                Some(line) => found.take_line(line, place, key, &mut differences),
                None => found.is_whole = false,
            }
            line.clear();
        }
        file.set_len(end)?;
        file.seek(SeekFrom::End(0))?;
        found.file = Mutex::new(Lines { file, end });
        Ok(found)
    }

    /// Takes in a line of the file. For each older key it is kept how it differs.
    fn take_line(
        &mut self,
        line: &[u8],
        place: Place,
        key: &Key,
        differences: &mut HashMap<u64, Arc<Difference>>,
    ) {
        if let Ok(entry) = serde_json::from_slice::<Entry<Graded>>(line) {
            let (id, work) = (entry.graded.id, entry.work);
            match differences.get(&entry.stamp).cloned() {
                _ if entry.stamp == self.stamp => {
                    self.known.insert(id, (work, place));
                }
                Some(difference) => {
                    let older = Older {
                        work,
                        place,
                        difference,
                    };
                    self.older.insert(id, older);
                }
                None => {}
            }
        } else if let Ok(head) = serde_json::from_slice::<Head>(line) {
            let difference = key.differs_from(&head.told);
            differences.extend(difference.map(|own| (head.stamp, Arc::new(own))));
            if let Some((_, stands)) = self.head.as_mut().filter(|_| head.stamp == self.stamp) {
                *stands = true;
            }
        }
        let end = serde_json::from_slice::<End>(line).ok();
        self.is_whole =
            end.is_some_and(|end| end.stamp == self.stamp && end.students == self.known.len());
    }

    /// Writes the line that stands before the students, unless it is there.
    pub(super) fn begin(&mut self) -> io::Result<()> {
        if let Some((line, stands)) = self.head.as_mut().filter(|(_, stands)| !*stands) {
            let file = self.file.get_mut().unwrap_or_else(PoisonError::into_inner);
            file.add(line.as_bytes())?;
            *stands = true;
        }
        Ok(())
    }

    /// What came of a student's work by an older key, if by this one it is the same.
    pub(super) fn untouched(&self, id: &str, digest: u64, work: &Work) -> Option<Graded> {
        let older = self.older.get(id).filter(|older| older.work == digest)?;
        let same = !older.difference.touches(work);
        same.then(|| self.lines().graded(older.place).ok())?
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
            head: self.head.map(|(line, _)| line),
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
    /// The line before them in a journal.
    head: Option<String>,
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
        let head = None;
        Ok((
            Self {
                head,
                lines,
                places,
            },
            ids,
        ))
    }
}

/// One line of a journal: the object with its digest.
fn line_of(entry: &impl Serialize) -> io::Result<String> {
    let mut line = serde_json::to_string(entry).map_err(io::Error::other)?;
    line.truncate(line.len().saturating_sub(1));
    let end = end_of(line.as_bytes());
    Ok(line + &end + "\n")
}

/// What ends a line that begins so: the digest of this beginning.
fn end_of(beginning: &[u8]) -> String {
    format!(",\"sum\":\"{:016x}\"}}", digest(std::iter::once(beginning)))
}

/// A line without its line break, if it is as it was written.
fn whole(line: &[u8]) -> Option<&[u8]> {
    /// The bytes of what [`end_of`] gives.
    const END: usize = 26;
    let line = line.strip_suffix(b"\n")?;
    let (beginning, end) = line.split_at_checked(line.len().checked_sub(END)?)?;
    (end == end_of(beginning).as_bytes()).then_some(line)
}

/// Puts a journal with these students alone in the place of one: the same whatever the order was in which they were marked.
pub(super) fn replace(path: &Path, students: &Students) -> io::Result<()> {
    output::replace_by(path, |file| {
        let head = students.head.as_deref().unwrap_or_default();
        file.write_all(head.as_bytes())?;
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
