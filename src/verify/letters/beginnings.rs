//! Values at the beginning: `\omega_3 = s` "at" `t = 0`, beside a line that says how ω₃ goes on in time.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{inner, symbols};

/// Words between what holds at an instant and that instant.
const AT: &[&str] = &[
    "at",
    "at time",
    "at the time",
    "at the instant",
    "when",
    "for",
];

impl Reading {
    /// Notes the lines that hold at one instant of a motion that the document solves, and those that name the instant.
    pub(crate) fn note_beginnings(&mut self, document: &Document) {
        for items in document.items.windows(3) {
            let [
                Item::Formula(formula),
                Item::Prose { text, .. },
                Item::Formula(instant),
            ] = items
            else {
                continue;
            };
            if !AT.contains(&text.trim().to_lowercase().as_str()) {
                continue;
            }
            let (Some(line), Some(instant)) = (only_line(formula), only_line(instant)) else {
                continue;
            };
            let [first, value] = line.sides.as_slice() else {
                continue;
            };
            if let Some(symbol) = lone(first)
                && names_time(instant)
                && is_solved(symbol, document)
            {
                let starts = [line, instant].map(|line| line.span.start);
                self.beginnings.extend(starts);
                self.starts.push((symbol.clone(), value.clone()));
            }
        }
    }
}

fn only_line(formula: &Formula) -> Option<&Line> {
    match formula.rows.as_slice() {
        [Row::Line(line)] => Some(line),
        _ => None,
    }
}

fn lone(node: &Node) -> Option<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

fn is_time(symbol: &Symbol) -> bool {
    symbol.name == "t" && symbol.subscripts.is_empty()
}

/// `t = 0`.
fn names_time(line: &Line) -> bool {
    let [left, right] = line.sides.as_slice() else {
        return false;
    };
    lone(left).is_some_and(is_time) && !symbols(right).into_iter().any(is_time)
}

/// Whether a line says what a symbol is at all times.
fn is_solved(symbol: &Symbol, document: &Document) -> bool {
    document.lines().any(|line| {
        let [left, rest @ ..] = line.sides.as_slice() else {
            return false;
        };
        lone(left) == Some(symbol) && rest.iter().flat_map(symbols).any(is_time)
    })
}
