//! Scalars, vectors and matrices, and the axes that their entries are taken on.
//!
//! A geometric vector is the same in every frame, and its rate needs a frame. An array holds the components on the axes
//! of a frame, and its rate is entry by entry. Both are worked with by their components on the work frame; only what a
//! document writes out entry by entry is a mere list, until it meets something that says which axes it is on.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::model::system::{FrameId, Matrix, System, Vector};
use crate::verify::term::dimensions::beyond_space;
use num_traits::Zero;
use std::fmt::{self, Display, Formatter};

/// What an index of a value runs over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Basis {
    /// Any axes: the identity matrix, zero.
    Any,
    /// No axes: the vector itself. The entries are components on the work frame.
    Itself,
    /// The axes of a frame. The entries are still components on the work frame.
    On(FrameId),
    /// Entries as they are written out.
    Written,
}

/// A scalar, a vector or a matrix.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Value {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    /// Row by row.
    pub(crate) entries: Vec<Fraction>,
    /// Of rows and of columns; of an index with one value it says nothing.
    pub(crate) basis: [Basis; 2],
}

/// The shape of a letter and the axes that it is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    pub(crate) basis: [Basis; 2],
}

impl Display for Shape {
    /// `a number`, `a vector`, `a 3 × 2 matrix`.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match (self.rows, self.columns) {
            (1, 1) => f.write_str("a number"),
            (3, 1) => f.write_str("a vector"),
            (rows, 1) => write!(f, "a column of {rows}"),
            (1, columns) => write!(f, "a row of {columns}"),
            (rows, columns) => write!(f, "a {rows} × {columns} matrix"),
        }
    }
}

/// Why a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// Nothing says what a letter is: its writing.
    Unknown(String),
    /// Shapes that do not fit: the line is wrong as it is typed.
    IllTyped(String),
    /// It is beyond what is worked out.
    Beyond(String),
}

pub(crate) type Valued = Result<Value, Trouble>;

/// An answer that says what does not fit.
pub(crate) fn ill_typed<T>(message: impl Into<String>) -> Result<T, Trouble> {
    Err(Trouble::IllTyped(message.into()))
}

/// Why something is not worked out that has too many terms.
pub(crate) const GROWN: &str = "this grew beyond what is worked out";

/// Why a letter has no value that is taken at an instant, or at none beside others that are.
pub(crate) const AT_INSTANT: &str = "a value at an instant";

/// Why a function has no value.
pub(crate) const OTHER_ARGUMENT: &str = "this function of this argument";

/// An answer that says what is not worked out.
pub(crate) fn beyond<T>(message: impl Into<String>) -> Result<T, Trouble> {
    Err(Trouble::Beyond(message.into()))
}

impl Value {
    pub(crate) fn scalar(value: Fraction) -> Self {
        Self {
            rows: 1,
            columns: 1,
            entries: vec![value],
            basis: [Basis::Any; 2],
        }
    }

    pub(crate) fn vector(vector: &Vector, basis: Basis) -> Self {
        let entries = vector.iter().cloned().collect();
        Self {
            rows: 3,
            columns: 1,
            entries,
            basis: [basis, Basis::Any],
        }
    }

    pub(crate) fn matrix(matrix: &Matrix, basis: [Basis; 2]) -> Self {
        let entries = (0..9).map(|at| matrix[(at / 3, at % 3)].clone()).collect();
        Self {
            rows: 3,
            columns: 3,
            entries,
            basis,
        }
    }

    /// Whether it is a vector and no column of numbers.
    pub(crate) fn is_itself(&self) -> bool {
        self.is_vector() && self.basis[0] == Basis::Itself
    }

    /// Entries as a document writes them.
    pub(crate) fn written(rows: usize, columns: usize, entries: Vec<Fraction>) -> Self {
        Self {
            rows,
            columns,
            entries,
            basis: [Basis::Written; 2],
        }
    }

    pub(crate) fn is_scalar(&self) -> bool {
        self.rows == 1 && self.columns == 1
    }

    /// The number that it is, of which nothing says that it has axes.
    pub(super) fn as_number(&mut self) -> Option<&mut Fraction> {
        let plain = self.is_scalar() && self.basis == [Basis::Any; 2];
        self.entries.first_mut().filter(|_| plain)
    }

    pub(crate) fn is_vector(&self) -> bool {
        self.rows == 3 && self.columns == 1
    }

    pub(crate) fn is_row(&self) -> bool {
        self.rows == 1 && self.columns == 3
    }

    pub(crate) fn is_matrix(&self) -> bool {
        self.rows == 3 && self.columns == 3
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.entries.iter().all(Fraction::is_zero)
    }

