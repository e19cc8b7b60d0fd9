//! What would have to stand in a place for a false line to hold.
//!
//! The difference of the sides is linear in what stands in most places of a line. Then two readings, of the line and
//! of the line with 1 added at the place, give the value that is wanted there; a table of what the document could
//! write there names it. All values are taken in one world of the prime field, so that the table is a look-up; what
//! comes out is an edit like any other, and is proved before it is shown.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line, Node};
use crate::notation::document::{Format, Row};
use crate::notation::reread;
use crate::scalar::Prime;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::edit::{Edit, edited};
use crate::verify::frame::Frame;
use crate::verify::repair::Search;
use crate::verify::vocabulary::{Word, difference};
use crate::verify::world::World;
use num_traits::{One, Zero};
use std::collections::HashMap;

/// Places of a line that are looked at.
const PLACES: usize = 80;
/// Worlds that are tried for one in which the line has a value.
const WORLDS: u64 = 6;

/// Where something may be wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// A symbol, under its dots.
    Symbol,
    /// A term of a sum, or a whole side.
    Term,
    /// A sum, or what may become one by a further term.
    Sum,
}

/// A place of a line.
struct Place<'a> {
    node: &'a Node,
    role: Role,
    /// Whether a term may be written beside it without brackets.
    open: bool,
}

/// A place with the values that decide what is wanted.
struct Slot<'a> {
    place: Place<'a>,
    /// What stands there.
    value: Fraction,
    /// The difference of the sides with 1 added here.
    shifted: Vec<Fraction>,
}

/// What stands in a slot, and what must be added to it.
struct Want {
    now: Prime,
    more: Prime,
}

/// The words of a document, by their value in one world.
pub(super) struct Table<'a> {
    words: &'a [Word],
    values: Vec<Option<Prime>>,
    at: HashMap<Prime, usize>,
}

impl Checker<'_> {
    /// Edits that put what is wanted in one place.
    pub(super) fn wanted(&mut self, line: &Line, search: &mut Search<'_>) -> Vec<Edit> {
        let Some(residual) = self.residual_with(line, &[], search) else {
            return vec![];
        };
        let mut places = vec![];
        for side in &line.sides {
            visit(side, true, &mut places);
        }
        places.truncate(PLACES);
        let slots: Vec<Slot<'_>> = places
            .into_iter()
            .filter_map(|place| self.slot(line, place, residual.len(), search))
            .collect();
        let words = self.vocabulary(line);
        for seed in 1..=WORLDS {
            let mut world: World<Prime> = World::new(&mut self.theory, seed);
            let Some(gap) = values(&mut world, &residual) else {
                continue;
            };
            let wants: Vec<Option<Want>> = slots
                .iter()
                .map(|slot| want(&mut world, slot, &gap))
                .collect();
            let table = Table::new(&words, &mut world);
            if std::mem::take(&mut self.theory.exhausted) {
                return vec![];
            }
            let unicode = self.document.format == Format::Text;
            let mut edits = vec![];
            for (slot, want) in slots.iter().zip(&wants) {
                if let Some(want) = want {
                    let text = self.document.source.slice(slot.place.node.span);
                    fill(&slot.place, text, want, &table, unicode, &mut edits);
                }
            }
            return edits;
        }
        vec![]
    }

    /// The difference of the sides of the line, with some edits.
    fn residual_with(
        &mut self,
        line: &Line,
        edits: &[&Edit],
        search: &mut Search<'_>,
    ) -> Option<Vec<Fraction>> {
        let text = self.document.source.slice(line.span);
        let text = edited(text, line.span.start, edits)?;
        let reads = self.reads(&text, search)?;
        let equations = &reads.first()?.equations;
        Some(
            equations
                .iter()
                .flat_map(|e| e.residual.entries.clone())
                .collect(),
        )
    }

    fn slot<'n>(
        &mut self,
        line: &Line,
        place: Place<'n>,
        entries: usize,
        search: &mut Search<'_>,
    ) -> Option<Slot<'n>> {
        let span = place.node.span;
        let inside = line.span.start <= span.start && span.end <= line.span.end;
        let value = self.lowering(Frame::Moving).value(place.node).ok()?;
        let [value] = value.entries.as_slice() else {
            return None;
        };
        let text = format!("({} + 1)", self.document.source.slice(span));
        let edit = plain_edit(span, text);
        let shifted = inside.then(|| self.residual_with(line, &[&edit], search))??;
        let value = value.clone();
        (shifted.len() == entries).then_some(Slot {
            place,
            value,
            shifted,
        })
    }
}

fn plain_edit(span: Span, text: String) -> Edit {
    Edit {
        span,
        text,
        kind: "",
        message: String::new(),
        cost: 0,
    }
}

fn values(world: &mut World<'_, Prime>, fractions: &[Fraction]) -> Option<Vec<Prime>> {
    fractions.iter().map(|f| world.fraction(f)).collect()
}

/// The one value that makes every component of the difference vanish.
fn want(world: &mut World<'_, Prime>, slot: &Slot<'_>, gap: &[Prime]) -> Option<Want> {
    let shifted = values(world, &slot.shifted)?;
    let now = world.fraction(&slot.value)?;
    let mut more = None;
    for (gap, shifted) in gap.iter().zip(shifted) {
        let slope = shifted - *gap;
        match slope.inverse() {
            None if !gap.is_zero() => return None,
            None => {}
            Some(inverse) => {
                let here = -*gap * inverse;
                if *more.get_or_insert(here) != here {
                    return None;
                }
            }
        }
    }
    more.filter(|more| !more.is_zero())
        .map(|more| Want { now, more })
}

