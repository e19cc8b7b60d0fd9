//! When premises are solved: definitions first, then conditions without rates, then the rest.

use crate::algebra::{Fraction, Variable};
use crate::verify::theory::{Premise, Theory};
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;

/// Sorts premises by when they are solved.
pub(crate) type Turn = (bool, bool, u8);

impl Theory {
    /// When a premise is solved: those of one instant last, definitions and the form of the inertia first, rates after
    /// values.
    pub(crate) fn turn(&self, premise: &Premise) -> Turn {
        let momentary = self.instants.contains_key(&premise.name);
        let mut residuals = premise.residuals.iter();
        let mean = residuals.all(|r| self.is_mean(r.numerator()));
        let later = !premise.definition && !mean && !self.is_of_products(premise);
        (momentary, later, self.highest_order(premise))
    }

    /// Whether all that a premise says is that products of inertia vanish, which makes what others say shorter.
    fn is_of_products(&self, premise: &Premise) -> bool {
        let inertia = Owner::Quantity(Quantity::Inertia, String::new());
        let product = |residual: &Fraction| {
            let entity = residual.as_variable().and_then(|v| self.atoms.entity_of(v));
            entity.is_some_and(|entity| self.atoms.info(entity).owner == inertia)
        };
        premise.residuals.iter().all(product)
    }

    /// Whether a premise that is added can be solved behind all others, so that their solutions stand.
    pub(crate) fn comes_last(&mut self, premise: &Premise) -> bool {
        let turn = Some(self.turn(premise));
        let in_turn = self.solution.relations.kept.is_empty() && turn >= self.last_turn;
        self.last_turn = self.last_turn.max(turn);
        self.left_out.is_empty() && (in_turn || self.only_names(premise))
    }

    /// The highest order of a rate in a premise; the moment counts as a rate, as it stands for one.
    fn highest_order(&self, premise: &Premise) -> u8 {
        let alone: Vec<Variable> = premise
            .residuals
            .iter()
            .filter_map(Fraction::as_variable)
            .collect();
        // Of \dot\theta = \ddot\theta = 0 the second says nothing new.
        let follows = |r: &&Fraction| {
            let own = r.as_variable();
            own.is_some_and(|v| alone.iter().any(|&lower| self.is_rate_of(v, lower)))
        };
        let residuals = premise.residuals.iter().filter(|r| !follows(r));
        let variables = residuals.flat_map(|r| r.numerator().variables());
        let order = |variable| match self.atoms.atom(variable) {
            Atom::Part { entity, order, .. } => match self.atoms.info(*entity).owner {
                Owner::Quantity(Quantity::Moment, _) => 1,
                _ => *order,
            },
            Atom::SpaceRate { .. } => 1,
            Atom::Kernel { .. } | Atom::Opaque { .. } => 0,
        };
        let found = self.of_rates.get(&premise.name).copied();
        variables.map(order).chain(found).max().unwrap_or(0)
    }

    /// Whether a variable is a higher rate of what another one is, or is a rate of.
    fn is_rate_of(&self, variable: Variable, lower: Variable) -> bool {
        let part = |v: Variable| match *self.atoms.atom(v) {
            Atom::Part {
                entity,
                component,
                order,
            } => Some((entity, component, order)),
            _ => None,
        };
        part(variable)
            .zip(part(lower))
            .is_some_and(|(high, low)| (high.0, high.1) == (low.0, low.1) && high.2 > low.2)
    }
}
