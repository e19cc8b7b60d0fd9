//! Letters that the front matter gives a meaning: `symbols: { h: momentum }`.

use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::Letter;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::phrases::named_first;

impl Reading {
    /// Takes each letter as what the front matter says, before any words are heard.
    pub(crate) fn by_front_matter(&mut self, document: &Document) {
        for (letter, name) in &document.front_matter.symbols {
            let letter = Letter::plain(letter.trim().trim_start_matches('\\'));
            match set(name) {
                Some(quantity) => {
                    self.quantities.insert(letter, quantity);
                }
                None => {
                    let unknown = format!("{}: `{name}` names no quantity here", letter.name);
                    self.not_set.push(unknown);
                }
            }
        }
    }
}

/// The quantity of a name, as reports have it or in other words for it.
fn set(name: &str) -> Option<Quantity> {
    let name = name.trim().to_lowercase();
    let exact = Quantity::NAMED.into_iter().find(|q| q.name() == name);
    exact.or_else(|| named_first(&name, 1))
}
