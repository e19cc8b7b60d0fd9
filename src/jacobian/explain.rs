//! The search for likely causes: the fewest simple changes of the right matrix that give the wrong one.
//!
//! Each candidate changes a region of the right matrix. It fits only if it gives every entry of the region, the right ones
//! too. Of the candidates that fit, the one that explains most wrong entries is taken, then the next for what is left.

mod reordered;

use super::cause::{Cause, Kind};
use super::slot::Slot;
use nalgebra::{DMatrix, Vector3};
use std::collections::BTreeSet;
use std::ops::Range;

/// The most causes that are named, and the most single entries that are looked at.
const MOST_CAUSES: usize = 12;
const MOST_ENTRIES: usize = 400;

/// A wrong matrix and the right one.
pub(super) struct Problem<'a> {
    pub(super) given: &'a DMatrix<f64>,
    pub(super) right: &'a DMatrix<f64>,
    /// How far an entry may be off.
    pub(super) slack: &'a DMatrix<f64>,
    /// The entries that are wrong.
    pub(super) wrong: &'a BTreeSet<(usize, usize)>,
    pub(super) rows: &'a [Slot],
    pub(super) columns: &'a [Slot],
}

/// A change of a region that fits.
struct Candidate {
    kind: Kind,
    rows: Vec<usize>,
    columns: Vec<usize>,
    explains: BTreeSet<(usize, usize)>,
}

/// A part of the matrix.
#[derive(Clone, PartialEq)]
struct Region {
    rows: Vec<usize>,
    columns: Vec<usize>,
}

/// The causes, the one that explains most first.
pub(super) fn causes(problem: &Problem<'_>) -> Vec<Cause> {
    let mut candidates = problem.candidates();
    let mut found = vec![];
    while found.len() < MOST_CAUSES {
        candidates.retain(|candidate| !candidate.explains.is_empty());
        let rank = |c: &Candidate| {
            let size = c.rows.len() * c.columns.len();
            (std::cmp::Reverse(c.explains.len()), c.kind.cost(), size)
        };
        let Some(best) = candidates.iter().min_by_key(|c| rank(c)) else {
            break;
        };
        let or = candidates
            .iter()
            .filter(|c| c.explains == best.explains && c.kind.cost() == best.kind.cost())
            .map(|c| c.kind)
            .filter(|kind| *kind != best.kind);
        let mut or: Vec<_> = or.collect();
        or.dedup();
        let explained = best.explains.clone();
        found.push(Cause {
            kind: best.kind,
            or,
            rows: best.rows.clone(),
            columns: best.columns.clone(),
            explains: explained.len(),
        });
        for candidate in &mut candidates {
            candidate
                .explains
                .retain(|entry| !explained.contains(entry));
        }
    }
    found
}

/// The rows or columns of each slot.
pub(super) fn ranges(slots: &[Slot], size: usize) -> Vec<Range<usize>> {
    let mut start = 0;
    let mut found: Vec<_> = slots
        .iter()
        .map(|slot| {
            let range = start..(start + slot.len()).min(size);
            start = range.end;
            range
        })
        .collect();
    if start < size {
        found.push(start..size);
    }
    found
}

