//! What a line can hand over: inertia, rates and masses that nothing determines.

use crate::algebra::Variable;
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::{INPUTS, is_in_digits};
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;

impl Checker<'_> {
    /// Whether a side is a lone inertia, rate or mass that no law and no line determines.
    pub(crate) fn is_free_input(&mut self, side: &Node) -> bool {
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
            Owner::Quantity(quantity, _) => Some(INPUTS.contains(quantity)),
            Owner::Symbol(_) => None,
        };
        input != Some(false)
            && components.into_iter().all(|component| {
                let value = self.theory.atoms.value(entity, component, 0);
                let normal = self.theory.normal(&value);
                match (input, normal.as_variable()) {
                    (Some(_), alone) => alone.is_some(),
                    (None, alone) => {
                        let named = alone.or_else(|| (-normal).as_variable());
                        named.is_some_and(|v| self.is_product_of_inertia(v))
                    }
                }
            })
    }

    /// Whether a variable is a product of inertia; other symbols may be names of it: `P_{xz} = \int xz\,dm`.
    fn is_product_of_inertia(&self, variable: Variable) -> bool {
        let atoms = &self.theory.atoms;
        let inertia = matches!(
            atoms.owner(variable),
            Some(Owner::Quantity(Quantity::Inertia, _))
        );
        inertia
            && matches!(*atoms.atom(variable), Atom::Part { component, order: 0, .. } if component >= 3)
    }

    /// Whether a side is a moment or product of inertia that only the same one about another point determines, which is
    /// free, and the others are numbers.
    pub(crate) fn is_free_elsewhere(&mut self, side: &Node, others: &[Node]) -> bool {
        let Kind::Symbol(symbol) = &inner(side).kind else {
            return false;
        };
        let Meaning::Component(entity, component) = self.meaning_of(symbol) else {
            return false;
        };
        if !others.iter().all(is_in_digits) {
            return false;
        }
        let of_inertia = |owner: &Owner| matches!(owner, Owner::Quantity(Quantity::Inertia, _));
        let value = self.theory.atoms.value(entity, component, 0);
        let variables = self.theory.normal(&value).variables();
        let atoms = &self.theory.atoms;
        let inertia = |v: &u32| atoms.owner(*v).is_some_and(of_inertia);
        let mut found = variables.iter().copied().filter(inertia);
        let one = found.next().filter(|_| found.next().is_none());
        let named = matches!(atoms.info(entity).owner, Owner::Symbol(_));
        one.is_some_and(|v| match *atoms.atom(v) {
            Atom::Part {
                component: c,
                order: 0,
                ..
            } => c == component || named && c >= 3,
            _ => false,
        })
    }

    /// Whether a side is a product of inertia that is determined by an angle of the document alone, as where axes are turned
    /// until another product vanishes: what it is then determines the angle.
    pub(crate) fn turns_with_an_angle(&mut self, side: &Node) -> bool {
        let Kind::Symbol(symbol) = &inner(side).kind else {
            return false;
        };
        let Meaning::Component(entity, component @ 3..) = self.meaning_of(symbol) else {
            return false;
        };
        let atoms = &self.theory.atoms;
        if !matches!(
            atoms.info(entity).owner,
            Owner::Quantity(Quantity::Inertia, _)
        ) {
            return false;
        }
        let value = self.theory.atoms.value(entity, component, 0);
        let variables = self.theory.normal(&value).variables();
        let atoms = &self.theory.atoms;
        let of_angle = |v: &Variable| match atoms.atom(*v) {
            Atom::Kernel {
                function: Function::Sin | Function::Cos | Function::Tan,
                argument,
            } => {
                let mut inside = argument.variables().into_iter();
                inside.all(|v| matches!(atoms.owner(v), Some(Owner::Symbol(_))))
            }
            _ => false,
        };
        variables.len() > 1 && variables.iter().any(of_angle)
    }
}
