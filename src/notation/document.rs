//! A document as the verifier sees it: headings, prose and formulas in the order in which they stand.

use crate::notation::ast::Line;
use crate::notation::macros::Macros;
use crate::source::{Source, Span};
use std::collections::BTreeMap;

/// The kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Markdown with mathematics.
    Markdown,
    /// LaTeX.
    Latex,
    /// A Jupyter notebook.
    Notebook,
    /// Plain text, ASCII or Unicode.
    Text,
}

/// A document that was read.
#[derive(Clone, Debug)]
pub struct Document {
    /// The kind of file.
    pub format: Format,
    /// The text that all spans refer to. For a notebook it is the markdown cells one after the other, as
    /// in `cells`; otherwise the file itself.
    pub source: Source,
    /// For a notebook, where each markdown cell begins in `source` and its index among all cells.
    pub cells: Vec<Cell>,
    /// What the author set before the text began.
    pub front_matter: FrontMatter,
    /// The macros that it defines for itself.
    pub macros: Macros,
    /// Everything that stands in the document.
    pub items: Vec<Item>,
}

impl Document {
    /// Where a byte of the source stands, as its author would say it.
    #[must_use]
    pub fn place(&self, offset: u32) -> Place {
        let (line, column) = self.source.line_column(offset);
        let after = self.cells.partition_point(|cell| cell.span.start <= offset);
        let Some(cell) = self.cells[..after].last() else {
            return Place {
                cell: None,
                line,
                column,
            };
        };
        let (first, _) = self.source.line_column(cell.span.start);
        Place {
            cell: Some(cell.index),
            line: line + 1 - first,
            column,
        }
    }
}

impl Document {
    /// The rows of all formulas.
    pub(crate) fn rows(&self) -> impl Iterator<Item = &Row> {
        let formulas = self.items.iter().filter_map(|item| match item {
            Item::Formula(formula) => Some(&formula.rows),
            _ => None,
        });
        formulas.flatten()
    }

    /// The rows of all formulas that state something.
    pub(crate) fn lines(&self) -> impl Iterator<Item = &Line> {
        self.rows().filter_map(|row| match row {
            Row::Line(line) => Some(line),
            _ => None,
        })
    }

    /// Where a row stands that begins with a byte: words before its first sign are its beginning, as its author counts lines.
    pub(crate) fn place_of_row(&self, offset: u32) -> Place {
        let own = self.place(offset);
        let before = self.source.text.get(..offset as usize);
        let Some(begin) = before.and_then(begin_of_words) else {
            return own;
        };
        let begin = self.place(begin);
        match begin.cell == own.cell && begin.line < own.line {
            true => begin,
            false => own,
        }
    }
}

/// Where the words begin that end a text: `\textrm{Let us define: }`.
fn begin_of_words(before: &str) -> Option<u32> {
    const COMMANDS: [&str; 6] = ["text", "textrm", "textit", "textbf", "mbox", "intertext"];
    // Words are short, and no more is looked at for each row.
    const LONGEST: usize = 200;
    let inside = before.trim_end().strip_suffix('}')?;
    let open = inside.rfind('{').filter(|at| inside.len() - at < LONGEST)?;
    let words = &inside[open + 1..];
    let command = inside[..open].rfind('\\')?;
    let named = COMMANDS.contains(&&inside[command + 1..open]);
    (named && !words.contains('}'))
        .then(|| command.try_into().ok())
        .flatten()
}

/// Where a byte of a document stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// The line in the file, or in the cell of a notebook, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
}

/// A line as people call it: `line 8`, or `cell 2, line 8` in a notebook.
pub(crate) fn line_name(cell: Option<usize>, line: usize) -> String {
    match cell {
        Some(cell) => format!("cell {cell}, line {line}"),
        None => format!("line {line}"),
    }
}

/// The headings that a place of a document stands under.
#[derive(Clone, Debug, Default)]
pub(crate) struct Headings(Vec<(u8, String)>);

impl Headings {
    /// A heading ends those of its level and below.
    pub(crate) fn enter(&mut self, level: u8, text: &str) {
        self.0.retain(|(above, _)| *above < level);
        self.0.push((level, text.to_owned()));
    }

    /// Their texts, the outermost first.
    pub(crate) fn texts(&self) -> Vec<String> {
        self.0.iter().map(|(_, text)| text.clone()).collect()
    }
}

/// A markdown cell of a notebook.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Its index among all cells of the notebook, from 0.
    pub index: usize,
    /// The bytes of the document's source that hold it.
    pub span: Span,
}

/// Settings at the head of a document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrontMatter {
    /// `integrals` or `entries`.
    pub products: Option<String>,
    /// `body` or `turning`.
    pub axes: Option<String>,
    /// Names of symbols: what stands for what (`h: momentum`).
    pub symbols: BTreeMap<String, String>,
    /// Sentences that say what the document means.
    pub sentences: Vec<Sentence>,
    /// Every other key as it was written, for the grader.
    pub other: serde_json::Map<String, serde_json::Value>,
}

/// A sentence by which an author says what a document means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sentence {
    /// Its words on one line.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// One thing that stands in a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A heading; it opens a section.
    Heading {
        /// 1 for the highest.
        level: u8,
        /// Its words, with formulas left out.
        text: String,
        /// Where.
        span: Span,
    },
    /// Words between formulas, with markup taken off but spaces and stops kept. A paragraph's text and its inline
    /// formulas follow one another as items.
    Prose {
        /// The words.
        text: String,
        /// Where.
        span: Span,
    },
    /// The end of a paragraph, list item or block. Displays stand inside paragraphs: a sentence may go on after one.
    Break,
    /// A formula.
    Formula(Formula),
    /// `<!-- assume -->` or `% assume`: a comment that sets a role.
    Comment {
        /// The words in it.
        text: String,
        /// Where.
        span: Span,
    },
}

/// A formula: one or more lines, or a mere expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Set apart (`$$`) or inside the text (`$`).
    pub display: bool,
    /// Its bytes, delimiters included.
    pub span: Span,
    /// What it holds.
    pub rows: Vec<Row>,
}

/// One row of a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Row {
    /// A relation.
    Line(Line),
    /// An expression without a relation: a symbol that is named, or a term that is spoken of. A list `i, j, k` is
    /// one row for each entry.
    Expression(crate::notation::ast::Node),
    /// What could not be read: the reason and the place.
    Unreadable {
        /// What was met and what was expected.
        message: String,
        /// A way to write it, where one is known.
        help: Option<String>,
        /// Where.
        span: Span,
    },
}

/// Adds words to the prose that stands last, or as prose of their own behind anything else.
pub(crate) fn push_prose(items: &mut Vec<Item>, words: &str, span: Span) {
    if words.is_empty() {
        return;
    }
    match items.last_mut() {
        Some(Item::Prose { text, span: last }) => {
            text.push_str(words);
            *last = last.to(span);
        }
        _ => items.push(Item::Prose {
            text: words.to_owned(),
            span,
        }),
    }
}
