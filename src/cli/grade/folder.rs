//! The submissions in a folder or in an archive: one file, one archive or one folder for each student.
//!
//! Nothing here follows a link, opens a device, or writes what it unpacks.

use crate::cli::grade::archive::Packed;
use crate::cli::grade::intake::{Intake, MOST_FILES, is_archive};
use crate::cli::grade::names::{Naming, shown};
use crate::grade::Work;
use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How deep folders may stand in each other.
const DEEPEST: usize = 5;

/// Where something that was handed in stands.
#[derive(Debug)]
enum Content {
    File(PathBuf),
    /// A member of the archive of the whole class, by its number.
    Packed(Arc<Packed>, usize),
}

/// A file, with the name under which it is reported.
#[derive(Debug)]
struct Piece {
    name: String,
    content: Content,
}

/// What a student hands in, not read yet.
#[derive(Debug, Default)]
pub(super) struct Pending {
    /// The student.
    pub(super) id: String,
    pieces: Vec<Piece>,
    /// What is wrong with how it was handed in.
    troubles: Vec<String>,
}

/// A name in the folder or in the archive of a class.
#[derive(Debug)]
struct Entry {
    /// In an archive it is the path of a member.
    name: Box<OsStr>,
    kind: EntryKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EntryKind {
    File,
    Folder,
    /// A member of the archive, by its number.
    Member(u32),
}

/// Where the submissions of a class stand.
#[derive(Debug)]
enum Place {
    Folder(PathBuf),
    /// An archive, with what is wrong with members of it.
    Archive(Arc<Packed>, BTreeMap<u32, String>),
}

/// The submissions of a class, in the order of their ids. Only names are kept of them: a class of any size takes little
/// memory, and what stands for a student is looked up when it is that student's turn.
#[derive(Debug)]
pub(super) struct HandedIn<'n> {
    naming: &'n Naming,
    place: Place,
    /// By their ids; those of one student in the order of names.
    entries: Vec<Entry>,
    /// The first entry of each student.
    students: Vec<u32>,
    /// Ids in small letters that several students have.
    alike: BTreeSet<String>,
}

impl<'n> HandedIn<'n> {
    /// The submissions of a folder or of an archive. Names that begin with a dot are left out.
    pub(super) fn find(path: &Path, naming: &'n Naming) -> io::Result<Self> {
        let (place, entries) = match fs::metadata(path)?.is_dir() {
            true => (Place::Folder(path.to_owned()), entries_of_folder(path)?),
            false => entries_of_archive(path)?,
        };
        let mut found = Self {
            naming,
            place,
            entries,
            students: vec![],
            alike: BTreeSet::new(),
        };
        found.sort();
        Ok(found)
    }

    /// Sorts the entries by ids and notes where each student begins. Students whose ids differ in capitals alone are one to
    /// some systems and platforms.
    fn sort(&mut self) {
        let (naming, mut entries) = (self.naming, std::mem::take(&mut self.entries));
        entries.sort_by(|a, b| a.name.cmp(&b.name));
        entries.sort_by_cached_key(|entry| entry.id(naming).0);
        entries.shrink_to_fit();
        let mut last = None;
        for (at, entry) in entries.iter().enumerate() {
            let id = entry.id(naming).0;
            if last.as_ref() != Some(&id) {
                self.students.push(at as u32);
                last = Some(id);
            }
        }
        self.entries = entries;
        let ids = (0..self.len()).map(|at| self.id(at).to_lowercase());
        let mut ids: Vec<String> = ids.collect();
        ids.sort_unstable();
        let alike = ids.windows(2).filter(|two| two[0] == two[1]);
        self.alike = alike.map(|two| two[0].clone()).collect();
    }

    /// How many students there are.
    pub(super) fn len(&self) -> usize {
        self.students.len()
    }

    fn entries_of(&self, student: usize) -> &[Entry] {
        let begins = |at: usize| self.students.get(at).map(|&at| at as usize);
        let end = begins(student + 1).unwrap_or(self.entries.len());
        &self.entries[begins(student).unwrap_or(end)..end]
    }

    fn id(&self, student: usize) -> String {
        let first = self.entries_of(student).first();
        first.map_or(String::new(), |entry| entry.id(self.naming).0)
    }

    /// The ids of all students, in their order.
    pub(super) fn ids(&self) -> impl Iterator<Item = String> {
        (0..self.len()).map(|at| self.id(at))
    }

    /// What a student hands in, by the place among all students.
    pub(super) fn student(&self, at: usize) -> Pending {
        let mut student = Pending {
            id: self.id(at),
            ..Pending::default()
        };
        let mut last: Option<String> = None;
        for entry in self.entries_of(at) {
            let text = entry.name.to_string_lossy();
            let name = entry.of_student(&text);
            if last.as_deref() != Some(name) {
                if last.is_some() && !self.naming.joins() {
                    student.complain("several files or folders have this id".to_owned());
                }
                let trouble = entry.id(self.naming).1;
                trouble
                    .into_iter()
                    .for_each(|trouble| student.complain(trouble));
                last = Some(name.to_owned());
            }
            self.add(entry, &text, &mut student);
        }
        if self.alike.contains(&student.id.to_lowercase()) {
            student.complain("another id differs from this one in capitals alone".to_owned());
        }
        student
    }

