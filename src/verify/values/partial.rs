//! Derivatives of functions in what laws determine: ∂f/∂Π of `f(Π) = Π × I⁻¹Π`, where Π is Iω besides.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::letters::usage::inner;
use crate::verify::theory::law::Dynamics;
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::lower::{Lowering, put_in, substituted};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use num_traits::Zero;
use std::collections::HashMap;

impl Lowering<'_> {
    /// The derivative in the state behind a step, `\partial R/\partial\omega_{k+1}`: that state is the unknown, so that
    /// the step does not give it, and the mean that is made of it moves along. `None` in any other state.
    pub(crate) fn slope_behind_a_step(
        &mut self,
        operand: &Node,
        value: &Value,
        by: &Value,
    ) -> Option<Value> {
        let places: Option<Vec<u32>> = by.entries.iter().map(Fraction::as_variable).collect();
        let places = places?;
        let behind = |v: &u32| matches!(self.theory.atoms.owner(*v), Some(Owner::Quantity(_, label)) if label.contains('+'));
        if !places.iter().all(behind) {
            return None;
        }
        let mut left_out = self.theory.left_out.clone();
        let mut means = HashMap::new();
        for premise in self.theory.premises() {
            for residual in &premise.residuals {
                if !residual.variables().iter().any(|v| places.contains(v)) {
                    continue;
                }
                left_out.insert(premise.name.clone());
                means.extend(mean_in(residual, &premise.preferred, &places));
            }
        }
        let function = match &inner(operand).kind {
            Kind::Symbol(symbol) => self.function_of(symbol).map(|function| function.value),
            _ => None,
        };
        let written = function.unwrap_or_else(|| value.clone());
        // A residual is made of a mean, which is made of the state.
        let once = written.map(|entry| put_in(entry, &means));
        let written = once.map(|entry| put_in(entry, &means));
        let before = std::mem::replace(&mut self.theory.left_out, left_out);
        self.with_dynamics(Dynamics::Forward, |lowering| {
            let slope = lowering.jacobian(&written, &places);
            lowering.theory.left_out = before;
            slope
        })
    }

    /// Whether the bare letter that a derivative is taken in is not what the same letter with an index is made of: the ω
    /// of `\partial\omega_{k+1}/\partial\omega`, where ω_{k+1} is given by ω_k.
    pub(crate) fn is_of_another_step(
        &mut self,
        operand: &Node,
        variable: &Node,
        value: &Value,
        by: &Value,
    ) -> bool {
        let (Kind::Symbol(of), Kind::Symbol(bare)) = (&inner(operand).kind, &inner(variable).kind)
        else {
            return false;
        };
        let indexed = !of.subscripts.is_empty() || !of.superscripts.is_empty();
        if of.name != bare.name || !indexed || !bare.subscripts.is_empty() {
            return false;
        }
        let met = self.theory.reached_variables(value.entries.iter());
        let made_of = by.entries.iter().flat_map(Fraction::variables);
        let atoms = &self.theory.atoms;
        let own = by.entries.iter().chain(&value.entries);
        let own: Vec<_> = own
            .flat_map(Fraction::variables)
            .filter_map(|v| atoms.entity_of(v))
            .collect();
        let quantity = |v: Variable| match atoms.owner(v) {
            Some(Owner::Quantity(quantity, _)) => Some(*quantity),
            _ => None,
        };
        let bare: Vec<Variable> = made_of.collect();
        let kind = bare.first().and_then(|&v| quantity(v));
        let of_step = |&v: &Variable| {
            let other = atoms.entity_of(v).is_some_and(|e| !own.contains(&e));
            other && kind.is_some() && quantity(v) == kind
        };
        !bare.iter().any(|v| met.contains(v)) || met.iter().any(of_step)
    }

    /// The Jacobian of a function that the document defined, in its own parameter or in the same quantity at a step, as
    /// `\partial f/\partial\omega_k` of f(ω); `None` where the operand is none, or has in it what changes along with that.
    pub(crate) fn slope_of_function(&mut self, operand: &Node, by: &Value) -> Option<Value> {
        let Kind::Symbol(symbol) = &inner(operand).kind else {
            return None;
        };
        let function = self.function_of(symbol)?;
        let rate = |v: Variable| matches!(self.theory.atoms.atom(v), Atom::Part { order: 1.., .. });
        let mut met = function.value.entries.iter().flat_map(Fraction::variables);
        if met.any(rate) {
            return None;
        }
        let places: Option<Vec<u32>> = by.entries.iter().map(Fraction::as_variable).collect();
        let (places, from) = (places?, &function.parameter);
        if places == *from {
            return self.slope_as_written(&function.value, by, &places);
        }
        let quantity = |v: &u32| match self.theory.atoms.owner(*v) {
            Some(Owner::Quantity(quantity, _)) => Some(*quantity),
            _ => None,
        };
        let same = |(v, own): (&u32, &u32)| quantity(v).is_some() && quantity(v) == quantity(own);
        if places.len() != from.len() || !places.iter().zip(from).all(same) {
            return None;
        }
        let at_step = |v: u32| {
            let place = from.iter().position(|&own| own == v);
            variable_fraction(place.map_or(v, |i| places[i]))
        };
        let value = function.value.map(|entry| substituted(entry, &at_step));
        self.slope_as_written(&value, by, &places)
    }

    /// The Jacobian of what is written, in a symbol that stands in it by itself and that a line or a law determines;
    /// `None` where anything else there changes along with it.
    pub(crate) fn slope_as_written(
        &mut self,
        written: &Value,
        by: &Value,
        places: &[u32],
    ) -> Option<Value> {
        let free: Vec<u32> = (0..places.len())
            .map(|i| {
                let latex = format!("\\text{{(parameter {})}}", i + 1);
                self.theory.atoms.special(Atom::Opaque { latex })
            })
            .collect();
        let image = |from: &[u32], to: &[u32], v: u32| {
            let place = from.iter().position(|&p| p == v);
            variable_fraction(place.map_or(v, |i| to[i]))
        };
        let there = |v: u32| image(places, &free, v);
        let value = written.map(|entry| substituted(entry, &there));
        let value = value.map(|entry| self.theory.normal(entry));
        let normals: Vec<Fraction> = by.entries.iter().map(|e| self.theory.normal(e)).collect();
        let moves = |v: &u32| {
            let owner = self.theory.atoms.owner(*v);
            !matches!(owner, Some(Owner::Quantity(Quantity::Inertia, _)))
        };
        let along: Vec<u32> = normals
            .iter()
            .flat_map(Fraction::variables)
            .filter(moves)
            .collect();
        let mut met = value.entries.iter().flat_map(Fraction::variables);
        if met.any(|v| along.contains(&v)) {
            return None;
        }
        let jacobian = self.jacobian(&value, &free)?;
        let back = |v: u32| image(&free, places, v);
        Some(jacobian.map(|entry| substituted(entry, &back)))
    }

    /// The derivative in components of the angular momentum, the others held fixed, of what is known by the angular
    /// velocity: ∂f/∂L = (∂f/∂ω)(∂L/∂ω)⁻¹. `None` where the motion is not free, or the derivative is in something else.
    pub(crate) fn slope_in_momentum(&mut self, value: &Value, places: &[u32]) -> Option<Value> {
        let [momentum, omega] = [Quantity::Momentum, Quantity::AngularVelocity].map(|quantity| {
            let entity = self.theory.atoms.quantity(quantity);
            [0, 1, 2].map(|c| self.theory.atoms.part(entity, c, 0))
        });
        let at: Option<Vec<usize>> = places
            .iter()
            .map(|place| momentum.iter().position(|part| part == place))
            .collect();
        let (at, free) = (at?, |v: &u32| self.theory.rule(*v).is_none());
        if !omega.iter().all(free) {
            return None;
        }
        let whole = Value::column(momentum.map(variable_fraction));
        let inverse = self.jacobian(&whole, &omega)?.inverse().ok()?;
        let slope = self.jacobian(value, &omega)?;
        let through = |row: &dyn Fn(usize) -> Fraction, column: usize| {
            (0..3).fold(Fraction::zero(), |sum, i| {
                sum + row(i) * inverse.at(i, column).clone()
            })
        };
        Some(match value.is_scalar() {
            true => Value::from_fn(at.len(), 1, |r, _| {
                through(&|i| slope.at(i, 0).clone(), at[r])
            }),
            false => Value::from_fn(slope.rows, at.len(), |r, c| {
                through(&|i| slope.at(r, i).clone(), at[c])
            }),
        })
    }
}

/// What a relation gives one symbol by others, if it prefers the symbol: the mean of two states.
fn mean_in(
    residual: &Fraction,
    preferred: &[Variable],
    places: &[Variable],
) -> Option<(Variable, Fraction)> {
    if preferred.iter().any(|v| places.contains(v)) {
        return None;
    }
    let own = preferred
        .iter()
        .find(|v| residual.variables().contains(v))?;
    let part = residual.numerator().coefficient_of(*own, 1);
    let constant = [&part, residual.denominator()]
        .iter()
        .all(|p| p.is_constant().is_some());
    let part = Fraction::from(part) / Fraction::from(residual.denominator().clone());
    let mean = variable_fraction(*own) - residual.clone() / part;
    let solved = constant && !mean.variables().contains(own);
    solved.then_some((*own, mean))
}
