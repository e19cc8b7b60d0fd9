//! What a formula is worth: a grid of fractions. A scalar is one by one, a vector a column of three.

use crate::algebra::Fraction;
use num_traits::{One, Zero};

/// Why two values cannot be joined.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ShapeMismatch(pub String);

/// A grid of exact fractions, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Value {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// The entries.
    pub entries: Vec<Fraction>,
}

impl Value {
    /// A scalar.
    pub(crate) fn scalar(entry: Fraction) -> Self {
        Self {
            rows: 1,
            columns: 1,
            entries: vec![entry],
        }
    }

    /// A column.
    pub(crate) fn column(entries: impl Into<Vec<Fraction>>) -> Self {
        let entries = entries.into();
        Self {
            rows: entries.len(),
            columns: 1,
            entries,
        }
    }

    /// A grid whose entry in row `r` and column `c` is `entry(r, c)`.
    pub(crate) fn from_fn(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> Fraction,
    ) -> Self {
        let entries = (0..rows * columns)
            .map(|i| entry(i / columns, i % columns))
            .collect();
        Self {
            rows,
            columns,
            entries,
        }
    }

    /// The identity of size `n`.
    pub(crate) fn identity(n: usize) -> Self {
        Self::from_fn(n, n, |r, c| {
            if r == c {
                Fraction::one()
            } else {
                Fraction::zero()
            }
        })
    }

    /// The unit vector along axis `axis`.
    pub(crate) fn axis(axis: usize) -> Self {
        Self::from_fn(3, 1, |r, _| {
            if r == axis {
                Fraction::one()
            } else {
                Fraction::zero()
            }
        })
    }

    /// The entry in a row and a column; the caller keeps to the grid.
    pub(crate) fn at(&self, row: usize, column: usize) -> &Fraction {
        &self.entries[row * self.columns + column]
    }

    /// Whether it is one by one.
    pub(crate) fn is_scalar(&self) -> bool {
        self.rows == 1 && self.columns == 1
    }

    /// The one entry of a number.
    pub(crate) fn as_scalar(&self) -> Option<&Fraction> {
        self.entries.first().filter(|_| self.is_scalar())
    }

    /// Whether it is a column of three.
    pub(crate) fn is_vector(&self) -> bool {
        self.rows == 3 && self.columns == 1
    }

    /// Whether every entry is zero.
    pub(crate) fn is_zero(&self) -> bool {
        self.entries.iter().all(Zero::is_zero)
    }

    /// What it is, in words.
    pub(crate) fn shape(&self) -> String {
        match (self.rows, self.columns) {
            (1, 1) => "a scalar".to_owned(),
            (_, 1) => "a vector".to_owned(),
            (1, _) => "a row".to_owned(),
            (r, c) => format!("a {r} × {c} matrix"),
        }
    }

    /// Each entry put through `f`.
    pub(crate) fn map(&self, f: impl FnMut(&Fraction) -> Fraction) -> Self {
        let entries = self.entries.iter().map(f).collect();
        Self {
            rows: self.rows,
            columns: self.columns,
            entries,
        }
    }

    /// `self + other`, or `self − other`. A scalar zero takes any shape.
    pub(crate) fn plus(&self, other: &Self, negative: bool) -> Result<Self, ShapeMismatch> {
        self.clone().joined(other.clone(), negative)
    }

    /// The same of values that are not needed any more.
    pub(crate) fn joined(self, other: Self, negative: bool) -> Result<Self, ShapeMismatch> {
        let (left, right) = self.matched(other)?;
        let pairs = left.entries.into_iter().zip(right.entries);
        let join = |(a, b)| if negative { a - b } else { a + b };
        Ok(Self {
            rows: left.rows,
            columns: left.columns,
            entries: pairs.map(join).collect(),
        })
    }

    /// Both values in one shape: zero takes any, a row of three stands for a column.
    fn matched(self, other: Self) -> Result<(Self, Self), ShapeMismatch> {
        let zero = |like: &Self| Self::from_fn(like.rows, like.columns, |_, _| Fraction::zero());
        if (self.rows, self.columns) == (other.rows, other.columns) {
            Ok((self, other))
        } else if self.is_scalar() && self.is_zero() {
            Ok((zero(&other), other))
        } else if other.is_scalar() && other.is_zero() {
            let zero = zero(&self);
            Ok((self, zero))
        } else if let Some(unit) = self.unit_of_size(&other) {
            Ok((unit, other))
        } else if let Some(unit) = other.unit_of_size(&self) {
            Ok((self, unit))
        } else if self.entries.len() == other.entries.len() && (self.rows == 1 || self.columns == 1)
        {
            let turned = Self {
                rows: self.rows,
                columns: self.columns,
                entries: other.entries,
            };
            Ok((self, turned))
        } else {
            Err(ShapeMismatch(format!(
                "{} against {}",
                self.shape(),
                other.shape()
            )))
        }
    }

    /// A multiple of the unit matrix, which is written without its size or as 1, in the size of another matrix.
    pub(crate) fn unit_of_size(&self, other: &Self) -> Option<Self> {
        let square = |value: &Self| value.rows == value.columns && value.rows > 1;
        if self.is_scalar() && self.entries[0].is_one() && square(other) {
            return Some(Self::identity(other.rows));
        }
        let factor = self.entries.first()?;
        let multiple = |(i, entry): (usize, &Fraction)| match i % (self.rows + 1) {
            0 => entry == factor,
            _ => entry.is_zero(),
        };
        let unit = square(self) && self.entries.iter().enumerate().all(multiple);
        (unit && square(other)).then(|| Self::identity(other.rows).scaled(factor))
    }

    /// The negative.
    pub(crate) fn negated(&self) -> Self {
        self.map(|entry| -entry.clone())
    }

