//! Plain text: formulas on lines of their own or inside sentences, in Unicode or ASCII.

use crate::notation::document::{Item, Row};
use crate::notation::items;
use crate::notation::lexer::tokens;
use crate::notation::parse;
use crate::notation::token::Letters;
use crate::notation::unicode;
use crate::source::Span;

/// The items of a text whose first byte stands at `offset` of the source.
pub(crate) fn read(text: &str, offset: usize) -> Vec<Item> {
    let mut reader = Reader {
        offset,
        items: vec![],
    };
    let mut at = 0;
    let mut lines = text.split_inclusive('\n').peekable();
    while let Some(line) = lines.next() {
        let level = lines.peek().and_then(|next| underline(next));
        match level {
            Some(level) if !line.trim().is_empty() => {
                let span = reader.span(at, line.trim_end().len());
                reader.items.push(Item::Heading {
                    level,
                    text: line.trim().to_owned(),
                    span,
                });
                at += line.len() + lines.next().map_or(0, str::len);
                continue;
            }
            _ => reader.line(line, at),
        }
        at += line.len();
    }
    reader.items
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

struct Reader {
    offset: usize,
    items: Vec<Item>,
}

impl Reader {
    fn span(&self, start: usize, length: usize) -> Span {
        Span::new(self.offset + start, self.offset + start + length)
    }

    fn line(&mut self, line: &str, at: usize) {
        let text = line.trim_end();
        if text.trim().is_empty() {
            self.items.push(Item::Break);
            return;
        }
        if let Some(heading) = text.strip_prefix('#') {
            let text = heading.trim_start_matches('#').trim().to_owned();
            let level = u8::try_from(line.bytes().take_while(|b| *b == b'#').count())
                .unwrap_or(6)
                .min(6);
            let span = self.span(at, line.trim_end().len());
            self.items.push(Item::Heading { level, text, span });
            return;
        }
        let lead = text.len() - text.trim_start().len();
        if is_formula(text) {
            self.formula(text.trim_start(), at + lead, true);
            return;
        }
        self.sentence(text, at);
        self.prose(" ", at + text.len());
    }

    fn prose(&mut self, words: &str, at: usize) {
        if words.is_empty() {
            return;
        }
        let span = self.span(at, words.len());
        match self.items.last_mut() {
            Some(Item::Prose { text, span: last }) => {
                text.push_str(words);
                *last = last.to(span);
            }
            _ => self.items.push(Item::Prose {
                text: words.to_owned(),
                span,
            }),
        }
    }

    fn formula(&mut self, text: &str, at: usize, display: bool) {
        let reading = parse::rows::rows(&tokens(text, self.offset + at, Letters::Words));
        let span = self.span(at, text.len());
        if !display
            && reading
                .rows
                .iter()
                .any(|row| matches!(row, Row::Unreadable { .. }))
        {
            return self.prose(text, at);
        }
        self.items.extend(items(reading, display, span));
    }

    /// A sentence: the runs of mathematical words in it are formulas.
    fn sentence(&mut self, text: &str, at: usize) {
        let mut from = 0;
        for (start, end) in runs(text) {
            self.prose(&text[from..start], at + from);
            self.formula(&text[start..end], at + start, false);
            from = end;
        }
        self.prose(&text[from..], at + from);
    }
}

/// How much a word looks like mathematics.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd)]
enum Look {
    Words,
    /// Could be either: a bracket, a number, a lone letter.
    Weak,
    Strong,
}

/// Short words of English that are no letters of a formula.
const SHORT: &[&str] = &[
    "a", "an", "as", "at", "be", "by", "do", "if", "in", "is", "it", "no", "of", "on", "or", "so",
    "to", "up", "us", "we", "he", "my", "go",
];

fn look(word: &str) -> Look {
    let core = word.trim_matches(['.', ',', ';', ':']);
    let strong = core.chars().any(|c| {
        matches!(
            c,
            '=' | '^' | '_' | '²' | '³' | '½' | '×' | '·' | '−' | '√' | '∂' | '∫'
        ) || ('Α'..='ω').contains(&c)
            || ('₀'..='₉').contains(&c)
            || ('\u{300}'..='\u{36f}').contains(&c)
            || !unicode::decomposed(c).1.is_empty()
    });
    let known = |word: &str| unicode::word(word).is_some();
    if strong || known(core) || is_rate(core) {
        return Look::Strong;
    }
    let runs = || {
        core.split(|c: char| !c.is_alphabetic())
            .filter(|run| !run.is_empty())
    };
    let english = |run: &str| SHORT.contains(&run) || run.chars().count() > 2;
    let sentence_letter = matches!(core, "A" | "I") && word != core;
    if core.is_empty() || sentence_letter || runs().any(|run| english(run) && !known(run)) {
        return Look::Words;
    }
    Look::Weak
}

/// `dT/dt`.
fn is_rate(word: &str) -> bool {
    let mut parts = word.splitn(2, '/');
    let differential =
        |part: Option<&str>| part.is_some_and(|p| p.starts_with('d') && p.chars().count() <= 4);
    differential(parts.next()) && differential(parts.next())
}

/// A line that is a formula as a whole: a relation, and no words.
fn is_formula(text: &str) -> bool {
    let related = text.contains(['=', '≈', '≠', '≡', '<', '>']);
    let label = text
        .rfind("  (")
        .filter(|&i| text.ends_with(')') && i > 0)
        .unwrap_or(text.len());
    related
        && text[..label]
            .split_whitespace()
            .all(|word| look(word) != Look::Words || matches!(word, "A" | "I" | "a" | "A," | "I,"))
}

/// The runs of words that hold something strongly mathematical, as ranges of bytes.
fn runs(text: &str) -> Vec<(usize, usize)> {
    let mut out = vec![];
    let mut run: Option<(usize, usize, bool)> = None;
    let mut at = 0;
    for piece in text.split_inclusive(char::is_whitespace) {
        let word = piece.trim_end();
        let look = look(word);
        let lone_letter = word.len() == 1 && matches!(word, "A" | "I" | "a");
        let after_operator = run.is_some_and(|(start, end, _)| {
            text[start..end].ends_with(['=', '+', '-', '−', '/', '*', '(', '×', '·'])
        });
        let belongs = look != Look::Words
            || (after_operator && word.trim_end_matches(['.', ',']).len() == 1)
            || (lone_letter && run.is_some());
        if belongs && !word.is_empty() {
            let stop = word.ends_with(['.', ',', ';', ':']);
            let end = at + word.trim_end_matches(['.', ',', ';', ':']).len();
            let strong = look == Look::Strong;
            run = Some(run.map_or((at, end, strong), |(start, _, before)| {
                (start, end, before || strong)
            }));
            if stop {
                out.extend(run.take());
            }
        } else if !word.is_empty() {
            out.extend(run.take());
        }
        at += piece.len();
    }
    out.extend(run);
    out.into_iter()
        .filter(|(start, end, strong)| *strong && end > start)
        .map(|(start, end, _)| (start, end))
        .collect()
}
