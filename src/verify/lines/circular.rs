//! Definitions in a circle: what a symbol is made of says nothing new of what that was made of.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::Entity;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Whether a line says of a symbol what it is by one that was defined by it: with the period `T = 2π/ω` and
    /// `ω² = mgd/I` before, `I = mgdT²/4π²` is no definition.
    pub(crate) fn runs_in_a_circle(&mut self, left: &Node, rest: &[Node]) -> bool {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let Some(own) = self.entity_named(symbol) else {
            return false;
        };
        let entities = |variables: Vec<Variable>| -> BTreeSet<Entity> {
            let atoms = &self.theory.atoms;
            let inside = variables.into_iter().flat_map(|v| atoms.with_arguments(v));
            inside.filter_map(|v| atoms.entity_of(v)).collect()
        };
        let definitions: Vec<(BTreeSet<Entity>, BTreeSet<Entity>)> = self
            .theory
            .premises()
            .iter()
            .filter(|premise| premise.definition)
            .map(|premise| {
                let all = premise.residuals.iter().flat_map(Fraction::variables);
                (entities(premise.preferred.clone()), entities(all.collect()))
            })
            .collect();
        let mut made_of: BTreeSet<Entity> = self.entities(rest).into_iter().collect();
        loop {
            let before = made_of.len();
            for (defined, all) in &definitions {
                if !defined.contains(&own) && defined.iter().any(|e| made_of.contains(e)) {
                    made_of.extend(all);
                }
            }
            if made_of.len() == before {
                return made_of.contains(&own);
            }
        }
    }
}
