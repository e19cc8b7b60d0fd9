//! Jupyter notebooks: the markdown cells, one after the other.

use crate::diagnostic::Diagnostic;
use crate::notation::document::{Cell, Document, Format, FrontMatter, Item};
use crate::notation::macros::Macros;
use crate::notation::{front_matter, long_lines, markdown};
use crate::source::{Source, Span};
use serde_json::Value;

/// Reads a notebook; one that is no JSON gives an empty document and says so.
pub(crate) fn read(
    name: &str,
    text: &str,
    macros: &impl Fn(&str) -> Macros,
    troubles: &mut Vec<Diagnostic>,
) -> Document {
    let mut joined = String::new();
    let mut cells = vec![];
    match serde_json::from_str::<Value>(text) {
        Ok(notebook) => {
            for (index, source) in markdown_cells(&notebook) {
                let start = joined.len();
                joined.push_str(&source);
                cells.push(Cell {
                    index,
                    span: Span::new(start, joined.len()),
                });
                joined.push_str("\n\n");
            }
        }
        Err(error) => {
            let message = format!("the notebook is not read: {error}");
            troubles.push(Diagnostic::error("notebook", Span::default(), message));
        }
    }
    let mut front = FrontMatter::default();
    let shown = long_lines::blanked(&joined, Format::Notebook, troubles);
    let macros = macros(&shown);
    let mut items: Vec<Item> = vec![];
    for (n, cell) in cells.iter().enumerate() {
        let start = cell.span.start as usize;
        let body = &shown[cell.span.range()];
        let skip = if n == 0 {
            front_matter::take(body, &mut front, troubles)
        } else {
            0
        };
        items.extend(markdown::items(&body[skip..], start + skip, &macros));
        items.push(Item::Break);
    }
    Document {
        format: Format::Notebook,
        source: Source::new(name, joined.as_str()),
        cells,
        front_matter: front,
        macros,
        items,
    }
}

/// The markdown cells with their index among all cells.
fn markdown_cells(notebook: &Value) -> Vec<(usize, String)> {
    let cells = notebook.get("cells").and_then(Value::as_array);
    let markdown =
        |cell: &&Value| cell.get("cell_type").and_then(Value::as_str) == Some("markdown");
    let cells = cells.into_iter().flatten().enumerate();
    cells
        .filter(|(_, cell)| markdown(cell))
        .map(|(index, cell)| (index, cell.get("source").map_or(String::new(), source)))
        .collect()
}

fn source(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(lines) => lines.iter().filter_map(Value::as_str).collect(),
        _ => String::new(),
    }
}
