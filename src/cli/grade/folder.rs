//! The submissions in a folder or in an archive: one file, one archive or one folder for each student.
//!
//! Nothing here follows a link, opens a device, or writes what it unpacks.

use crate::cli::grade::archive::Packed;
use crate::cli::grade::intake::{Intake, MOST_FILES, is_archive};
use crate::cli::grade::names::{Naming, shown};
use crate::grade::Work;
use std::collections::BTreeMap;
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
    /// The names that stand for the student.
    names: Vec<String>,
}

/// The submissions of a folder or of an archive, in the order of their ids. Names that begin with a dot are left out.
pub(super) fn pending(path: &Path, naming: &Naming) -> io::Result<Vec<Pending>> {
    let mut found = Found {
        naming,
        students: BTreeMap::new(),
    };
    match fs::metadata(path)?.is_dir() {
        true => found.in_folder(path)?,
        false => found.in_archive(path)?,
    }
    found.tell_apart();
    let students = found.students.into_values().map(|mut student| {
        student.names = vec![];
        student.pieces.shrink_to_fit();
        student
    });
    Ok(students.collect())
}

/// The students found so far.
struct Found<'n> {
    naming: &'n Naming,
    students: BTreeMap<String, Pending>,
}

impl Found<'_> {
    fn in_folder(&mut self, folder: &Path) -> io::Result<()> {
        let mut entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            let name = entry.file_name();
            if name.as_encoded_bytes().starts_with(b".") {
                continue;
            }
            let is_folder = fs::symlink_metadata(entry.path())?.is_dir();
            let text = name.to_string_lossy();
            let student = self.student(&text, is_folder);
            if name.to_str().is_none() {
                student.complain("its name is not UTF-8".to_owned());
            }
            student.add(&entry.path(), &text, 0);
        }
        Ok(())
    }

    /// Each member stands with the student whose name its path begins with.
    fn in_archive(&mut self, path: &Path) -> io::Result<()> {
        let packed = Arc::new(Packed::open(path)?);
        for member in packed.members()? {
            let (student, inside) = match member.path.split_once('/') {
                Some((student, inside)) => (self.student(student, true), inside),
                None => (self.student(&member.path, false), member.path.as_str()),
            };
            match member.trouble {
                Some(trouble) => student.complain(format!("{} {trouble}", shown(inside))),
                None => student.pieces.push(Piece {
                    name: shown(inside),
                    content: Content::Packed(Arc::clone(&packed), member.number),
                }),
            }
        }
        Ok(())
    }

    /// Sends to a person the students whose ids differ in capitals alone: to some systems and platforms they are one.
    fn tell_apart(&mut self) {
        let mut alike: BTreeMap<String, usize> = BTreeMap::new();
        for id in self.students.keys() {
            *alike.entry(id.to_lowercase()).or_default() += 1;
        }
        for (id, student) in &mut self.students {
            if alike.get(&id.to_lowercase()).is_some_and(|&ids| ids > 1) {
                student.complain("another id differs from this one in capitals alone".to_owned());
            }
        }
    }

    /// The student for whom a name stands.
    fn student(&mut self, name: &str, is_folder: bool) -> &mut Pending {
        let (id, trouble) = self.naming.id(name, is_folder);
        let student = self.students.entry(id.clone()).or_insert_with(|| Pending {
            id,
            ..Pending::default()
        });
        if !student.names.iter().any(|known| known == name) {
            if !student.names.is_empty() && !self.naming.joins() {
                student.complain("several files or folders have this id".to_owned());
            }
            student.names.push(name.to_owned());
            trouble
                .into_iter()
                .for_each(|trouble| student.complain(trouble));
        }
        student
    }
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
