//! Vectors that a sentence says to be perpendicular by the product that is zero.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Operator};
use crate::notation::document::Row;
use crate::verify::language::statement::{Declaration, Extent, Formula, Statement, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, node_of};
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

impl Builder<'_> {
    /// The angle between vectors that are said to be perpendicular.
    pub(super) fn denote_right_angle(
        &mut self,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<()> {
        let right = self.system().atoms.pi() * Fraction::from_ratio(1, 2);
        let right = Quantity::Known(Value::scalar(right));
        self.denote(letter, Meaning::Quantity(right), declaration);
        Some(())
    }

    /// "`$g\cdot h=0$`": whether a sentence says that the product of two vectors by their letters is zero.
    pub(super) fn are_told_perpendicular(&self, ends: &[Term]) -> bool {
        let ends: Option<Vec<String>> = ends
            .iter()
            .map(|end| Some(spelled(node_of(letter_of(end)?)?)))
            .collect();
        let zero =
            |node: &Node| matches!(&node.kind, Kind::Number(number) if number.value.is_zero());
        let product = |node: &Node| match &node.kind {
            Kind::Product(factors) => {
                let dotted = factors.iter().skip(1).all(|f| f.operator == Operator::Dot);
                let mut own: Vec<String> = factors.iter().map(|f| spelled(&f.node)).collect();
                own.sort();
                Some(own).filter(|_| dotted)
            }
            _ => None,
        };
        let ends = ends.map(|mut ends| {
            ends.sort();
            ends
        });
        ends.is_some()
            && self.declarations.iter().any(|d| {
                let Statement::Holds(Formula {
                    row: Row::Line(line),
                    ..
                }) = &d.statement
                else {
                    return false;
                };
                let whole = d.extent == Extent::Document;
                match line.sides.as_slice() {
                    [left, right] => whole && zero(right) && product(left) == ends,
                    _ => false,
                }
            })
    }
}
