//! Writes a result to the terminal, or to a file in one piece.

use crate::cli::input;
use anstream::{AutoStream, ColorChoice};
use clap::ValueEnum;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// The forms of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Form {
    Text,
    Json,
}

/// The forms of a report that people read or programs take.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum PageForm {
    Text,
    Json,
    Html,
}

/// The forms of a report that is a table of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum TableForm {
    Text,
    Json,
    Csv,
}

/// Says what went wrong and returns the exit code for it.
pub(super) fn failed(error: &str) -> u8 {
    eprintln!("error: {error}");
    2
}

/// Writes a text with terminal colours to standard error, where `color` rules.
pub(super) fn say(text: &str, color: ColorChoice) {
    let mut stream = AutoStream::new(io::stderr().lock(), color);
    // Nothing is left to complain to.
    let _ = stream.write_all(text.as_bytes());
}

/// Writes as [`write()`] does; says what went wrong and returns the exit code for it, or 0.
pub(super) fn deliver(text: &str, out: Option<&Path>, color: ColorChoice) -> u8 {
    match write(text, out, color) {
        Ok(()) => 0,
        Err(error) => {
            let target = out.map_or("standard output".to_owned(), input::name);
            failed(&format!("{target}: {error}"))
        }
    }
}

/// Writes a text with terminal colours to `out`, where they are taken off, or to standard output, where `color` rules.
///
/// A file is complete or not there at all: the text goes to a new file beside it, which then takes its name. A reader
/// of standard output that has heard enough is no error.
fn write(text: &str, out: Option<&Path>, color: ColorChoice) -> io::Result<()> {
    let Some(path) = out else {
        let mut stream = AutoStream::new(io::stdout().lock(), color);
        let done = stream
            .write_all(text.as_bytes())
            .and_then(|()| stream.flush());
        return match done {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            done => done,
        };
    };
    let plain = anstream::adapter::strip_str(text).to_string();
    match fs::metadata(path) {
        Ok(kind) if kind.is_dir() => Err(io::Error::from(io::ErrorKind::IsADirectory)),
        Ok(kind) if !kind.is_file() => fs::write(path, plain),
        // A link stays a link: what it points to is replaced.
        Ok(_) => replace(&fs::canonicalize(path)?, &plain),
        Err(_) => replace(path, &plain),
    }
}

/// Writes a file in one piece: a new file beside it takes its name when it is on the disk.
pub(super) fn replace(path: &Path, text: &str) -> io::Result<()> {
    replace_by(path, |file| file.write_all(text.as_bytes()))
}

/// The same without waiting for the disk, for what can be made again if the power fails.
pub(super) fn replace_unsynced(path: &Path, text: &str) -> io::Result<()> {
    let mut file = begun_again(path)?;
    file.write_all(text.as_bytes())?;
    file.persist(path)?;
    Ok(())
}

/// As [`replace`], by what writes it piece by piece.
pub(super) fn replace_by(
    path: &Path,
    write: impl FnOnce(&mut Replacement) -> io::Result<()>,
) -> io::Result<()> {
    let mut file = Replacement::of(path)?;
    write(&mut file)?;
    file.finish()
}

/// A file under way that takes the place of another when it is finished, and is gone if it never is.
pub(super) struct Replacement {
    file: BufWriter<NamedTempFile>,
    path: PathBuf,
}

impl Replacement {
    /// Of the file at a path, which need not be there.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        Ok(Self {
            file: BufWriter::new(begun(path)?),
            path: path.to_owned(),
        })
    }

    /// Puts it in its place when it is on the disk.
    pub(super) fn finish(self) -> io::Result<()> {
        let file = self.file.into_inner().map_err(io::Error::from)?;
        file.as_file().sync_all()?;
        file.persist(&self.path)?;
        Ok(())
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A new file beside one whose name it will take.
fn begun(path: &Path) -> io::Result<NamedTempFile> {
    builder().tempfile_in(folder_of(path))
}

/// No file system takes longer names.
const LONGEST_NAME: usize = 255;

/// The same under a name that tells whose place it will take: what a run leaves that is killed, the next one takes away.
fn begun_again(path: &Path) -> io::Result<NamedTempFile> {
    let name = path.file_name().and_then(|name| name.to_str());
    let name = name.map(|name| format!(".{name}.part"));
    let Some(name) = name.filter(|name| name.len() <= LONGEST_NAME) else {
        return begun(path);
    };
    let folder = folder_of(path);
    let begin = || -> io::Result<NamedTempFile> {
        let mut builder: tempfile::Builder<'_, '_> = builder();
        builder.prefix(&name).rand_bytes(0).tempfile_in(&folder)
    };
    match begin() {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            fs::remove_file(folder.join(&name))?;
            begin()
        }
        begun => begun,
    }
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

#[cfg(unix)]
pub(super) fn builder() -> tempfile::Builder<'static, 'static> {
    use std::os::unix::fs::PermissionsExt;
    let mut builder = tempfile::Builder::new();
    // As for any new file; the user's mask still takes its part away.
    builder.permissions(fs::Permissions::from_mode(0o666));
    builder
}

#[cfg(not(unix))]
pub(super) fn builder() -> tempfile::Builder<'static, 'static> {
    tempfile::Builder::new()
}
