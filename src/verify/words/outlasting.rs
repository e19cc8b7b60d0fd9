//! Premises that hold on when their section ends: no torque, in a document that from there on speaks of none; a law of
//! the torque, where the next section goes on with what stands in it.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Node, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::torque_free::{speaks_of_a_torque, torque_free};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Words that leave the shape of the body behind.
const OTHER_BODIES: &[&str] = &[
    "general body",
    "any body",
    "arbitrary body",
    "arbitrary rigid body",
    "general rigid body",
    "any rigid body",
    "another body",
    "general shape",
    "arbitrary shape",
    "asymmetric",
    "unsymmetric",
    "no symmetry",
    "without symmetry",
    "not symmetric",
    "no longer symmetric",
    "no plane of symmetry",
    "without a plane of symmetry",
    "without any symmetry",
    "products of inertia",
    "now a ",
    "consider a ",
    "in general",
];

impl Checker<'_> {
    /// Whether a premise that no moment acts holds on under the next heading: nothing speaks of a moment from there on.
    pub(crate) fn outlasts(&mut self, name: &str, heading: Span) -> bool {
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
            || self.is_used_under(name, heading)
            || self.shapes_the_body(name, heading)
            || self.goes_on_in_orbit(name, heading)
            || self.motion_goes_on(name, heading)
    }

    /// Whether a premise that products of inertia vanish holds on under the next heading: formulas from there on have one
    /// of the others, never one of these, and no word turns to another body.
    fn shapes_the_body(&mut self, name: &str, heading: Span) -> bool {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let product = |variable: &Variable| match *self.theory.atoms.atom(*variable) {
            Atom::Part {
                entity,
                component,
                order: 0,
            } if entity == inertia => Some(component).filter(|component| *component >= 3),
            _ => None,
        };
        let mut premises = self.theory.premises().iter();
        let Some(premise) = premises.find(|p| p.name == name) else {
            return false;
        };
        let told = premise.residuals.iter().filter(|entry| !entry.is_zero());
        let alone = told.map(|entry| {
            entry
                .as_variable()
                .or_else(|| (-entry.clone()).as_variable())
        });
        let vanishing: Option<BTreeSet<u8>> = alone
            .map(|alone| alone.as_ref().and_then(product))
            .collect();
        let Some(vanishing) = vanishing.filter(|all| !all.is_empty()) else {
            return false;
        };
        let document = self.document;
        let mut met = BTreeSet::new();
        for item in items_from(document, heading) {
            match item {
                Item::Formula(formula) => {
                    for symbol in formula.rows.iter().flat_map(nodes).flat_map(symbols) {
                        if let Meaning::Component(entity, component) = self.meaning_of(symbol)
                            && entity == inertia
                            && component >= 3
                        {
                            met.insert(component);
                        }
                    }
                }
                Item::Prose { text, .. } | Item::Heading { text, .. }
                    if has_any(&lowered(text), OTHER_BODIES) =>
                {
                    return false;
                }
                _ => {}
            }
        }
        !met.is_empty() && met.is_disjoint(&vanishing)
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
        // An energy that is defined by it is no other law.
        let others = self
            .theory
            .premises()
            .iter()
            .filter(|p| p.name != name && !p.definition);
        let others: BTreeSet<Entity> = others.flat_map(entities).collect();
        let own = |e: &&Entity| matches!(owner(e), Owner::Symbol(_)) && !others.contains(e);
        let keys: Vec<String> = met
            .iter()
            .filter(own)
            .map(|e| self.theory.atoms.info(*e).latex.clone())
            .collect();
        let behind = items_from(self.document, heading).skip(1);
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

    /// Whether words from a heading on say that no moment acts.
    pub(crate) fn is_freed_from(&self, heading: Span) -> bool {
        items_from(self.document, heading).any(|item| match item {
            Item::Prose { text, .. } | Item::Heading { text, .. } => torque_free(&lowered(text)),
            _ => false,
        })
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

/// What stands in a document from a heading on.
pub(crate) fn items_from(document: &Document, heading: Span) -> impl Iterator<Item = &Item> {
    document.items.iter().skip_while(move |item| match item {
        Item::Heading { span, .. } => span.start < heading.start,
        Item::Formula(formula) => formula.span.start < heading.start,
        Item::Prose { span, .. } => span.start < heading.start,
        _ => true,
    })
}

pub(crate) fn nodes(row: &Row) -> Vec<&Node> {
    match row {
        Row::Line(line) => line.sides.iter().collect(),
        Row::Expression(node) => vec![node],
        Row::Unreadable { .. } => vec![],
    }
}
