//! Factors whose order counts, written the other way round, and matrices that are to be transposed.

use crate::notation::ast::{Factor, Kind, Node, Operator};
use crate::verify::correction::edit::Edit;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner, undotted};
use crate::verify::repair::slips::Slips;
use crate::verify::values::quantity::{Quantity, Shape};

impl Slips<'_> {
    pub(crate) fn swapped(&mut self, factors: &[Factor]) {
        for pair in factors.windows(2) {
            let [first, second] = [&pair[0].node, &pair[1].node];
            let counts = [first, second].map(|node| is_matrix(self.reading, node));
            let (kind, message) = match pair[1].operator {
                Operator::Cross => ("cross-order", "the factors of × are swapped"),
                Operator::Tensor => ("factor-order", "the factors are swapped"),
                Operator::Juxtaposed if counts == [true; 2] => {
                    ("factor-order", "the factors are swapped")
                }
                _ => continue,
            };
            let [a, b] = [first, second].map(|node| self.source.slice(node.span));
            let sign = self.source.slice(pair[1].sign).trim();
            let text = match sign {
                "" => format!("{b} {a}"),
                _ => format!("{b} {sign} {a}"),
            };
            self.push(first.span.to(second.span), text, kind, 11, message);
        }
    }

    /// `I (a × b)` for `a × (I b)`, as if the tensor were a number. It is read as a call of I.
    pub(crate) fn tensor_put_first(&mut self, node: &Node, tensor: &Node, group: &Node) {
        let (Kind::Symbol(symbol), Kind::Product(inside)) = (&tensor.kind, &inner(group).kind)
        else {
            return;
        };
        let quantity = self.reading.quantities.get(&Letter::of(symbol));
        let [a, b] = inside.as_slice() else { return };
        let vectors = matches!(b.operator, Operator::Cross | Operator::Dot);
        if quantity != Some(&Quantity::Inertia) || !symbol.subscripts.is_empty() || !vectors {
            return;
        }
        let [tensor, a, sign, b] = [tensor.span, a.node.span, b.sign, b.node.span]
            .map(|span| self.source.slice(span).trim());
        let message = "the inertia is a tensor: it goes with its vector";
        for text in [
            format!("{a} {sign} ({tensor} {b})"),
            format!("({tensor} {a}) {sign} {b}"),
        ] {
            self.push(node.span, text, "scalar-inertia", 9, message);
        }
    }

    /// A transpose that a matrix lacks. The inertia is its own.
    pub(crate) fn transposes(&mut self, node: &Node) {
        if let Kind::Transpose(inside) = &node.kind {
            let twice = |edit: &Edit| edit.kind == "transpose" && edit.span == inside.span;
            self.edits.retain(|edit| !twice(edit));
            return;
        }
        let letter = match &undotted(node).kind {
            Kind::Symbol(symbol) => Letter::of(symbol),
            _ => return,
        };
        let inertia = self.reading.quantities.get(&letter) == Some(&Quantity::Inertia);
        if inertia {
            return self.inverts(node);
        }
        if !is_matrix(self.reading, node) {
            return;
        }
        let text = self.source.slice(node.span);
        let text = match text.trim_start().starts_with("\\frac") {
            true => format!("\\left({text}\\right)^T"),
            false => format!("{text}^T"),
        };
        self.push(node.span, text, "transpose", 16, "a transpose is missing");
    }

    /// The inverse of the inertia for the inertia.
    fn inverts(&mut self, node: &Node) {
        let whole = matches!(&node.kind, Kind::Symbol(symbol) if symbol.subscripts.is_empty());
        if whole {
            let text = format!("{}^{{-1}}", self.source.slice(node.span));
            self.push(node.span, text, "inverse", 17, "an inverse is missing");
        }
    }
}

/// Whether a factor is a matrix to see, or a symbol for one.
fn is_matrix(reading: &Reading, node: &Node) -> bool {
    match &inner(node).kind {
        Kind::Matrix(_) | Kind::Transpose(_) | Kind::Skew(_) => true,
        Kind::Symbol(symbol) => {
            let quantity = reading.quantities.get(&Letter::of(symbol));
            quantity.is_some_and(|q| !matches!(q.shape(), Shape::Scalar | Shape::Vector))
        }
        Kind::TimeDerivative { operand, .. } => is_matrix(reading, operand),
        _ => false,
    }
}