    /// Every entry times `factor`.
    pub(crate) fn scaled(&self, factor: &Fraction) -> Self {
        self.map(|entry| entry.clone() * factor.clone())
    }

    /// The product by juxtaposition: scalar times anything, or of matrices.
    pub(crate) fn times(&self, other: &Self) -> Result<Self, ShapeMismatch> {
        if self.is_scalar() {
            return Ok(other.scaled(&self.entries[0]));
        }
        if other.is_scalar() {
            return Ok(self.scaled(&other.entries[0]));
        }
        if self.columns != other.rows {
            return Err(ShapeMismatch(format!(
                "{} times {}",
                self.shape(),
                other.shape()
            )));
        }
        Ok(Self::from_fn(self.rows, other.columns, |r, c| {
            (0..self.columns).fold(Fraction::zero(), |sum, k| {
                sum + self.at(r, k).clone() * other.at(k, c).clone()
            })
        }))
    }

    /// The product with a dot: of scalars, of vectors, of a dyadic with a vector.
    pub(crate) fn dot(&self, other: &Self) -> Result<Self, ShapeMismatch> {
        if self.columns == 1 && other.columns == 1 && self.rows == other.rows && self.rows > 1 {
            return self.transposed().times(other);
        }
        if self.columns == 1 && self.rows > 1 && other.rows == self.rows {
            return Ok(self.transposed().times(other)?.transposed());
        }
        self.times(other)
    }

    /// The cross product of two vectors.
    pub(crate) fn cross(&self, other: &Self) -> Result<Self, ShapeMismatch> {
        if self.is_scalar() && other.is_scalar() {
            return self.times(other);
        }
        if self.entries.len() != 3 || other.entries.len() != 3 {
            return Err(ShapeMismatch(format!(
                "{} × {}",
                self.shape(),
                other.shape()
            )));
        }
        let (a, b) = (&self.entries, &other.entries);
        let minor = |i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
        Ok(Self::column([minor(1, 2), minor(2, 0), minor(0, 1)]))
    }

    /// The matrix \[a\]× with \[a\]× b = a × b.
    pub(crate) fn skew(&self) -> Result<Self, ShapeMismatch> {
        if self.entries.len() != 3 {
            return Err(ShapeMismatch(format!(
                "the skew matrix of {}",
                self.shape()
            )));
        }
        let columns: Vec<Self> = (0..3)
            .map(|c| self.cross(&Self::axis(c)))
            .collect::<Result<_, _>>()?;
        Ok(Self::from_fn(3, 3, |r, c| columns[c].entries[r].clone()))
    }

    /// Rows for columns.
    pub(crate) fn transposed(&self) -> Self {
        Self::from_fn(self.columns, self.rows, |r, c| self.at(c, r).clone())
    }

    /// The sum of the diagonal.
    pub(crate) fn trace(&self) -> Result<Self, ShapeMismatch> {
        self.square("trace")?;
        let sum = (0..self.rows).fold(Fraction::zero(), |sum, i| sum + self.at(i, i).clone());
        Ok(Self::scalar(sum))
    }

    /// The determinant, by cofactors of the first row; up to four rows.
    pub(crate) fn determinant(&self) -> Result<Fraction, ShapeMismatch> {
        self.square("determinant")?;
        match self.rows {
            1 => Ok(self.entries[0].clone()),
            2..=4 => (0..self.columns).try_fold(Fraction::zero(), |sum, c| {
                if self.at(0, c).is_zero() {
                    return Ok(sum);
                }
                let term = self.at(0, c).clone() * self.minor(0, c).determinant()?;
                Ok(if c % 2 == 0 { sum + term } else { sum - term })
            }),
            n => Err(ShapeMismatch(format!("a determinant of {n} rows"))),
        }
    }

    /// The inverse: adjugate over determinant.
    pub(crate) fn inverse(&self) -> Result<Self, ShapeMismatch> {
        let determinant = self.determinant()?;
        if determinant.is_zero() {
            return Err(ShapeMismatch("the inverse of a singular matrix".to_owned()));
        }
        if self.is_scalar() {
            return Ok(Self::scalar(Fraction::one() / determinant));
        }
        let mut entries = Vec::with_capacity(self.entries.len());
        for r in 0..self.rows {
            for c in 0..self.columns {
                let minor = self.minor(c, r).determinant()?;
                let cofactor = if (r + c) % 2 == 0 { minor } else { -minor };
                entries.push(cofactor / determinant.clone());
            }
        }
        Ok(Self {
            rows: self.rows,
            columns: self.columns,
            entries,
        })
    }

    /// The grid without a row and a column.
    fn minor(&self, row: usize, column: usize) -> Self {
        let skip = |i: usize, left_out: usize| if i < left_out { i } else { i + 1 };
        Self::from_fn(self.rows - 1, self.columns - 1, |r, c| {
            self.at(skip(r, row), skip(c, column)).clone()
        })
    }

    fn square(&self, what: &str) -> Result<(), ShapeMismatch> {
        if self.rows == self.columns {
            Ok(())
        } else {
            Err(ShapeMismatch(format!("the {what} of {}", self.shape())))
        }
    }
}

/// The sides of a line, each that is a multiple of the unit matrix in the size of the matrix beside it.
pub(crate) fn units_in_size(mut sides: Vec<Value>) -> Vec<Value> {
    for i in 1..sides.len() {
        let (before, after) = (&sides[i - 1], &sides[i]);
        if before.rows == after.rows {
            continue;
        }
        if let Some(unit) = after.unit_of_size(before) {
            sides[i] = unit;
        } else if let Some(unit) = before.unit_of_size(after) {
            sides[i - 1] = unit;
        }
    }
    sides
}
