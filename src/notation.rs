//! Reads what people write: a text becomes a [`Document`] of headings, prose and
//! formulas, and each formula a typed tree.
//!
//! Reading never fails. What is not understood stands in the tree as an error at its place, and everything
//! around it is read all the same.
//!
#![doc = include_str!("notation/manual.md")]

mod alphabets;
pub mod ast;
mod delimiters;
pub mod document;
mod front_matter;
mod habits;
mod lately;
mod latex;
mod lexer;
mod long_lines;
mod macros;
mod markdown;
mod notebook;
mod parse;
mod plain;
mod plain_words;
pub mod print;
mod seen_from;
mod sentences;
mod struck;
mod token;
mod told_marks;
mod triads;
mod unicode;

pub use alphabets::lookalike;
pub(crate) use front_matter::SETTINGS;
pub use macros::Macros;
pub use sentences::sentences;
pub(crate) use struck::{Struck, struck};

use crate::diagnostic::Diagnostic;
use crate::source::{Source, Span};
use delimiters::{Region, is_restructured, with_plain_headings};
use document::{Document, Format, Formula, Item, Row};
use parse::rows::Reading;
use std::borrow::Cow;
use std::path::Path;
use token::Letters;
use triads::Triads;

/// What is read, and as what, in Markdown: the manual that `polhode help notation` shows.
pub const MANUAL: &str = include_str!("notation/manual.md");

/// A formula longer than this is not read: nobody writes one, and a proof of it would not end.
const LONGEST_FORMULA: usize = 50_000;

/// What the macros of a formula that is read anew may expand to.
const LONGEST_REREAD: usize = 10_000;

impl Format {
    /// The format that the name of a file promises; Markdown where it promises none.
    pub fn of_path(path: &Path) -> Self {
        match path.extension().and_then(|e| e.to_str()) {
            Some("tex" | "ltx" | "latex") => Self::Latex,
            Some("ipynb") => Self::Notebook,
            Some("txt" | "text") => Self::Text,
            _ => Self::Markdown,
        }
    }
}

/// Reads a document. What could not be read is said beside it, and the rest stands in it.
///
/// ```
/// use polhode::notation::{document::{Format, Item}, read};
///
/// let (document, troubles) = read("note.md", "Then $L_x = I_x\\omega_x$.", Format::Markdown);
/// assert!(troubles.is_empty());
/// assert!(matches!(document.items[1], Item::Formula(_)));
/// ```
pub fn read(name: &str, text: &str, format: Format) -> (Document, Vec<Diagnostic>) {
    read_with(name, text, format, &[])
}

/// Reads a document of which sentences tell elsewhere what it means. A command that it does not define is a mark of
/// letters where such a sentence, or one of its own, sets it around a letter, and a letter where one speaks of it alone.
///
/// ```
/// use polhode::notation::{document::{Format, Item}, read_declared};
///
/// let told = ["`\\uvec{k}` is a unit vector."];
/// let (_, troubles) = read_declared("note.md", "$\\uvec{k} = \\uvec{k}$", Format::Markdown, &told);
/// assert!(troubles.is_empty());
/// ```
pub fn read_declared(
    name: &str,
    text: &str,
    format: Format,
    sentences: &[&str],
) -> (Document, Vec<Diagnostic>) {
    let (document, troubles) = read(name, text, format);
    let own = document.front_matter.sentences.iter();
    let own = own.map(|said| said.text.as_str());
    let all = own.chain(sentences.iter().copied());
    let marks = told_marks::told_marks(all, text, &document.macros);
    match marks.is_empty() {
        true => (document, troubles),
        false => read_with(name, text, format, &marks),
    }
}

