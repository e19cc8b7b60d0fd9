//! The point that a document takes moments about, where it has a letter of its own: "the angular momentum about ⟨A⟩".

use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes, axis};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::subscript::POINTS;
use crate::verify::words::text::Text;
use std::collections::BTreeSet;

/// What stands before the letter of such a point.
const ABOUT: &[&str] = &[
    "about",
    "about point",
    "about the point",
    "about the bearing",
];

impl Reading {
    /// Finds the point by its label on momenta and moments, where that is the only one and the words take them about it.
    pub(crate) fn note_own_point(&mut self, text: &Text) {
        let directed = |q: &Quantity| matches!(q, Quantity::Momentum | Quantity::Moment);
        let letters = self.quantities.iter().filter(|(_, q)| directed(q));
        let labels = letters.filter_map(|(letter, _)| self.usage.subscripts.get(letter));
        let point = |label: &&String| axis(label).is_none() && axes(label).is_none();
        let labels: BTreeSet<&String> = labels.flatten().filter(point).collect();
        let mut labels = labels.into_iter();
        let (Some(label), None) = (labels.next(), labels.next()) else {
            return;
        };
        let mut signs = label.chars();
        let capital = signs.next().is_some_and(char::is_uppercase) && signs.next().is_none();
        let used = self.quantities.contains_key(&Letter::plain(label));
        if !capital || used || POINTS.contains(&label.as_str()) {
            return;
        }
        let mark = format!("⟨{label}⟩");
        let named = text.sentences().iter().any(|sentence| {
            let text = sentence.named();
            text.match_indices(&mark).any(|(at, _)| {
                ABOUT
                    .iter()
                    .any(|words| text[..at].trim_end().ends_with(words))
            })
        });
        self.own_point = named.then(|| label.clone());
    }
}
