//! Tables as text with commas (RFC 4180), with the bytes of each cell, so that one can be put in and the rest left alone.

use std::ops::Range;

/// One row: the bytes of its cells, with their quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The bytes of each cell.
    pub cells: Vec<Range<usize>>,
}

impl Row {
    /// The values of the cells, without quotes.
    pub fn values(&self, text: &str) -> Vec<String> {
        let value = |cell: &Range<usize>| {
            let raw = &text[cell.clone()];
            let inner = raw
                .strip_prefix('"')
                .map(|raw| raw.strip_suffix('"').unwrap_or(raw));
            inner.map_or(raw.to_owned(), |inner| inner.replace("\"\"", "\""))
        };
        self.cells.iter().map(value).collect()
    }
}

/// The rows of a table. Cells stand between commas, or semicolons where the first row has more of those; a quoted cell may
/// hold line breaks. An empty line is no row.
pub fn rows(text: &str) -> impl Iterator<Item = Row> {
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let first = text[start..].lines().next().unwrap_or("");
    let count = |c: char| first.chars().filter(|&other| other == c).count();
    let between = if count(';') > count(',') { b';' } else { b',' };
    let mut at = start;
    std::iter::from_fn(move || {
        while matches!(text.as_bytes().get(at), Some(b'\r' | b'\n')) {
            at += 1;
        }
        (at < text.len()).then(|| row(text.as_bytes(), &mut at, between))
    })
}

fn row(bytes: &[u8], at: &mut usize, between: u8) -> Row {
    let mut cells = vec![];
    let (mut start, mut quoted) = (*at, false);
    loop {
        match bytes.get(*at) {
            Some(b'"') => quoted = !quoted,
            Some(byte) if *byte == between && !quoted => {
                cells.push(start..*at);
                start = *at + 1;
            }
            Some(b'\r' | b'\n') if !quoted => break,
            None => break,
            Some(_) => {}
        }
        *at += 1;
    }
    cells.push(start..*at);
    Row { cells }
}
