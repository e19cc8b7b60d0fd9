//! The submissions in a folder: one file or one folder for each student.
//!
//! Nothing here follows a link, opens a device, or reads more than a submission may have.

use crate::cli::grade::journal::digest;
use crate::grade::{Text, Work};
use crate::notation::document::Format;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// What one student may hand in, in bytes.
const MOST_BYTES: u64 = 1 << 20;

/// Files of one student, and how deep folders may stand in each other.
const MOST_FILES: usize = 50;
const DEEPEST: usize = 5;

/// The longest id.
const LONGEST_ID: usize = 120;

/// Endings of files that are read.
const ENDINGS: [&str; 9] = [
    "md", "markdown", "tex", "ltx", "latex", "ipynb", "txt", "text", "mkd",
];

/// What a student hands in, not read yet.
#[derive(Debug, Default)]
pub(super) struct Pending {
    /// The student.
    pub(super) id: String,
    /// The files with the names under which they are reported.
    files: Vec<(String, PathBuf)>,
    /// What is wrong with how it was handed in.
    troubles: Vec<String>,
}

/// The submissions of a folder, in the order of their ids. Names that begin with a dot are left out.
pub(super) fn pending(folder: &Path) -> io::Result<Vec<Pending>> {
    let mut entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(fs::DirEntry::file_name);
    let mut found: BTreeMap<String, Pending> = BTreeMap::new();
    for entry in entries {
        let name = entry.file_name();
        if name.as_encoded_bytes().starts_with(b".") {
            continue;
        }
        let kind = fs::symlink_metadata(entry.path())?.file_type();
        let stem = match kind.is_dir() {
            true => name.to_string_lossy().into_owned(),
            false => Path::new(&name)
                .file_stem()
                .unwrap_or(&name)
                .to_string_lossy()
                .into_owned(),
        };
        let id = escaped(&stem);
        let mut troubles = vec![];
        if id != stem || name.to_str().is_none() {
            troubles.push("its name has characters that an id can't have".to_owned());
        }
        let known = found.contains_key(&id);
        let one = found.entry(id.clone()).or_insert_with(|| Pending {
            id,
            ..Pending::default()
        });
        if known {
            troubles.push("several files or folders have this id".to_owned());
        }
        one.troubles.extend(troubles);
        one.add(&entry.path(), &name.to_string_lossy(), 0);
    }
    Ok(found.into_values().collect())
}

impl Pending {
    /// Takes in a file, or all files of a folder.
    fn add(&mut self, path: &Path, name: &str, depth: usize) {
        let name = &shown(name);
        let kind = match fs::symlink_metadata(path) {
            Ok(kind) => kind.file_type(),
            Err(error) => return self.troubles.push(format!("{name}: {error}")),
        };
        if kind.is_symlink() {
            self.troubles
                .push(format!("{name} is a link, which is not followed"));
        } else if kind.is_dir() && depth >= DEEPEST {
            self.troubles
                .push(format!("{name}: folders stand too deep in each other"));
        } else if kind.is_dir() {
            self.add_folder(path, name, depth);
        } else if !kind.is_file() {
            self.troubles.push(format!("{name} is no regular file"));
        } else if self.files.len() >= MOST_FILES {
            let many = format!("more than {MOST_FILES} files are not read");
            if !self.troubles.contains(&many) {
                self.troubles.push(many);
            }
        } else if !is_read(path) {
            self.troubles
                .push(format!("{name} is no kind of file that is read"));
        } else {
            self.files.push((name.clone(), path.to_owned()));
        }
    }

    fn add_folder(&mut self, path: &Path, name: &str, depth: usize) {
        let entries = fs::read_dir(path).and_then(Iterator::collect::<io::Result<Vec<_>>>);
        let mut entries = match entries {
            Ok(entries) => entries,
            Err(error) => return self.troubles.push(format!("{name}: {error}")),
        };
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            let own = entry.file_name();
            if self.troubles.len() > MOST_FILES || own.as_encoded_bytes().starts_with(b".") {
                continue;
            }
            let inside = match depth {
                0 => own.to_string_lossy().into_owned(),
                _ => format!("{name}/{}", own.to_string_lossy()),
            };
            self.add(&entry.path(), &inside, depth + 1);
        }
    }

    /// Reads the files.
    ///
    /// # Errors
    ///
    /// Why none of it can be marked, in one clause.
    pub(super) fn read(&self) -> Result<Work, String> {
        let mut texts = vec![];
        let mut troubles = self.troubles.clone();
        let mut left = MOST_BYTES;
        for (name, path) in &self.files {
            match text(path, left) {
                Ok(text) => {
                    left = left.saturating_sub(text.len() as u64);
                    texts.push(Text {
                        name: name.clone(),
                        format: Format::of_path(path),
                        text,
                    });
                }
                Err(reason) => troubles.push(format!("{name} {reason}")),
            }
        }
        if texts.is_empty() && !troubles.is_empty() {
            return Err(troubles.join("; "));
        }
        Ok(Work {
            id: self.id.clone(),
            texts,
            troubles,
        })
    }
}

