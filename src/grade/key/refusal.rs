//! Why a key can't be used.

use crate::notation::document::Document;
use crate::source::Span;
use std::fmt;

/// Why a key can't be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// The line of the key, from 1.
    pub source_line: Option<usize>,
    /// What is wrong, and what to do.
    pub message: String,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(cell) = self.cell {
            write!(f, "cell {cell}, ")?;
        }
        if let Some(line) = self.source_line {
            write!(f, "line {line}: ")?;
        }
        f.write_str(&self.message)
    }
}

/// A refusal of the whole key.
pub(super) fn refusal(message: String) -> Refusal {
    Refusal {
        cell: None,
        source_line: None,
        message,
    }
}

/// A refusal at a place of the key.
pub(super) fn at(document: &Document, span: Span, message: String) -> Refusal {
    let place = document.place(span.start);
    Refusal {
        cell: place.cell,
        source_line: Some(place.line),
        message,
    }
}