/// Reads a document with commands that mark letters.
fn read_with(name: &str, text: &str, format: Format, marks: &Marks) -> (Document, Vec<Diagnostic>) {
    let mut troubles = vec![];
    // A text with displays that are marked as such is read by these marks.
    let restructured = format == Format::Text && is_restructured(text);
    let format = if restructured {
        Format::Markdown
    } else {
        format
    };
    let headed = restructured.then(|| with_plain_headings(text));
    let text = headed.as_deref().unwrap_or(text);
    let mut document = read_items(name, text, format, (false, marks), &mut troubles);
    if habits::decimal_commas(&document) {
        troubles.clear();
        document = read_items(name, text, format, (true, marks), &mut troubles);
    }
    habits::labels_above(&mut document);
    habits::rates_in_deltas(&mut document);
    seen_from::labels_under_dots(&mut document);
    troubles.extend(deceptive(&document.source.text));
    for item in &document.items {
        if let Item::Formula(formula) = item {
            troubles.extend(formula.rows.iter().filter_map(trouble));
        }
    }
    (document, troubles)
}

/// Commands that mark letters or are letters, each with what it stands for.
type Marks = [(String, String)];

/// Reads what stands in a document, with the decimal sign and the marks that its author uses.
fn read_items(
    name: &str,
    text: &str,
    format: Format,
    (decimal_comma, marks): (bool, &Marks),
    troubles: &mut Vec<Diagnostic>,
) -> Document {
    let macros = |text: &str| {
        let found = Macros::collect(text).with_decimal_comma(decimal_comma);
        found.with_marks(marks)
    };
    let mut document = match format {
        Format::Notebook => notebook::read(name, text, &macros, troubles),
        _ => Document {
            format,
            source: Source::new(name, text),
            cells: vec![],
            front_matter: document::FrontMatter::default(),
            macros: Macros::default().with_decimal_comma(decimal_comma),
            items: vec![],
        },
    };
    let text = match format {
        Format::Notebook => Cow::Borrowed(text),
        _ => long_lines::blanked(text, format, troubles),
    };
    let text = text.as_ref();
    match format {
        Format::Notebook => {}
        Format::Markdown => {
            let body = front_matter::take(text, &mut document.front_matter, troubles);
            document.macros = macros(&text[body..]);
            document.items = markdown::items(&text[body..], body, &document.macros);
        }
        Format::Latex => {
            document.macros = macros(text);
            let front = &mut document.front_matter;
            document.items = latex::items(text, &document.macros, front, troubles)
        }
        Format::Text => {
            let body = front_matter::take(text, &mut document.front_matter, troubles);
            document.macros.triads = Triads::of(&text[body..]);
            let triads = document.macros.triads;
            document.items = plain::read(&text[body..], body, decimal_comma, triads);
        }
    }
    document
}

/// Says where a text holds characters that hide what it says; formulas with one are not read.
fn deceptive(text: &str) -> Option<Diagnostic> {
    let (what, span) = hidden(text, 0)?;
    Some(Diagnostic::warning("hidden", span, what))
}

/// The first character of a text that hides what it says, in words.
fn hidden(text: &str, offset: usize) -> Option<(&'static str, Span)> {
    let doubtful = |b: u8| b == 0 || b == unicode::FIRST_BYTE_OF_A_MARK;
    if !text.bytes().any(doubtful) {
        return None;
    }
    let (at, c) = text.char_indices().find(|(_, c)| unicode::deceptive(*c))?;
    let what = match c {
        '\0' => "a NUL byte stands here",
        _ => {
            "a mark that turns the direction of writing stands here: what is shown is not what is read"
        }
    };
    Some((what, Span::new(offset + at, offset + at + c.len_utf8())))
}

/// What keeps a formula from being read at all.
fn refused(text: &str, offset: usize) -> Option<Reading> {
    if text.len() > LONGEST_FORMULA {
        return Some(too_long(Span::new(offset, offset + text.len())));
    }
    hidden(text, offset).map(|(what, span)| unreadable(what, None, span))
}

fn trouble(row: &Row) -> Option<Diagnostic> {
    let (message, span) = parse::rows::first_error(row)?;
    Some(Diagnostic::warning("unreadable", span, message))
}

