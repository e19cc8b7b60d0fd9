//! A text with a name, and places in it.
//!
//! Every finding of polhode points at bytes of a [`Source`]. A [`Span`] is a range of byte
//! offsets; lines and columns are worked out only when somebody wants to read them.

/// A range of bytes in a text: `start` inclusive, `end` exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Offset of the first byte.
    pub start: u32,
    /// Offset of the byte after the last.
    pub end: u32,
}

impl Span {
    /// The bytes from `start` up to `end`.
    pub fn new(start: usize, end: usize) -> Self {
        let offset = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Self {
            start: offset(start),
            end: offset(end.max(start)),
        }
    }

    /// The smallest span that holds both.
    pub fn to(self, other: Self) -> Self {
        Self {
            start: self.start.min(other.start),
            end: self.end.max(other.end),
        }
    }

    /// The place right before it.
    pub fn before(self) -> Self {
        let end = self.start;
        Self { end, ..self }
    }

    /// The place right behind it.
    pub fn behind(self) -> Self {
        let start = self.end;
        Self { start, ..self }
    }

    /// The span as a range of indices.
    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }

    /// The same span in a text that begins `by` bytes earlier.
    pub fn shifted(self, by: usize) -> Self {
        Self::new(self.start as usize + by, self.end as usize + by)
    }
}

/// A text and the name that people know it by.
#[derive(Clone, Debug)]
pub struct Source {
    /// The path as it was given, or `<stdin>`.
    pub name: String,
    /// The whole text.
    pub text: String,
    line_starts: Vec<u32>,
    /// The characters before each block of [`BLOCK`] bytes, so that a column far along a line is soon counted.
    characters: Vec<u32>,
}

const BLOCK: usize = 1024;

/// The characters that begin among some bytes.
fn characters(bytes: &[u8]) -> usize {
    let inside = |byte: u8| byte & 0xc0 == 0x80;
    bytes.iter().filter(|&&byte| !inside(byte)).count()
}

impl Source {
    /// Takes a text in and notes where its lines begin.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let breaks = text.bytes().enumerate().filter(|&(_, b)| b == b'\n');
        let line_starts = std::iter::once(0)
            .chain(breaks.map(|(i, _)| Span::new(i + 1, i + 1).start))
            .collect();
        let blocks = text.as_bytes().chunks(BLOCK).chain([&[][..]]);
        let before = blocks.scan(0, |sum, block| {
            let before = *sum;
            *sum += characters(block);
            u32::try_from(before).ok()
        });
        Self {
            name: name.into(),
            characters: before.collect(),
            text,
            line_starts,
        }
    }

    /// The text that a span covers; empty where the span lies outside or cuts a character.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or("")
    }

    /// Line and column of a byte offset, both from 1; the column counts characters.
    pub fn line_column(&self, offset: u32) -> (usize, usize) {
        let line = self
            .line_starts
            .partition_point(|&start| start <= offset)
            .max(1);
        let start = self.line_starts[line - 1] as usize;
        let offset = offset as usize;
        if !self.text.is_char_boundary(offset) {
            return (line, 1);
        }
        let inside = self.text.as_bytes().get(start..offset).unwrap_or_default();
        let column = match inside.len() < BLOCK {
            true => characters(inside),
            false => self.characters_before(offset) - self.characters_before(start),
        };
        (line, column + 1)
    }

    fn characters_before(&self, offset: usize) -> usize {
        let block = offset / BLOCK;
        let rest = self.text.as_bytes().get(block * BLOCK..offset);
        let before = self.characters.get(block).map_or(0, |&n| n as usize);
        before + characters(rest.unwrap_or_default())
    }

    /// The number of lines, at least 1.
    pub fn lines(&self) -> usize {
        self.line_starts.len()
    }
}
