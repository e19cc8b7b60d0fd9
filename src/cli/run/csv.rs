//! Results as CSV: the trajectories if they are asked for, else one row a body.

use crate::cli::run::writer::Form;
use crate::motion::State;
use crate::scene::{Outcome, Row, Run};
use std::io::{self, Write};

#[derive(Default)]
pub(super) struct Csv {
    name: String,
    trajectory: bool,
}

impl Form for Csv {
    fn open(&mut self, out: &mut dyn Write, run: &Run) -> io::Result<()> {
        self.trajectory = run.outputs.trajectory;
        writeln!(out, "{}", head(self.trajectory))
    }

    fn begin(&mut self, _: &mut dyn Write, name: &str) -> io::Result<()> {
        self.name = quoted(name);
        Ok(())
    }

    fn row(&mut self, out: &mut dyn Write, row: &Row) -> io::Result<()> {
        self.state(out, row.time, &row.state, true)?;
        writeln!(out, ",{:e}", row.energy)
    }

    fn end(&mut self, out: &mut dyn Write, outcome: &Outcome) -> io::Result<()> {
        if self.trajectory {
            return Ok(());
        }
        self.state(out, outcome.time, &outcome.last, outcome.has_attitude)?;
        for value in [outcome.energy_drift, outcome.momentum_drift, outcome.error] {
            match value {
                Some(value) => write!(out, ",{value:e}")?,
                None => write!(out, ",")?,
            }
        }
        writeln!(out)
    }

    fn close(&mut self, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }
}

impl Csv {
    /// The time and the state, fields of the attitude empty where it is not known.
    fn state(
        &self,
        out: &mut dyn Write,
        time: f64,
        state: &State<f64>,
        has_attitude: bool,
    ) -> io::Result<()> {
        write!(out, "{},{time}", self.name)?;
        if has_attitude {
            let [w, x, y, z] = state.attitude.components();
            write!(out, ",{w:e},{x:e},{y:e},{z:e}")?;
        } else {
            write!(out, ",,,,")?;
        }
        let omega = state.angular_velocity;
        write!(out, ",{:e},{:e},{:e}", omega.x, omega.y, omega.z)
    }
}

/// The names of the columns.
pub(super) fn head(trajectory: bool) -> String {
    let last = if trajectory {
        "energy"
    } else {
        "energy_drift,momentum_drift,error_estimate"
    };
    format!("body,time,qw,qx,qy,qz,wx,wy,wz,{last}")
}

/// A name as a field; one that a spreadsheet would take for a formula gets a quote in front (as OWASP advises).
pub(super) fn quoted(name: &str) -> String {
    let guarded = match name.chars().next() {
        Some('=' | '+' | '-' | '@') => format!("'{name}"),
        _ => name.to_owned(),
    };
    if guarded.contains([',', '"']) {
        format!("\"{}\"", guarded.replace('"', "\"\""))
    } else {
        guarded
    }
}
