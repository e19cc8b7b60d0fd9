//! Premises that hold on when their section ends: no torque, in a document that from there on speaks of none.

use crate::algebra::{Fraction, Variable};
use crate::notation::document::{Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::torque_free::speaks_of_a_torque;

impl Checker<'_> {
    /// Whether a premise that no moment acts holds on under the next heading: nothing speaks of a moment from there on.
    pub(crate) fn outlasts(&self, name: &str, heading: Span) -> bool {
        let of_moment = |variable: Variable| {
            let owner = self.theory.atoms.owner(variable);
            matches!(owner, Some(Owner::Quantity(Quantity::Moment, _)))
        };
        let mut premises = self.theory.premises().iter();
        let free = premises.find(|p| p.name == name).is_some_and(|premise| {
            let mut variables = premise.residuals.iter().flat_map(Fraction::variables);
            variables.all(of_moment)
        });
        free && !self.speaks_of_a_moment_from(heading)
    }

    fn speaks_of_a_moment_from(&self, heading: Span) -> bool {
        let moment = |letter: Letter| {
            let part = self.reading.components.get(&letter).map(|(q, _)| q);
            self.reading.quantities.get(&letter).or(part) == Some(&Quantity::Moment)
        };
        self.document.items.iter().any(|item| match item {
            Item::Formula(formula) if formula.span.start > heading.start => {
                let nodes = formula.rows.iter().flat_map(|row| match row {
                    Row::Line(line) => line.sides.iter().collect(),
                    Row::Expression(node) => vec![node],
                    Row::Unreadable { .. } => vec![],
                });
                nodes.flat_map(symbols).any(|s| moment(Letter::of(s)))
            }
            Item::Prose { text, span } | Item::Heading { text, span, .. } => {
                span.start >= heading.start && speaks_of_a_torque(text)
            }
            _ => false,
        })
    }
}
