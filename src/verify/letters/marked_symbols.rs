//! Symbols that are kept for what hangs on them: a δ before, or a label beside two indices.

use crate::notation::ast::Symbol;
use crate::verify::letters::usage::{Usage, axes};

/// Symbols of a kind that are kept: a real document has a few.
const MOST: usize = 40;

impl Usage {
    pub(super) fn keep_marked(&mut self, symbol: &Symbol) {
        let keep = |all: &mut Vec<Symbol>| {
            if all.len() < MOST && !all.contains(symbol) {
                all.push(symbol.clone());
            }
        };
        if symbol.variation {
            keep(&mut self.varied);
        }
        if is_labelled_entry(symbol) {
            keep(&mut self.entries);
        }
    }
}

/// Whether a symbol has two indices of axes, and a label or a prime besides.
fn is_labelled_entry(symbol: &Symbol) -> bool {
    let texts = symbol.subscripts.iter().flat_map(|text| text.split(','));
    let (indices, labels): (Vec<&str>, Vec<&str>) = texts.partition(|text| axes(text).is_some());
    let labelled = !labels.is_empty() || !symbol.superscripts.is_empty() || symbol.primes > 0;
    indices.len() == 1 && labelled
}