/// The places in a tree, each with whether a term may be added beside it.
fn visit<'a>(node: &'a Node, open: bool, out: &mut Vec<Place<'a>>) {
    let mut push = |node, role| out.push(Place { node, role, open });
    match &node.kind {
        Kind::Symbol(_) => {
            push(node, Role::Symbol);
            push(node, Role::Sum);
            return;
        }
        Kind::TimeDerivative { operand, .. } if matches!(operand.kind, Kind::Symbol(_)) => {
            push(node, Role::Symbol);
            push(node, Role::Sum);
            return;
        }
        Kind::TimeDerivative { .. } | Kind::Number(_) => return,
        Kind::Derivative { .. } => {
            push(node, Role::Sum);
            return;
        }
        Kind::Sum(terms) => {
            push(node, Role::Sum);
            for term in terms {
                out.push(Place {
                    node: &term.node,
                    role: Role::Term,
                    open: false,
                });
                visit(&term.node, false, out);
            }
            return;
        }
        _ if open => {
            push(node, Role::Term);
            push(node, Role::Sum);
        }
        _ => {}
    }
    let inner_open = matches!(
        node.kind,
        Kind::Group(..) | Kind::Quotient(..) | Kind::Matrix(_) | Kind::Tuple(_)
    );
    for child in node.children() {
        visit(child, inner_open, out);
    }
}

/// Edits that put what is wanted in a slot.
fn fill(
    place: &Place<'_>,
    text: &str,
    want: &Want,
    table: &Table<'_>,
    unicode: bool,
    out: &mut Vec<Edit>,
) {
    let span = place.node.span;
    let mut push = |text: String, kind, cost, message: String| {
        out.push(Edit {
            span,
            text,
            kind,
            message,
            cost,
        });
    };
    match place.role {
        Role::Symbol => {
            if let Some(word) = table.word(want.now + want.more)
                && let Some((kind, cost)) = difference(place.node, word)
            {
                let message = match kind {
                    "missing-dot" => "a dot is missing".to_owned(),
                    "extra-dot" => "a dot too many".to_owned(),
                    _ => format!("{} should be {}", text.trim(), word.text),
                };
                push(word.text.clone(), kind, cost, message);
            }
        }
        Role::Term => {
            let Some(ratio) = want
                .now
                .inverse()
                .map(|inverse| (want.now + want.more) * inverse)
            else {
                return;
            };
            let two = Prime::new(2);
            let half = if unicode { "½ " } else { "\\tfrac{1}{2} " };
            let bracketed = match place.node.kind {
                Kind::Negate(_) | Kind::Sum(_) => format!("({text})"),
                _ => text.to_owned(),
            };
            if ratio == two {
                push(
                    format!("2 {bracketed}"),
                    "factor",
                    15,
                    "a factor 2 is missing".to_owned(),
                );
            } else if ratio * two == Prime::one() {
                push(
                    format!("{half}{bracketed}"),
                    "factor",
                    14,
                    "a factor ½ is missing".to_owned(),
                );
            } else if ratio == -Prime::one() && place.open {
                push(
                    format!("-{bracketed}"),
                    "sign",
                    11,
                    "the sign is wrong".to_owned(),
                );
            }
        }
        Role::Sum => {
            let Some((sign, term, cost)) = table.term(want.more, place.open) else {
                return;
            };
            let whole = format!("{text} {sign} {term}");
            let whole = match (&place.node.kind, place.open) {
                (Kind::Sum(_), _) | (_, true) => whole,
                _ => format!("({whole})"),
            };
            push(
                whole,
                "missing-term",
                cost,
                format!("a term is missing: {sign} {term}"),
            );
        }
    }
}

impl<'a> Table<'a> {
    fn new(words: &'a [Word], world: &mut World<'_, Prime>) -> Self {
        let values: Vec<Option<Prime>> = words
            .iter()
            .map(|word| world.fraction(&word.value))
            .collect();
        let mut at = HashMap::new();
        for (i, value) in values.iter().enumerate() {
            if let Some(value) = value.filter(|value| !value.is_zero()) {
                at.entry(value).or_insert(i);
            }
        }
        Self { words, values, at }
    }

    fn word(&self, value: Prime) -> Option<&'a Word> {
        self.at.get(&value).and_then(|&i| self.words.get(i))
    }

    /// A sign and a product of few words that come to a value; more than one factor only where brackets are not needed.
    fn term(&self, value: Prime, long: bool) -> Option<(char, String, u32)> {
        for (sign, value) in [('+', value), ('-', -value)] {
            if let Some(word) = self.word(value) {
                return Some((sign, word.text.clone(), 18));
            }
        }
        if !long {
            return None;
        }
        for (i, first) in self.values.iter().enumerate() {
            let Some(inverse) = first.and_then(Prime::inverse) else {
                continue;
            };
            for (sign, value) in [('+', value), ('-', -value)] {
                if let Some(second) = self.word(value * inverse) {
                    let first = self.words.get(i)?;
                    return Some((sign, format!("{} {}", first.text, second.text), 20));
                }
            }
        }
        None
    }
}

/// The expression that a text holds.
pub(super) fn expression(format: Format, text: &str) -> Option<Node> {
    let rows = reread(format, &format!("{text} = 0"));
    match rows.as_slice() {
        [Row::Line(line)] => line.sides.first().cloned(),
        _ => None,
    }
}
