//! Columns of numbered functions: the f of `\partial f/\partial\omega` beside f₁, f₂, f₃.

use crate::notation::ast::{Kind, Node, Operator};
use crate::verify::letters::attitude_matrix::MATRIX_LETTERS;
use crate::verify::letters::usage::{Letter, Usage, inner};

impl Usage {
    /// Notes a letter under a derivative, and the one that it is taken in.
    pub(super) fn derived(&mut self, operand: &Node, variables: &[Node]) {
        if let (Some(of), [by]) = (naked(operand), variables) {
            let by = naked(by).map(|by| (of, by));
            self.differentiated.extend(by);
        }
    }

    /// Notes the letters of `\omega' = R\omega`, with that of the matrix first.
    pub(super) fn turned_column(&mut self, left: &Node, right: &Node) {
        let (Kind::Symbol(turned), Kind::Product(factors)) =
            (&inner(left).kind, &inner(right).kind)
        else {
            return;
        };
        if let [matrix, column] = factors.as_slice()
            && column.operator == Operator::Juxtaposed
            && let (Some(matrix), Some(column)) = (naked(&matrix.node), naked(&column.node))
            && MATRIX_LETTERS.contains(&matrix.name.as_str())
            && Letter::of(turned) == column
        {
            self.turned.push([matrix, column]);
        }
    }

    /// What a matrix that is written out turns is a vector.
    pub(super) fn turned_columns(&mut self) {
        for [matrix, column] in std::mem::take(&mut self.turned) {
            if self.get(&matrix).tensor > 0 && !self.squares.contains_key(&matrix) {
                self.letters.entry(column).or_default().vector += 1;
            }
        }
    }

    /// Notes the letter of a right side that is called with a letter, `f(\omega)`: with an index it is a component.
    pub(super) fn called(&mut self, head: &Node, arguments: &[Node]) {
        let right_side = |of: &Letter| matches!(of.name.as_str(), "f" | "g" | "F");
        let by = arguments.first().and_then(naked);
        let pair = naked(head).filter(right_side).zip(by);
        self.called.extend(pair.filter(|(_, by)| by.name != "t"));
    }

    /// The f of `\partial f/\partial\omega` is a vector where f₁, f₂, f₃ are written, and ω₁ is too.
    pub(super) fn columns_of_functions(&mut self) {
        for (of, by) in std::mem::take(&mut self.differentiated) {
            let numbered = ["1", "2", "3"].iter().all(|i| self.has_index(&of, i));
            let lettered = ["x", "y", "z"].iter().all(|i| self.has_index(&of, i));
            if (numbered || lettered) && self.get(&by).component > 0 {
                self.letters.entry(of).or_default().vector += 1;
            }
        }
        for (of, by) in std::mem::take(&mut self.called) {
            let component = ["1", "2", "3", "x", "y", "z"]
                .iter()
                .any(|i| self.has_index(&of, i));
            if component && self.get(&by).component > 0 {
                self.letters.entry(of).or_default().vector += 1;
            }
        }
    }
}

/// The letter of a symbol that stands without mark and index.
fn naked(node: &Node) -> Option<Letter> {
    match &inner(node).kind {
        Kind::Symbol(symbol) if symbol.subscripts.is_empty() && !symbol.style.vector => {
            Some(Letter::of(symbol))
        }
        _ => None,
    }
}
