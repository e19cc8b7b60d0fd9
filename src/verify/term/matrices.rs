//! Lists, matrices and determinants that are written out.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::model::atoms::whole;
use crate::verify::model::system::FrameId;
use crate::verify::term::customs::BracketProduct;
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Trouble, Value, Valued, beyond, ill_typed};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// Determinants of more rows are not worked out.
const MOST_ROWS: usize = 4;

impl Lowering<'_> {
    pub(super) fn quotient(&mut self, top: &Node, bottom: &Node) -> Valued {
        let (top, bottom) = (self.value(top)?, self.value(bottom)?);
        self.system.quotient(&top, &bottom)
    }

    /// Products of inertia have a sign convention; entries of other matrices have none, nor have those of a tensor that is
    /// worked out, where nothing tells it.
    pub(super) fn written_as_products(&self, value: &Value) -> bool {
        let atoms = &self.system.atoms;
        let worked_out = |entry: &Fraction| {
            let letter = entry.as_variable();
            letter.is_some_and(|letter| atoms.atom(letter).law.is_some())
        };
        let told = self.letters.customs.products.of_inertia_told;
        value.basis[0] == value.basis[1]
            && value.transposed().entries == value.entries
            && (told || !value.entries.iter().any(worked_out))
    }

    /// What a cross says of two values: their cross product, its component across a plane, or the product of matrices.
    pub(super) fn crossed(&mut self, left: &Value, right: &Value, custom: FrameId) -> Valued {
        let products = &self.letters.customs.products;
        if left.is_matrix() && products.cross_matrices_at(self.at) {
            return self.system.times(left, right, custom);
        }
        let product = self.system.cross(left, right, custom)?;
        match products.across_at(self.at) {
            Some(axis) => {
                let axis = Value::vector(axis, Basis::Itself);
                self.system.dot(&product, &axis, custom)
            }
            None => Ok(product),
        }
    }

    /// A number and a matrix that are added or compared: where sentences say so, the number is that many times the identity matrix.
    pub(crate) fn beside_matrix(&mut self, a: Value, b: Value) -> Result<(Value, Value), Trouble> {
        if !self.letters.customs.products.adds_identity_at(self.at) {
            return Ok((a, b));
        }
        Ok(match (a.is_scalar(), b.is_scalar()) {
            (true, false) => (self.times_identity(&a, &b)?, b),
            (false, true) => {
                let b = self.times_identity(&b, &a)?;
                (a, b)
            }
            _ => (a, b),
        })
    }

    /// A number times the identity matrix of the size of a matrix; what is none is beside the number as it was.
    fn times_identity(&mut self, number: &Value, beside: &Value) -> Valued {
        if beside.rows != beside.columns {
            return Ok(number.clone());
        }
        let identity = match beside.is_matrix() {
            true => self.system.value_of(&Quantity::Identity)?,
            false => {
                let size = beside.rows;
                let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
                let entries = places.map(|(row, column)| whole(i64::from(row == column)));
                Value::written(size, size, entries.collect())
            }
        };
        Ok(identity.scaled(&number.to_scalar()?))
    }

    /// A list of components of one frame is on that frame, unless a sentence says what lists are on.
    fn on_its_frame(&mut self, list: Value, frames: &BTreeSet<FrameId>) -> Valued {
        let told = self.frame_of_brackets();
        let own = frames.first().filter(|_| frames.len() == 1).copied();
        match told.or(own).filter(|_| list.is_vector()) {
            Some(frame) => {
                let basis = [Basis::On(frame), Basis::Any];
                self.system.taken_on(&list, basis, frame)
            }
            None => Ok(list),
        }
    }

    /// Two vectors in brackets, where a sentence says which product they are.
    pub(super) fn product_in_brackets(&mut self, node: &Node, list: &[Node]) -> Option<Valued> {
        let opening = self.source.slice(node.span).chars().next()?;
        self.bracketed(opening, list)
    }

    fn bracketed(&mut self, opening: char, list: &[Node]) -> Option<Valued> {
        let products = &self.letters.customs.products.in_brackets;
        let product = products.get(&opening).copied()?;
        let [left, right] = list else { return None };
        let left = self.value(left).ok()?;
        let right = self.value(right).ok()?;
        if !left.is_vector() || !right.is_vector() {
            return None;
        }
        let custom = self.custom();
        Some(match product {
            BracketProduct::Dot => self.system.dot(&left, &right, custom),
            BracketProduct::Cross => self.crossed(&left, &right, custom),
        })
    }

    /// A factor behind which two vectors stand in round brackets: no function of them, where these are a product.
    pub(super) fn times_bracketed(&mut self, head: &Node, list: &[Node]) -> Option<Valued> {
        let product = self.bracketed('(', list)?;
        let times = |own: &mut Self| {
            let (factor, product) = (own.value(head)?, product?);
            let custom = own.custom();
            own.system.times(&factor, &product, custom)
        };
        Some(times(self))
    }

    /// A list of components; lists in square brackets within one are the rows of a matrix, as in code.
    pub(super) fn tuple(&mut self, list: &[Vec<Node>]) -> Valued {
        let row = |entry: &Node| match &entry.kind {
            Kind::Tuple(row) if self.source.slice(entry.span).starts_with('[') => Some(row.clone()),
            _ => None,
        };
        let rows: Option<Vec<Vec<Node>>> = list.iter().flatten().map(row).collect();
        match rows {
            Some(rows) => self.list(&rows, false),
            None => self.list(list, true),
        }
    }

    /// A list of components, or a matrix row by row; entries may be vectors side by side.
    pub(super) fn list(&mut self, rows: &[Vec<Node>], column: bool) -> Valued {
        let seen = std::mem::take(&mut self.frames_seen);
        let mut values = vec![];
        let blank: Vec<usize> = blank_columns(rows);
        for row in rows {
            let kept = row.iter().enumerate().filter(|(at, _)| !blank.contains(at));
            let row: Result<Vec<Value>, Trouble> = kept.map(|(_, node)| self.value(node)).collect();
            values.push(row?);
        }
        let frames = std::mem::replace(&mut self.frames_seen, seen);
        self.frames_seen.extend(&frames);
        let custom = self.custom();
        let width = values.first().map_or(0, Vec::len);
        if width == 0 || values.iter().any(|row| row.len() != width) {
            return ill_typed("the rows of a matrix differ in length");
        }
        let all: Vec<&Value> = values.iter().flatten().collect();
        if all.iter().all(|v| v.is_scalar()) {
            let entries: Vec<Fraction> = all.iter().map(|v| v.entries[0].clone()).collect();
            let value = match column {
                true => Value::written(entries.len(), 1, entries),
                false => Value::written(values.len(), width, entries),
            };
            return self.on_its_frame(value, &frames);
        }
        if all.len() == 1 {
            return Ok(all[0].clone());
        }
        if values.len() == 1 && all.iter().all(|v| v.is_vector()) {
            let out = all.iter().map(|v| self.system.written_out(v, custom));
            let out = out.collect::<Result<Vec<_>, _>>()?;
            let entries = (0..3)
                .flat_map(|r| out.iter().map(move |v| v.entries[r].clone()))
                .collect();
            return Ok(Value::written(3, width, entries));
        }
        let in_rows = self.letters.customs.vectors_are_rows_at(self.at);
        let rows = |v: &&Value| v.is_row() || in_rows && v.is_vector();
        if width == 1 && all.iter().all(rows) {
            let out = all.iter().map(|v| self.system.written_out(v, custom));
            let out = out.collect::<Result<Vec<_>, _>>()?;
            let entries = out.iter().flat_map(|v| v.entries.clone()).collect();
            return Ok(Value::written(values.len(), 3, entries));
        }
        if (column || width == 1) && all.iter().all(|v| v.columns == 1) {
            // Numbers and arrays below one another, as in a quaternion.
            let mut entries = vec![];
            for value in all {
                entries.extend(self.system.as_list(value)?.entries);
            }
            return Ok(Value::written(entries.len(), 1, entries));
        }
        beyond("a matrix of vectors in this arrangement")
    }

    /// A determinant of numbers, or with unit vectors in its first row a cross product.
    pub(super) fn determinant(&mut self, rows: &[Vec<Node>]) -> Valued {
        let mut values = vec![];
        for row in rows {
            let row: Result<Vec<Value>, Trouble> =
                row.iter().map(|node| self.value(node)).collect();
            values.push(row?);
        }
        let size = values.len();
        if !(2..=MOST_ROWS).contains(&size) || values.iter().any(|row| row.len() != size) {
            return beyond("a determinant of this size");
        }
        let custom = self.custom();
        let below = values[1..].iter().map(|row| {
            let entries = row.iter().map(Value::to_scalar);
            entries.collect::<Result<Vec<_>, _>>()
        });
        let below = below.collect::<Result<Vec<_>, _>>()?;
        // The first row may hold the unit vectors of a cross product.
        let mut sum = Value::scalar(Fraction::zero());
        for (column, first) in values[0].iter().enumerate() {
            let term = first.scaled(&cofactor(&below, column));
            sum = self.system.plus(&sum, &term, custom)?;
        }
        Ok(sum)
    }
}

