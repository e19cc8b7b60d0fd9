//! Derivations with pieces cut out, doubled, swapped and poisoned: they are read to an end, and every place that is named
//! lies in the file and between two characters.

use polhode::notation::ast::Node;
use polhode::notation::document::{Document, Format, Item, Row};
use polhode::notation::read;
use polhode::source::Span;
use proptest::prelude::*;

const DERIVATIONS: [&str; 5] = [
    include_str!("../../derivations/01-inertia-tensor.md"),
    include_str!("../../derivations/02-euler-equations.md"),
    include_str!("../../derivations/03-energy-and-momentum.md"),
    include_str!("../../derivations/04-symmetric-body.md"),
    include_str!("../../derivations/05-quaternion-rate.md"),
];

/// Pieces that mean something to the reader, where they are least expected.
const POISON: &[&str] = &[
    "$",
    "$$",
    "\\",
    "\\[",
    "\\)",
    "{",
    "}",
    "(",
    ")",
    "|",
    "&",
    "\\\\",
    "^",
    "_",
    "'",
    "%",
    "%%",
    "`",
    "```",
    "---\n",
    "<!--",
    "-->",
    "\0",
    "\u{202e}",
    "\u{307}",
    "\u{20d7}",
    "ω̇",
    "𝐋",
    "²",
    "½",
    "\u{feff}",
    "\r\n",
    "\n\n",
    "\t",
    "\\frac",
    "\\dot",
    "\\overset{\\circ}",
    "\\begin{cases}",
    "\\end{cases}",
    "\\left.",
    "\\right|",
    "\\text{",
    "\\tag{1}",
    "\\newcommand{\\a}{\\a\\a}",
    "\\a",
    "\\mqty(",
    "\\sqrt[",
    "d/dt",
    "1{,}0",
    "1\\,000",
    ",5",
    "e9",
    "\\verb|",
    "\\input{x}",
    "---",
    "=",
    "&=",
    "x**-",
    "# ",
    "| a | b |",
    "> ",
];

/// One change of a text, its places given as parts of its length.
#[derive(Clone, Debug)]
enum Change {
    Delete(f64, f64),
    Double(f64, f64),
    Swap(f64, f64),
    Insert(f64, usize),
}

fn change() -> impl Strategy<Value = Change> {
    let part = || 0.0..1.0f64;
    prop_oneof![
        (part(), part()).prop_map(|(a, b)| Change::Delete(a, b)),
        (part(), part()).prop_map(|(a, b)| Change::Double(a, b)),
        (part(), part()).prop_map(|(a, b)| Change::Swap(a, b)),
        (part(), 0..POISON.len()).prop_map(|(a, i)| Change::Insert(a, i)),
        (part(), 0..POISON.len()).prop_map(|(a, i)| Change::Insert(a, i)),
    ]
}

/// The boundary of a character near a part of the text.
fn place(text: &str, part: f64) -> usize {
    let mut at = (part * text.len() as f64) as usize;
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn changed(text: &str, change: &Change) -> String {
    // What is cut out or doubled is a twentieth of the text at most.
    let piece = |a: f64, b: f64| {
        let start = place(text, a);
        let end = place(text, (a + b / 20.0).min(1.0)).max(start);
        (&text[..start], &text[start..end], &text[end..])
    };
    match *change {
        Change::Delete(a, b) => {
            let (before, _, after) = piece(a, b);
            format!("{before}{after}")
        }
        Change::Double(a, b) => {
            let (before, middle, after) = piece(a, b);
            format!("{before}{middle}{middle}{after}")
        }
        Change::Swap(a, b) => {
            let (before, middle, after) = piece(a, b);
            format!("{middle}{before}{after}")
        }
        Change::Insert(a, i) => {
            let (before, after) = text.split_at(place(text, a));
            format!("{before}{}{after}", POISON[i])
        }
    }
}

fn holds(text: &str, span: Span) {
    let (start, end) = (span.start as usize, span.end as usize);
    assert!(
        start <= end && end <= text.len(),
        "{span:?} of {}",
        text.len()
    );
    assert!(
        text.is_char_boundary(start) && text.is_char_boundary(end),
        "{span:?}"
    );
}

fn nodes_hold(text: &str, root: &Node) {
    let mut open = vec![root];
    while let Some(node) = open.pop() {
        holds(text, node.span);
        open.extend(node.children());
    }
}

fn places_hold(document: &Document) {
    let text = &document.source.text;
    for item in &document.items {
        match item {
            Item::Heading { span, .. } | Item::Prose { span, .. } | Item::Comment { span, .. } => {
                holds(text, *span);
            }
            Item::Break => {}
            Item::Formula(formula) => {
                holds(text, formula.span);
                for row in &formula.rows {
                    match row {
                        Row::Unreadable { span, .. } => holds(text, *span),
                        Row::Expression(node) => nodes_hold(text, node),
                        Row::Line(line) => {
                            holds(text, line.span);
                            line.relations
                                .iter()
                                .for_each(|(_, span)| holds(text, *span));
                            line.sides.iter().for_each(|side| nodes_hold(text, side));
                        }
                    }
                }
            }
        }
    }
}

/// A notebook of one cell.
fn notebook(text: &str) -> String {
    let source = serde_json::to_string(text).expect("a text is JSON");
    format!(r#"{{"cells": [{{"cell_type": "markdown", "source": {source}}}], "nbformat": 4}}"#)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn what_is_broken_is_read_to_its_end(
        which in 0..DERIVATIONS.len(),
        changes in prop::collection::vec(change(), 1..12),
    ) {
        let text = changes
            .iter()
            .fold(DERIVATIONS[which].to_owned(), |text, change| changed(&text, change));
        for format in [Format::Markdown, Format::Latex, Format::Text] {
            let (document, troubles) = read("a", &text, format);
            places_hold(&document);
            troubles.iter().for_each(|trouble| holds(&text, trouble.primary.span));
        }
        let (document, _) = read("a.ipynb", &notebook(&text), Format::Notebook);
        places_hold(&document);
    }
}
