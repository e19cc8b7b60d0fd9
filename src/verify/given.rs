//! Lines that hand a value over: the mass, the moments of inertia, how fast the body turns.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::atoms::{Atom, Entity, Owner};
use crate::verify::check::Checker;
use crate::verify::decide::passes_filter;
use crate::verify::line::Read;
use crate::verify::names;
use crate::verify::quantity::{Quantity, Shape};
use crate::verify::symbol::{Meaning, meaning};
use crate::verify::usage::{Letter, inner, symbols};
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Quantities that a problem hands over.
const INPUTS: &[Quantity] = &[
    Quantity::Inertia,
    Quantity::AngularVelocity,
    Quantity::FrameRate,
    Quantity::RelativeMomentum,
    Quantity::Position,
    Quantity::Mass,
];

impl Checker<'_> {
    /// Whether a line only hands over what nothing determines: the mass, a moment of inertia, the angular velocity, by
    /// numbers or by symbols that the theory does not know; or the form of the inertia matrix.
    pub(super) fn is_given(&mut self, sides: &[Node], read: &Read) -> bool {
        let [first, .., last] = sides else {
            return false;
        };
        if self.theory.setting.gyrostat && self.only_wheels(read) {
            return true;
        }
        let zero = matches!(&last.kind, Kind::Number(n) if n.value.is_zero());
        if (zero && self.asserted && self.displayed) || !self.is_free_input(first) {
            return false;
        }
        if sides.len() == 2 && (self.is_free_input(last) || self.is_form_of_inertia(read)) {
            return true;
        }
        (0..read.equations.len()).all(|i| {
            let [left, right] = [&sides[i], &sides[i + 1]].map(|side| self.hands_over(side));
            let holds = passes_filter(&mut self.theory, &read.equations[i].residual) == Some(true);
            holds
                || (left.is_some()
                    && right.is_some()
                    && (left, right) != (Some(false), Some(false)))
                || (self.is_free_input(&sides[i]) && self.is_free_input(&sides[i + 1]))
        })
    }

    /// Whether a side has a symbol that the theory does not know, or is a number; `None` where a quantity stands in it
    /// that is no input.
    fn hands_over(&mut self, side: &Node) -> Option<bool> {
        let symbols = symbols(side);
        let mut foreign = symbols.is_empty();
        for symbol in symbols {
            let (Meaning::Whole(entity) | Meaning::Component(entity, _)) = self.meaning_of(symbol)
            else {
                continue;
            };
            match &self.theory.atoms.info(entity).owner {
                Owner::Symbol(_) => foreign |= self.is_free(entity),
                Owner::Quantity(quantity, _) if *quantity == Quantity::Mass => foreign = true,
                Owner::Quantity(quantity, _) if INPUTS.contains(quantity) => {}
                Owner::Quantity(..) => return None,
            }
        }
        Some(foreign)
    }

    /// Whether the sides differ by the momentum of the wheels alone, which the line thereby hands over.
    fn only_wheels(&mut self, read: &Read) -> bool {
        let wheels = |checker: &Self, v: u32| match checker.theory.atoms.atom(v) {
            Atom::Part { entity, .. } => matches!(
                checker.theory.atoms.info(*entity).owner,
                Owner::Symbol(_) | Owner::Quantity(Quantity::RelativeMomentum, _)
            ),
            _ => false,
        };
        let residuals = read
            .equations
            .iter()
            .flat_map(|e| e.residual.entries.clone());
        residuals.collect::<Vec<_>>().iter().all(|entry| {
            let variables = self.theory.normal(entry).variables();
            variables.len() <= 2 && variables.into_iter().all(|v| wheels(self, v))
        })
    }

    /// `J = [[J_x, 0, …], …]`: the entries are its own, or a zero in the place of a product.
    fn is_form_of_inertia(&mut self, read: &Read) -> bool {
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let left = equation.left.entries.iter();
        equation.left.rows == 3
            && equation.left.columns == 3
            && left.zip(&equation.right.entries).all(|(own, written)| {
                written.is_zero() || (own.clone() - written.clone()).is_zero()
            })
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
        let input = match &self.theory.atoms.info(entity).owner {
            Owner::Quantity(quantity, _) => INPUTS.contains(quantity),
            Owner::Symbol(_) => false,
        };
        input
            && components.into_iter().all(|component| {
                let value = self.theory.atoms.value(entity, component, 0);
                self.theory.normal(&value).as_variable().is_some()
            })
    }

    /// Takes a line in that hands a value over; where its sentence derives it, it is not checked, and that is said.
    pub(super) fn given(&mut self, sides: &[Node], finding: &mut Finding) {
        self.accept(sides, Role::Given, finding);
        if finding.verdict != Verdict::Accepted {
            return;
        }
        let lone = |side: &Node| matches!(inner(side).kind, Kind::Symbol(_));
        if self.asserted && !sides.iter().all(lone) {
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
        let tied = self.tied();
        let entries: Vec<Fraction> = read
            .equations
            .iter()
            .flat_map(|e| e.residual.entries.clone())
            .collect();
        for entry in &entries {
            for variable in self.theory.normal(entry).variables() {
                for variable in self.with_arguments(variable) {
                    let Atom::Part { entity, order, .. } = *self.theory.atoms.atom(variable) else {
                        continue;
                    };
                    let info = self.theory.atoms.info(entity);
                    match &info.owner {
                        Owner::Quantity(_, variant) if variant.is_empty() => mechanical = true,
                        // The moment about some other point follows no law that is known here.
                        _ if self.is_about_another_point(entity) => {
                            mechanical = true;
                            loose = Some(names::latex(&self.theory.atoms, variable));
                        }
                        _ if order > 0 && info.shape == Shape::Vector => {
                            let moves_freely = !self.any_vector && !self.rate_is_tied(entity);
                            loose = moves_freely
                                .then(|| names::latex(&self.theory.atoms, variable))
                                .or(loose);
                        }
                        _ if tied.contains(&entity.0) => {}
                        _ if info.shape != Shape::Vector => {
                            loose = Some(names::latex(&self.theory.atoms, variable));
                        }
                        _ => {}
                    }
                }
            }
        }
        loose.filter(|_| mechanical)
    }

    /// Entities that accepted lines connect with a quantity of the theory, however long the way.
    fn tied(&self) -> BTreeSet<u32> {
        let groups: Vec<BTreeSet<u32>> = self
            .theory
            .premises()
            .iter()
            .map(|p| p.residuals.iter().flat_map(Fraction::variables))
            .map(|variables| {
                variables
                    .flat_map(|v| self.with_arguments(v))
                    .filter_map(|v| self.entity_of(v))
                    .collect()
            })
            .collect();
        let mechanical = |e: &u32| matches!(&self.theory.atoms.info(Entity(*e)).owner, Owner::Quantity(q, v) if v.is_empty() && *q != Quantity::Mass);
        let mut tied: BTreeSet<u32> = groups
            .iter()
            .flatten()
            .copied()
            .filter(mechanical)
            .collect();
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

    /// Whether a symbol has the letter of the moment or the momentum: the M_P beside an M.
    fn is_about_another_point(&self, entity: Entity) -> bool {
        let laws = |q: &Quantity| matches!(q, Quantity::Moment | Quantity::Momentum);
        let info = self.theory.atoms.info(entity);
        match &info.owner {
            Owner::Quantity(quantity, variant) => laws(quantity) && !variant.is_empty(),
            Owner::Symbol(key) => {
                let letter = key.split(' ').next().unwrap_or_default();
                let quantity = self.reading.quantities.get(&Letter::plain(letter));
                info.shape == Shape::Vector && quantity.is_some_and(laws)
            }
        }
    }

    /// Whether an accepted line has a rate of an entity in it.
    fn rate_is_tied(&self, entity: Entity) -> bool {
        let rate = |v: u32| matches!(self.theory.atoms.atom(v), Atom::Part { entity: e, order, .. } if *e == entity && *order > 0);
        let premises = self.theory.premises().iter();
        premises
            .flat_map(|p| &p.residuals)
            .any(|r| r.variables().into_iter().any(rate))
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
