//! Zip archives: what is in them by name, before anything is unpacked.

use crate::cli::grade::names::shown;
use std::fs::File;
use std::io::{self, Read, Seek};
use std::path::{Component, Path};
use std::sync::{Mutex, PoisonError};
use zip::ZipArchive;

/// Members of the archive of one student that are looked at.
const MOST_MEMBERS: usize = 1000;

/// A file in an archive.
pub(super) struct Member {
    pub(super) number: usize,
    /// Its path, with slashes.
    pub(super) path: String,
    /// Why it is not read, where it is not.
    pub(super) trouble: Option<String>,
}

/// The archive of a whole class.
#[derive(Debug)]
pub(super) struct Packed {
    archive: Mutex<ZipArchive<File>>,
}

impl Packed {
    pub(super) fn open(path: &Path) -> io::Result<Self> {
        let archive = ZipArchive::new(File::open(path)?).map_err(|error| match error {
            zip::result::ZipError::Io(error) => error,
            _ => io::Error::other("is neither a folder nor a zip archive"),
        })?;
        Ok(Self {
            archive: Mutex::new(archive),
        })
    }

    /// Its files, in the order of their paths.
    pub(super) fn members(&self) -> io::Result<Vec<Member>> {
        let mut archive = self.archive.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(all_members(&mut archive, usize::MAX))
    }

    /// Lets a reader have the bytes of a member. One reads at a time.
    pub(super) fn read(&self, number: usize, reader: impl FnOnce(&mut dyn Read)) -> io::Result<()> {
        let mut archive = self.archive.lock().unwrap_or_else(PoisonError::into_inner);
        let mut file = archive.by_index(number).map_err(io::Error::other)?;
        reader(&mut file);
        Ok(())
    }
}

/// The files of the archive of one student, in the order of their paths.
pub(super) fn members<R: Read + Seek>(archive: &mut ZipArchive<R>) -> Vec<Member> {
    let mut members = all_members(archive, MOST_MEMBERS);
    if archive.len() > MOST_MEMBERS {
        members.push(Member {
            number: 0,
            path: "the archive".to_owned(),
            trouble: Some(format!(
                "has more than {MOST_MEMBERS} members; the others are not looked at"
            )),
        });
    }
    members
}

fn all_members<R: Read + Seek>(archive: &mut ZipArchive<R>, most: usize) -> Vec<Member> {
    let mut members: Vec<Member> = (0..archive.len().min(most))
        .filter_map(|number| member(archive, number))
        .collect();
    members.sort_by(|a, b| a.path.cmp(&b.path));
    members
}

/// A member by its number; none for a folder and for what a system puts in for itself.
fn member<R: Read + Seek>(archive: &mut ZipArchive<R>, number: usize) -> Option<Member> {
    let file = match archive.by_index_raw(number) {
        Ok(file) => file,
        Err(error) => {
            return Some(Member {
                number,
                path: format!("member {}", number + 1),
                trouble: Some(format!("can't be read: {error}")),
            });
        }
    };
    let name = match file.name() {
        Ok(name) => name.into_owned(),
        Err(_) => String::from_utf8_lossy(file.name_raw()).into_owned(),
    };
    let (trouble, path) = match safe_path(&name) {
        None => (
            Some("leads out of the archive, and is not read".to_owned()),
            shown(&name).replace('/', "\u{2215}"),
        ),
        Some(path) if file.is_symlink() => {
            (Some("is a link, which is not followed".to_owned()), path)
        }
        Some(path) if file.encrypted() => {
            (Some("is encrypted, and can't be read".to_owned()), path)
        }
        Some(path) => (None, path),
    };
    let hidden = path
        .split('/')
        .any(|part| part.starts_with('.') || part == "__MACOSX");
    (!file.is_dir() && (!hidden || trouble.is_some())).then_some(Member {
        number,
        path,
        trouble,
    })
}

/// A path that stays in the archive, with slashes; none where it leads out of it.
fn safe_path(name: &str) -> Option<String> {
    let name = name.replace('\\', "/");
    let mut parts = vec![];
    for part in Path::new(&name).components() {
        match part {
            Component::Normal(part) => parts.push(part.to_string_lossy().into_owned()),
            Component::CurDir => {}
            _ => return None,
        }
    }
    let drive = parts.first().is_some_and(|first| first.ends_with(':'));
    (!parts.is_empty() && !drive && !name.contains('\0')).then(|| parts.join("/"))
}
