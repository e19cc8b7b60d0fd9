//! Mathematics in reStructuredText: the directive `.. math::` and the role `` :math:`x` ``.

use super::search::{blank_line, find};
use super::{LONGEST_CODE, Region, Scan};
use std::ops::Range;

/// Opens a display: what stands behind it on its line and in the lines below it that are set in.
const DIRECTIVE: &str = ".. math::";

/// Opens a formula in the text, which ends at the next backtick.
const ROLE: &str = ":math:`";

/// Whether a text has displays as reStructuredText marks them.
pub(crate) fn is_restructured(text: &str) -> bool {
    let mut lines = text.lines();
    lines.any(|line| line.trim_start().starts_with(DIRECTIVE))
}

/// The text with `~` under a heading written as `-`, byte for byte: in Markdown it would open a block of code.
pub(crate) fn with_plain_headings(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut above = 0;
    for line in text.split_inclusive('\n') {
        let marks = line.trim_end();
        let adorns = marks.len() >= 3 && marks.bytes().all(|b| b == b'~') && marks.len() >= above;
        match adorns && above > 0 {
            true => out.push_str(&line.replace('~', "-")),
            false => out.push_str(line),
        }
        above = line.trim_end().chars().count();
    }
    out
}

impl Scan<'_> {
    /// `` :math:`x` ``
    pub(super) fn role(&mut self) {
        let start = self.at;
        let inner = start + ROLE.len();
        if !self.text[start..].starts_with(ROLE) {
            self.at += 1;
            return;
        }
        self.at = inner;
        let limit = self.bytes.len().min(inner + LONGEST_CODE);
        if let Some(length) = find(&self.bytes[inner..limit], b"`") {
            self.at = inner + length + 1;
            self.found.push(Region {
                outer: start..self.at,
                inner: inner..inner + length,
                display: false,
                closed: true,
            });
        }
    }

    /// `.. math::`, whose formulas stand apart by blank lines where no environment holds them together.
    pub(super) fn math_directive(&mut self) {
        let start = self.at;
        if !self.text[start..].starts_with(DIRECTIVE) || !self.starts_line() {
            self.at += 1;
            return;
        }
        let end = self.end_of_block(start);
        let mut from = start;
        for inner in self.formulas(start + DIRECTIVE.len()..end) {
            self.found.push(Region {
                outer: from..inner.end,
                inner: inner.clone(),
                display: true,
                closed: true,
            });
            from = inner.end;
        }
        self.at = end;
    }

    /// Where the lines end that are set in more than the one that begins at `start`, or are blank.
    fn end_of_block(&self, start: usize) -> usize {
        let line_start = self.text[..start].rfind('\n').map_or(0, |i| i + 1);
        let mut end = self.line_end(start);
        let mut at = end;
        while at < self.bytes.len() {
            let rest = &self.bytes[at..];
            let indent = rest
                .iter()
                .take_while(|b| matches!(b, b' ' | b'\t'))
                .count();
            let blank = blank_line(rest);
            if !blank && indent <= start - line_start {
                break;
            }
            at = self.line_end(at);
            if !blank {
                end = at;
            }
        }
        end
    }

    fn line_end(&self, from: usize) -> usize {
        find(&self.bytes[from..], b"\n").map_or(self.bytes.len(), |i| from + i + 1)
    }

    /// The formulas of a block without its options, `:label: euler`.
    fn formulas(&self, block: Range<usize>) -> Vec<Range<usize>> {
        let mut formulas: Vec<Range<usize>> = vec![];
        let mut open = false;
        let mut at = block.start;
        while at < block.end {
            let end = self.line_end(at).min(block.end);
            let line = &self.text[at..end];
            let option = formulas.is_empty() && line.trim_start().starts_with(':');
            match (line.trim().is_empty() || option, formulas.last_mut()) {
                (true, Some(last)) => open &= depth(&self.text[last.clone()]) > 0,
                (true, None) => {}
                (false, Some(last)) if open => last.end = at + line.trim_end().len(),
                (false, _) => {
                    let lead = line.len() - line.trim_start().len();
                    formulas.push(at + lead..at + line.trim_end().len());
                    open = true;
                }
            }
            at = end;
        }
        formulas
    }
}

/// How many environments a text leaves open.
fn depth(text: &str) -> usize {
    let opened = text.matches("\\begin{").count();
    opened.saturating_sub(text.matches("\\end{").count())
}
