//! The files of `tests/documents/`: small documents, and the verdict that each of their lines must get.
//!
//! Each block of such a file is a document. Behind the format of its text (`markdown`, `latex`, `text`, `ipynb`) stands a
//! letter for each line that is judged: `p`roved, `a`ccepted, `r`efuted, `u`ndecided, `?` for unreadable, letters in
//! brackets where any of them will do, and `-` alone where no line is judged:
//!
//! ````text
//! ```markdown aap[ru]
//! ````
//!
//! A block `diff` is the last document that is written in full, but for some lines: `-` takes a line out, `+` puts one
//! in, and a line that begins with a space only says where. Each line is looked for below the one before it.

use polhode::notation::document::Format;
use std::fs;
use std::path::{Path, PathBuf};

/// A document of a file.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// The file that it stands in.
    pub(crate) file: PathBuf,
    /// The line of the file on which its block begins, from 1.
    pub(crate) place: usize,
    /// What it shows.
    pub(crate) heading: String,
    /// The kind of its text.
    pub(crate) format: Format,
    /// Its text.
    pub(crate) text: String,
    /// For each line that is judged the letters of the verdicts that it may get.
    pub(crate) expected: Vec<String>,
}

/// All documents, file by file.
pub(crate) fn samples() -> Vec<Sample> {
    let entries = fs::read_dir("tests/documents").expect("the documents");
    let mut files: Vec<_> = entries.map(|e| e.expect("an entry").path()).collect();
    files.sort();
    let read = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("readable");
        samples_of(file, &text)
    };
    files.iter().flat_map(read).collect()
}

/// The documents of one file.
pub(crate) fn samples_of(file: &Path, text: &str) -> Vec<Sample> {
    let mut found: Vec<Sample> = vec![];
    let mut heading = String::new();
    let mut full: Option<(Format, Vec<&str>)> = None;
    let mut lines = text.lines().enumerate();
    while let Some((index, line)) = lines.next() {
        if let Some(words) = line.strip_prefix("## ") {
            (heading, full) = (words.to_owned(), None);
        }
        let Some((fence, kind, letters)) = opening(line) else {
            continue;
        };
        let here = format!("{}:{}", file.display(), index + 1);
        let body: Vec<_> = lines
            .by_ref()
            .map(|(_, line)| line)
            .take_while(|line| *line != fence)
            .collect();
        let (format, body) = match (format(kind), &full) {
            (Some(format), _) => {
                full = Some((format, body.clone()));
                (format, body)
            }
            (None, Some((format, before))) if kind == "diff" => {
                let changed = changed(before, &body);
                let changed = changed.unwrap_or_else(|line| panic!("{here}: no line {line:?}"));
                (*format, changed)
            }
            _ => panic!("{here}: a block of no kind that is known here: {kind}"),
        };
        found.push(Sample {
            file: file.to_owned(),
            place: index + 1,
            heading: heading.clone(),
            format,
            text: body.join("\n") + "\n",
            expected: expected(letters).unwrap_or_else(|| panic!("{here}: verdicts {letters:?}")),
        });
    }
    found
}

/// The fence, the kind and the verdicts of a line that opens a block.
pub(crate) fn opening(line: &str) -> Option<(&str, &str, &str)> {
    let fence = &line[..line.len() - line.trim_start_matches('`').len()];
    let (kind, letters) = line[fence.len()..].split_once(' ')?;
    (fence.len() > 2).then_some((fence, kind, letters))
}

fn format(kind: &str) -> Option<Format> {
    match kind {
        "markdown" => Some(Format::Markdown),
        "latex" => Some(Format::Latex),
        "text" => Some(Format::Text),
        "ipynb" => Some(Format::Notebook),
        _ => None,
    }
}

/// For each line its letters; a group in brackets is one line.
fn expected(letters: &str) -> Option<Vec<String>> {
    let mut found: Vec<String> = vec![];
    let mut group: Option<String> = None;
    for letter in letters.chars().filter(|_| letters != "-") {
        match (letter, &mut group) {
            ('[', None) => group = Some(String::new()),
            (']', Some(_)) => found.extend(group.take()),
            ('p' | 'a' | 'r' | 'u' | '?', Some(group)) => group.push(letter),
            ('p' | 'a' | 'r' | 'u' | '?', None) => found.push(letter.to_string()),
            _ => return None,
        }
    }
    group.is_none().then_some(found)
}

/// A document with some of its lines changed; or the line that it does not have.
fn changed<'a>(before: &[&'a str], diff: &[&'a str]) -> Result<Vec<&'a str>, &'a str> {
    let (mut rest, mut found) = (before, vec![]);
    for entry in diff {
        if let Some(line) = entry.strip_prefix('+') {
            found.push(line);
            continue;
        }
        let line = entry.get(1..).unwrap_or_default();
        let at = rest.iter().position(|other| *other == line).ok_or(*entry)?;
        let kept = at + usize::from(entry.starts_with(' '));
        found.extend(&rest[..kept]);
        rest = &rest[at + 1..];
    }
    found.extend(rest);
    Ok(found)
}
