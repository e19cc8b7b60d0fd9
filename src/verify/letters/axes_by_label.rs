//! Letters that the document writes on both triads of axes, and tells apart by a label alone: `I_w = R I_b R^T`.

use crate::notation::document::{Document, Item};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::values::quantity::{Quantity, Shape};
use std::collections::BTreeSet;

/// Labels of axes of fixed orientation, with a word that they are short for.
const SPACE: &[(&str, &[&str])] = &[
    ("w", &["world"]),
    ("W", &["world"]),
    ("s", &["space", "spatial"]),
    ("S", &["space", "spatial"]),
    ("n", &["inertial", "newton", "navigation"]),
    ("N", &["inertial", "newton", "navigation"]),
    ("i", &["inertial"]),
    ("e", &["earth"]),
    ("world", &["world"]),
    ("space", &["space"]),
];
const BODY: &[&str] = &["b", "B", "body"];

impl Reading {
    /// Notes the letters of vectors and tensors that stand on both triads of axes.
    pub(crate) fn by_labels(&mut self, document: &Document) {
        if !self.attitude.is_spoken_of() {
            return;
        }
        let said = |word: &str| {
            document.items.iter().any(|item| match item {
                Item::Prose { text, .. } | Item::Heading { text, .. } => {
                    text.to_lowercase().contains(word)
                }
                _ => false,
            })
        };
        let labels = SPACE
            .iter()
            .filter(|(_, words)| words.iter().any(|word| said(word)));
        let labels: Vec<&str> = labels.map(|(label, _)| *label).collect();
        let turns =
            |quantity: &Quantity| matches!(quantity.shape(), Shape::Vector | Shape::Symmetric);
        let both = |letter: &&Letter| {
            let met = self.usage.subscripts.get(letter);
            let has =
                |labels: &[&str]| met.is_some_and(|all| labels.iter().any(|l| all.contains(*l)));
            has(&labels) && has(BODY)
        };
        let turning = self
            .quantities
            .iter()
            .filter(|(_, quantity)| turns(quantity));
        let turning: Vec<&Letter> = turning.map(|(letter, _)| letter).collect();
        let found: BTreeSet<Letter> = turning.iter().copied().filter(both).cloned().collect();
        // Beside ω_s and ω_b, a τ_s that never stands bare wears the same label.
        let one = |letter: &&Letter| {
            let met = self.usage.subscripts.get(letter).into_iter().flatten();
            let label = |l: &String| labels.contains(&l.as_str()) || BODY.contains(&l.as_str());
            let mut all = document
                .lines()
                .flat_map(|line| &line.sides)
                .flat_map(symbols);
            let bare = all.any(|s| s.subscripts.is_empty() && Letter::of(s) == **letter);
            !found.is_empty() && !bare && met.clone().next().is_some() && met.clone().all(label)
        };
        let others = turning.into_iter().filter(|l| one(l)).cloned();
        self.on_both_axes = others.chain(found.iter().cloned()).collect();
    }
}
