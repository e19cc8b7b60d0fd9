//! Rows and columns in another order, and slots written otherwise.

use super::{Candidate, Problem, Region, ranges};
use crate::jacobian::cause::Kind;
use crate::jacobian::slot::{Rewriting, Slot};
use nalgebra::DMatrix;
use std::collections::BTreeSet;
use std::ops::Range;

impl Problem<'_> {
    /// Swapped rows and columns, one by one and by slots.
    pub(super) fn permuted(&self, found: &mut Vec<Candidate>) {
        let (height, width) = self.right.shape();
        let (row_slots, column_slots) = (ranges(self.rows, height), ranges(self.columns, width));
        let strips = |slots: &[Range<usize>], size: usize| {
            let parts = slots.iter().filter(|s| s.len() < size).cloned();
            std::iter::once(0..size).chain(parts).collect::<Vec<_>>()
        };
        for strip in strips(&row_slots, height) {
            for (a, b) in self.swapped_columns(&strip) {
                let region = Region {
                    rows: strip.clone().collect(),
                    columns: vec![a, b],
                };
                let other = |r: usize, c: usize| self.taken(r, if c == a { b } else { a });
                self.try_change(Kind::SwappedColumns(a, b), &region, other, found);
            }
        }
        for strip in strips(&column_slots, width) {
            for (a, b) in self.swapped_rows(&strip) {
                let region = Region {
                    rows: vec![a, b],
                    columns: strip.clone().collect(),
                };
                let other = |r: usize, c: usize| self.taken(if r == a { b } else { a }, c);
                self.try_change(Kind::SwappedRows(a, b), &region, other, found);
            }
        }
        let whole = Region {
            rows: (0..height).collect(),
            columns: (0..width).collect(),
        };
        for (a, b, order) in exchanged(&column_slots) {
            let other = |r: usize, c: usize| self.taken(r, order[c]);
            self.try_change(Kind::ColumnSlots(a, b), &whole, other, found);
        }
        for (a, b, order) in exchanged(&row_slots) {
            let other = |r: usize, c: usize| self.taken(order[r], c);
            self.try_change(Kind::RowSlots(a, b), &whole, other, found);
        }
    }

    fn taken(&self, r: usize, c: usize) -> (f64, f64) {
        (self.right[(r, c)], self.slack[(r, c)])
    }

    /// Pairs of columns, one of them wrong, of which each holds in the given rows what belongs into the other.
    fn swapped_columns(&self, rows: &Range<usize>) -> Vec<(usize, usize)> {
        let holds = |at: usize, what: usize| {
            let same = |r: usize| {
                (self.given[(r, at)] - self.right[(r, what)]).abs() <= self.slack[(r, what)]
            };
            rows.clone().all(same)
        };
        let wrong: BTreeSet<_> = self.wrong.iter().map(|entry| entry.1).collect();
        swaps(&wrong, self.right.ncols(), holds)
    }

    /// The same of rows.
    fn swapped_rows(&self, columns: &Range<usize>) -> Vec<(usize, usize)> {
        let holds = |at: usize, what: usize| {
            let same = |c: usize| {
                (self.given[(at, c)] - self.right[(what, c)]).abs() <= self.slack[(what, c)]
            };
            columns.clone().all(same)
        };
        let wrong: BTreeSet<_> = self.wrong.iter().map(|entry| entry.0).collect();
        swaps(&wrong, self.right.nrows(), holds)
    }

    /// Slots written otherwise: all columns or rows of one, all slots that can be, or one block.
    pub(super) fn rewritten(&self, found: &mut Vec<Candidate>) {
        let (height, width) = self.right.shape();
        let (row_slots, column_slots) = (ranges(self.rows, height), ranges(self.columns, width));
        let rows = rewritings(self.rows, &row_slots);
        let columns = rewritings(self.columns, &column_slots);
        for (place, by) in &columns {
            let right = on_columns(self.right, place, &by.matrix, false);
            let slack = on_columns(self.slack, place, &by.matrix, true);
            self.try_matrix(by, (0..height, place.clone()), (&right, &slack), found);
            for strip in row_slots.iter().filter(|s| s.len() < height) {
                self.try_matrix(by, (strip.clone(), place.clone()), (&right, &slack), found);
            }
        }
        for (place, by) in &rows {
            let right = on_rows(self.right, place, &by.matrix, false);
            let slack = on_rows(self.slack, place, &by.matrix, true);
            self.try_matrix(by, (place.clone(), 0..width), (&right, &slack), found);
            for strip in column_slots.iter().filter(|s| s.len() < width) {
                self.try_matrix(by, (place.clone(), strip.clone()), (&right, &slack), found);
            }
        }
        // The same slip in rows and columns at once.
        for (place, by) in &rows {
            let (right, slack) = (
                on_rows(self.right, place, &by.matrix, false),
                on_rows(self.slack, place, &by.matrix, true),
            );
            for (across, of) in columns.iter().filter(|(_, of)| of.kind == by.kind) {
                let right = on_columns(&right, across, &of.matrix, false);
                let slack = on_columns(&slack, across, &of.matrix, true);
                self.try_matrix(by, (0..height, 0..width), (&right, &slack), found);
            }
        }
    }

    fn try_matrix(
        &self,
        by: &Rewriting,
        (rows, columns): (Range<usize>, Range<usize>),
        (right, slack): (&DMatrix<f64>, &DMatrix<f64>),
        found: &mut Vec<Candidate>,
    ) {
        let region = Region {
            rows: rows.collect(),
            columns: columns.collect(),
        };
        let change = |r: usize, c: usize| (right[(r, c)], slack[(r, c)]);
        self.try_change(Kind::Written(by.kind), &region, change, found);
    }
}

