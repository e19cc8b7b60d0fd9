//! What formulas give a name to: the letter that a row is about, and lines that name the components of a vector,
//! `\mathbf r_b = (r_x, r_y, r_z)`.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::verify::check::Checker;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner, symbols};
use crate::verify::values::atoms::Entity;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::subscript::{ENERGY_LABELS, LOADS};
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::Finding;

impl Checker<'_> {
    /// Takes in a line that gives the components of a vector their names, where nothing determines either.
    pub(crate) fn names_components(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let Meaning::Whole(whole) = self.meaning_of(symbol) else {
            return false;
        };
        let entries: Vec<&Node> = match &inner(right).kind {
            Kind::Tuple(entries) => entries.iter().collect(),
            Kind::Matrix(rows) => rows.iter().flatten().collect(),
            _ => return false,
        };
        let vector = self.theory.atoms.info(whole).shape == Shape::Vector;
        let free = |checker: &mut Self, entity: Entity, component: u8| {
            let value = checker.theory.atoms.value(entity, component, 0);
            checker.theory.normal(&value).as_variable() == Fraction::as_variable(&value)
        };
        if !vector || entries.len() != 3 || !(0..3).all(|c| free(self, whole, c)) {
            return false;
        }
        for (at, entry) in (0..3).zip(entries) {
            let Kind::Symbol(symbol) = &inner(entry).kind else {
                return false;
            };
            let named = match self.meaning_of(symbol) {
                Meaning::Component(entity, component) if component == at => (entity, component),
                Meaning::Whole(entity) => (entity, 0),
                _ => return false,
            };
            if named.0 == whole || !free(self, named.0, named.1) {
                return false;
            }
        }
        self.accept_definition(sides, finding)
    }
}

/// The letters that a row names: of an expression, or of the left side of a line.
pub(crate) fn named_letters(row: &Row) -> Vec<Letter> {
    let node = match row {
        Row::Expression(node) => node,
        Row::Line(line) if !line.continues => match line.sides.first() {
            Some(side) => side,
            None => return vec![],
        },
        _ => return vec![],
    };
    lone_letters(node)
}

/// The letter of a lone symbol, or the letters of the entries of a column.
fn lone_letters(node: &Node) -> Vec<Letter> {
    match &inner(node).kind {
        Kind::Symbol(symbol)
            if symbol.subscripts.iter().all(|s| {
                let label = [LOADS, ENERGY_LABELS].concat();
                axis(s).is_some() || s.len() <= 2 || label.contains(&s.as_str())
            }) =>
        {
            vec![Letter::of(symbol)]
        }
        Kind::Matrix(rows) if rows.iter().all(|row| row.len() == 1) => {
            letters_of_entries(rows.iter().flatten())
        }
        Kind::Tuple(entries) => letters_of_entries(entries.iter()),
        Kind::Norm(inside) => symbols(inside).into_iter().map(Letter::of).collect(),
        _ => vec![],
    }
}

/// The letters of the entries of a column; three components of no one vector, `(r_x, h_y, h_z)`, name nothing.
fn letters_of_entries<'n>(entries: impl Iterator<Item = &'n Node> + Clone) -> Vec<Letter> {
    let indexed = |entry: &Node| match &inner(entry).kind {
        Kind::Symbol(symbol) => symbol.subscripts.iter().any(|s| axis(s).is_some()),
        _ => false,
    };
    let letters: Vec<Letter> = entries.clone().flat_map(lone_letters).collect();
    match letters.as_slice() {
        [a, b, c] if entries.clone().all(indexed) && (a != b || b != c) => vec![],
        _ => letters,
    }
}

/// The letter on the left of a line that writes a Jacobian, by the words before it or by what it is set equal to: the J
/// of `J(\omega) = …`, the F of `F = \partial f/\partial\omega`.
pub(crate) fn jacobian_named(row: &Row, called: bool) -> Option<Letter> {
    let Row::Line(line) = row else { return None };
    let vector = |node: &Node| symbols(node).iter().all(|s| s.subscripts.is_empty());
    let derived = line.sides.get(1).is_some_and(|side| {
        matches!(&inner(side).kind, Kind::Derivative { operand, variables, .. }
            if vector(operand) && variables.iter().all(vector))
    });
    let left = inner(
        line.sides
            .first()
            .filter(|_| !line.continues && (called || derived))?,
    );
    let left = match &left.kind {
        Kind::Call(head, _) => inner(head),
        _ => left,
    };
    match &left.kind {
        Kind::Symbol(symbol) if symbol.subscripts.is_empty() => Some(Letter::of(symbol)),
        _ => None,
    }
}

impl Reading {
    /// The readings in words, for the report.
    pub(crate) fn describe(&self) -> Vec<String> {
        let whole = self
            .quantities
            .iter()
            .filter(|(_, q)| **q != Quantity::Attitude)
            .map(|(l, q)| format!("{}: {}", l.name, q.name()));
        let parts = self.components.iter().map(|(l, (q, c))| {
            format!(
                "{}: {} of the {}",
                l.name,
                ["first", "second", "third"][usize::from(*c) % 3],
                q.name()
            )
        });
        let not_set = self.not_set.iter().cloned();
        let attitude = self.attitude.describe();
        whole.chain(parts).chain(attitude).chain(not_set).collect()
    }
}
