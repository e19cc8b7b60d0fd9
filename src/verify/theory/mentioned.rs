//! What the premises in force speak of.

use crate::algebra::{Fraction, Variable};
use crate::verify::theory::{Premise, Theory};
use crate::verify::values::atoms::{Atom, Atoms, Entity, Owner};
use std::collections::{BTreeMap, BTreeSet};

/// The variables that premises mention, those in the arguments of functions too, and whose parts they are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mentioned {
    variables: BTreeSet<Variable>,
    parts: BTreeSet<(Entity, u8)>,
    /// The places of the premises that mention an entity.
    premises: BTreeMap<Entity, Vec<usize>>,
}

impl Mentioned {
    /// Notes what the premise at a place mentions.
    pub(crate) fn add(&mut self, place: usize, premise: &Premise, atoms: &Atoms) {
        let written = premise.residuals.iter().flat_map(Fraction::variables);
        for variable in written.flat_map(|v| atoms.with_arguments(v)) {
            self.variables.insert(variable);
            if let Atom::Part {
                entity, component, ..
            } = *atoms.atom(variable)
            {
                self.parts.insert((entity, component));
                let places = self.premises.entry(entity).or_default();
                if places.last() != Some(&place) {
                    places.push(place);
                }
            }
        }
    }
}

impl Theory {
    /// The premises that some entities lead to, over the entities of those as well, as far as these are to be followed.
    pub(crate) fn premises_about(
        &self,
        mut open: Vec<Entity>,
        follow: impl Fn(Entity) -> bool,
    ) -> Vec<&Premise> {
        let (mut seen, mut places) = (BTreeSet::new(), BTreeSet::new());
        while let Some(entity) = open.pop() {
            if !follow(entity) || !seen.insert(entity) {
                continue;
            }
            for &place in self.mentioned.premises.get(&entity).into_iter().flatten() {
                let Some(premise) = self.premises.get(place).filter(|_| places.insert(place))
                else {
                    continue;
                };
                let written = premise.residuals.iter().flat_map(Fraction::variables);
                open.extend(written.filter_map(|v| self.atoms.entity_of(v)));
            }
        }
        let found = places
            .into_iter()
            .filter_map(|place| self.premises.get(place));
        found.collect()
    }

    /// Whether a premise mentions a variable.
    pub(crate) fn mentions(&self, variable: Variable) -> bool {
        self.mentioned.variables.contains(&variable)
    }

    /// Whether a premise mentions an entity: a component of it, or a rate.
    pub(crate) fn mentions_entity(&self, entity: Entity) -> bool {
        self.mentions_part(entity, None)
    }

    /// Whether a premise mentions a component of an entity, or any, where none is asked for.
    pub(crate) fn mentions_part(&self, entity: Entity, place: Option<u8>) -> bool {
        let (first, last) = place.map_or((0, u8::MAX), |place| (place, place));
        let parts = (entity, first)..=(entity, last);
        self.mentioned.parts.range(parts).next().is_some()
    }

    /// Whether a premise only names what no other premise speaks of.
    pub(crate) fn only_names(&self, premise: &Premise) -> bool {
        let named = |&variable: &Variable| match *self.atoms.atom(variable) {
            Atom::Part {
                entity, component, ..
            } => match self.atoms.info(entity).owner {
                Owner::Symbol(_) => !self.mentions_part(entity, Some(component)),
                // Laws go from each component of a quantity to the others.
                Owner::Quantity(..) => !self.mentions_entity(entity),
            },
            _ => false,
        };
        premise.definition && !premise.preferred.is_empty() && premise.preferred.iter().all(named)
    }
}
