//! Plain text: formulas on lines of their own or inside sentences, in Unicode or ASCII.

mod look;

use crate::notation::document::{Item, Row, push_prose};
use crate::notation::lexer::tokens;
use crate::notation::parse;
use crate::notation::token::{Letters, Lexeme, Token};
use crate::notation::triads::Triads;
use crate::notation::unicode;
use crate::notation::{items, refused};
use crate::source::Span;
use look::{RELATIONS, entry, is_formula, is_mathematical, labelled, marker, runs};

/// The items of a text whose first byte stands at `offset` of the source.
pub(crate) fn read(text: &str, offset: usize, decimal_comma: bool, triads: Triads) -> Vec<Item> {
    let written = text;
    let text = &*without_bold(text);
    let text = &*without_ticks(text);
    let text = &*without_wide_stops(text);
    let mut reader = Reader {
        text,
        written,
        offset,
        decimal_comma,
        letters: Letters::Words(triads),
        items: vec![],
    };
    let mut at = 0;
    while at < text.len() {
        at = reader.line(at);
    }
    reader.items
}

/// The text with blanks in place of the stars around what is bold: `**L = I ω**`. Those between two operands are a
/// power.
fn without_bold(text: &str) -> std::borrow::Cow<'_, str> {
    if !text.contains("**") {
        return text.into();
    }
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut rest = line;
        while let Some((before, inside, behind)) = bold(rest) {
            out.push_str(before);
            out.push_str("  ");
            out.push_str(inside);
            out.push_str("  ");
            rest = behind;
        }
        out.push_str(rest);
    }
    out.into()
}

/// The text with blanks in place of the backticks around what is code in Markdown: `L = I ω`.
fn without_ticks(text: &str) -> std::borrow::Cow<'_, str> {
    if !text.contains('`') {
        return text.into();
    }
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let paired = line.matches('`').count().is_multiple_of(2);
        match paired && !line.contains("``") {
            true => out.push_str(&line.replace('`', " ")),
            false => out.push_str(line),
        }
    }
    out.into()
}

/// The text with the stops and brackets of Chinese and Japanese as those of ASCII, each with blanks beside it that keep all
/// places: `L = I ω。`.
fn without_wide_stops(text: &str) -> std::borrow::Cow<'_, str> {
    if !text.contains(|c| unicode::plain_stop(c).is_some()) {
        return text.into();
    }
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        let blanks = " ".repeat(c.len_utf8() - 1);
        match unicode::plain_stop(c) {
            Some('(') => out.extend([blanks.as_str(), "("]),
            Some(stop) => {
                out.push(stop);
                out.push_str(&blanks);
            }
            None => out.push(c),
        }
    }
    out.into()
}

/// Whether a line is one piece of code in Markdown and nothing else: what its author marked so is a formula.
fn is_code(line: &str) -> bool {
    let line = line.trim();
    let inside = line.strip_prefix('`').and_then(|l| l.strip_suffix('`'));
    inside.is_some_and(|inside| !inside.is_empty() && !inside.contains('`'))
}

/// What stands before, in and behind the first bold words of a line.
fn bold(line: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = line.split_once("**")?;
    let (inside, behind) = rest.split_once("**")?;
    let apart = |c: char| !c.is_alphanumeric() && !matches!(c, ')' | ']' | '*');
    let opens = before.chars().next_back().is_none_or(apart);
    let closes = behind.chars().next().is_none_or(|c| apart(c) && c != '(');
    let blank = |c: Option<char>| c.is_none_or(char::is_whitespace);
    let words = !blank(inside.chars().next()) && !blank(inside.chars().next_back());
    (opens && closes && words).then_some((before, inside, behind))
}

fn underline(line: &str) -> Option<u8> {
    let line = line.trim();
    let all = |c: char| line.len() >= 3 && line.chars().all(|d| d == c);
    if all('=') {
        Some(1)
    } else if all('-') {
        Some(2)
    } else {
        None
    }
}

fn line_end(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |i| at + i + 1)
}

struct Reader<'a> {
    text: &'a str,
    /// The same with the marks of bold words and of code.
    written: &'a str,
    offset: usize,
    decimal_comma: bool,
    letters: Letters,
    items: Vec<Item>,
}

impl<'a> Reader<'a> {
    fn span(&self, start: usize, length: usize) -> Span {
        Span::new(self.offset + start, self.offset + start + length)
    }

