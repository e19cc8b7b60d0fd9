//! Code in Markdown: nothing in it is a formula, but for a fence of the language `math`.

use super::{Region, Scan, find, paragraph_end};

impl Scan<'_> {
    /// Code between backticks, or a fence at the start of a line; a fence of the language `math` is a display.
    pub(super) fn code(&mut self) {
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
