//! Letters in formulas that only look like those of the key.

use crate::notation;
use crate::notation::document::{Document, Item, line_name};

/// Where a formula holds a letter that looks like a Latin one and is another.
pub(super) fn lookalike(document: &Document) -> Option<String> {
    document.items.iter().find_map(|item| {
        let Item::Formula(formula) = item else {
            return None;
        };
        let (letter, latin) = notation::lookalike(document.source.slice(formula.span))?;
        let place = document.place(formula.span.start);
        Some(format!(
            "{} has the letter {letter} (U+{:04X}), which looks like {latin} and is another",
            line_name(place.cell, place.line),
            u32::from(letter)
        ))
    })
}
