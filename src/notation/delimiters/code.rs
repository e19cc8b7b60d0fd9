//! Code in Markdown: nothing in it is a formula, but for a fence of the language `math`.

use super::search::{blank_line, find};
use super::{LONGEST_CODE, Region, Scan};
use std::ops::Range;

/// Blocks in one another are looked through to this depth.
const DEEPEST: usize = 64;

/// Directives of MyST's Markdown, and blocks of bookdown, that hold text and no code.
const OF_TEXT: [&str; 32] = [
    "admonition",
    "note",
    "tip",
    "warning",
    "important",
    "hint",
    "caution",
    "attention",
    "danger",
    "seealso",
    "dropdown",
    "margin",
    "sidebar",
    "aside",
    "topic",
    "epigraph",
    "details",
    "card",
    "tab-set",
    "tab-item",
    "proof",
    "theorem",
    "definition",
    "lemma",
    "corollary",
    "proposition",
    "remark",
    "example",
    "exercise",
    "solution",
    "question",
    "answer",
];

/// Whether the word behind the marks of a fence opens a block of text: `{note}`, `{prf:theorem}`.
fn holds_text(language: &str) -> bool {
    let name = language.strip_prefix('{').unwrap_or_default();
    let name = name.split(['}', ',', ' ']).next().unwrap_or_default();
    OF_TEXT.contains(&name.strip_prefix("prf:").unwrap_or(name))
}

impl Scan<'_> {
    /// `%% … %%`, a comment in Obsidian's Markdown.
    pub(super) fn remark(&mut self) {
        let start = self.at;
        self.at += 2;
        if let Some(length) = self.search(self.at, "%%", find) {
            self.at += length + 2;
            self.comments.push(start..self.at);
        }
    }

    /// Code between backticks, or a fence at the start of a line; a fence of the language `math` is a display.
    pub(super) fn code(&mut self) {
        let mark = self.bytes[self.at];
        let run = self.bytes[self.at..]
            .iter()
            .take_while(|b| **b == mark)
            .count();
        if run >= 3 && self.starts_line() {
            return self.fence(run, mark);
        }
        if mark == b'~' {
            self.at += run;
            return;
        }
        let start = self.at + run;
        let limit = self.bytes.len().min(start + LONGEST_CODE);
        let mut at = start;
        while at < limit && !(self.bytes[at] == b'\n' && blank_line(&self.bytes[at + 1..])) {
            let close = self.bytes[at..].iter().take_while(|b| **b == b'`').count();
            at += close.max(1);
            if close == run {
                self.at = at;
                return;
            }
        }
        self.at = start;
    }

    /// `:::{math}`, a display in MyST's Markdown; what stands in other directives is text.
    pub(super) fn directive(&mut self) {
        let marks = self.bytes[self.at..].iter().take_while(|b| **b == b':');
        let run = marks.count();
        let opens_display = self
            .text
            .get(self.at + run..)
            .unwrap_or("")
            .starts_with("{math}");
        match opens_display && self.starts_line() {
            true => self.fence(run, b':'),
            false => self.at += run,
        }
    }

    /// Whether the text stands at the start of a line, behind a few marks of a list or a quotation.
    pub(super) fn starts_line(&self) -> bool {
        let near = &self.bytes[self.at.saturating_sub(100)..self.at];
        let lead = near.iter().rev().take_while(|b| **b != b'\n');
        lead.clone().all(|b| matches!(b, b' ' | b'\t' | b'>'))
            && (lead.count() < near.len() || self.at <= 100)
    }

    fn fence(&mut self, run: usize, mark: u8) {
        let start = self.at;
        if let Some(closing) = self
            .comments
            .iter()
            .rev()
            .take(DEEPEST)
            .find(|comment| comment.start == start)
        {
            self.at = closing.end;
            return;
        }
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
        if holds_text(language) {
            return self.open_block(start..body, close..end);
        }
        if matches!(language, "math" | "{math}") {
            let options = self.options(body.min(close), close);
            self.found.push(Region {
                outer: start..end,
                inner: options..close,
                display: true,
                closed: close < end,
            });
        }
        self.at = end.max(start + run);
    }

    /// What stands between two marks is text: the marks and the options behind the first one count as comments.
    fn open_block(&mut self, opening: Range<usize>, closing: Range<usize>) {
        let body = opening.end.min(closing.start);
        let options = self.options(body, closing.start);
        let mut head = opening.start;
        for line in self
            .text
            .get(head..options)
            .unwrap_or("")
            .split_inclusive('\n')
        {
            self.comments.push(head..head + line.trim_end().len());
            head += line.len();
        }
        let last = self.text.get(closing.clone()).unwrap_or("");
        let indent = last.len() - last.trim_start().len();
        let end = closing.start + last.trim_end().len();
        if closing.start + indent < end {
            self.comments.push(closing.start + indent..end);
        }
        self.at = options;
    }

    /// Where the lines of options `:label: euler` at the head of a block end.
    fn options(&self, mut at: usize, end: usize) -> usize {
        while self.bytes[at..end].starts_with(b":") {
            at += find(&self.bytes[at..end], b"\n").map_or(end - at, |i| i + 1);
        }
        at
    }
}
