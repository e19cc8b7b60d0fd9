//! Equations of motion that an author leaves out: the one of an axis about which the body is said not to turn.

use crate::algebra::{Fraction, Variable};
use crate::verify::theory::Theory;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use num_traits::Zero;

impl Theory {
    /// Whether a condition is that no moment acts about the axis of which the equation of motion is dropped.
    pub(super) fn is_dropped(&self, residual: &Fraction) -> bool {
        let axis = self.setting.dropped_axis;
        axis.is_some() && self.axis_of_moment(residual) == axis
    }

    /// Whether a condition says of a body that does not turn about an axis that no moment acts about it, and this comes
    /// down to (A − C)ω₁ω₃ = 0: who lets ω₂ be zero leaves that out of account, and gives the body no shape by it.
    pub(super) fn is_left_out_of_account(&self, rest: &Fraction, written: &Fraction) -> bool {
        let Some(axis) = self.axis_of_moment(written) else {
            return false;
        };
        let of = |v: Variable, quantity: Quantity| {
            self.atoms.owner(v) == Some(&Owner::Quantity(quantity, String::new()))
        };
        let unchanging = |v: &Variable| {
            let said = self.premises.iter().flat_map(|p| &p.residuals);
            said.filter_map(Fraction::as_variable)
                .any(|zero| zero == *v)
        };
        let met = rest.numerator().variables().into_iter();
        let rest = met
            .filter(unchanging)
            .fold(rest.numerator().clone(), |rest, v| {
                rest.coefficient_of(v, 0)
            });
        let common = rest.common_monomial();
        let turns = common.factors().map(|(v, _)| v);
        let turns = turns.filter(|&v| of(v, Quantity::AngularVelocity));
        let shape = rest.divided_by(&common).variables();
        turns.count() == 2
            && shape.iter().all(|&v| of(v, Quantity::Inertia))
            && self.is_said_not_to_turn(axis)
    }

    fn is_said_not_to_turn(&self, axis: u8) -> bool {
        let rates = |entity| &self.atoms.info(entity).owner;
        let omega = Owner::Quantity(Quantity::AngularVelocity, String::new());
        let mut rules = self.solution.rules.iter();
        rules.any(|(&(entity, component), (order, rule))| {
            component == axis && *order == 0 && rule.value.is_zero() && *rates(entity) == omega
        })
    }

    /// The axis of the moment that a residual is, and nothing beside.
    fn axis_of_moment(&self, residual: &Fraction) -> Option<u8> {
        let Atom::Part {
            entity,
            component,
            order: 0,
        } = *self.atoms.atom(residual.as_variable()?)
        else {
            return None;
        };
        let moment = Owner::Quantity(Quantity::Moment, String::new());
        (self.atoms.info(entity).owner == moment).then_some(component)
    }
}
