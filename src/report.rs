//! What is shown: a check as text and as JSON, and the derivation itself.

use crate::diagnostic::Diagnostic;
use crate::notation::document::Document;
use crate::verify::Report;

pub mod certificate;
pub mod derive;
pub mod grade;
pub mod html;
pub mod json;
pub mod terminal;

/// A document that was read and checked.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The document.
    pub document: Document,
    /// What the reader had to say of it.
    pub diagnostics: Vec<Diagnostic>,
    /// What was found, line by line.
    pub report: Report,
}

/// An input that could not be read, or a sentence in it that was not understood.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Failure {
    /// Its name as it was given.
    pub path: String,
    /// Why, in one clause.
    pub message: String,
    /// The notebook cell, from 0.
    pub cell: Option<usize>,
    /// The line and the column, from 1, where it is known.
    pub place: Option<(usize, usize)>,
    /// What to do.
    pub help: Option<String>,
}
