//! Code in Markdown: nothing in it is a formula, but for a fence of the language `math`.

use super::search::{blank_line, find};
use super::{LONGEST_CODE, Region, Scan};

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

    /// Where the lines of options `:label: euler` at the head of a block end.
    fn options(&self, mut at: usize, end: usize) -> usize {
        while self.bytes[at..end].starts_with(b":") {
            at += find(&self.bytes[at..end], b"\n").map_or(end - at, |i| i + 1);
        }
        at
    }
}
