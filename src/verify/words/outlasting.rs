//! Premises that hold on when their section ends: no torque, in a document that from there on speaks of none; a law of
//! the torque, where the next section goes on with what stands in it.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Node, Symbol};
use crate::notation::document::{Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::torque_free::speaks_of_a_torque;
use std::collections::BTreeSet;

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
        free && !self.speaks_of_a_moment_from(heading) || self.is_used_under(name, heading)
    }

    /// Whether the formulas under a heading have a symbol that only a premise on the moment speaks of: the k of u = −kω.
    fn is_used_under(&self, name: &str, heading: Span) -> bool {
        let entities = |premise: &Premise| -> BTreeSet<Entity> {
            let variables = premise.residuals.iter().flat_map(Fraction::variables);
            variables
                .filter_map(|v| self.theory.atoms.entity_of(v))
                .collect()
        };
        let owner = |entity: &Entity| &self.theory.atoms.info(*entity).owner;
        let Some(premise) = self.theory.premises().iter().find(|p| p.name == name) else {
            return false;
        };
        let met = entities(premise);
        let moment = |e: &Entity| matches!(owner(e), Owner::Quantity(Quantity::Moment, _));
        let others = self.theory.premises().iter().filter(|p| p.name != name);
        let others: BTreeSet<Entity> = others.flat_map(entities).collect();
        let own = |e: &&Entity| matches!(owner(e), Owner::Symbol(_)) && !others.contains(e);
        let keys: Vec<String> = met
            .iter()
            .filter(own)
            .map(|e| self.theory.atoms.info(*e).latex.clone())
            .collect();
        let behind = self.document.items.iter().skip_while(|item| match item {
            Item::Heading { span, .. } => span.start <= heading.start,
            Item::Formula(formula) => formula.span.start < heading.start,
            Item::Prose { span, .. } => span.start < heading.start,
            _ => true,
        });
        let section = behind.take_while(|item| !matches!(item, Item::Heading { .. }));
        let written = section.flat_map(|item| match item {
            Item::Formula(formula) => formula
                .rows
                .iter()
                .flat_map(nodes)
                .flat_map(symbols)
                .collect(),
            _ => vec![],
        });
        let named = |symbol: &Symbol| symbol.subscripts.is_empty() && keys.contains(&symbol.name);
        met.iter().any(moment) && !keys.is_empty() && written.into_iter().any(named)
    }

    fn speaks_of_a_moment_from(&self, heading: Span) -> bool {
        let moment = |letter: Letter| {
            let part = self.reading.components.get(&letter).map(|(q, _)| q);
            self.reading.quantities.get(&letter).or(part) == Some(&Quantity::Moment)
        };
        self.document.items.iter().any(|item| match item {
            Item::Formula(formula) if formula.span.start > heading.start => {
                let nodes = formula.rows.iter().flat_map(nodes);
                nodes.flat_map(symbols).any(|s| moment(Letter::of(s)))
            }
            Item::Prose { text, span } | Item::Heading { text, span, .. } => {
                span.start >= heading.start && speaks_of_a_torque(text)
            }
            _ => false,
        })
    }
}

fn nodes(row: &Row) -> Vec<&Node> {
    match row {
        Row::Line(line) => line.sides.iter().collect(),
        Row::Expression(node) => vec![node],
        Row::Unreadable { .. } => vec![],
    }
}
