//! The imaginary unit: who joins two equations in one complex equation writes it i.

use crate::notation::ast::Symbol;
use crate::notation::document::Document;
use crate::verify::letters::usage::{Letter, Usage};

/// Words of those who calculate with complex numbers, and what they write for the unit.
const SAID: &[&str] = &["complex", "imaginary", "\\sqrt{-1}"];

/// Whether the plain letter i is the imaginary unit: complex numbers are spoken of, and i is never anything that moves,
/// has an index or a direction.
pub(crate) fn has_imaginary_unit(document: &Document, usage: &Usage) -> bool {
    let used = usage.get(&Letter::plain("i"));
    let number = used.bare > 0 && used.vector + used.component + used.double + used.tensor == 0;
    let plain = number && !used.moving && used.hats == 0 && !usage.plain_units;
    let text = plain.then(|| document.source.text.to_lowercase());
    text.is_some_and(|text| SAID.iter().any(|said| text.contains(said)))
}

/// Whether a symbol is a letter i and nothing else.
pub(crate) fn is_plain_i(symbol: &Symbol) -> bool {
    let bare = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
    symbol.name == "i" && bare && symbol.primes == 0 && !symbol.style.vector && !symbol.style.hat
}
