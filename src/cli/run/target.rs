//! Where a long result goes: the terminal, or a file that is complete or not there.

use crate::cli::output;
use std::fs;
use std::io::{self, BufWriter, StdoutLock, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Bytes that are gathered before they are handed on.
const BUFFER: usize = 1 << 16;

pub(super) enum Target {
    Stdout(BufWriter<StdoutLock<'static>>),
    /// A new file beside the one that it will replace.
    File(BufWriter<NamedTempFile>, PathBuf),
    /// A device or a pipe, which has no name to take.
    Device(BufWriter<fs::File>),
}

impl Target {
    pub(super) fn open(out: Option<&Path>) -> io::Result<Self> {
        let Some(path) = out else {
            let stdout = BufWriter::with_capacity(BUFFER, io::stdout().lock());
            return Ok(Self::Stdout(stdout));
        };
        // A link stays a link: what it points to is replaced.
        let path = match fs::metadata(path) {
            Ok(kind) if kind.is_dir() => return Err(io::Error::from(io::ErrorKind::IsADirectory)),
            Ok(kind) if !kind.is_file() => {
                let device = fs::OpenOptions::new().write(true).open(path)?;
                return Ok(Self::Device(BufWriter::with_capacity(BUFFER, device)));
            }
            Ok(_) => fs::canonicalize(path)?,
            Err(_) => path.to_owned(),
        };
        let folder = match path.parent() {
            Some(parent) if parent != Path::new("") => parent.to_owned(),
            _ => PathBuf::from("."),
        };
        let file = output::builder().tempfile_in(folder)?;
        Ok(Self::File(BufWriter::with_capacity(BUFFER, file), path))
    }

    /// Everything is written: the file takes its name.
    pub(super) fn close(self) -> io::Result<()> {
        match self {
            Self::Stdout(mut stdout) => stdout.flush(),
            Self::Device(mut device) => device.flush(),
            Self::File(file, path) => {
                let file = file.into_inner().map_err(io::IntoInnerError::into_error)?;
                file.as_file().sync_all()?;
                file.persist(path)?;
                Ok(())
            }
        }
    }
}

impl Write for Target {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(stdout) => stdout.write(bytes),
            Self::Device(device) => device.write(bytes),
            Self::File(file, _) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(stdout) => stdout.flush(),
            Self::Device(device) => device.flush(),
            Self::File(file, _) => file.flush(),
        }
    }
}
