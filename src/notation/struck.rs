//! What an author has struck out: `~~…~~` and `<del>` in Markdown, `\sout{…}` and `\cancel{…}` in LaTeX.
//!
//! The reader keeps such text, for a term that cancels is struck out too. Who asks whether a line is still meant asks here.

use crate::notation::document::{Document, Format, Item};
use crate::notation::token::matching_brace;
use crate::source::Span;
use pulldown_cmark::{Event, Options, Parser, Tag};
use std::ops::Range;

/// Commands that strike out their argument.
const COMMANDS: [&str; 8] = [
    "cancel",
    "bcancel",
    "xcancel",
    "sout",
    "xout",
    "st",
    "hcancel",
    "strikeout",
];

/// Elements of HTML that strike out what stands in them.
const ELEMENTS: [&str; 3] = ["del", "s", "strike"];

/// No command strikes out more bytes.
const LONGEST: usize = 8_000;

/// What is struck out in a document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Struck {
    /// The bytes, with the marks around them.
    pub(crate) sure: Vec<Span>,
    /// The bytes between two marks that strike out nothing where they stand, as `~~` in two paragraphs.
    pub(crate) unsure: Vec<Span>,
}

/// What is struck out in a document, in the text and inside formulas.
pub(crate) fn struck(document: &Document) -> Struck {
    let text = &document.source.text;
    let mut found = Struck::default();
    if matches!(document.format, Format::Markdown | Format::Notebook) {
        let bare = without_formulas(document);
        if bare.contains('~') {
            found.sure.extend(in_markdown(&bare));
            found.unsure.extend(left_over(&bare, &found.sure));
        }
        found.sure.extend(in_elements(&bare));
    }
    found.sure.extend(by_commands(text));
    found
}

/// The text with letters in place of formulas, so that nothing in them is taken for Markdown.
fn without_formulas(document: &Document) -> String {
    let text = &document.source.text;
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(formula.span.range()),
        _ => None,
    });
    let (mut bare, mut at) = (String::with_capacity(text.len()), 0);
    for range in formulas.filter(|range| text.get(range.clone()).is_some()) {
        if range.start >= at {
            bare.push_str(&text[at..range.start]);
            bare.extend(std::iter::repeat_n('M', range.len()));
            at = range.end;
        }
    }
    bare.push_str(&text[at..]);
    bare
}

fn in_markdown(bare: &str) -> Vec<Span> {
    let events = Parser::new_ext(bare, Options::ENABLE_STRIKETHROUGH).into_offset_iter();
    let struck = events.filter(|(event, _)| matches!(event, Event::Start(Tag::Strikethrough)));
    struck.map(|(_, range)| span(range)).collect()
}

fn in_elements(bare: &str) -> Vec<Span> {
    // Only letters of ASCII change, so that places stay.
    let small = bare.to_ascii_lowercase();
    let mut found = vec![];
    for element in ELEMENTS {
        let (open, close) = (format!("<{element}>"), format!("</{element}>"));
        let mut at = 0;
        while let Some(start) = small[at..].find(&open).map(|start| at + start) {
            let end = small[start..].find(&close);
            let end = end.map_or(small.len(), |end| start + end + close.len());
            found.push(span(start..end));
            at = end;
        }
    }
    found
}

/// From one `~~` that strikes out nothing to the next.
fn left_over(bare: &str, sure: &[Span]) -> Vec<Span> {
    let mut covered = vec![false; bare.len()];
    for span in sure {
        covered[span.range()].fill(true);
    }
    let marks = bare.match_indices("~~").map(|(at, _)| at);
    let alone = marks.filter(|&at| {
        let fence = bare[at..].starts_with("~~~") || bare[..at].ends_with('~');
        !fence && !covered[at]
    });
    let alone: Vec<usize> = alone.collect();
    let pairs = alone.chunks_exact(2);
    pairs.map(|pair| span(pair[0]..pair[1] + 2)).collect()
}

/// The commands that strike out, each with its argument.
fn by_commands(text: &str) -> Vec<Span> {
    let mut found = vec![];
    for (at, _) in text.match_indices('\\') {
        let behind = &text[at + 1..];
        let length = behind.bytes().take_while(u8::is_ascii_alphabetic).count();
        let (name, mut rest) = behind.split_at(length);
        let struck = match name {
            "enclose" => rest
                .split_once('}')
                .filter(|(kind, _)| kind.contains("strike"))
                .map(|(_, argument)| rest = argument)
                .is_some(),
            _ => COMMANDS.contains(&name),
        };
        let argument = rest.trim_start();
        let open = text.len() - argument.len();
        if struck && let Some(inside) = argument.strip_prefix('{') {
            let ends = (0..=LONGEST.min(inside.len())).rev();
            let most = ends.into_iter().find(|&end| inside.is_char_boundary(end));
            let inside = &inside[..most.unwrap_or(0)];
            let length = matching_brace(inside).map_or(inside.len(), |length| length + 1);
            found.push(span(at..open + 1 + length));
        }
    }
    found
}

fn span(range: Range<usize>) -> Span {
    Span::new(range.start, range.end)
}