fn is_read(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_none_or(|ending| ENDINGS.contains(&ending.to_ascii_lowercase().as_str()))
}

/// The text of a file of no more than some bytes.
fn text(path: &Path, most: u64) -> Result<String, String> {
    let mut bytes = vec![];
    let read = File::open(path).and_then(|file| file.take(most + 1).read_to_end(&mut bytes));
    read.map_err(|error| format!("can't be read: {error}"))?;
    if bytes.len() as u64 > most {
        return Err(format!(
            "is too large: a submission may have {} kB",
            MOST_BYTES >> 10
        ));
    }
    if bytes.contains(&0) {
        return Err("is no text: there is a NUL in it".to_owned());
    }
    if bytes.starts_with("\u{feff}".as_bytes()) {
        bytes.drain(..3);
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        format!("is not UTF-8: the byte at offset {at} fits nowhere")
    })
}

/// An id without characters that hide or move others, and without those that paths are made of.
fn escaped(name: &str) -> String {
    let mut id = String::new();
    for c in name.chars() {
        let harmless = c.is_alphanumeric() || "-_.@+ ,()[]'=~".contains(c);
        match harmless && id.len() < LONGEST_ID {
            true => id.push(c),
            false if id.len() < LONGEST_ID => id.push_str(&format!("%{:X}", u32::from(c))),
            false => {}
        }
    }
    match id.is_empty() {
        true => "%".to_owned(),
        false => id,
    }
}

/// A name as it is shown in a reason.
fn shown(name: &str) -> String {
    let shown = name
        .chars()
        .map(|c| if c.is_control() { '\u{fffd}' } else { c });
    shown.take(LONGEST_ID).collect()
}

/// Names that some systems keep for devices.
const RESERVED: [&str; 22] = [
    "con", "prn", "aux", "nul", "com1", "com2", "com3", "com4", "com5", "com6", "com7", "com8",
    "com9", "lpt1", "lpt2", "lpt3", "lpt4", "lpt5", "lpt6", "lpt7", "lpt8", "lpt9",
];

/// The name of a student's files: plain characters, and no name of a device.
pub(super) fn file_stem(id: &str) -> String {
    let mut stem = String::new();
    for byte in id.bytes() {
        match byte {
            b'-' | b'_' | b'.' | b'@' | b'+' => stem.push(char::from(byte)),
            _ if byte.is_ascii_alphanumeric() => stem.push(char::from(byte)),
            _ => stem.push_str(&format!("%{byte:02X}")),
        }
    }
    let first = stem.split('.').next().unwrap_or("").to_ascii_lowercase();
    let plain =
        !stem.starts_with('.') && !stem.ends_with('.') && !RESERVED.contains(&first.as_str());
    match plain && stem.len() <= LONGEST_ID {
        true => stem,
        false => {
            let start: String = stem.trim_matches('.').chars().take(LONGEST_ID).collect();
            format!("_{start}-{:016x}", digest([id.as_bytes()].into_iter()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_harmless() {
        assert_eq!(file_stem("s017"), "s017");
        for id in [
            "../../etc/passwd",
            "con",
            "aux.x",
            "..",
            "<script>",
            "a/b",
            &"x".repeat(400),
        ] {
            let stem = file_stem(id);
            assert!(
                stem.len() < 200 && !stem.contains(['/', '\\', '<', '>']),
                "{stem}"
            );
            assert!(!stem.starts_with('.'), "{stem}");
        }
    }

    #[test]
    fn an_id_hides_nothing() {
        assert_eq!(escaped("ada"), "ada");
        assert_eq!(escaped("a\u{202e}b"), "a%202Eb");
        assert_eq!(escaped("a\nb"), "a%Ab");
    }
}
