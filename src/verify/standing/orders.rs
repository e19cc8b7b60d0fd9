//! Inequalities: what they say of the numbers in which lines are tried, and whether one may be assumed.

use crate::algebra::Fraction;
use crate::notation::ast::Relation;
use crate::verify::facts::world::World;
use crate::verify::language::messages;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::Standing;
use std::collections::BTreeSet;

impl Judge<'_> {
    /// "I_3 > I_1": a narrower motion, if there is one. Whether it follows is not decided.
    pub(super) fn hold_order(&mut self, link: &Link<'_>, relation: Relation) -> Held {
        let mut held = Held::open(messages::OPEN_RELATION);
        let upward = match relation {
            Relation::Less | Relation::LessOrEqual => true,
            Relation::Greater | Relation::GreaterOrEqual => false,
            _ => return held,
        };
        let Ok(sides) = self.sides(link, &BTreeSet::new()) else {
            return held;
        };
        let [(left, right)] = &*sides.sides else {
            return held;
        };
        let difference = match upward {
            true => right.clone() - left.clone(),
            false => left.clone() - right.clone(),
        };
        let mut orders = self.orders();
        let atoms = &mut self.reading.system.atoms;
        let Ok(difference) = self.facts.normal(atoms, &difference) else {
            return held;
        };
        orders.push(difference.clone());
        if World::refuting(&self.facts, atoms, &[difference], &orders).is_some() {
            held.standing = Standing::Free;
        }
        held
    }

    /// What inequalities say at this place, in free variables.
    pub(super) fn orders(&mut self) -> Vec<Fraction> {
        let own = self.reading.sizes.orders.iter();
        let own: Vec<Fraction> = own
            .filter(|(reach, _)| reach.covers(&self.at, 0))
            .map(|(_, order)| order.clone())
            .collect();
        let atoms = &mut self.reading.system.atoms;
        own.iter()
            .filter_map(|order| self.facts.normal(atoms, order).ok())
            .collect()
    }
}
