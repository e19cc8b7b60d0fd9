//! Where the mathematics of a text stands: `$…$`, `$$…$$`, `\(…\)`, `\[…\]`, environments of equations.
//!
//! This is settled on the bytes of the file, before anything else is read: inside mathematics `\\`, `_` and a leading
//! `+` mean something else than in the text around it.

use std::ops::Range;

/// A formula in a text, as ranges of bytes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Region {
    /// With its delimiters.
    pub(crate) outer: Range<usize>,
    /// What is to be read.
    pub(crate) inner: Range<usize>,
    pub(crate) display: bool,
    /// Whether the closing delimiter was found.
    pub(crate) closed: bool,
}

/// What else a text holds in which `$` means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dialect {
    /// Code in backticks and fences, HTML comments.
    Markdown,
    /// `%` comments, verbatim.
    Latex,
}

/// Environments that are displays when they stand in the text.
const DISPLAYS: &[&str] = &[
    "equation",
    "align",
    "aligned",
    "eqnarray",
    "gather",
    "multline",
    "alignat",
    "flalign",
    "displaymath",
    "math",
    "dmath",
    "IEEEeqnarray",
    "subequations",
];

/// The formulas of a text in order.
pub(crate) fn regions(text: &str, dialect: Dialect) -> Vec<Region> {
    let mut scan = Scan {
        text,
        bytes: text.as_bytes(),
        at: 0,
        dialect,
        found: vec![],
    };
    while scan.at < scan.bytes.len() {
        scan.step();
    }
    scan.found
}

struct Scan<'a> {
    text: &'a str,
    bytes: &'a [u8],
    at: usize,
    dialect: Dialect,
    found: Vec<Region>,
}

