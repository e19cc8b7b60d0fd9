//! Where the mathematics of a text stands: `$…$`, `$$…$$`, `\(…\)`, `\[…\]`, environments of equations.
//!
//! This is settled on the bytes of the file, before anything else is read: inside mathematics `\\`, `_` and a leading
//! `+` mean something else than in the text around it.

mod code;
mod restructured;
mod search;

pub(crate) use restructured::{is_restructured, with_plain_headings};
pub(crate) use search::find;

use search::{blank_line, find_command, find_unescaped, paragraph_end};
use std::collections::BTreeSet;
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
    "numcases",
    "subnumcases",
    "empheq",
    "IEEEeqnarray",
];

/// Code in a line is not longer than this.
const LONGEST_CODE: usize = 4096;

/// What authors call the two ends of a display in their own files.
const ABBREVIATED: &[(&str, &str)] = &[
    ("be", "ee"),
    ("beq", "eeq"),
    ("bea", "eea"),
    ("beqn", "eeqn"),
    ("beqa", "eeqa"),
    ("bal", "eal"),
    ("ba", "ea"),
    ("bse", "ese"),
    ("bg", "eg"),
];

/// The formulas of a text in order.
pub(crate) fn regions(text: &str, dialect: Dialect) -> Vec<Region> {
    scan(text, dialect).found
}

/// The formulas of a Markdown text in order, and its comments between `%%`.
pub(crate) fn regions_and_comments(text: &str) -> (Vec<Region>, Vec<Range<usize>>) {
    let scan = scan(text, Dialect::Markdown);
    (scan.found, scan.comments)
}

fn scan(text: &str, dialect: Dialect) -> Scan<'_> {
    let mut scan = Scan {
        text,
        bytes: text.as_bytes(),
        at: 0,
        dialect,
        found: vec![],
        comments: vec![],
        missing: BTreeSet::new(),
        fruitless: 0,
    };
    while scan.at < scan.bytes.len() {
        scan.step();
    }
    scan
}

struct Scan<'a> {
    text: &'a str,
    bytes: &'a [u8],
    at: usize,
    dialect: Dialect,
    found: Vec<Region>,
    comments: Vec<Range<usize>>,
    /// Closing marks that do not come again: each is looked for to the end of the text once.
    missing: BTreeSet<String>,
    /// Up to here no escaped closing mark was found.
    fruitless: usize,
}

