//! Letters in formulas of sentences that name axes.

use crate::notation::ast::{Kind, Node, Style};
use crate::notation::document::Row;
use crate::verify::language::statement::{Declaration, Formula};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::term::letters::spelled;

impl Builder<'_> {
    /// The letters of a formula that only name axes, with the unit vectors along these.
    pub(super) fn names_of_axes(
        &self,
        node: &Node,
        declaration: &Declaration,
    ) -> Vec<(Formula, (FrameId, usize))> {
        let mut found = self.plain_names_of_axes(node, declaration);
        // "`$x\\hat x$`": of a letter and its unit vector only the one with the mark is the axis.
        found.retain(|(letter, _)| !has_marked(node, &letter.source));
        found
    }

    fn plain_names_of_axes(
        &self,
        node: &Node,
        declaration: &Declaration,
    ) -> Vec<(Formula, (FrameId, usize))> {
        let mut found = vec![];
        for child in node.children() {
            let letter = match &child.kind {
                Kind::Symbol(symbol) if symbol.style == Style::default() => {
                    match symbol.subscripts.is_empty() {
                        true => Formula {
                            source: symbol.name.clone(),
                            row: Row::Expression(child.clone()),
                        },
                        false => Formula::of(child),
                    }
                }
                _ => {
                    found.extend(self.plain_names_of_axes(child, declaration));
                    continue;
                }
            };
            // "a1", as words write `a_1`
            let axis = match spelled(child) {
                plain if plain == letter.source => self.axes.get(&plain),
                labelled => self.axes.get(&labelled.replace('_', "")),
            };
            if let Some(&axis) = axis
                && self.quantity_of(&letter, declaration).is_none()
            {
                found.push((letter, axis));
            }
        }
        found
    }
}

/// Whether a letter stands in a formula with a mark.
fn has_marked(node: &Node, name: &str) -> bool {
    let own = match &node.kind {
        Kind::Symbol(symbol) => symbol.name == name && symbol.style != Style::default(),
        _ => false,
    };
    own || node.children().any(|child| has_marked(child, name))
}
