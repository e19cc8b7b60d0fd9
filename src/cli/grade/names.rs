//! Names: from what is handed in to ids, and from ids to files.

use crate::cli::grade::journal::digest;
use crate::notation::lookalike;
use regex_lite::{Captures, Regex};
use std::path::Path;
use unicode_normalization::UnicodeNormalization;

/// The longest id.
const LONGEST_ID: usize = 120;

/// How the id of a student is had from the name of a file or a folder.
#[derive(Debug, Default)]
pub(super) struct Naming {
    pattern: Option<Regex>,
}

impl Naming {
    /// By a pattern: the group called `id`, else the first group, else all that it finds.
    pub(super) fn by(pattern: Option<Regex>) -> Self {
        Self { pattern }
    }

    /// Whether several files may be of one student.
    pub(super) fn joins(&self) -> bool {
        self.pattern.is_some()
    }

    /// The id for a name, and what is wrong with the name.
    pub(super) fn id(&self, name: &str, is_folder: bool) -> (String, Option<String>) {
        let name = composed(name);
        let stem = match (is_folder, Path::new(&name).file_stem()) {
            (false, Some(stem)) => stem.to_string_lossy().into_owned(),
            _ => name,
        };
        let Some(pattern) = &self.pattern else {
            return plain(&stem);
        };
        match pattern
            .captures(&stem)
            .and_then(|found| group(&found).map(str::to_owned))
        {
            Some(id) => plain(&id),
            None => {
                let why = "its name does not fit the pattern of --id-pattern".to_owned();
                (escaped(&stem), Some(why))
            }
        }
    }
}

fn group<'h>(found: &Captures<'h>) -> Option<&'h str> {
    let named = found
        .name("id")
        .or_else(|| found.iter().skip(1).flatten().next());
    let all = named.or_else(|| found.get(0))?;
    Some(all.as_str()).filter(|id| !id.is_empty())
}

fn plain(name: &str) -> (String, Option<String>) {
    let id = escaped(name);
    let why = match lookalike(name) {
        _ if id != name => Some("its name has characters that an id can't have".to_owned()),
        Some((letter, latin)) => Some(format!(
            "its name has the letter {letter} (U+{:04X}), which looks like {latin} and is another",
            u32::from(letter)
        )),
        None => None,
    };
    (id, why)
}

/// A name in which each letter is one with its accents: systems write `é` in two ways.
pub(super) fn composed(name: &str) -> String {
    name.nfc().collect()
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
pub(super) fn shown(name: &str) -> String {
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