impl Problem<'_> {
    fn candidates(&self) -> Vec<Candidate> {
        let mut found = vec![];
        let regions = self.regions();
        for region in &regions {
            self.scaled(region, &mut found);
        }
        for region in regions.iter().filter(|r| r.rows.len() == r.columns.len()) {
            if region.rows.len() > 1 {
                self.of_square(region, &mut found);
            }
        }
        self.permuted(&mut found);
        self.rewritten(&mut found);
        self.approximate(&mut found);
        found
    }

    /// The whole, the strips and blocks of the slots, single rows and columns, and single wrong entries.
    fn regions(&self) -> Vec<Region> {
        let (height, width) = self.right.shape();
        let (all_rows, all_columns) = (0..height, 0..width);
        let (row_slots, column_slots) = (ranges(self.rows, height), ranges(self.columns, width));
        let rows = || (0..height).map(|r| r..r + 1);
        let columns = || (0..width).map(|c| c..c + 1);
        let mut found: Vec<Region> = vec![];
        let mut add = |rows: Range<usize>, columns: Range<usize>| {
            let region = Region {
                rows: rows.collect(),
                columns: columns.collect(),
            };
            let hit = self.wrong_in(&region).next().is_some();
            if hit && !found.contains(&region) {
                found.push(region);
            }
        };
        add(all_rows.clone(), all_columns.clone());
        for slot in &row_slots {
            add(slot.clone(), all_columns.clone());
            for column in &column_slots {
                add(slot.clone(), column.clone());
            }
            for column in columns().filter(|_| row_slots.len() > 1) {
                add(slot.clone(), column);
            }
        }
        for slot in &column_slots {
            add(all_rows.clone(), slot.clone());
            for row in rows().filter(|_| column_slots.len() > 1) {
                add(row, slot.clone());
            }
        }
        for row in rows() {
            add(row, all_columns.clone());
        }
        for column in columns() {
            add(all_rows.clone(), column);
        }
        for (r, c) in self.wrong.iter().take(MOST_ENTRIES) {
            add(*r..r + 1, *c..c + 1);
        }
        found
    }

    fn wrong_in<'a>(
        &'a self,
        region: &'a Region,
    ) -> impl Iterator<Item = (usize, usize)> + use<'a> {
        let entries = region.entries();
        entries.filter(|entry| self.wrong.contains(entry))
    }

    /// Adds the change of a region if it gives every entry within its slack.
    fn try_change(
        &self,
        kind: Kind,
        region: &Region,
        change: impl Fn(usize, usize) -> (f64, f64),
        found: &mut Vec<Candidate>,
    ) {
        let fits = region.entries().all(|(r, c)| {
            let (value, slack) = change(r, c);
            (self.given[(r, c)] - value).abs() <= slack
        });
        if fits {
            found.push(Candidate {
                kind,
                rows: region.rows.clone(),
                columns: region.columns.clone(),
                explains: self.wrong_in(region).collect(),
            });
        }
    }

    /// Multiples of the right entries.
    fn scaled(&self, region: &Region, found: &mut Vec<Candidate>) {
        let (right, slack) = (self.right, self.slack);
        let by = |factor: f64| {
            move |r: usize, c: usize| {
                let entry = (r, c);
                let given = self.given[entry].abs() * 1e-9;
                (factor * right[entry], factor.abs() * slack[entry] + given)
            }
        };
        self.try_change(Kind::Sign, region, by(-1.0), found);
        self.try_change(Kind::Factor(2.0), region, by(2.0), found);
        self.try_change(Kind::Factor(0.5), region, by(0.5), found);
        self.try_change(Kind::Missing, region, |r, c| (0.0, slack[(r, c)]), found);
        let zeros = region
            .entries()
            .all(|entry| right[entry].abs() <= slack[entry]);
        if zeros {
            let given = |r: usize, c: usize| (self.given[(r, c)], slack[(r, c)]);
            self.try_change(Kind::Extra, region, given, found);
        }
        // Any other common factor has to hold in more than one entry.
        let sized = |entry: &(usize, usize)| right[*entry].abs() > 1e3 * slack[*entry];
        let largest = self.wrong_in(region).filter(sized).max_by(|a, b| {
            let relative = |entry: &(usize, usize)| right[*entry].abs() / slack[*entry];
            relative(a).total_cmp(&relative(b))
        });
        let factor = largest.map(|entry| self.given[entry] / right[entry]);
        let common = factor.filter(|f| ![-1.0, 0.0, 0.5, 2.0].iter().any(|k| (f - k).abs() < 1e-6));
        if let Some(factor) = common
            && self.wrong_in(region).filter(sized).count() > 1
        {
            self.try_change(Kind::Factor(factor), region, by(factor), found);
        }
    }

    /// A square region transposed, or with a multiple of the identity or a cross product added.
    fn of_square(&self, region: &Region, found: &mut Vec<Candidate>) {
        let (right, slack) = (self.right, self.slack);
        let (top, left) = (region.rows[0], region.columns[0]);
        let across = |r: usize, c: usize| {
            let entry = (c - left + top, r - top + left);
            (right[entry], slack[entry] + slack[(r, c)])
        };
        self.try_change(Kind::Transposed, region, across, found);
        let added = |r: usize, c: usize| {
            let entry = (r + top, c + left);
            self.given[entry] - right[entry]
        };
        let mean =
            (0..region.rows.len()).map(|i| added(i, i)).sum::<f64>() / region.rows.len() as f64;
        let identity = |r: usize, c: usize| {
            let extra = if r - top == c - left { mean } else { 0.0 };
            (right[(r, c)] + extra, slack[(r, c)] + 1e-9 * mean.abs())
        };
        self.try_change(Kind::Identity(mean), region, identity, found);
        if region.rows.len() == 3 {
            let half = |r, c| (added(r, c) - added(c, r)) / 2.0;
            let v = Vector3::new(half(2, 1), half(0, 2), half(1, 0));
            let skew = v.cross_matrix();
            let term = |r: usize, c: usize| {
                let extra = skew[(r - top, c - left)];
                (right[(r, c)] + extra, slack[(r, c)] + 1e-9 * extra.abs())
            };
            self.try_change(Kind::CrossTerm(v), region, term, found);
        }
    }

    /// Entries that are nearly right.
    fn approximate(&self, found: &mut Vec<Candidate>) {
        let off = |entry: &(usize, usize)| {
            (self.given[*entry] - self.right[*entry]).abs() / self.right[*entry].abs()
        };
        let near: BTreeSet<_> = self
            .wrong
            .iter()
            .copied()
            .filter(|e| off(e) < 1e-4)
            .collect();
        let Some(worst) = near.iter().map(off).max_by(f64::total_cmp) else {
            return;
        };
        found.push(Candidate {
            kind: Kind::Approximate(-worst.log10().ceil() as i32),
            rows: near
                .iter()
                .map(|e| e.0)
                .collect::<BTreeSet<_>>()
                .into_iter()
                .collect(),
            columns: near
                .iter()
                .map(|e| e.1)
                .collect::<BTreeSet<_>>()
                .into_iter()
                .collect(),
            explains: near,
        });
    }
}

impl Region {
    fn entries(&self) -> impl Iterator<Item = (usize, usize)> + use<'_> {
        let rows = self.rows.iter();
        rows.flat_map(|r| self.columns.iter().map(|c| (*r, *c)))
    }
}