    pub(crate) fn to_scalar(&self) -> Result<Fraction, Trouble> {
        match self.is_scalar() {
            true => Ok(self.entries[0].clone()),
            false => ill_typed(format!("{} stands where a number must stand", self.shape())),
        }
    }

    pub(crate) fn to_vector(&self) -> Result<Vector, Trouble> {
        match self.is_vector() || self.is_row() {
            true => Ok(Vector::from_fn(|row, _| self.entries[row].clone())),
            false => ill_typed(format!("{} stands where a vector must stand", self.shape())),
        }
    }

    pub(crate) fn to_matrix(&self) -> Result<Matrix, Trouble> {
        match self.is_matrix() {
            true => Ok(Matrix::from_fn(|r, c| self.entries[3 * r + c].clone())),
            false => ill_typed(format!("{} stands where a matrix must stand", self.shape())),
        }
    }

    /// The row and the column of an entry, or those of the equal one on the other side of the diagonal, where that comes first.
    pub(crate) fn earlier_place(&self, at: usize) -> (usize, usize) {
        let (row, column) = (at / self.columns, at % self.columns);
        let mirrored = self.entries.get(column * self.columns + row);
        let equal = self.rows == self.columns && mirrored == self.entries.get(at);
        match equal && row > column {
            true => (column, row),
            false => (row, column),
        }
    }

    pub(crate) fn shape(&self) -> Shape {
        Shape {
            rows: self.rows,
            columns: self.columns,
            basis: self.basis,
        }
    }

    pub(crate) fn transposed(&self) -> Self {
        let at = |r: usize, c: usize| self.entries[r * self.columns + c].clone();
        let entries = (0..self.columns)
            .flat_map(|c| (0..self.rows).map(move |r| (r, c)))
            .map(|(r, c)| at(r, c))
            .collect();
        Self {
            rows: self.columns,
            columns: self.rows,
            entries,
            basis: [self.basis[1], self.basis[0]],
        }
    }

    /// Its rows and its columns turned, three of them at a time: Q A Pᵀ.
    fn turned(&self, turns: &[Option<Matrix>; 2], basis: [Basis; 2]) -> Self {
        let mut out = self.clone();
        if let (3, Some(turn)) = (out.rows, &turns[0]) {
            out.entries = times(turn, &out.entries, out.columns);
        }
        if let (3, Some(turn)) = (out.columns, &turns[1]) {
            let mut columns = out.transposed();
            columns.entries = times(turn, &columns.entries, columns.columns);
            out = columns.transposed();
        }
        Self { basis, ..out }
    }

    pub(crate) fn scaled(&self, factor: &Fraction) -> Self {
        let entries = self.entries.iter().map(|e| e.clone() * factor.clone());
        self.with_entries(entries.collect())
    }

    /// Other entries in its shape and on its axes.
    pub(crate) fn with_entries(&self, entries: Vec<Fraction>) -> Self {
        let (rows, columns, basis) = (self.rows, self.columns, self.basis);
        Self {
            rows,
            columns,
            entries,
            basis,
        }
    }

    pub(crate) fn negated(&self) -> Self {
        let entries = self.entries.iter().map(|e| -e.clone());
        self.with_entries(entries.collect())
    }

    /// The basis of a vector, whether it stands as a column or as a row.
    pub(crate) fn vector_basis(&self) -> Basis {
        self.basis[usize::from(self.rows == 1)]
    }

    /// The frame on whose axes its components are.
    pub(crate) fn frame(&self) -> Option<FrameId> {
        match self.vector_basis() {
            Basis::On(frame) => Some(frame),
            _ => None,
        }
    }

    /// What its indices run over, where they run.
    fn bases(&self) -> [Basis; 2] {
        let runs = |size: usize, basis: Basis| if size > 1 { basis } else { Basis::Any };
        [
            runs(self.rows, self.basis[0]),
            runs(self.columns, self.basis[1]),
        ]
    }

    /// Whether it is a multiple of the identity, from axes to the same axes.
    fn is_the_same_on_any_axes(&self) -> bool {
        let size = self.rows;
        let fits = |(at, entry): (usize, &Fraction)| match at / size == at % size {
            true => *entry == self.entries[0],
            false => entry.is_zero(),
        };
        size == self.columns
            && size > 1
            && self.basis[0] == self.basis[1]
            && self.entries.iter().enumerate().all(fits)
    }

    /// v× as a matrix.
    pub(crate) fn cross_product_matrix(&self) -> Valued {
        let skew = mechanics::skew(&self.to_vector()?);
        Ok(Self::matrix(&skew, [self.vector_basis(); 2]))
    }

