//! Slips in the axis: an index, a difference of moments of inertia.

use crate::notation::ast::{Kind, Node, Symbol, Term};
use crate::verify::correction::edit::{other_axis, replaced_index};
use crate::verify::letters::usage::{Letter, axes, axis, symbols};
use crate::verify::repair::slips::Slips;
use crate::verify::values::quantity::Quantity;

impl Slips<'_> {
    /// (I_yy − I_zz) for (I_zz − I_xx): another pair of moments.
    pub(crate) fn difference(&mut self, node: &Node, terms: &[Term]) {
        let [first, second] = terms else { return };
        if !second.negative || first.negative {
            return;
        }
        let inertial = |node: &Node| symbols(node).iter().any(|s| self.moment(s).is_some());
        let plain = matches!(first.node.kind, Kind::Symbol(_));
        if !plain && inertial(&first.node) && inertial(&second.node) {
            let text = format!("{} - {}", self.slice(&second.node), self.slice(&first.node));
            self.push(
                node.span,
                text,
                "inertia-difference",
                12,
                "the difference of moments is the wrong way round",
            );
        }
        let (Kind::Symbol(a), Kind::Symbol(b)) = (&first.node.kind, &second.node.kind) else {
            return;
        };
        let (Some(i), Some(j)) = (self.moment(a), self.moment(b)) else {
            return;
        };
        for (p, q) in [(0, 1), (1, 0), (1, 2), (2, 1), (2, 0), (0, 2)] {
            if (p, q) == (i, j) {
                continue;
            }
            let (Some(left), Some(right)) = (
                self.with_moment(&first.node, a, p),
                self.with_moment(&second.node, b, q),
            ) else {
                continue;
            };
            let text = format!("{left} - {right}");
            self.push(
                node.span,
                text,
                "inertia-difference",
                12,
                "the wrong difference of moments",
            );
        }
    }

    /// The axis of a principal moment.
    pub(crate) fn moment(&self, symbol: &Symbol) -> Option<u8> {
        if let Some(&(Quantity::Inertia, component)) =
            self.reading.components.get(&Letter::of(symbol))
        {
            return Some(component);
        }
        if self.reading.quantities.get(&Letter::of(symbol)) != Some(&Quantity::Inertia) {
            return None;
        }
        let index = symbol.subscripts.first()?;
        axis(index).or_else(|| axes(index).filter(|(r, c)| r == c).map(|(r, _)| r))
    }

    /// The text of a moment about another axis.
    pub(crate) fn with_moment(&self, node: &Node, symbol: &Symbol, to: u8) -> Option<String> {
        let letters = self
            .reading
            .components
            .iter()
            .find(|(_, v)| **v == (Quantity::Inertia, to));
        if let (Some((letter, _)), true) = (
            letters,
            self.reading.components.contains_key(&Letter::of(symbol)),
        ) {
            return Some(letter.name.clone());
        }
        let index = symbol.subscripts.first()?;
        let mut characters: Vec<char> = index.chars().collect();
        for c in &mut characters {
            *c = other_axis(*c, to)?;
        }
        let new: String = characters.into_iter().collect();
        replaced_index(self.slice(node), index, &new)
    }

    /// Another axis for each letter of an index.
    pub(crate) fn index(&mut self, node: &Node, text: &str, index: &str) {
        let characters: Vec<char> = index.chars().collect();
        if characters.len() > 2 || characters.iter().any(|c| axis(&c.to_string()).is_none()) {
            return;
        }
        for (place, c) in characters.iter().enumerate() {
            for to in 0..3 {
                let Some(other) = other_axis(*c, to).filter(|o| o != c) else {
                    continue;
                };
                let mut new = characters.clone();
                new[place] = other;
                let new: String = new.into_iter().collect();
                if let Some(text) = replaced_index(text, index, &new) {
                    let message = format!("the index should be {new}");
                    self.push(node.span, text, "index", 12, message);
                }
            }
        }
    }
}