/// Reads the LaTeX of one formula whose first byte stands at `offset` of its source.
pub fn read_formula(text: &str, offset: usize, macros: &Macros) -> Vec<Row> {
    reading(text, offset, macros).rows
}

/// The rows of a formula and the words between them.
fn reading(text: &str, offset: usize, macros: &Macros) -> Reading {
    if let Some(refused) = refused(text, offset) {
        return refused;
    }
    if macros.is_empty() {
        let commas = macros.decimal_comma;
        let read = |text: &str, offset: usize| {
            parse::rows::rows(&lexer::tokens(text, offset, Letters::Single, commas))
        };
        return match commas {
            true => read(text, offset),
            false => lately::read_lately(text, offset, read),
        };
    }
    let Some((expanded, origin)) = macros.expand(text) else {
        let span = Span::new(offset, offset + text.len());
        return unreadable("a macro that expands without end", None, span);
    };
    let mut tokens = lexer::tokens(&expanded, 0, Letters::Single, macros.decimal_comma);
    let end_of_text = Span::new(text.len(), text.len());
    let came_from = |at: u32| origin.get(at as usize).copied().unwrap_or(end_of_text);
    for token in &mut tokens {
        let last = token.span.end.saturating_sub(1).max(token.span.start);
        token.span = came_from(token.span.start)
            .to(came_from(last))
            .shifted(offset);
    }
    parse::rows::rows(&tokens)
}

/// Reads a formula as if it stood in a document, spans counted from its own first byte.
pub fn reread(document: &Document, text: &str) -> Vec<Row> {
    document.macros.allow(LONGEST_REREAD);
    match document.format {
        Format::Text => {
            let letters = Letters::Words(document.macros.triads);
            let decimal_comma = document.macros.decimal_comma;
            parse::rows::rows(&lexer::tokens(text, 0, letters, decimal_comma)).rows
        }
        _ => read_formula(text, 0, &document.macros),
    }
}

fn too_long(span: Span) -> Reading {
    let help = "write it in several lines";
    unreadable("a formula that is too long to be read", Some(help), span)
}

fn unreadable(message: &str, help: Option<&str>, span: Span) -> Reading {
    let row = Row::Unreadable {
        message: message.into(),
        help: help.map(str::to_owned),
        span,
    };
    Reading {
        rows: vec![row],
        words: vec![],
    }
}

/// The formula of a region, whose inside is `inner`, of a text that begins at `offset` of the source.
fn formula(inner: &str, offset: usize, region: &Region, macros: &Macros) -> Vec<Item> {
    let span = Span::new(offset + region.outer.start, offset + region.outer.end);
    let reading = if region.closed {
        reading(inner, offset + region.inner.start, macros)
    } else {
        let help = "close it before the paragraph ends";
        unreadable("a formula that is not closed", Some(help), span)
    };
    items(reading, region.display, span)
}

/// A formula, parted where words of the sentence stand in it: `a = b \text{ where } c = d`.
fn items(reading: Reading, display: bool, span: Span) -> Vec<Item> {
    let mut items = vec![];
    let mut rows = reading.rows.into_iter();
    let (mut taken, mut start) = (0, span.start);
    let part = |rows: Vec<Row>, start: u32, end: u32| {
        (!rows.is_empty()).then(|| {
            let span = Span { start, end };
            Item::Formula(Formula {
                display,
                span,
                rows,
            })
        })
    };
    for (before, text, place) in reading.words {
        let rows = rows.by_ref().take(before - taken).collect();
        items.extend(part(rows, start, place.start));
        items.push(Item::Prose {
            text: format!(" {text} "),
            span: place,
        });
        (taken, start) = (before, place.end);
    }
    let rest: Vec<Row> = rows.collect();
    if rest.is_empty() && items.is_empty() {
        items.push(Item::Formula(Formula {
            display,
            span,
            rows: rest,
        }));
    } else {
        items.extend(part(rest, start, span.end));
    }
    items
}
