//! Documents that write their quaternion in one layout and then in another: first `q_0` for the scalar, then `q_4`.

use crate::notation::ast::Symbol;
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::attitude_reading::{AttitudeReading, Part, Spelling};
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::words::attitude_words::{Sentence, sentences};
use crate::verify::words::book::has_any;
use std::collections::BTreeMap;

/// Changes of the layout that are followed at most.
const CHANGES: usize = 8;

/// How the quaternion is written from a place of the document on.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    /// The first byte.
    start: u32,
    scalar_last: bool,
    parts: BTreeMap<Spelling, Part>,
}

impl AttitudeReading {
    /// Reads the quaternion as the document writes it at a place.
    pub(crate) fn turn_to(&mut self, place: u32) {
        let layout = self.layouts.iter().rfind(|layout| layout.start <= place);
        if let Some(layout) = layout.cloned() {
            self.scalar_last = layout.scalar_last;
            self.parts = layout.parts;
        }
    }

    /// The layouts of a document whose scalar is called `q_0` in one part and `q_4` in another; none where it has one
    /// name throughout.
    pub(crate) fn layouts(
        &self,
        document: &Document,
        taken: &impl Fn(&Letter) -> bool,
    ) -> Vec<Layout> {
        let Some(letter) = &self.quaternion else {
            return vec![];
        };
        let starts = changes(document, letter);
        if starts.len() < 2 {
            return vec![];
        }
        let ends = starts.iter().skip(1).map(|&end| Some(end)).chain([None]);
        let layout = |(&start, end): (&usize, Option<usize>)| {
            let items = &document.items[start..end.unwrap_or(document.items.len())];
            let part = Document {
                items: items.to_vec(),
                ..document.clone()
            };
            let mut reading = Self::default();
            let all: Vec<&Symbol> = part
                .lines()
                .flat_map(|line| &line.sides)
                .flat_map(symbols)
                .collect();
            reading.find_quaternion(&all, &sentences(&part), taken);
            part.lines()
                .for_each(|line| line.sides.iter().for_each(|side| reading.layout(side)));
            Layout {
                start: items.iter().find_map(place).unwrap_or(0),
                scalar_last: reading.scalar_last,
                parts: reading.parts,
            }
        };
        starts.iter().zip(ends).map(layout).collect()
    }
}

/// The items at which the scalar changes its name, the first included: the heading, or else the paragraph, that the new
/// name stands in.
fn changes(document: &Document, letter: &Letter) -> Vec<usize> {
    let mut starts = vec![0];
    let (mut heading, mut paragraph) = (None, 0);
    let mut now: Option<&str> = None;
    for (at, item) in document.items.iter().enumerate() {
        match item {
            Item::Heading { .. } => heading = Some(at),
            Item::Break => paragraph = at + 1,
            Item::Formula(formula) => {
                let names = scalars(&formula.rows, letter);
                let [name] = names.as_slice() else {
                    continue;
                };
                if now.is_some_and(|now| now != *name) && starts.len() < CHANGES {
                    starts.push(heading.unwrap_or(paragraph));
                }
                (now, heading) = (Some(*name), None);
            }
            _ => {}
        }
    }
    starts
}

/// The names, of `0` and `4`, that the scalar has in a formula.
fn scalars(rows: &[Row], letter: &Letter) -> Vec<&'static str> {
    let of_row = |row: &Row| -> Vec<Symbol> {
        match row {
            Row::Line(line) => line.sides.iter().flat_map(symbols).cloned().collect(),
            Row::Expression(node) => symbols(node).into_iter().cloned().collect(),
            Row::Unreadable { .. } => vec![],
        }
    };
    let all: Vec<Symbol> = rows.iter().flat_map(of_row).collect();
    let named = |name: &&str| {
        let mut own = all.iter().filter(|s| Letter::of(s) == *letter);
        own.any(|s| s.subscripts == [*name])
    };
    ["0", "4"].into_iter().filter(named).collect()
}

fn place(item: &Item) -> Option<u32> {
    match item {
        Item::Heading { span, .. } | Item::Prose { span, .. } | Item::Comment { span, .. } => {
            Some(span.start)
        }
        Item::Formula(formula) => Some(formula.span.start),
        Item::Break => None,
    }
}

/// Whether the words call a letter the vector part of the quaternion.
pub(crate) fn is_vector_part(letter: &str, said: &[Sentence]) -> bool {
    let name = format!("⟨{letter}⟩");
    let called = [
        format!("{name} is the vector part"),
        format!("{name} for the vector part"),
        format!("{name} the vector part"),
        format!("{name} denotes the vector part"),
        format!("vector part {name}"),
        format!("vector part is {name}"),
        format!("vector part by {name}"),
    ];
    said.iter().any(|s| has_any(&s.text, &called))
}