    /// Reads the line at an offset, with what goes on from it, and returns where the next begins.
    fn line(&mut self, at: usize) -> usize {
        let end = line_end(self.text, at);
        let line = self.text[at..end].trim_end();
        if line.trim().is_empty() {
            self.items.push(Item::Break);
            return end;
        }
        if let Some(after) = self.heading(line, at, end) {
            return after;
        }
        let body = line.trim_start();
        let mut start = at + line.len() - body.len();
        let marker = marker(body);
        if marker > 0 && marker < body.len() {
            self.items.push(Item::Break);
            self.prose(&body[..marker], start);
            start += marker;
        }
        let body = &self.text[start..at + line.len()];
        let code = is_code(&self.written[at..end]) && body.contains(RELATIONS);
        if !code && !is_formula(labelled(body).0) {
            self.sentence(body, start);
            self.prose(" ", start + body.len());
            return end;
        }
        let last = self.continued(start, at + line.len(), end);
        self.display(&self.text[start..last], start);
        line_end(self.text, last.max(at))
    }

    fn heading(&mut self, line: &str, at: usize, end: usize) -> Option<usize> {
        let span = self.span(at, line.len());
        let next = line_end(self.text, end);
        if let Some(level) = underline(&self.text[end..next]) {
            let text = line.trim().to_owned();
            self.items.push(Item::Heading { level, text, span });
            return Some(next);
        }
        let text = line.trim_start_matches('#');
        let level = line.len() - text.len();
        if level == 0 || !text.starts_with(' ') {
            return None;
        }
        let level = u8::try_from(level).unwrap_or(6).min(6);
        let text = text.trim().to_owned();
        self.items.push(Item::Heading { level, text, span });
        Some(end)
    }

    /// Where a formula that ends at `last` really ends: a line that ends with a sign goes on, and so does one before a
    /// line that begins with a sign and holds no relation.
    fn continued(&self, start: usize, mut last: usize, mut next: usize) -> usize {
        let signs = ['+', '-', '−', '*', '·', '×', '/'];
        while next < self.text.len() && labelled(&self.text[start..last]).1.is_none() {
            let end = line_end(self.text, next);
            let line = self.text[next..end].trim_end();
            let body = labelled(line.trim()).0;
            let open = self.text[start..last].ends_with(signs)
                || self.text[start..last].ends_with(['=', '(', ',']);
            let goes_on = body.starts_with(signs) && !body.contains(['=', '<', '>', '≈']);
            let joins = open && !is_formula(body) || goes_on;
            if body.is_empty() || !joins || !is_mathematical(body) {
                break;
            }
            last = next + line.len();
            next = end;
        }
        last
    }

    fn prose(&mut self, words: &str, at: usize) {
        // The space between two sentences may stand for the end of the file.
        let length = words.len().min(self.text.len() - at);
        let span = self.span(at, length);
        push_prose(&mut self.items, words, span);
    }

    /// A formula on a line of its own.
    fn display(&mut self, text: &'a str, at: usize) {
        let (body, label) = labelled(text);
        if let Some(reading) = refused(body, self.offset + at) {
            let span = self.span(at, text.len());
            return self.items.extend(items(reading, true, span));
        }
        let mut tokens = tokens(body, self.offset + at, self.letters, self.decimal_comma);
        tokens.extend(label.map(|label| Token {
            kind: Lexeme::Tag(label),
            span: self.span(at + body.len(), text.len() - body.len()),
            spaced: true,
        }));
        let span = self.span(at, text.len());
        self.items
            .extend(items(parse::rows::rows(&tokens), true, span));
    }

    /// A sentence: the runs of mathematical words in it are formulas.
    fn sentence(&mut self, text: &str, at: usize) {
        let mut from = 0;
        if let Some((symbol, words)) = entry(text) {
            self.items.push(Item::Break);
            self.inline(&text[..symbol], at);
            self.prose(": ", at + symbol);
            return self.sentence(&text[words..], at + words);
        }
        for (start, end) in runs(text) {
            self.prose(&text[from..start], at + from);
            self.inline(&text[start..end], at + start);
            from = end;
        }
        self.prose(&text[from..], at + from);
    }

    fn inline(&mut self, text: &str, at: usize) {
        if refused(text, at).is_some() {
            return self.prose(text, at);
        }
        let tokens = tokens(text, self.offset + at, self.letters, self.decimal_comma);
        let reading = parse::rows::rows(&tokens);
        let broken = |row: &Row| matches!(row, Row::Unreadable { .. });
        if reading.rows.iter().any(broken) {
            return self.prose(text, at);
        }
        let span = self.span(at, text.len());
        self.items.extend(items(reading, false, span));
    }
}
