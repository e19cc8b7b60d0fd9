//! Results as Parquet: the trajectories if they are asked for, else one row a body, with the columns of the CSV.

use crate::cli::run::writer::Form;
use crate::motion::State;
use crate::scene::{Outcome, Row, Run};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};
use std::io::{self, Write};
use std::mem;
use std::sync::Arc;

/// Rows that are gathered before they are written: some ten megabytes.
const GROUP: usize = 1 << 17;

const STATE: [&str; 8] = ["time", "qw", "qx", "qy", "qz", "wx", "wy", "wz"];
const DRIFTS: [&str; 3] = ["energy_drift", "momentum_drift", "error_estimate"];

#[derive(Default)]
pub(super) struct Parquet {
    trajectory: bool,
    name: ByteArray,
    bodies: Vec<ByteArray>,
    columns: Vec<Column>,
    /// Writes into memory, from where each group of rows is handed on.
    writer: Option<SerializedFileWriter<Vec<u8>>>,
}

/// The numbers of a column; where some may be missing, which are there.
struct Column {
    name: &'static str,
    values: Vec<f64>,
    present: Option<Vec<i16>>,
}

impl Column {
    fn new(name: &'static str, required: bool) -> Self {
        Self {
            name,
            values: Vec::new(),
            present: (!required).then(Vec::new),
        }
    }

    fn push(&mut self, value: Option<f64>) {
        self.values.extend(value);
        if let Some(present) = &mut self.present {
            present.push(i16::from(value.is_some()));
        }
    }

    fn schema(&self) -> Result<TypePtr, ParquetError> {
        let repetition = match self.present {
            None => Repetition::REQUIRED,
            Some(_) => Repetition::OPTIONAL,
        };
        let column = Type::primitive_type_builder(self.name, Physical::DOUBLE);
        Ok(Arc::new(column.with_repetition(repetition).build()?))
    }
}

fn io(error: ParquetError) -> io::Error {
    io::Error::other(error)
}

impl Form for Parquet {
    fn open(&mut self, _: &mut dyn Write, run: &Run) -> io::Result<()> {
        self.trajectory = run.outputs.trajectory;
        let whole = self.trajectory;
        self.columns = STATE
            .map(|name| Column::new(name, whole || !name.starts_with('q')))
            .into();
        if self.trajectory {
            self.columns.push(Column::new("energy", true));
        } else {
            self.columns
                .extend(DRIFTS.map(|name| Column::new(name, false)));
        }
        self.writer = Some(writer(&self.columns).map_err(io)?);
        Ok(())
    }

    fn begin(&mut self, _: &mut dyn Write, name: &str) -> io::Result<()> {
        self.name = ByteArray::from(name);
        Ok(())
    }

    fn row(&mut self, out: &mut dyn Write, row: &Row) -> io::Result<()> {
        self.push(row.time, &row.state, true, &[Some(row.energy)]);
        self.flush(out, GROUP)
    }

    fn end(&mut self, out: &mut dyn Write, outcome: &Outcome) -> io::Result<()> {
        if self.trajectory {
            return Ok(());
        }
        let drifts = [outcome.energy_drift, outcome.momentum_drift, outcome.error];
        self.push(outcome.time, &outcome.last, outcome.has_attitude, &drifts);
        self.flush(out, GROUP)
    }

    fn close(&mut self, out: &mut dyn Write) -> io::Result<()> {
        self.flush(out, 1)?;
        match self.writer.take() {
            Some(writer) => out.write_all(&writer.into_inner().map_err(io)?),
            None => Ok(()),
        }
    }
}

impl Parquet {
    fn push(&mut self, time: f64, state: &State<f64>, has_attitude: bool, others: &[Option<f64>]) {
        self.bodies.push(self.name.clone());
        let attitude = state.attitude.components();
        let attitude = attitude.map(|component| has_attitude.then_some(component));
        let omega = state.angular_velocity.iter().copied().map(Some);
        let values = [Some(time)]
            .into_iter()
            .chain(attitude)
            .chain(omega)
            .chain(others.iter().copied());
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(value);
        }
    }

    /// Hands the rows on as a group, if there are as many.
    fn flush(&mut self, out: &mut dyn Write, least: usize) -> io::Result<()> {
        let Some(writer) = self.writer.as_mut().filter(|_| self.bodies.len() >= least) else {
            return Ok(());
        };
        let mut group = writer.next_row_group().map_err(io)?;
        let done = write_group(&mut group, &self.bodies, &self.columns);
        done.and_then(|()| group.close()).map_err(io)?;
        writer.flush()?;
        out.write_all(&mem::take(writer.inner_mut()))?;
        self.bodies.clear();
        for column in &mut self.columns {
            column.values.clear();
            column.present.iter_mut().for_each(Vec::clear);
        }
        Ok(())
    }
}

fn writer(columns: &[Column]) -> Result<SerializedFileWriter<Vec<u8>>, ParquetError> {
    let body = Type::primitive_type_builder("body", Physical::BYTE_ARRAY)
        .with_repetition(Repetition::REQUIRED)
        .with_logical_type(Some(LogicalType::String))
        .build()?;
    let mut fields = vec![Arc::new(body)];
    for column in columns {
        fields.push(column.schema()?);
    }
    let schema = Type::group_type_builder("trajectory")
        .with_fields(fields)
        .build()?;
    // Names repeat, numbers do not.
    let properties = WriterProperties::builder()
        .set_created_by(format!("polhode {}", env!("CARGO_PKG_VERSION")))
        .set_dictionary_enabled(false)
        .set_column_dictionary_enabled("body".into(), true)
        .build();
    SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties))
}

fn write_group(
    group: &mut SerializedRowGroupWriter<'_, Vec<u8>>,
    bodies: &[ByteArray],
    columns: &[Column],
) -> Result<(), ParquetError> {
    if let Some(mut column) = group.next_column()? {
        column
            .typed::<ByteArrayType>()
            .write_batch(bodies, None, None)?;
        column.close()?;
    }
    for Column {
        values, present, ..
    } in columns
    {
        if let Some(mut column) = group.next_column()? {
            let present = present.as_deref();
            column
                .typed::<DoubleType>()
                .write_batch(values, present, None)?;
            column.close()?;
        }
    }
    Ok(())
}
