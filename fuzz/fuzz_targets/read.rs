//! Reading ends without a panic, and every place that it names lies in the text.
//!
//! `cargo +nightly fuzz run read`; the first byte of an input chooses the format.

#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode::notation::document::{Document, Format, Item, Row};
use polhode::notation::read;
use polhode::source::Span;

fn format(byte: u8) -> Format {
    match byte % 4 {
        0 => Format::Markdown,
        1 => Format::Latex,
        2 => Format::Text,
        _ => Format::Notebook,
    }
}

fn holds(text: &str, span: Span) {
    let (start, end) = (span.start as usize, span.end as usize);
    assert!(text.get(start..end).is_some(), "{span:?} of {}", text.len());
}

fn places_hold(document: &Document) {
    let text = &document.source.text;
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        holds(text, formula.span);
        let mut open = vec![];
        for row in &formula.rows {
            match row {
                Row::Unreadable { span, .. } => holds(text, *span),
                Row::Expression(node) => open.push(node),
                Row::Line(line) => open.extend(&line.sides),
            }
        }
        while let Some(node) = open.pop() {
            holds(text, node.span);
            open.extend(node.children());
        }
    }
}

fuzz_target!(|input: (u8, &str)| {
    let (document, _) = read("fuzz", input.1, format(input.0));
    places_hold(&document);
});
