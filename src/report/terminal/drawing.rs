//! One finding as a compiler draws it: a title, the place in the text, notes and remedies.

use crate::notation::document::Document;
use crate::notation::document::Place;
use crate::source::Span;
use annotate_snippets::{
    Annotation, AnnotationKind, Level, Message, Origin, Renderer, Snippet, normalize_untrusted_str,
};
use std::ops::Range;

/// Bytes that are shown before and after a place on an overlong line.
const MARGIN: usize = 240;
/// Bytes of a place that are underlined at most.
const UNDERLINED: usize = 4_000;

/// One drawing: a fact, its place, and what else there is to say.
pub(super) struct Drawing<'a> {
    pub(super) document: &'a Document,
    pub(super) level: Level<'static>,
    pub(super) code: Option<&'static str>,
    pub(super) title: String,
    pub(super) primary: (Span, String),
    pub(super) others: Vec<(Span, String)>,
    pub(super) notes: Vec<String>,
    pub(super) helps: Vec<String>,
}

/// Draws it, with terminal colours and an empty line at its end.
pub(super) fn draw(drawing: &Drawing<'_>) -> String {
    let (span, beside) = &drawing.primary;
    let place = drawing.document.place(span.start);
    let excerpt = Excerpt::around(&drawing.document.source.text, *span);
    let (mut annotations, mut notes) = (vec![], vec![]);
    let primary = AnnotationKind::Primary;
    annotations.push(annotation(primary, excerpt.range.clone(), beside));
    for (span, text) in &drawing.others {
        match excerpt.inside(*span) {
            Some(range) => annotations.push(annotation(AnnotationKind::Context, range, text)),
            None => notes.push(format!(
                "line {}: {text}",
                drawing.document.place(span.start).line
            )),
        }
    }
    let snippet = Snippet::source(excerpt.text)
        .line_start(place.line)
        .annotations(annotations);
    let mut title = drawing.level.clone().primary_title(&drawing.title);
    if let Some(code) = drawing.code {
        title = title.id(code);
    }
    let path = path(drawing.document, place);
    // The renderer counts columns from where the snippet begins, so a window of a line needs its origin said.
    let group = if excerpt.whole_lines {
        title.element(snippet.path(path))
    } else {
        let origin = Origin::path(path).line(place.line);
        title
            .element(origin.char_column(place.column))
            .element(snippet)
    };
    let group = group
        .elements(messages(&Level::NOTE, &notes))
        .elements(messages(&Level::NOTE, &drawing.notes))
        .elements(messages(&Level::HELP, &drawing.helps));
    Renderer::styled().render(&[group]) + "\n\n"
}

/// The document's name, with the cell for a notebook.
fn path(document: &Document, place: Place) -> String {
    let path = normalize_untrusted_str(&document.source.name);
    match place.cell {
        Some(cell) => format!("{path}, cell {cell}"),
        None => path,
    }
}

fn messages<'a>(
    level: &'a Level<'static>,
    texts: &'a [String],
) -> impl Iterator<Item = Message<'a>> {
    let texts = texts.iter();
    texts.map(|text| level.clone().message(normalize_untrusted_str(text)))
}

fn annotation<'a>(kind: AnnotationKind, range: Range<usize>, text: &str) -> Annotation<'a> {
    let annotation = kind.span(range);
    match text {
        "" => annotation,
        text => annotation.label(normalize_untrusted_str(text)),
    }
}

/// The part of a text that is shown around a place: whole lines, or a window of an overlong one.
struct Excerpt<'a> {
    text: &'a str,
    offset: usize,
    /// Whether `text` begins at the beginning of a line.
    whole_lines: bool,
    /// The place, within `text`.
    range: Range<usize>,
}

impl<'a> Excerpt<'a> {
    fn around(text: &'a str, span: Span) -> Self {
        let start = boundary(text, span.range().start);
        let end = boundary(text, span.range().end.min(start + UNDERLINED)).max(start);
        let (before, after) = text.split_at(start);
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let rest = after.split_at(end - start).1;
        let line_end = rest.find('\n').map_or(text.len(), |at| end + at);
        let offset = line_start.max(boundary(text, start.saturating_sub(MARGIN)));
        let last = line_end.min(boundary(text, end + MARGIN));
        Self {
            text: text.get(offset..last).unwrap_or_default(),
            offset,
            whole_lines: offset == line_start,
            range: start - offset..end - offset,
        }
    }

    /// A span as a range of the shown text, where it lies inside.
    fn inside(&self, span: Span) -> Option<Range<usize>> {
        let start = span.range().start.checked_sub(self.offset)?;
        let end = span.range().end.checked_sub(self.offset)?;
        self.text.get(start..end).map(|_| start..end)
    }
}

/// The last character boundary at or before an offset.
fn boundary(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