impl Scan<'_> {
    fn step(&mut self) {
        let rest = &self.bytes[self.at..];
        match rest {
            [b'`' | b'~', ..] if self.dialect == Dialect::Markdown => self.code(),
            [b':', b':', b':', ..] if self.dialect == Dialect::Markdown => self.directive(),
            [b':', b'm', ..] if self.dialect == Dialect::Markdown => self.role(),
            [b'.', b'.', b' ', ..] if self.dialect == Dialect::Markdown => self.math_directive(),
            [b'<', b'!', b'-', b'-', ..] if self.dialect == Dialect::Markdown => {
                self.skip_past("-->")
            }
            [b'%', b'%', ..] if self.dialect == Dialect::Markdown => self.remark(),
            [b'%', ..] if self.dialect == Dialect::Latex => self.skip_past("\n"),
            [b'\\', b'v' | b'i' | b'b', ..] if self.dialect == Dialect::Latex && self.hidden() => {}
            [b'\\', b'\\', b'(' | b'[', ..] if self.dialect == Dialect::Markdown => self.escaped(),
            [b'$', b'$', ..] => self.delimited("$$", "$$", true),
            [b'$', ..] => self.inline(),
            [b'\\', b'[', ..] => self.delimited("\\[", "\\]", true),
            [b'\\', b'(', ..] => self.delimited("\\(", "\\)", false),
            [b'\\', b'b', ..] if rest.starts_with(b"\\begin{") => self.environment(),
            [b'\\', _, ..] => self.at += 2,
            _ => self.at += 1,
        }
    }

    /// `\verb|$x$|` and `\iffalse … \fi` hold no mathematics, and an abbreviation may open a display: `\be … \ee`.
    fn hidden(&mut self) -> bool {
        let rest = &self.text[self.at..];
        if let Some(inner) = rest.strip_prefix("\\verb")
            && let Some(mark) = inner.bytes().next().filter(u8::is_ascii_punctuation)
        {
            let near = &inner.as_bytes()[1..inner.len().min(LONGEST_CODE)];
            let length = find(near, &[mark]).unwrap_or(0);
            self.at += "\\verb".len() + 1 + length + 1;
            return true;
        }
        if rest.starts_with("\\iffalse") {
            self.skip_past("\\fi");
            return true;
        }
        let name = &rest[1..=rest[1..]
            .bytes()
            .take_while(u8::is_ascii_alphabetic)
            .count()];
        let Some((open, close)) = ABBREVIATED.iter().find(|(open, _)| *open == name) else {
            return false;
        };
        // Where it is defined it opens nothing.
        if rest[1 + open.len()..].starts_with(['{', '}']) {
            return false;
        }
        let close = format!("\\{close}");
        let inner = self.at + 1 + open.len();
        let Some(length) = self.search(inner, &close, find_command) else {
            return false;
        };
        let end = inner + length + close.len();
        self.found.push(Region {
            outer: self.at..end,
            inner: inner..inner + length,
            display: true,
            closed: true,
        });
        self.at = end;
        true
    }

    /// `\\( … \\)` and `\\[ … \\]`, escaped once more for a program that takes one backslash off.
    fn escaped(&mut self) {
        let start = self.at;
        let display = self.bytes[start + 2] == b'[';
        let close: &[u8] = if display { b"\\\\]" } else { b"\\\\)" };
        let inner = start + 3;
        self.at = inner;
        if inner < self.fruitless {
            return;
        }
        let limit = paragraph_end(self.bytes, inner);
        self.fruitless = limit;
        if let Some(length) = find(&self.bytes[inner..limit], close) {
            self.fruitless = 0;
            self.at = inner + length + close.len();
            self.found.push(Region {
                outer: start..self.at,
                inner: inner..inner + length,
                display,
                closed: true,
            });
        }
    }

    fn skip_past(&mut self, end: &str) {
        let rest = &self.text.as_bytes()[self.at..];
        let found = find(rest, end.as_bytes());
        self.at = found.map_or(self.bytes.len(), |i| self.at + i + end.len());
    }

    fn delimited(&mut self, open: &str, close: &str, display: bool) {
        let start = self.at;
        let inner = start + open.len();
        match self.search(inner, close, find_unescaped) {
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

    /// The next closing mark from an offset, as its distance.
    fn search(
        &mut self,
        from: usize,
        close: &str,
        find: impl Fn(&[u8], &[u8]) -> Option<usize>,
    ) -> Option<usize> {
        if self.missing.contains(close) {
            return None;
        }
        let found = find(&self.bytes[from..], close.as_bytes());
        if found.is_none() {
            self.missing.insert(close.to_owned());
        }
        found
    }

    /// The distance of the next dollar in the paragraph.
    fn dollar(&self, from: usize) -> Option<usize> {
        let mut at = from;
        while let Some(byte) = self.bytes.get(at) {
            match byte {
                b'$' => return Some(at - from),
                b'\\' => at += 1,
                b'\n' if blank_line(&self.bytes[at + 1..]) => return None,
                _ => {}
            }
            at += 1;
        }
        None
    }

    /// `$…$` within one paragraph; a dollar before a digit and after a space is money.
    fn inline(&mut self) {
        let start = self.at;
        let inner = start + 1;
        let Some(length) = self.dollar(inner).filter(|n| *n > 0) else {
            self.at += 1;
            return;
        };
        let end = inner + length;
        let text = &self.bytes[inner..end];
        let spaced = text.last().is_some_and(u8::is_ascii_whitespace);
        let follows = self.bytes.get(end + 1).is_some_and(u8::is_ascii_digit);
        if (follows && spaced) || is_money(text) {
            self.at += 1;
            return;
        }
        // The power of a unit in words: `kg m$^2$`.
        let of_text = start.checked_sub(1).and_then(|at| self.bytes.get(at));
        if text.starts_with(b"^") && of_text.is_some_and(u8::is_ascii_alphanumeric) {
            self.at = end + 1;
            return;
        }
        // In one dialect backticks stand inside the dollars.
        let ticked = length > 2 && text.starts_with(b"`") && text.ends_with(b"`");
        let inside = inner + usize::from(ticked)..end - usize::from(ticked);
        self.found.push(Region {
            outer: start..end + 1,
            inner: inside,
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
        match self.search(body, &end_mark, find) {
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

/// A price and what stands behind it, up to the next dollar.
fn is_money(text: &[u8]) -> bool {
    let plain = !text.iter().any(|b| matches!(b, b'=' | b'\\' | b'^' | b'_'));
    let word = text
        .split(|b| !b.is_ascii_alphabetic())
        .any(|run| run.len() > 2);
    let spaced = text.last().is_some_and(u8::is_ascii_whitespace);
    text.first().is_some_and(u8::is_ascii_digit) && plain && (word || spaced)
}
