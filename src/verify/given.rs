//! Lines that hand a value over: the mass, the moments of inertia, how fast the body turns.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::atoms::{Atom, Owner};
use crate::verify::check::Checker;
use crate::verify::line::Read;
use crate::verify::names;
use crate::verify::quantity::{Quantity, Shape};
use crate::verify::symbol::{Meaning, meaning};
use crate::verify::usage::{inner, symbols};
use crate::verify::verdict::{Finding, Role, Verdict};
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Whether a line only hands over a value that nothing determines: the mass, a moment of inertia, the angular
    /// velocity, each by numbers or by symbols that the theory does not know.
    pub(super) fn is_given(&mut self, sides: &[Node]) -> bool {
        let [given @ .., value] = sides else {
            return false;
        };
        let zero = matches!(&value.kind, Kind::Number(n) if num_traits::Zero::is_zero(&n.value));
        if zero && self.asserted && self.displayed {
            return false;
        }
        let free = given.iter().all(|side| self.is_free_input(side));
        let like_it = given.len() == 1 && self.is_free_input(value);
        let foreign = |checker: &mut Self, s: &Symbol| match checker.meaning_of(s) {
            Meaning::Whole(e) | Meaning::Component(e, _) => {
                let owner = checker.theory.atoms.info(e).owner.clone();
                matches!(owner, Owner::Symbol(_) | Owner::Quantity(Quantity::Mass, _))
            }
            _ => true,
        };
        free && (like_it || symbols(value).into_iter().all(|s| foreign(self, s)))
    }

    /// Whether a side is a lone inertia, rate or mass that no law and no line determines.
    fn is_free_input(&mut self, side: &Node) -> bool {
        let Kind::Symbol(symbol) = &inner(side).kind else {
            return false;
        };
        let (entity, components) = match self.meaning_of(symbol) {
            Meaning::Whole(entity) => {
                let count = self.theory.atoms.info(entity).shape.components();
                (entity, 0..count)
            }
            Meaning::Component(entity, component) => (entity, component..component + 1),
            _ => return false,
        };
        let owner = self.theory.atoms.info(entity).owner.clone();
        let input = matches!(
            owner,
            Owner::Quantity(
                Quantity::Inertia
                    | Quantity::AngularVelocity
                    | Quantity::FrameRate
                    | Quantity::Mass,
                _
            )
        );
        input
            && components.into_iter().all(|component| {
                let variable = self.theory.atoms.part(entity, component, 0);
                self.theory.rule(variable).is_none()
            })
    }

    /// Takes a line in that hands a value over; where its sentence derives it, it is not checked, and that is said.
    pub(super) fn given(&mut self, sides: &[Node], finding: &mut Finding) {
        self.accept(sides, Role::Given, finding);
        if finding.verdict != Verdict::Accepted {
            return;
        }
        if self.asserted {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some("taken as given below: nothing here determines it".to_owned());
        } else {
            finding.role = Role::Given;
            finding.remarks.push("taken as given".to_owned());
        }
    }

    pub(super) fn meaning_of(&mut self, symbol: &Symbol) -> Meaning {
        meaning(symbol, &self.reading, &mut self.theory.atoms)
    }

    /// A number or matrix of the document alone that stands beside quantities of the theory in what differs, and that
    /// no accepted line connects with them: with another value of it the sides might be equal.
    pub(super) fn untied(&mut self, read: &Read) -> Option<String> {
        let mut loose = None;
        let mut mechanical = false;
        let tied: BTreeSet<u32> = self
            .theory
            .premises()
            .iter()
            .flat_map(|p| p.residuals.iter().flat_map(Fraction::variables))
            .filter_map(|v| self.entity_of(v))
            .collect();
        let entries: Vec<Fraction> = read
            .equations
            .iter()
            .flat_map(|e| e.residual.entries.clone())
            .collect();
        for entry in &entries {
            for variable in self.theory.normal(entry).variables() {
                for variable in self.with_arguments(variable) {
                    let Atom::Part { entity, .. } = *self.theory.atoms.atom(variable) else {
                        continue;
                    };
                    let info = self.theory.atoms.info(entity);
                    match &info.owner {
                        Owner::Quantity(_, variant) if variant.is_empty() => mechanical = true,
                        _ if info.shape != Shape::Vector && !tied.contains(&entity.0) => {
                            loose = Some(names::latex(&self.theory.atoms, variable));
                        }
                        _ => {}
                    }
                }
            }
        }
        loose.filter(|_| mechanical)
    }

    fn entity_of(&self, variable: u32) -> Option<u32> {
        match self.theory.atoms.atom(variable) {
            Atom::Part { entity, .. } => Some(entity.0),
            _ => None,
        }
    }

    /// A variable, or the variables of the argument of a kernel.
    fn with_arguments(&self, variable: u32) -> Vec<u32> {
        match self.theory.atoms.atom(variable) {
            Atom::Kernel { argument, .. } => argument
                .variables()
                .into_iter()
                .flat_map(|v| self.with_arguments(v))
                .collect(),
            _ => vec![variable],
        }
    }
}
