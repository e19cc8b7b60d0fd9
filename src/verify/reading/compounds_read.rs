//! Formulas of several letters that sentences say to be quantities: "`$2m$` is the mass of the hub".

use crate::notation::ast::{Factor, Kind, Node};
use crate::notation::document::Row;
use crate::notation::print::latex;
use crate::verify::language::statement::{Declaration, Formula, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::node_of;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

impl Builder<'_> {
    /// Whether a formula is worked out from what its letters are, and names nothing.
    pub(super) fn is_worked_out(&self, formula: &Formula, declaration: &Declaration) -> bool {
        let Some(node) = node_of(formula) else {
            return false;
        };
        let number = |f: &Factor| matches!(f.node.kind, Kind::Number(_));
        match &node.kind {
            Kind::Negate(_) | Kind::Sum(_) | Kind::Quotient(..) => true,
            Kind::Product(factors) if factors.iter().any(number) => true,
            _ => !self.names_of_axes(node, declaration).is_empty(),
        }
    }

    /// The value of a formula is that of a quantity.
    pub(super) fn hold_formula_is(
        &mut self,
        formula: &Formula,
        quantity: &Quantity,
        declaration: &Declaration,
    ) {
        let known = self.system().value_of(quantity).ok();
        let value = match quantity {
            Quantity::Position { .. } => self.place_value(formula, declaration),
            _ => self.formula_value(formula, declaration),
        };
        match value.zip(known) {
            Some((value, known)) => self.hold_equal(&value, &known, declaration),
            None => self.say_unused(declaration),
        }
    }

    /// The place that a formula tells: its letters of which nothing is said, and of which no rate is written, are constant.
    pub(super) fn place_value(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Value> {
        let node = node_of(formula)?.clone();
        for letter in symbols_in(&node) {
            if !self.is_told(&letter, declaration)
                && !self.has_rate(&Term::Formula(letter.clone()))
                && let Some(size) = self.scalar(&letter, declaration)
            {
                self.make_constant(&size);
            }
        }
        self.formula_value(formula, declaration)
    }
}

/// The letters of a formula, each as a formula.
fn symbols_in(node: &Node) -> Vec<Formula> {
    match &node.kind {
        Kind::Symbol(_) => vec![Formula {
            source: latex(node),
            row: Row::Expression(node.clone()),
        }],
        _ => node.children().flat_map(symbols_in).collect(),
    }
}
