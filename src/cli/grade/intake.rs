//! Reads what one student hands in, within bounds that hold whatever it is.

use crate::cli::grade::archive::{self, Member};
use crate::grade::{Text, Work};
use crate::notation::document::Format;
use std::io::{Cursor, Read, Seek};
use std::path::Path;
use zip::ZipArchive;

/// What one student may hand in, in bytes of text.
const MOST_BYTES: u64 = 1 << 20;

/// Most texts have no more bytes, and are read at once.
const USUAL: usize = 8 << 10;

/// The largest archive that is opened, in bytes.
const MOST_PACKED: u64 = 8 << 20;

/// Files of one student.
pub(super) const MOST_FILES: usize = 50;

/// Endings of files that are read.
const ENDINGS: [&str; 10] = [
    "md", "markdown", "tex", "ltx", "latex", "ipynb", "txt", "text", "mkd", "rst",
];

/// What was read so far.
pub(super) struct Intake {
    texts: Vec<Text>,
    troubles: Vec<String>,
    left: u64,
    files: usize,
}

impl Intake {
    pub(super) fn new(troubles: Vec<String>) -> Self {
        Self {
            texts: vec![],
            troubles,
            left: MOST_BYTES,
            files: 0,
        }
    }

    pub(super) fn complain(&mut self, trouble: String) {
        if self.troubles.len() <= MOST_FILES && !self.troubles.contains(&trouble) {
            self.troubles.push(trouble);
        }
    }

    /// Reads a file of text.
    pub(super) fn text(&mut self, name: &str, reader: impl Read) {
        if self.files >= MOST_FILES {
            return self.complain(format!("more than {MOST_FILES} files are not read"));
        }
        self.files += 1;
        if !is_read(name) {
            return self.complain(format!("{name} is no kind of file that is read"));
        }
        match text(reader, self.left) {
            Ok(text) => {
                self.left = self.left.saturating_sub(text.len() as u64);
                self.texts.push(Text {
                    name: name.to_owned(),
                    format: Format::of_path(Path::new(name)),
                    text,
                });
            }
            Err(reason) => self.complain(format!("{name} {reason}")),
        }
    }

    /// Reads the files in an archive, whose names follow `folder`.
    pub(super) fn archive(&mut self, folder: &str, mut reader: impl Read + Seek) {
        let size = reader
            .seek(std::io::SeekFrom::End(0))
            .and_then(|size| reader.rewind().map(|()| size));
        let opened = match size {
            Err(error) => Err(error.to_string()),
            Ok(size) if size > MOST_PACKED => Err(format!(
                "it is too large: an archive may have {} MB",
                MOST_PACKED >> 20
            )),
            Ok(_) => ZipArchive::new(reader).map_err(|error| error.to_string()),
        };
        let mut opened = match opened {
            Ok(opened) => opened,
            Err(reason) => return self.complain(format!("the archive can't be opened: {reason}")),
        };
        for member in archive::members(&mut opened) {
            self.member(folder, member, &mut opened);
        }
    }

    /// Reads the files in an archive that is a member of another.
    pub(super) fn archive_within(&mut self, folder: &str, reader: impl Read) {
        let mut bytes = vec![];
        match reader.take(MOST_PACKED + 1).read_to_end(&mut bytes) {
            Ok(_) => self.archive(folder, Cursor::new(bytes)),
            Err(error) => self.complain(format!("an archive can't be read: {error}")),
        }
    }

    fn member<R: Read + Seek>(&mut self, folder: &str, member: Member, of: &mut ZipArchive<R>) {
        let name = match folder.is_empty() {
            true => member.path,
            false => format!("{folder}/{}", member.path),
        };
        if let Some(trouble) = member.trouble {
            return self.complain(format!("{name} {trouble}"));
        }
        if is_archive(&name) {
            return self.complain(format!(
                "{name} is an archive in an archive, which is not opened"
            ));
        }
        match of.by_index(member.number) {
            Ok(file) => self.text(&name, file),
            Err(error) => self.complain(format!("{name} can't be read: {error}")),
        }
    }

    /// The work of the student.
    ///
    /// # Errors
    ///
    /// Why none of it can be marked, in one clause.
    pub(super) fn work(self, id: &str) -> Result<Work, String> {
        if self.texts.is_empty() && !self.troubles.is_empty() {
            return Err(self.troubles.join("; "));
        }
        Ok(Work {
            id: id.to_owned(),
            texts: self.texts,
            troubles: self.troubles,
            answers: vec![],
        })
    }
}

/// Whether a name is that of an archive that can be opened.
pub(super) fn is_archive(name: &str) -> bool {
    ending(name).is_some_and(|ending| ending == "zip")
}

fn is_read(name: &str) -> bool {
    ending(name).is_none_or(|ending| ENDINGS.contains(&ending.as_str()))
}

fn ending(name: &str) -> Option<String> {
    let ending = Path::new(name).extension()?;
    Some(ending.to_string_lossy().to_ascii_lowercase())
}

/// The text of a file of no more than some bytes.
fn text(reader: impl Read, most: u64) -> Result<String, String> {
    let mut bytes = Vec::with_capacity(USUAL);
    let read = reader.take(most + 1).read_to_end(&mut bytes);
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
