//! Markdown with mathematics.

use crate::notation::delimiters::{Region, regions_and_comments};
use crate::notation::document::{Item, Row, push_prose};
use crate::notation::formula;
use crate::notation::macros::Macros;
use crate::notation::plain;
use crate::notation::triads::Triads;
use crate::source::Span;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::borrow::Cow;
use std::ops::Range;

/// Reads Markdown whose first byte stands at `offset` of the source.
pub(crate) fn items(text: &str, offset: usize, macros: &Macros) -> Vec<Item> {
    let (found, comments) = regions_and_comments(text);
    let masked = masked(text, &found, &comments);
    let mut reader = Reader {
        offset,
        text,
        macros,
        regions: &found,
        next: 0,
        heading: None,
        code: 0,
        unlabelled: false,
        items: vec![],
    };
    let parser = Parser::new_ext(
        &masked,
        Options::ENABLE_TABLES
            | Options::ENABLE_STRIKETHROUGH
            | Options::ENABLE_FOOTNOTES
            | Options::ENABLE_WIKILINKS,
    );
    for (event, range) in parser.into_offset_iter() {
        reader.event(event, range);
    }
    reader.formulas_before(usize::MAX);
    reader.items
}

/// The text with each formula replaced by as many letters, and each comment by spaces, so that nothing in them is taken
/// for Markdown.
fn masked(text: &str, regions: &[Region], comments: &[Range<usize>]) -> String {
    let formulas = regions.iter().map(|region| (&region.outer, 'M'));
    let mut parts: Vec<_> = formulas.chain(comments.iter().map(|c| (c, ' '))).collect();
    parts.sort_by_key(|(range, _)| range.start);
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for (range, cover) in parts {
        out.push_str(&text[at..range.start]);
        out.extend(std::iter::repeat_n(cover, range.len()));
        at = range.end;
    }
    out.push_str(&text[at..]);
    out
}

/// The inside of a formula; the marks of a quotation at the start of its lines give way to spaces.
fn unquoted<'a>(text: &'a str, region: &Region) -> Cow<'a, str> {
    let inner = text.get(region.inner.clone()).unwrap_or("");
    let mark = |c: char| matches!(c, '>' | ' ' | '\t');
    let quoted = |start: usize| {
        let line = text[..start].rfind('\n').map_or(0, |i| i + 1);
        text[line..start].trim_start().starts_with('>')
    };
    if !inner.contains('\n') || !quoted(region.outer.start) {
        return Cow::Borrowed(inner);
    }
    let mut lines = inner.split_inclusive('\n');
    let mut out = lines.next().unwrap_or("").to_owned();
    for line in lines {
        let rest = line.trim_start_matches(mark);
        out.extend(std::iter::repeat_n(' ', line.len() - rest.len()));
        out.push_str(rest);
    }
    Cow::Owned(out)
}

/// The level of a heading between signs, as wikis write them: `== Quaternions ==`.
fn level_between_signs(paragraph: &str) -> Option<u8> {
    let line = paragraph.trim();
    let rest = line.trim_start_matches('=');
    let level = line.len() - rest.len();
    let text = rest.trim_end_matches('=');
    let closed = rest.len() - text.len() == level && !line.contains('\n');
    let words = text.starts_with(' ') && text.ends_with(' ') && !text.contains(['=', '$']);
    let level = u8::try_from(level).ok()?;
    (closed && words && (1..=6).contains(&level)).then_some(level)
}

/// Greek letters, letters with dots, raised and lowered ones, and signs of operations.
fn is_of_mathematics(c: char) -> bool {
    matches!(
        c,
        '\u{300}'..='\u{36f}'
            | '\u{370}'..='\u{3ff}'
            | '\u{1d2c}'..='\u{1d6a}'
            | '\u{1e00}'..='\u{1eff}'
            | '\u{2070}'..='\u{209c}'
            | '·' | '×' | '²' | '³' | '√' | '∂' | '∫' | '∑'
    )
}

struct Reader<'a> {
    offset: usize,
    text: &'a str,
    macros: &'a Macros,
    regions: &'a [Region],
    next: usize,
    heading: Option<(u8, String, usize)>,
    code: usize,
    /// Whether the code says of no language that it is in it.
    unlabelled: bool,
    items: Vec<Item>,
}