/// The determinant of what is below an entry of the first row, without its column, with the sign of its place.
fn cofactor(below: &[Vec<Fraction>], column: usize) -> Fraction {
    let without = |row: &Vec<Fraction>| {
        let entries = row.iter().enumerate().filter(|(at, _)| *at != column);
        entries.map(|(_, entry)| entry.clone()).collect::<Vec<_>>()
    };
    let rows: Vec<Vec<Fraction>> = below.iter().map(without).collect();
    let minor = match rows.split_first() {
        None => Fraction::one(),
        Some((first, below)) => {
            let terms = first.iter().enumerate();
            terms.fold(Fraction::zero(), |sum, (at, entry)| {
                sum + entry.clone() * cofactor(below, at)
            })
        }
    };
    match column % 2 {
        0 => minor,
        _ => -minor,
    }
}

/// Columns in which no row has anything, where the matrix is square without them: `&&` only moves cells apart.
fn blank_columns(rows: &[Vec<Node>]) -> Vec<usize> {
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let blank = |node: &Node| matches!(node.kind, Kind::Number(_)) && node.span.range().is_empty();
    let all = |column: &usize| rows.iter().all(|row| row.get(*column).is_none_or(blank));
    let blank: Vec<usize> = (0..width).filter(all).collect();
    if width - blank.len() == rows.len() {
        blank
    } else {
        vec![]
    }
}