    /// The v of v×: the inverse of [`cross_product_matrix`](Self::cross_product_matrix).
    pub(crate) fn vector_of_cross_product_matrix(&self) -> Valued {
        let m = self.to_matrix()?;
        let [rows, columns] = self.basis;
        let skew = m
            .iter()
            .zip(m.transpose().iter())
            .all(|(a, b)| (a.clone() + b.clone()).is_zero());
        if !skew || rows != columns {
            return beyond(OTHER_ARGUMENT);
        }
        let vector = Vector::new(m[(2, 1)].clone(), m[(0, 2)].clone(), m[(1, 0)].clone());
        Ok(Self::vector(&vector, rows))
    }

    fn has_written(&self) -> bool {
        self.bases().contains(&Basis::Written)
    }
}

impl System {
    /// Entry by entry on the axes that a value is on; of a geometric one on those of a frame.
    pub(crate) fn written_out(&mut self, value: &Value, custom: FrameId) -> Valued {
        if value.is_the_same_on_any_axes() {
            let basis = [Basis::Written; 2];
            return Ok(Value {
                basis,
                ..value.clone()
            });
        }
        let mut turn = |basis| match basis {
            Basis::On(frame) => self.entries_turned(frame, self.work),
            Basis::Itself => self.entries_turned(custom, self.work),
            Basis::Any | Basis::Written => Ok(None),
        };
        let turns = [turn(value.basis[0])?, turn(value.basis[1])?];
        Ok(value.turned(&turns, [Basis::Written; 2]))
    }

    /// The trace. Of a matrix between two frames it is that of its entries.
    pub(crate) fn trace(&mut self, value: &Value, custom: FrameId) -> Valued {
        let value = match value.basis[0] == value.basis[1] {
            true => value.clone(),
            false => self.written_out(value, custom)?,
        };
        Ok(Value::scalar(value.to_matrix()?.trace()))
    }

    /// The entries of the matrix between two frames, if they are two; only a space of three dimensions has them.
    fn entries_turned(&mut self, to: FrameId, from: FrameId) -> Result<Option<Matrix>, Trouble> {
        match self.dimensions() {
            3 => Ok((to != from).then(|| self.rotation(to, from))),
            _ => Err(beyond_space()),
        }
    }

    /// Written entries taken as those on the axes of frames.
    pub(crate) fn taken_on(&mut self, value: &Value, basis: [Basis; 2], custom: FrameId) -> Valued {
        let mut turn = |basis| match basis {
            Basis::On(frame) => self.entries_turned(self.work, frame),
            _ => self.entries_turned(self.work, custom),
        };
        let turns = [turn(basis[0])?, turn(basis[1])?];
        Ok(value.turned(&turns, basis))
    }

    /// Two values of one shape, on the same axes.
    pub(crate) fn brought_together(
        &mut self,
        a: &Value,
        b: &Value,
        custom: FrameId,
    ) -> Result<(Value, Value), Trouble> {
        if a.is_scalar() || a.bases() == b.bases() {
            return Ok((a.clone(), b.clone()));
        }
        let on = |basis| (Value { basis, ..a.clone() }, Value { basis, ..b.clone() });
        if a.is_zero() || b.is_zero() {
            return Ok(on(if a.is_zero() { b.basis } else { a.basis }));
        }
        match (a.has_written(), b.has_written()) {
            (true, false) => return Ok((self.taken_on(a, b.basis, custom)?, b.clone())),
            (false, true) => return Ok((a.clone(), self.taken_on(b, a.basis, custom)?)),
            _ => {}
        }
        match joined(a, b).filter(|_| !a.has_written()) {
            Some(basis) => Ok(on(basis)),
            None => Ok((self.written_out(a, custom)?, self.written_out(b, custom)?)),
        }
    }
}

/// The basis of two values that differ by no more than one being the thing itself.
fn joined(a: &Value, b: &Value) -> Option<[Basis; 2]> {
    let one = |a: Basis, b: Basis| match (a, b) {
        _ if a == b => Some(a),
        (Basis::Any | Basis::Itself, other) | (other, Basis::Any | Basis::Itself) => Some(other),
        _ => None,
    };
    let (own, other) = (a.bases(), b.bases());
    let basis = [one(own[0], other[0])?, one(own[1], other[1])?];
    // The tensor itself has one frame for both indices; a matrix between two frames is none.
    let two = a.is_matrix() && matches!(basis, [Basis::On(f), Basis::On(g)] if f != g);
    (!two || own == other).then_some(basis)
}

fn times(turn: &Matrix, entries: &[Fraction], columns: usize) -> Vec<Fraction> {
    let column = |c: usize| Vector::from_fn(|r, _| entries[r * columns + c].clone());
    let turned: Vec<Vector> = (0..columns)
        .map(|c| mechanics::apply(turn, &column(c)))
        .collect();
    (0..3)
        .flat_map(|r| turned.iter().map(move |v| v[r].clone()))
        .collect()
}
