//! Results as JSON, written as they come.

use crate::cli::run::writer::Form;
use crate::scene::{Outcome, Row, Run, Sensitivity};
use nalgebra::SMatrix;
use serde_json::{Value, json};
use std::io::{self, Write};

#[derive(Default)]
pub(super) struct Json {
    bodies: u64,
    rows: u64,
    trajectory: bool,
}

impl Form for Json {
    fn open(&mut self, out: &mut dyn Write, run: &Run) -> io::Result<()> {
        self.trajectory = run.outputs.trajectory;
        let head = json!({"duration": run.duration, "tolerance": run.tolerance});
        write!(
            out,
            "{{\"schema\": \"polhode-run/1\", \"run\": {head}, \"bodies\": ["
        )
    }

    fn begin(&mut self, out: &mut dyn Write, name: &str) -> io::Result<()> {
        let comma = if self.bodies > 0 { "," } else { "" };
        self.bodies += 1;
        self.rows = 0;
        write!(out, "{comma}\n{{\"name\": {}", Value::from(name))?;
        if self.trajectory {
            write!(out, ", \"trajectory\": [")?;
        }
        Ok(())
    }

    fn row(&mut self, out: &mut dyn Write, row: &Row) -> io::Result<()> {
        let comma = if self.rows > 0 { "," } else { "" };
        self.rows += 1;
        write!(out, "{comma}\n  {{\"time\": {}, ", Value::from(row.time))?;
        write!(out, "\"attitude\": ")?;
        serde_json::to_writer(&mut *out, &row.state.attitude.components())?;
        write!(out, ", \"angular_velocity\": ")?;
        serde_json::to_writer(&mut *out, row.state.angular_velocity.as_slice())?;
        write!(out, ", \"energy\": {}}}", Value::from(row.energy))
    }

    fn end(&mut self, out: &mut dyn Write, outcome: &Outcome) -> io::Result<()> {
        if self.trajectory {
            write!(out, "]")?;
        }
        write!(out, ", \"attitude\": ")?;
        let attitude = outcome.last.attitude.components();
        serde_json::to_writer(&mut *out, &outcome.has_attitude.then_some(attitude))?;
        write!(out, ", \"angular_velocity\": ")?;
        serde_json::to_writer(&mut *out, outcome.last.angular_velocity.as_slice())?;
        write!(out, ", \"time\": {}", Value::from(outcome.time))?;
        for (key, value) in [
            ("energy_drift", outcome.energy_drift),
            ("momentum_drift", outcome.momentum_drift),
            ("error_estimate", outcome.error),
        ] {
            write!(out, ", \"{key}\": ")?;
            serde_json::to_writer(&mut *out, &value.filter(|v| v.is_finite()))?;
        }
        write!(out, ", \"plan\": {}", Value::from(outcome.way.to_string()))?;
        let jacobian = outcome.jacobian.as_ref().map_or(Value::Null, blocks);
        write!(out, ", \"jacobian\": {jacobian}}}")
    }

    fn close(&mut self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "\n]}}")
    }
}

/// The blocks that were asked for, by row.
fn blocks(found: &Sensitivity) -> Value {
    let mut form = serde_json::Map::new();
    let mut put = |key: &str, rows: Option<Vec<Vec<f64>>>| {
        if let Some(rows) = rows {
            form.insert(key.to_owned(), json!(rows));
        }
    };
    put("attitude", found.attitude.as_ref().map(rows));
    put(
        "angular_velocity",
        found.angular_velocity.as_ref().map(rows),
    );
    put("torque", found.torque.as_ref().map(rows));
    put("inertia", found.inertia.as_ref().map(rows));
    put("dt", found.dt.as_ref().map(rows));
    Value::Object(form)
}

fn rows<const N: usize>(block: &SMatrix<f64, 6, N>) -> Vec<Vec<f64>> {
    block
        .row_iter()
        .map(|row| row.iter().copied().collect())
        .collect()
}
