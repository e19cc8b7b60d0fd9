//! A motion that a section sets up and that the next ones go on with: "the shaft turns at the constant rate ⟨Ω⟩", and
//! under the headings behind it nothing moves in another way.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Formula, Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{inner, symbols};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::outlasting::{items_from, nodes};
use std::collections::BTreeSet;

/// Quantities that say how something turns.
const TURNS: &[Quantity] = &[
    Quantity::AngularVelocity,
    Quantity::FrameRate,
    Quantity::RelativeMomentum,
];

impl Checker<'_> {
    /// Whether a premise says how the body turns by symbols of the document, or that such a symbol is constant, and the
    /// formulas from a heading on have these symbols; those of its section set no rate anew and have no rate of one.
    pub(crate) fn motion_goes_on(&mut self, name: &str, heading: Span) -> bool {
        let mut premises = self.theory.premises().iter();
        let Some(premise) = premises.find(|p| p.name == name) else {
            return false;
        };
        let Some(own) = self.turns_by(premise) else {
            return false;
        };
        let rates = [Quantity::AngularVelocity, Quantity::FrameRate];
        let rates = rates.map(|quantity| self.theory.atoms.quantity(quantity));
        let momentum = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let document = self.document;
        let (mut used, mut headings) = (false, 0);
        for item in items_from(document, heading) {
            headings += usize::from(matches!(item, Item::Heading { .. }));
            let Item::Formula(formula) = item else {
                continue;
            };
            for side in formula.rows.iter().flat_map(nodes) {
                let met = self.entities_of(symbols(side));
                used |= met.iter().any(|entity| own.contains(entity));
                if headings > 1 {
                    continue;
                }
                let rated = self.entities_of(under_dots(side));
                if rated.iter().any(|e| own.contains(e) || rates.contains(e)) {
                    return false;
                }
            }
            // A bare Ω is the length of the vector, or the number in it.
            let mut set = set_by(formula);
            set.retain(|s| s.style.vector || matches!(self.meaning_of(s), Meaning::Component(..)));
            let set = self.entities_of(set);
            let anew = |e: &Entity| rates.contains(e) || *e == momentum;
            if headings == 1 && set.iter().any(anew) {
                return false;
            }
        }
        used
    }

    /// The symbols of the document by which a display says how the body turns, or the one that words call constant.
    fn turns_by(&self, premise: &Premise) -> Option<BTreeSet<Entity>> {
        let atoms = &self.theory.atoms;
        let owner = |entity: Entity| &atoms.info(entity).owner;
        let parts = premise.residuals.iter().flat_map(Fraction::variables);
        let parts = parts.flat_map(|v| atoms.with_arguments(v));
        let mut own = BTreeSet::new();
        let (mut turns, mut rests) = (false, true);
        for variable in parts {
            let Atom::Part { entity, order, .. } = *atoms.atom(variable) else {
                continue;
            };
            rests &= order == 1;
            match owner(entity) {
                Owner::Symbol(_) => {
                    own.insert(entity);
                }
                Owner::Quantity(quantity, variant) if variant.is_empty() => {
                    turns |= order == 0 && TURNS.contains(quantity);
                    rests = false;
                    if !TURNS.contains(quantity) && *quantity != Quantity::Mass {
                        return None;
                    }
                }
                // The ω_s of a wheel, the speed v.
                Owner::Quantity(..) => {
                    own.insert(entity);
                }
            }
        }
        let given = turns && self.cases.is_set_up(&premise.name);
        let constant = rests && premise.residuals.len() == 1 && own.len() == 1;
        (!own.is_empty() && (given || constant)).then_some(own)
    }

    fn entities_of(&mut self, symbols: Vec<&Symbol>) -> BTreeSet<Entity> {
        let named = symbols.into_iter().map(|symbol| self.meaning_of(symbol));
        let entity = |meaning| match meaning {
            Meaning::Whole(entity) | Meaning::Component(entity, _) => Some(entity),
            _ => None,
        };
        named.filter_map(entity).collect()
    }
}

/// Symbols that stand under a derivative in time.
fn under_dots(node: &Node) -> Vec<&Symbol> {
    match &node.kind {
        Kind::TimeDerivative { operand, .. } => symbols(operand),
        _ => node.children().flat_map(under_dots).collect(),
    }
}

/// Symbols that stand alone before the sign of a line.
fn set_by(formula: &Formula) -> Vec<&Symbol> {
    let lone = |side: &&Node| matches!(inner(side).kind, Kind::Symbol(_));
    let first = formula.rows.iter().filter_map(|row| match row {
        Row::Line(line) => line.sides.first(),
        _ => None,
    });
    first.filter(|side| lone(side)).flat_map(symbols).collect()
}
