//! The variation of an expression, `\delta(\omega\times J\omega)`: its differential in what the document writes a δ before.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::values::lower::{Lowering, Trouble};
use crate::verify::values::value::Value;
use num_traits::Zero;

impl Lowering<'_> {
    /// The variation, where the head is a δ that is no symbol of its own; `None` where nothing inside is varied anywhere.
    pub(crate) fn variation(
        &mut self,
        head: &Node,
        argument: &Node,
    ) -> Result<Option<Value>, Trouble> {
        let bare = |s: &Symbol| s.name == "delta" && s.subscripts.is_empty() && s.primes == 0;
        if !matches!(&inner(head).kind, Kind::Symbol(s) if bare(s)) {
            return Ok(None);
        }
        let inside = symbols(argument);
        let varied = self.reading.usage.varied.iter().filter(|varied| {
            let base = unvaried(varied);
            inside.iter().any(|s| **s == base)
        });
        let varied: Vec<Symbol> = varied.cloned().collect();
        let value = self.value(argument)?;
        let node = |symbol: Symbol| Node {
            span: argument.span,
            kind: Kind::Symbol(symbol),
        };
        let mut pairs: Vec<(u32, Fraction)> = vec![];
        for symbol in varied {
            let base = self.value(&node(unvaried(&symbol)))?.entries;
            let change = self.value(&node(symbol))?.entries;
            let places: Option<Vec<u32>> = base.iter().map(Fraction::as_variable).collect();
            let Some(places) = places.filter(|places| places.len() == change.len()) else {
                return Ok(None);
            };
            pairs.extend(places.into_iter().zip(change));
        }
        if pairs.is_empty() {
            return Ok(None);
        }
        Ok(Some(value.map(|entry| {
            let parts = pairs.iter();
            let parts = parts.map(|(place, change)| self.partial(entry, *place) * change.clone());
            parts.fold(Fraction::zero(), |sum, part| sum + part)
        })))
    }
}

/// The symbol without its δ.
fn unvaried(symbol: &Symbol) -> Symbol {
    Symbol {
        variation: false,
        ..symbol.clone()
    }
}
