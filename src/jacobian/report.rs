//! What was found about a Jacobian.

use super::cause::{Cause, Kind};
use super::explain::ranges;
use super::slot::Slot;
use std::fmt;

/// Entries that a report shows.
const SHOWN: usize = 12;

/// What is known of an entry, or of the whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It agrees.
    Right,
    /// The function can't be differenced well enough to tell: noise, a kink, or values that are not finite.
    Unsure,
    /// It differs by more than every error that was made in finding out.
    Wrong,
}

/// An entry of the Jacobian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// The row, from 0.
    pub row: usize,
    /// The column, from 0.
    pub column: usize,
    /// What was given.
    pub given: f64,
    /// What dual numbers or differences say.
    pub right: f64,
    /// How far a right entry may be from that.
    pub error: f64,
    /// |given − right| over the natural scale of its row and column.
    pub discrepancy: f64,
    /// What is known of it.
    pub verdict: Verdict,
    /// The slope of the Taylor remainder, of a black box: 2 where the entry is right, 1 where it is wrong. `None` where
    /// nothing but rounding remains.
    pub slope: Option<f64>,
}

/// What was found about a Jacobian: each entry, the largest discrepancy first, and likely causes.
///
/// Its `Display` is the report in words and a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    pub(super) entries: Vec<Entry>,
    pub(super) causes: Vec<Cause>,
    pub(super) rows: Vec<Slot>,
    pub(super) columns: Vec<Slot>,
    pub(super) shape: [usize; 2],
    pub(super) black_box: bool,
}

impl Report {
    /// The verdict on the whole: that of the worst entry.
    pub fn verdict(&self) -> Verdict {
        if self
            .causes
            .iter()
            .any(|cause| matches!(cause.kind, Kind::Shape(..)))
        {
            return Verdict::Wrong;
        }
        let worst = self.entries.iter().map(|entry| entry.verdict).max();
        worst.unwrap_or(Verdict::Right)
    }

    /// Whether every entry agrees.
    pub fn is_right(&self) -> bool {
        self.verdict() == Verdict::Right
    }

    /// All entries: the wrong ones first, then those of which nothing can be told, each by falling discrepancy.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The likely causes, the one that explains most wrong entries first; together they may leave some unexplained.
    pub fn causes(&self) -> &[Cause] {
        &self.causes
    }

    fn of(&self, verdict: Verdict) -> impl Iterator<Item = &Entry> {
        self.entries
            .iter()
            .filter(move |entry| entry.verdict == verdict)
    }

    /// The names of rows or columns of which some are shown.
    fn place(&self, cause: &Cause) -> String {
        let [height, width] = self.shape;
        let rows = part(&self.rows, height, &cause.rows);
        let columns = part(&self.columns, width, &cause.columns);
        match (rows, columns) {
            (None, None) => "the whole matrix".into(),
            (Some(rows), None) => format!("rows {rows}"),
            (None, Some(columns)) => format!("columns {columns}"),
            (Some(rows), Some(columns)) => format!("∂{rows}/∂{columns}"),
        }
    }

    fn told(&self, cause: &Cause) -> String {
        let [height, width] = self.shape;
        let (rows, columns) = (names(&self.rows, height), names(&self.columns, width));
        let name = |names: &[String], i: usize| names.get(i).cloned().unwrap_or_default();
        let slot = |slots: &[Slot], i: usize| {
            slots
                .get(i)
                .map_or("the last".into(), |slot| slot.name().to_owned())
        };
        match cause.kind {
            Kind::SwappedRows(a, b) => {
                let across = part(&self.columns, width, &cause.columns);
                let within =
                    across.map_or(String::new(), |columns| format!(" in columns {columns}"));
                format!(
                    "rows {} and {} swapped{within}",
                    name(&rows, a),
                    name(&rows, b)
                )
            }
            Kind::SwappedColumns(a, b) => {
                let across = part(&self.rows, height, &cause.rows);
                let within = across.map_or(String::new(), |rows| format!(" in rows {rows}"));
                format!(
                    "columns {} and {} swapped{within}",
                    name(&columns, a),
                    name(&columns, b)
                )
            }
            Kind::RowSlots(a, b) => {
                format!(
                    "rows {} and {} have changed places",
                    slot(&self.rows, a),
                    slot(&self.rows, b)
                )
            }
            Kind::ColumnSlots(a, b) => format!(
                "columns {} and {} have changed places",
                slot(&self.columns, a),
                slot(&self.columns, b)
            ),
            kind => format!("{}: {}", self.place(cause), kind.told()),
        }
    }

