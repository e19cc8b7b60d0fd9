//! Reads an input, and says clearly why one can't be read.

use std::fmt;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// The largest input that is read, in bytes.
const LIMIT: u64 = 64 << 20;

/// Why an input could not be read.
#[derive(Debug)]
pub(super) enum InputError {
    /// The system refused it.
    Io(io::Error),
    /// A folder.
    Directory,
    /// A device, a pipe or a socket.
    NotAFile,
    /// More than [`LIMIT`] bytes.
    TooLarge,
    /// Not UTF-8, from this byte on.
    NotUtf8(usize),
    /// Text in the two-byte encoding that some editors write.
    Utf16,
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) if error.kind() == io::ErrorKind::NotFound => {
                f.write_str("there is no such file")
            }
            Self::Io(error) => write!(f, "{error}"),
            Self::Directory => f.write_str("is a directory; name the files in it"),
            Self::NotAFile => {
                f.write_str("is no regular file; send it through standard input, as `-`")
            }
            Self::TooLarge => write!(f, "is larger than {} MB", LIMIT >> 20),
            Self::NotUtf8(byte) => {
                write!(f, "is not UTF-8: the byte at offset {byte} fits nowhere")
            }
            Self::Utf16 => f.write_str("is UTF-16; save it as UTF-8"),
        }
    }
}

impl std::error::Error for InputError {}

impl From<io::Error> for InputError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// The text of a file, or of standard input where the path is `-`.
pub(super) fn read(path: &Path) -> Result<String, InputError> {
    text(bytes(path)?)
}

/// The same with a byte order mark, where there is one.
pub(super) fn read_with_mark(path: &Path) -> Result<String, InputError> {
    let bytes = bytes(path)?;
    let mark = match bytes.starts_with("\u{feff}".as_bytes()) {
        true => "\u{feff}",
        false => "",
    };
    Ok(format!("{mark}{}", text(bytes)?))
}

fn bytes(path: &Path) -> Result<Vec<u8>, InputError> {
    let mut bytes = Vec::new();
    if path.as_os_str() == "-" {
        io::stdin().lock().take(LIMIT + 1).read_to_end(&mut bytes)?;
    } else {
        // Looked at before it is opened: to open a pipe would wait for its writer.
        let kind = fs::metadata(path)?;
        if kind.is_dir() {
            return Err(InputError::Directory);
        }
        if !kind.is_file() {
            return Err(InputError::NotAFile);
        }
        if kind.len() > LIMIT {
            return Err(InputError::TooLarge);
        }
        File::open(path)?.take(LIMIT + 1).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// The name under which an input is reported.
pub(super) fn name(path: &Path) -> String {
    if path.as_os_str() == "-" {
        return "<stdin>".to_owned();
    }
    path.to_string_lossy().into_owned()
}

fn text(mut bytes: Vec<u8>) -> Result<String, InputError> {
    if bytes.len() as u64 > LIMIT {
        return Err(InputError::TooLarge);
    }
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(InputError::Utf16);
    }
    if bytes.starts_with("\u{feff}".as_bytes()) {
        bytes.drain(..3);
    }
    String::from_utf8(bytes).map_err(|error| InputError::NotUtf8(error.utf8_error().valid_up_to()))
}
