//! A file of costs.

use crate::diagnostic::Diagnostic;
use crate::scene::Costs;
use crate::scene::read::reader::{Bound, Reader, Table, span};
use crate::source::{Source, Span};
use toml::de::DeTable;

const KEYS: &[&str] = &[
    "taylor",
    "taylor_space",
    "dop853",
    "dop853_space",
    "free",
    "spin",
    "rk4",
];

/// The costs that a file holds, or what is wrong with it.
pub(in crate::scene) fn costs(source: &Source) -> Result<Costs, Vec<Diagnostic>> {
    let mut reader = Reader::default();
    let found = match DeTable::parse(&source.text) {
        Ok(table) => {
            let whole = Table {
                entries: table.get_ref(),
                span: Span::new(0, 0),
                what: "a file of costs",
            };
            reader.known(&whole, KEYS);
            all(&mut reader, &whole)
        }
        Err(error) => {
            let place = error.span().map_or_else(Span::default, span);
            reader.report(Diagnostic::error("syntax", place, error.message()));
            None
        }
    };
    match found {
        Some(costs) if reader.diagnostics.is_empty() => Ok(costs),
        _ => Err(reader.diagnostics),
    }
}

fn all(reader: &mut Reader, table: &Table<'_>) -> Option<Costs> {
    Some(Costs {
        taylor: list(reader, table, "taylor")?,
        taylor_space: list(reader, table, "taylor_space")?,
        dop853: list(reader, table, "dop853")?,
        dop853_space: list(reader, table, "dop853_space")?,
        free: list(reader, table, "free")?,
        spin: single(reader, table, "spin")?,
        rk4: single(reader, table, "rk4")?,
    })
}

fn single(reader: &mut Reader, table: &Table<'_>, key: &str) -> Option<f64> {
    let value = reader.required(table, key)?;
    reader.number(value, "a cost", Bound::Positive)
}

fn list<const N: usize>(reader: &mut Reader, table: &Table<'_>, key: &str) -> Option<[f64; N]> {
    let value = reader.required(table, key)?;
    let list = reader.list(value, "the costs")?;
    let found: Vec<f64> = list
        .iter()
        .map(|value| reader.number(value, "a cost", Bound::Positive))
        .collect::<Option<_>>()?;
    match found.try_into() {
        Ok(found) => Some(found),
        Err(_) => reader.wrong(value, format!("there have to be {N} costs")),
    }
}