/// Pairs of which each holds what belongs into the other.
fn swaps(
    wrong: &BTreeSet<usize>,
    count: usize,
    holds: impl Fn(usize, usize) -> bool,
) -> Vec<(usize, usize)> {
    let mut found = vec![];
    for &a in wrong {
        let others = (0..count).filter(|b| *b != a && (*b > a || !wrong.contains(b)));
        found.extend(
            others
                .filter(|b| holds(a, *b) && holds(*b, a))
                .map(|b| (a, b)),
        );
    }
    found
}

/// The orders in which two slots have changed places: for each place what stands there.
fn exchanged(slots: &[Range<usize>]) -> Vec<(usize, usize, Vec<usize>)> {
    let pairs = (0..slots.len()).flat_map(|a| (a + 1..slots.len()).map(move |b| (a, b)));
    let exchange = |(a, b)| {
        let mut order: Vec<_> = slots.iter().collect();
        order.swap(a, b);
        (a, b, order.into_iter().flat_map(Clone::clone).collect())
    };
    pairs.map(exchange).collect()
}

fn rewritings(slots: &[Slot], ranges: &[Range<usize>]) -> Vec<(Range<usize>, Rewriting)> {
    let whole = slots
        .iter()
        .zip(ranges)
        .filter(|(slot, range)| slot.len() == range.len());
    whole
        .flat_map(|(slot, range)| slot.rewritings().into_iter().map(|by| (range.clone(), by)))
        .collect()
}

/// The matrix with the columns of a slot in other coordinates; of slacks, by magnitudes.
fn on_columns(
    matrix: &DMatrix<f64>,
    place: &Range<usize>,
    by: &DMatrix<f64>,
    magnitudes: bool,
) -> DMatrix<f64> {
    let by = if magnitudes {
        by.map(f64::abs)
    } else {
        by.clone()
    };
    let mut changed = matrix.clone();
    let columns = matrix.columns(place.start, place.len()) * by;
    changed
        .columns_mut(place.start, place.len())
        .copy_from(&columns);
    changed
}

/// The same with its rows, which take the inverse.
fn on_rows(
    matrix: &DMatrix<f64>,
    place: &Range<usize>,
    by: &DMatrix<f64>,
    magnitudes: bool,
) -> DMatrix<f64> {
    on_columns(&matrix.transpose(), place, by, magnitudes).transpose()
}