impl Scan<'_> {
    fn step(&mut self) {
        let rest = &self.bytes[self.at..];
        match rest {
            [b'`' | b'~', ..] if self.dialect == Dialect::Markdown => self.code(),
            [b'<', b'!', b'-', b'-', ..] if self.dialect == Dialect::Markdown => {
                self.skip_past("-->")
            }
            [b'%', ..] if self.dialect == Dialect::Latex => self.skip_past("\n"),
            [b'$', b'$', ..] => self.delimited("$$", "$$", true),
            [b'$', ..] => self.inline(),
            [b'\\', b'[', ..] => self.delimited("\\[", "\\]", true),
            [b'\\', b'(', ..] => self.delimited("\\(", "\\)", false),
            [b'\\', b'b', ..] if rest.starts_with(b"\\begin{") => self.environment(),
            [b'\\', _, ..] => self.at += 2,
            _ => self.at += 1,
        }
    }

    fn skip_past(&mut self, end: &str) {
        let rest = &self.text.as_bytes()[self.at..];
        let found = find(rest, end.as_bytes());
        self.at = found.map_or(self.bytes.len(), |i| self.at + i + end.len());
    }

    /// Code between backticks, or a fence at the start of a line; a fence of the language `math` is a display.
    fn code(&mut self) {
        let mark = self.bytes[self.at];
        let run = self.bytes[self.at..]
            .iter()
            .take_while(|b| **b == mark)
            .count();
        let line_start = self.bytes[..self.at]
            .iter()
            .rposition(|b| *b == b'\n')
            .map_or(0, |i| i + 1);
        let starts_line = self.bytes[line_start..self.at]
            .iter()
            .all(|b| matches!(b, b' ' | b'\t' | b'>'));
        if run >= 3 && starts_line {
            return self.fence(run, mark);
        }
        if mark == b'~' {
            self.at += run;
            return;
        }
        let ticks = vec![b'`'; run];
        let start = self.at + run;
        let limit = paragraph_end(self.bytes, start);
        let mut from = start;
        while let Some(i) = find(&self.bytes[from..limit], &ticks) {
            let close = self.bytes[from + i..limit]
                .iter()
                .take_while(|b| **b == b'`')
                .count();
            if close == run {
                self.at = from + i + run;
                return;
            }
            from += i + close;
        }
        self.at = start;
    }

    fn fence(&mut self, run: usize, mark: u8) {
        let start = self.at;
        let line_end = |from: usize| {
            find(&self.bytes[from..], b"\n").map_or(self.bytes.len(), |i| from + i + 1)
        };
        let body = line_end(start);
        let language = self.text.get(start + run..body).unwrap_or("").trim();
        let mut line = body;
        let mut close = self.bytes.len();
        while line < self.bytes.len() {
            let end = line_end(line);
            let text = self.text.get(line..end).unwrap_or("").trim();
            if text.len() >= run && text.bytes().all(|b| b == mark) {
                close = line;
                break;
            }
            line = end;
        }
        let end = if close < self.bytes.len() {
            line_end(close)
        } else {
            close
        };
        if language == "math" {
            self.found.push(Region {
                outer: start..end,
                inner: body.min(close)..close,
                display: true,
                closed: close < end,
            });
        }
        self.at = end.max(start + run);
    }

    fn delimited(&mut self, open: &str, close: &str, display: bool) {
        let start = self.at;
        let inner = start + open.len();
        match find_unescaped(&self.bytes[inner..], close.as_bytes()) {
            Some(i) => {
                let end = inner + i + close.len();
                self.found.push(Region {
                    outer: start..end,
                    inner: inner..inner + i,
                    display,
                    closed: true,
                });
                self.at = end;
            }
            None => {
                let end = paragraph_end(self.bytes, inner);
                self.found.push(Region {
                    outer: start..end,
                    inner: inner..end,
                    display,
                    closed: false,
                });
                self.at = end;
            }
        }
    }

    /// `$…$` within one paragraph; a dollar before a digit and after a space is money.
    fn inline(&mut self) {
        let start = self.at;
        let inner = start + 1;
        let limit = paragraph_end(self.bytes, inner);
        let close = find_unescaped(&self.bytes[inner..limit], b"$");
        let Some(length) = close.filter(|n| *n > 0) else {
            self.at += 1;
            return;
        };
        let end = inner + length;
        let text = &self.bytes[inner..end];
        let spaced = text.last().is_some_and(u8::is_ascii_whitespace);
        let money = self.bytes.get(end + 1).is_some_and(u8::is_ascii_digit) && spaced;
        if money {
            self.at += 1;
            return;
        }
        self.found.push(Region {
            outer: start..end + 1,
            inner: inner..end,
            display: false,
            closed: true,
        });
        self.at = end + 1;
    }

    fn environment(&mut self) {
        let start = self.at;
        let name_start = start + "\\begin{".len();
        let Some(length) = find(&self.bytes[name_start..], b"}").filter(|n| *n < 40) else {
            self.at = name_start;
            return;
        };
        let name = self.text.get(name_start..name_start + length).unwrap_or("");
        let end_mark = format!("\\end{{{name}}}");
        if matches!(
            name,
            "verbatim" | "lstlisting" | "comment" | "minted" | "Verbatim" | "tikzpicture"
        ) && self.dialect == Dialect::Latex
        {
            return self.skip_past(&end_mark);
        }
        if !DISPLAYS.contains(&name.trim_end_matches('*')) {
            self.at = name_start + length + 1;
            return;
        }
        let body = name_start + length + 1;
        match find(&self.bytes[body..], end_mark.as_bytes()) {
            Some(i) => {
                let end = body + i + end_mark.len();
                // The environment itself is read with what it holds: its name says how its columns are meant.
                self.found.push(Region {
                    outer: start..end,
                    inner: start..end,
                    display: true,
                    closed: true,
                });
                self.at = end;
            }
            None => {
                let end = paragraph_end(self.bytes, body);
                self.found.push(Region {
                    outer: start..end,
                    inner: body..end,
                    display: true,
                    closed: false,
                });
                self.at = end;
            }
        }
    }
}

/// The offset of a pattern.
pub(crate) fn find(bytes: &[u8], pattern: &[u8]) -> Option<usize> {
    let first = *pattern.first()?;
    let mut from = 0;
    while let Some(i) = bytes[from..].iter().position(|b| *b == first) {
        if bytes[from + i..].starts_with(pattern) {
            return Some(from + i);
        }
        from += i + 1;
    }
    None
}

fn find_unescaped(bytes: &[u8], pattern: &[u8]) -> Option<usize> {
    let mut i = 0;
    while i < bytes.len() {
        if bytes[i..].starts_with(pattern) {
            return Some(i);
        }
        i += if bytes[i] == b'\\' { 2 } else { 1 };
    }
    None
}

/// Where the paragraph ends: at a blank line, or at the end of the text.
fn paragraph_end(bytes: &[u8], from: usize) -> usize {
    let mut at = from;
    while let Some(i) = find(&bytes[at..], b"\n") {
        let next = at + i + 1;
        let blank = bytes[next..]
            .iter()
            .take_while(|b| **b != b'\n')
            .all(|b| b.is_ascii_whitespace());
        if blank {
            return at + i;
        }
        at = next;
    }
    bytes.len()
}