impl Reader<'_> {
    fn span(&self, range: &Range<usize>) -> Span {
        Span::new(self.offset + range.start, self.offset + range.end)
    }

    fn event(&mut self, event: Event<'_>, range: Range<usize>) {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                self.formulas_before(range.start);
                self.heading = Some((level as u8, String::new(), range.start));
            }
            Event::Start(Tag::Paragraph)
                if let Some(level) = self.text.get(range.clone()).and_then(level_between_signs) =>
            {
                self.formulas_before(range.start);
                self.heading = Some((level, String::new(), range.start));
            }
            Event::End(TagEnd::Heading(_)) => self.end_heading(range),
            Event::End(TagEnd::Paragraph) if self.heading.is_some() => {
                if let Some((_, text, _)) = &mut self.heading {
                    *text = text.trim().trim_matches('=').to_owned();
                }
                self.end_heading(range);
            }
            // Text that is set in from the margin with formulas in it is no code.
            Event::Start(Tag::CodeBlock(CodeBlockKind::Indented)) if self.has_formulas(&range) => {
                self.formulas_before(range.start);
            }
            Event::End(TagEnd::CodeBlock) if self.code == 0 => {
                self.formulas_before(range.end);
                self.items.push(Item::Break);
            }
            Event::Start(Tag::CodeBlock(kind)) => {
                self.code += 1;
                self.unlabelled = match kind {
                    CodeBlockKind::Fenced(language) => matches!(&*language, "" | "text"),
                    CodeBlockKind::Indented => false,
                };
            }
            Event::End(TagEnd::CodeBlock) => {
                self.code = self.code.saturating_sub(1);
                self.regions_skipped(range);
            }
            Event::End(
                TagEnd::Paragraph
                | TagEnd::Item
                | TagEnd::TableCell
                | TagEnd::BlockQuote(_)
                | TagEnd::HtmlBlock,
            ) => {
                self.formulas_before(range.end);
                self.items.push(Item::Break);
            }
            Event::Start(_) => self.formulas_before(range.start),
            Event::Text(_) if self.code > 0 && self.unlabelled => self.plain(range),
            Event::Text(_) if self.code > 0 => {}
            Event::Text(text) => self.text(&text, range),
            Event::Code(text) => {
                self.formulas_before(range.start);
                let inside = range.start + 1..range.end.saturating_sub(1);
                match self.heading.is_none() && self.is_plain_formula(&inside) {
                    true => self.plain(inside),
                    false => self.prose(&text, &range),
                }
            }
            Event::SoftBreak | Event::HardBreak => {
                self.formulas_before(range.start);
                self.prose(" ", &range);
            }
            Event::Html(html) | Event::InlineHtml(html) => self.html(&html, range),
            _ => {}
        }
    }

    /// A fenced block of the language `math` is a region of its own; formulas in any other code are none.
    fn regions_skipped(&mut self, range: Range<usize>) {
        while let Some(region) = self
            .regions
            .get(self.next)
            .filter(|r| r.outer.start < range.end)
        {
            if region.outer.start <= range.start + 3 && region.outer.end + 3 >= range.end {
                self.formula(region.clone());
            }
            self.next += 1;
        }
    }

    /// Whether formulas with commands of LaTeX stand between their signs in a piece of the text.
    fn has_formulas(&self, range: &Range<usize>) -> bool {
        let mut inside = self.regions[self.next..].iter();
        let mut inside = inside.by_ref().take_while(|r| r.outer.start < range.end);
        inside.any(|region| {
            let formula = self.text.get(region.inner.clone()).unwrap_or("");
            let follows =
                |at: usize| formula[at + 1..].starts_with(|c: char| c.is_ascii_alphabetic());
            region.outer.start >= range.start
                && formula.match_indices('\\').any(|(at, _)| follows(at))
        })
    }

    /// Whether a piece of the text is mathematics in Unicode: it has a sign of relation, and letters or signs that programs
    /// do without.
    fn is_plain_formula(&self, range: &Range<usize>) -> bool {
        let text = self.text.get(range.clone()).unwrap_or("");
        text.contains(['=', '≈', '≠', '≤', '≥']) && text.contains(is_of_mathematics)
    }

    /// Code that is mathematics in Unicode is read as plain text is.
    fn plain(&mut self, range: Range<usize>) {
        if !self.is_plain_formula(&range) {
            return;
        }
        let text = self.text.get(range.clone()).unwrap_or("");
        let triads = Triads::of(text);
        let found = plain::read(
            text,
            self.offset + range.start,
            self.macros.decimal_comma,
            triads,
        );
        self.items.extend(found);
    }

    /// Text in which formulas may stand; where escapes have changed nothing, the bytes of the source are used.
    fn text(&mut self, text: &str, range: Range<usize>) {
        let mut at = range.start;
        let inside = |region: &&Region| region.outer.start < range.end;
        if self.regions.get(self.next).filter(inside).is_none() {
            return self.prose(text, &range);
        }
        while let Some(region) = self.regions.get(self.next).filter(inside).cloned() {
            if region.outer.start > at {
                let words = self
                    .text
                    .get(at..region.outer.start)
                    .unwrap_or("")
                    .to_owned();
                self.prose(&words, &(at..region.outer.start));
            }
            at = region.outer.end;
            self.next += 1;
            self.formula(region);
        }
        if at < range.end {
            let words = self.text.get(at..range.end).unwrap_or("").to_owned();
            self.prose(&words, &(at..range.end));
        }
    }

    /// `{#eq-euler}` and `(eq:euler)` behind a display name it.
    fn label<'w>(&mut self, words: &'w str) -> &'w str {
        let text = words.trim_start();
        let found = [("{#", '}'), ("(eq:", ')')]
            .iter()
            .find(|(open, _)| text.starts_with(open));
        let line = match self.items.last_mut() {
            Some(Item::Formula(formula)) if formula.display => formula.rows.last_mut(),
            _ => None,
        };
        let (Some((open, close)), Some(Row::Line(line))) = (found, line) else {
            return words;
        };
        let Some(end) = text.find(*close) else {
            return words;
        };
        let name = text[open.len()..end].split_whitespace().next();
        let prefix = if *close == ')' { "eq:" } else { "" };
        line.labels
            .extend(name.map(|name| format!("{prefix}{name}")));
        &text[end + 1..]
    }

    fn prose(&mut self, words: &str, range: &Range<usize>) {
        let words = self.label(words);
        if let Some((_, heading, _)) = &mut self.heading {
            heading.push_str(words);
            return;
        }
        let span = self.span(range);
        push_prose(&mut self.items, words, span);
    }

    fn formula(&mut self, region: Region) {
        let inner = unquoted(self.text, &region);
        let found = formula(&inner, self.offset, &region, self.macros);
        // A formula in a heading names its subject; it states nothing.
        if self.heading.is_none() {
            self.items.extend(found);
        }
    }

    fn formulas_before(&mut self, limit: usize) {
        while let Some(region) = self
            .regions
            .get(self.next)
            .filter(|r| r.outer.start < limit)
            .cloned()
        {
            self.next += 1;
            self.formula(region);
        }
    }

    fn end_heading(&mut self, range: Range<usize>) {
        self.formulas_before(range.end);
        if let Some((level, text, _)) = self.heading.take() {
            let span = self.span(&range);
            self.items.push(Item::Heading {
                level,
                text: text.trim().to_owned(),
                span,
            });
        }
    }

    /// The comments of a piece of HTML; a formula may stand between two of them.
    fn html(&mut self, html: &str, range: Range<usize>) {
        let mut at = 0;
        while let Some(open) = html[at..].find("<!--") {
            let start = at + open;
            let inner = &html[start + 4..];
            let length = inner.find("-->").unwrap_or(inner.len());
            self.formulas_before(range.start + start);
            let text = inner[..length].trim().to_owned();
            let span = self.span(&(range.start + start..range.end));
            self.items.push(Item::Comment { text, span });
            at = (start + 4 + length + 3).min(html.len());
        }
        if at == 0 {
            self.formulas_before(range.start);
        }
    }
}
