//! Results as text for people.

use crate::cli::run::writer::Form;
use crate::scene::{Outcome, Row, Run, Sensitivity};
use annotate_snippets::normalize_untrusted_str;
use nalgebra::SMatrix;
use std::io::{self, Write};

/// Bodies that are shown; CSV and JSON have them all.
const SHOWN: u64 = 20;
/// Rows of a trajectory that are shown.
const ROWS: u64 = 200;

#[derive(Default)]
pub(super) struct Text {
    bodies: u64,
    rows: u64,
    tolerance: f64,
    estimated: bool,
    worst: f64,
}

impl Text {
    fn shown(&self) -> bool {
        self.bodies <= SHOWN
    }
}

impl Form for Text {
    fn open(&mut self, _: &mut dyn Write, run: &Run) -> io::Result<()> {
        self.tolerance = run.tolerance;
        self.estimated = run.estimate_error;
        Ok(())
    }

    fn begin(&mut self, out: &mut dyn Write, name: &str) -> io::Result<()> {
        self.bodies += 1;
        self.rows = 0;
        if self.shown() {
            writeln!(out, "{}", normalize_untrusted_str(name))?;
        }
        Ok(())
    }

    fn row(&mut self, out: &mut dyn Write, row: &Row) -> io::Result<()> {
        self.rows += 1;
        if !self.shown() || self.rows > ROWS {
            return Ok(());
        }
        if self.rows == 1 {
            let heads = ["time", "qw", "qx", "qy", "qz", "ωx", "ωy", "ωz", "energy"];
            write!(out, "  {:>10}", heads[0])?;
            for head in &heads[1..] {
                write!(out, " {head:>13}")?;
            }
            writeln!(out)?;
        }
        write!(out, "  {:>10.4}", row.time)?;
        let omega = row.state.angular_velocity;
        let numbers = row
            .state
            .attitude
            .components()
            .into_iter()
            .chain(omega.iter().copied());
        for number in numbers {
            write!(out, " {}", short(number))?;
        }
        writeln!(out, " {}", short(row.energy))
    }

    fn end(&mut self, out: &mut dyn Write, outcome: &Outcome) -> io::Result<()> {
        self.worst = self.worst.max(outcome.error.unwrap_or(0.0));
        if !self.shown() {
            return Ok(());
        }
        if self.rows > ROWS {
            let left = self.rows - ROWS;
            writeln!(out, "  … and {left} rows more; `--format csv` has them all")?;
        }
        let [w, x, y, z] = outcome.last.attitude.components();
        let omega = outcome.last.angular_velocity;
        writeln!(out, "  at t = {} s, by {}", outcome.time, outcome.way)?;
        if outcome.has_attitude {
            writeln!(
                out,
                "    attitude          {w:>22.16} {x:>22.16} {y:>22.16} {z:>22.16}"
            )?;
        }
        writeln!(
            out,
            "    angular velocity  {:>22.15e} {:>22.15e} {:>22.15e} rad/s",
            omega.x, omega.y, omega.z
        )?;
        for (name, value) in [
            ("energy drift", outcome.energy_drift),
            ("momentum drift", outcome.momentum_drift),
            ("error, estimated", outcome.error),
        ] {
            if let Some(value) = value {
                writeln!(out, "    {name:<17} {value:>9.1e}")?;
            }
        }
        if let Some(jacobian) = &outcome.jacobian {
            blocks(out, jacobian)?;
        }
        writeln!(out)
    }

    fn close(&mut self, out: &mut dyn Write) -> io::Result<()> {
        if self.bodies > SHOWN {
            let left = self.bodies - SHOWN;
            writeln!(out, "… and {left} bodies more; `--format csv` has them all")?;
        }
        let bodies = match self.bodies {
            1 => "1 body".to_owned(),
            n => format!("{n} bodies"),
        };
        if self.estimated {
            let (worst, tolerance) = (self.worst, self.tolerance);
            writeln!(
                out,
                "{bodies}, largest estimated error {worst:.1e}, tolerance {tolerance:e}"
            )
        } else {
            writeln!(out, "{bodies}")
        }
    }
}

/// A number in the width of a column.
fn short(number: f64) -> String {
    if number == 0.0 || (1e-3..1e5).contains(&number.abs()) {
        format!("{number:>13.8}")
    } else {
        format!("{number:>13.5e}")
    }
}

fn blocks(out: &mut dyn Write, found: &Sensitivity) -> io::Result<()> {
    block(out, "attitude", found.attitude.as_ref())?;
    block(out, "angular velocity", found.angular_velocity.as_ref())?;
    block(out, "torque", found.torque.as_ref())?;
    block(out, "inertia", found.inertia.as_ref())?;
    block(out, "duration", found.dt.as_ref())
}

fn block<const N: usize>(
    out: &mut dyn Write,
    name: &str,
    block: Option<&SMatrix<f64, 6, N>>,
) -> io::Result<()> {
    let Some(block) = block else {
        return Ok(());
    };
    writeln!(out, "    derivative in the {name}")?;
    for (row, name) in block.row_iter().zip(["θx", "θy", "θz", "ωx", "ωy", "ωz"]) {
        write!(out, "      {name}")?;
        for number in row.iter() {
            write!(out, " {}", short(*number))?;
        }
        writeln!(out)?;
    }
    Ok(())
}
