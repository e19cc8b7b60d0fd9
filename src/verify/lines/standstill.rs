//! The time at which a body stops: "it comes to rest after ⟨t = Iω_0/τ⟩".

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::lower::put_in;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;
use std::collections::HashMap;

/// Words of a sentence that tells when a body turns no more.
const STOPS: &[&str] = &[
    "comes to rest",
    "come to rest",
    "brought to rest",
    "stops",
    "to a stop",
    "to stop",
    "stop it",
    "stands still",
    "comes to a standstill",
];

impl Checker<'_> {
    /// Decides such a line by the angular velocity at that time, where a line before gives it as a function of time.
    pub(crate) fn tells_when_it_stops(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let names_time = matches!(&inner(left).kind, Kind::Symbol(symbol) if symbol.name == "t");
        if !names_time || !has_any(&lowered(&self.sentence), STOPS) {
            return false;
        }
        let Some(at) = self.lowering(Frame::Moving).scalar(right) else {
            return false;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let time = self.theory.atoms.quantity(Quantity::Time);
        let time = self.theory.atoms.part(time, 0, 0);
        let moving = (0..3).map(|c| self.theory.atoms.part(omega, c, 0));
        let moving: Vec<Fraction> = moving.map(variable_fraction).collect();
        let then = HashMap::from([(time, at.clone())]);
        let ends = moving.iter().find_map(|own| {
            let value = self.theory.normal(own);
            let timed = !value.is_zero() && value.variables().contains(&time);
            timed.then(|| put_in(&value, &then))
        });
        let Some(end) = ends else { return false };
        let equations = vec![Equation::of_scalars(end, Fraction::zero())];
        match decide(&mut self.theory, &equations) {
            Decision::True(_) => {
                finding.verdict = Verdict::Accepted;
                finding.role = Role::Given;
                let how = "the angular velocity vanishes at that time";
                finding.remarks.push(how.to_owned());
            }
            decision @ Decision::False(_) => {
                let read = Read::of(equations);
                self.failed(sides, &read, decision, finding);
            }
            _ => return false,
        }
        true
    }
}