    /// Adds the pieces that an entry stands for.
    fn add(&self, entry: &Entry, text: &str, to: &mut Pending) {
        match (&self.place, entry.kind) {
            (Place::Folder(folder), EntryKind::File | EntryKind::Folder) => {
                if entry.name.to_str().is_none() {
                    to.complain("its name is not UTF-8".to_owned());
                }
                to.add(&folder.join(&*entry.name), text, 0);
            }
            (Place::Archive(packed, troubles), EntryKind::Member(number)) => {
                let inside = text.split_once('/').map_or(text, |(_, inside)| inside);
                match troubles.get(&number) {
                    Some(trouble) => to.complain(format!("{} {trouble}", shown(inside))),
                    None => to.pieces.push(Piece {
                        name: shown(inside),
                        content: Content::Packed(Arc::clone(packed), number as usize),
                    }),
                }
            }
            _ => {}
        }
    }
}

impl Entry {
    /// The id of the student for whom it stands, and what is wrong with its name.
    fn id(&self, naming: &Naming) -> (String, Option<String>) {
        let text = self.name.to_string_lossy();
        let is_folder = match self.kind {
            EntryKind::File => false,
            EntryKind::Folder => true,
            EntryKind::Member(_) => text.contains('/'),
        };
        naming.id(self.of_student(&text), is_folder)
    }

    /// The part of its name that stands for the student: of a path in an archive, the first.
    fn of_student<'t>(&self, text: &'t str) -> &'t str {
        match self.kind {
            EntryKind::Member(_) => text.split_once('/').map_or(text, |(student, _)| student),
            _ => text,
        }
    }
}

fn entries_of_folder(folder: &Path) -> io::Result<Vec<Entry>> {
    let mut entries = vec![];
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name();
        if name.as_encoded_bytes().starts_with(b".") {
            continue;
        }
        let kind = match entry.file_type()?.is_dir() {
            true => EntryKind::Folder,
            false => EntryKind::File,
        };
        let name = name.into_boxed_os_str();
        entries.push(Entry { name, kind });
    }
    Ok(entries)
}

/// Each member stands with the student whose name its path begins with.
fn entries_of_archive(path: &Path) -> io::Result<(Place, Vec<Entry>)> {
    let packed = Packed::open(path)?;
    let (mut entries, mut troubles) = (vec![], BTreeMap::new());
    for member in packed.members()? {
        let number = u32::try_from(member.number).map_err(io::Error::other)?;
        troubles.extend(member.trouble.map(|trouble| (number, trouble)));
        entries.push(Entry {
            name: OsString::from(member.path).into_boxed_os_str(),
            kind: EntryKind::Member(number),
        });
    }
    Ok((Place::Archive(Arc::new(packed), troubles), entries))
}

impl Pending {
    /// Says once what is wrong. More than one for each file is not said.
    pub(super) fn complain(&mut self, trouble: String) {
        if self.troubles.len() <= MOST_FILES && !self.troubles.contains(&trouble) {
            self.troubles.push(trouble);
        }
    }

    /// Takes in a file, or all files of a folder.
    fn add(&mut self, path: &Path, name: &str, depth: usize) {
        let name = &shown(name);
        let kind = match fs::symlink_metadata(path) {
            Ok(kind) => kind.file_type(),
            Err(error) => return self.complain(format!("{name}: {error}")),
        };
        if kind.is_symlink() {
            self.complain(format!("{name} is a link, which is not followed"));
        } else if kind.is_dir() && depth >= DEEPEST {
            self.complain(format!("{name}: folders stand too deep in each other"));
        } else if kind.is_dir() {
            self.add_folder(path, name, depth);
        } else if !kind.is_file() {
            self.complain(format!("{name} is no regular file"));
        } else if self.pieces.len() > MOST_FILES {
            // One more than is read: the reader says that there are more.
        } else {
            self.pieces.push(Piece {
                name: name.clone(),
                content: Content::File(path.to_owned()),
            });
        }
    }

    fn add_folder(&mut self, path: &Path, name: &str, depth: usize) {
        let entries = fs::read_dir(path).and_then(Iterator::collect::<io::Result<Vec<_>>>);
        let mut entries = match entries {
            Ok(entries) => entries,
            Err(error) => return self.complain(format!("{name}: {error}")),
        };
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            let own = entry.file_name();
            if own.as_encoded_bytes().starts_with(b".") {
                continue;
            }
            let inside = match depth {
                0 => own.to_string_lossy().into_owned(),
                _ => format!("{name}/{}", own.to_string_lossy()),
            };
            self.add(&entry.path(), &inside, depth + 1);
        }
    }

    /// Reads the files, and those in archives.
    ///
    /// # Errors
    ///
    /// Why none of it can be marked, in one clause.
    pub(super) fn read(&self) -> Result<Work, String> {
        let mut intake = Intake::new(self.troubles.clone());
        for piece in &self.pieces {
            // The name of a lone archive tells nothing beside the names in it.
            let is_lone = self.pieces.len() == 1 && is_archive(&piece.name);
            let name = if is_lone { "" } else { &piece.name };
            let done = match &piece.content {
                Content::File(path) => File::open(path).map(|file| match is_archive(&piece.name) {
                    true => intake.archive(name, file),
                    false => intake.text(&piece.name, file),
                }),
                Content::Packed(packed, number) => {
                    packed.read(*number, |file| match is_archive(&piece.name) {
                        true => intake.archive_within(name, file),
                        false => intake.text(&piece.name, file),
                    })
                }
            };
            if let Err(error) = done {
                intake.complain(format!("{} can't be read: {error}", piece.name));
            }
        }
        intake.work(&self.id)
    }
}
