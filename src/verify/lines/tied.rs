//! What accepted lines tie to the motion.

use crate::algebra::Fraction;
use crate::verify::check::Checker;
use crate::verify::lines::pendulum;
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::quantity::Quantity;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Entities that accepted lines connect with a quantity of the theory, however long the way.
    pub(super) fn tied(&self) -> BTreeSet<Entity> {
        let groups: Vec<BTreeSet<Entity>> = self
            .theory
            .premises()
            .iter()
            .map(|p| p.residuals.iter().flat_map(Fraction::variables))
            .map(|variables| variables.flat_map(|v| self.entities_in(v)).collect())
            .collect();
        let mechanical = |&e: &Entity| matches!(&self.theory.atoms.info(e).owner, Owner::Quantity(q, v) if v.is_empty() && *q != Quantity::Mass);
        let mut tied: BTreeSet<Entity> = groups
            .iter()
            .flatten()
            .copied()
            .filter(mechanical)
            .collect();
        let pairs = self.theory.setting.parallel_axes.iter().flatten();
        tied.extend(pairs.flat_map(|pair| pair.entities(&self.theory.atoms)));
        let laws = self.theory.premises().iter().zip(&groups);
        let of_weight = laws.filter(|(premise, _)| premise.name == pendulum::LAW);
        tied.extend(of_weight.flat_map(|(_, group)| group));
        loop {
            let before = tied.len();
            for group in &groups {
                if group.iter().any(|e| tied.contains(e)) {
                    tied.extend(group);
                }
            }
            if tied.len() == before {
                return tied;
            }
        }
    }
}
