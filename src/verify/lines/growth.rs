//! What grows or decays from its value at the beginning: `\omega_1(t) = \omega_1(0)\,e^{-kt/I_1}`.
//!
//! The right side of such a line changes at a multiple of itself, and is what the left side is at the beginning. So the
//! line holds just where the left side changes at that multiple of itself too.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Function, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::theory::Theory;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

/// Terms of what is differentiated in time.
pub(crate) const LONGEST: usize = 60;

/// Whether a value is the same at all times.
pub(crate) fn lasts(theory: &mut Theory, value: &Fraction) -> bool {
    let rate = theory.atoms.derivative(value);
    value.numerator().len() <= LONGEST && theory.normal(&rate).is_zero()
}

impl Checker<'_> {
    /// Decides a line of this form by the rate of its left side.
    pub(crate) fn grows_from_the_beginning(
        &mut self,
        sides: &[Node],
        finding: &mut Finding,
    ) -> bool {
        let [left, right] = sides else { return false };
        let mut lowering = self.lowering(Frame::Moving);
        let (Ok(left), Ok(right)) = (lowering.value(left), lowering.value(right)) else {
            return false;
        };
        // The rate of another vector is not that of its components, whose axes turn.
        let as_components = left.is_scalar() || left.entries.iter().all(|e| self.is_spin(e));
        if !as_components || left.entries.len() != right.entries.len() {
            return false;
        }
        let mut equations = vec![];
        for (left, right) in left.entries.into_iter().zip(right.entries) {
            let Some(factor) = self.growth(&right) else {
                return false;
            };
            if left.numerator().len() > LONGEST {
                return false;
            }
            let [first, second] =
                [&left, &right].map(|side| self.at_time_zero(side, Self::start_of));
            if !self.theory.kernels_reduced(first - second).is_zero() {
                return false;
            }
            let (rate, multiple) = (self.theory.atoms.derivative(&left), factor * left);
            equations.push(Equation::of_scalars(rate, multiple));
        }
        let to_order = self.keep_order(&mut equations);
        match decide(&mut self.theory, &equations) {
            Decision::True(_) => {
                // Two real equations in one would give what the line does not speak of a complex value.
                match self.is_complex(&equations) {
                    true => finding.verdict = Verdict::Accepted,
                    false => self.accept(sides, Role::Given, finding),
                }
                let how = "both sides change at the same multiple of themselves, and are equal at the beginning";
                finding.remarks.push(how.to_owned());
            }
            decision @ Decision::False(_) => {
                let read = Read {
                    equations,
                    unlabelled: Frame::Moving,
                    ambiguous: false,
                    to_order,
                };
                self.failed(sides, &read, decision, finding);
            }
            _ => return false,
        }
        true
    }

    /// Whether a value is a component of an angular velocity.
    fn is_spin(&self, value: &Fraction) -> bool {
        let owner = |entity| &self.theory.atoms.info(entity).owner;
        let entity = value
            .as_variable()
            .and_then(|v| self.theory.atoms.entity_of(v));
        entity.is_some_and(|e| matches!(owner(e), Owner::Quantity(Quantity::AngularVelocity, _)))
    }

    /// Whether the imaginary unit stands in equations.
    fn is_complex(&mut self, equations: &[Equation]) -> bool {
        let unit = self.lowering(Frame::Moving).imaginary_unit();
        let entries = equations.iter().flat_map(|e| &e.residual.entries);
        let mut variables = entries.flat_map(Fraction::variables);
        unit.as_variable()
            .is_some_and(|unit| variables.any(|v| v == unit))
    }

    /// The constant that the rate of a function of time is this function times.
    fn growth(&mut self, value: &Fraction) -> Option<Fraction> {
        let exponential = |v: u32| {
            let atom = self.theory.atoms.atom(v);
            matches!(atom, Atom::Kernel { function: Function::Exp, argument }
                if argument.variables().into_iter().any(|v| self.is_time(v)))
        };
        if !value.variables().into_iter().any(exponential) || value.numerator().len() > LONGEST {
            return None;
        }
        let rate = self.theory.atoms.derivative(value);
        let factor = self.theory.normal(&(rate / value.clone()));
        let lasts = factor.is_valid() && !factor.is_zero() && lasts(&mut self.theory, &factor);
        lasts.then_some(factor)
    }

    /// What a variable is at t = 0, where it moves.
    fn start_of(&mut self, variable: Variable) -> Option<Fraction> {
        let part = matches!(self.theory.atoms.atom(variable), Atom::Part { .. });
        if !part || lasts(&mut self.theory, &variable_fraction(variable)) {
            return None;
        }
        let start = names::at_instant(&mut self.theory.atoms, variable, "0");
        Some(self.theory.atoms.value(start, 0, 0))
    }

    pub(crate) fn is_time(&self, variable: Variable) -> bool {
        let owner = self.theory.atoms.owner(variable);
        owner == Some(&Owner::Quantity(Quantity::Time, String::new()))
    }
}