    fn table(&self, f: &mut fmt::Formatter<'_>, verdict: Verdict) -> fmt::Result {
        let [height, width] = self.shape;
        let (rows, columns) = (names(&self.rows, height), names(&self.columns, width));
        let label = |entry: &Entry| format!("∂{}/∂{}", rows[entry.row], columns[entry.column]);
        let shown: Vec<_> = self
            .of(verdict)
            .take(SHOWN)
            .map(|e| (label(e), e))
            .collect();
        let wide = shown
            .iter()
            .map(|(label, _)| label.chars().count())
            .max()
            .unwrap_or(0)
            .max(5);
        let by = if self.black_box {
            "by differences"
        } else {
            "by dual numbers"
        };
        write!(
            f,
            "\n  {:wide$}  {:>23}  {by:>23}  {:>9}",
            "entry", "given", "off by"
        )?;
        if self.black_box {
            write!(f, "  {:>9}  {:>5}", "error", "slope")?;
        }
        for (label, e) in &shown {
            let off = (e.given - e.right).abs();
            write!(
                f,
                "\n  {label:wide$}  {:>23.15e}  {:>23.15e}  {off:>9.1e}",
                e.given, e.right
            )?;
            if self.black_box {
                let slope = e.slope.map_or("-".into(), |slope| format!("{slope:.2}"));
                write!(f, "  {:>9.1e}  {slope:>5}", e.error)?;
            }
        }
        let more = self.of(verdict).count() - shown.len();
        if more > 0 {
            write!(f, "\n  … and {more} more")?;
        }
        Ok(())
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |verdict| self.of(verdict).count();
        let (wrong, unsure, all) = (
            count(Verdict::Wrong),
            count(Verdict::Unsure),
            self.entries.len(),
        );
        match self.verdict() {
            Verdict::Right => write!(
                f,
                "the Jacobian is right at this point, in all {all} entries"
            )?,
            Verdict::Unsure => write!(f, "no entry of the Jacobian is shown to be wrong")?,
            Verdict::Wrong => write!(f, "the Jacobian is wrong in {wrong} of {all} entries")?,
        }
        if !self.causes.is_empty() {
            write!(f, "\nlikely cause:")?;
        }
        for cause in &self.causes {
            write!(f, "\n  {}", self.told(cause))?;
            for other in &cause.or {
                write!(f, ", or {}", other.told())?;
            }
            if cause.explains > 0 {
                write!(f, " (explains {} of {wrong})", cause.explains)?;
            }
        }
        if wrong > 0 {
            self.table(f, Verdict::Wrong)?;
        }
        if unsure > 0 {
            write!(
                f,
                "\n{unsure} of {all} entries can't be told: noise, a kink or a value that is not finite hides the derivative \
                 at every step. Try another point, the function on dual numbers, or a smoother one."
            )?;
            self.table(f, Verdict::Unsure)?;
        }
        Ok(())
    }
}

/// The names of all rows or columns: those of the slots, and numbers for what no slot names.
fn names(slots: &[Slot], size: usize) -> Vec<String> {
    let mut found: Vec<_> = slots.iter().flat_map(Slot::components).collect();
    found.truncate(size);
    found.extend((found.len()..size).map(|i| format!("[{i}]")));
    found
}

/// The name of some rows or columns: of a slot, or one by one; `None` for all.
fn part(slots: &[Slot], size: usize, some: &[usize]) -> Option<String> {
    if some.len() == size {
        return None;
    }
    let ranges = ranges(slots, size);
    let whole = slots
        .iter()
        .zip(&ranges)
        .find(|(_, range)| some.iter().copied().eq((*range).clone()));
    if let Some((slot, _)) = whole {
        return Some(slot.name().to_owned());
    }
    let names = names(slots, size);
    let listed: Vec<_> = some
        .iter()
        .filter_map(|i| names.get(*i))
        .map(String::as_str)
        .collect();
    Some(listed.join(", "))
}
