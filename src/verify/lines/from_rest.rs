//! What a body that starts from rest has gained on its way: `\dot\theta^2 = \frac{2mgl}{I}(\cos\theta - \cos\theta_0)`.
//!
//! Such a line holds just where it holds at the beginning and the difference of its sides does not change.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::lower::put_in;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::lowered;
use num_traits::Zero;
use std::collections::HashMap;

const FROM_REST: &[&str] = &["from rest", "at rest", "released", "is let go"];

/// Words right before where a motion starts: "let go from rest at ⟨θ = θ_0⟩".
const LET_GO: &[&str] = &[
    "from rest at",
    "from rest with",
    "from rest in",
    "released at",
    "released from",
    "released with",
    "let go at",
    "let go from",
    "let go with",
];

/// A difference between how a symbol changes, what it is and what it was at the beginning.
pub(crate) struct SinceStart {
    difference: Fraction,
    rate: Variable,
    value: Variable,
    start: Variable,
}

impl Checker<'_> {
    /// Decides such a claim, where words say that the motion starts from rest.
    pub(crate) fn follows_from_rest(
        &mut self,
        sides: &[Node],
        read: &Read,
        finding: &mut Finding,
    ) -> bool {
        let Some(since) = self.since_start(read) else {
            return false;
        };
        if sides.len() != 2 || !self.text.says(FROM_REST) {
            return false;
        }
        let start = self.at_rest(&since);
        let change = self.change(&since);
        for rest in [start, change] {
            let equation = Equation::vanishing(Value::scalar(rest));
            match decide(&mut self.theory, &[equation]) {
                Decision::True(_) => {}
                Decision::False(witness) => {
                    finding.verdict = Verdict::Refuted;
                    finding.reason = Some("the motion from rest does not keep to it".to_owned());
                    finding.counterexample = Some(*witness);
                    return true;
                }
                _ => return false,
            }
        }
        self.accept(sides, Role::Given, finding);
        let how = "it holds at the beginning, and the motion keeps to it";
        finding.remarks.push(how.to_owned());
        true
    }

    /// Takes in where a motion starts, which it leaves at once.
    pub(crate) fn tells_where_it_starts(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let said = lowered(&self.sentence);
        let near = |words: &&str| {
            let behind = said.rfind(*words).map(|at| &said[at + words.len()..]);
            behind.is_some_and(|b| !b.contains(['⟨', ',', ';', ':']) && b.split(' ').count() < 6)
        };
        let [left, right] = sides else { return false };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return false;
        };
        let info = self.theory.atoms.info(entity);
        let moves = matches!(info.owner, Owner::Symbol(_)) && !info.constant;
        if self.displayed
            || !moves
            || self.entities([right]).contains(&entity)
            || !LET_GO.iter().any(near)
        {
            return false;
        }
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Assume;
        finding.remarks.push("at the beginning".to_owned());
        self.now_known(sides);
        true
    }

    /// How the difference changes; what was at the beginning does not.
    fn change(&mut self, since: &SinceStart) -> Fraction {
        let entity = self.theory.atoms.entity_of(since.start);
        let still = entity.map(|entity| self.theory.atoms.part(entity, 0, 1));
        let change = self.theory.atoms.derivative(&since.difference);
        let still = still.map(|still| (still, Fraction::zero()));
        put_in(&change, &still.into_iter().collect())
    }

    /// The difference at the beginning.
    fn at_rest(&mut self, since: &SinceStart) -> Fraction {
        let mut begin = HashMap::from([
            (since.rate, Fraction::zero()),
            (since.value, variable_fraction(since.start)),
        ]);
        let mut kernels = vec![];
        for variable in since.difference.variables() {
            if let Atom::Kernel { function, argument } = self.theory.atoms.atom(variable).clone() {
                let argument = put_in(&argument, &begin);
                let kernel = self.lowering(Frame::Moving).kernel(function, argument);
                kernels.extend(kernel.map(|kernel| (variable, kernel)));
            }
        }
        begin.extend(kernels);
        put_in(&since.difference, &begin)
    }

    /// What a line says of how far a motion has come: the rate of θ, θ and θ₀ stand in it.
    pub(crate) fn since_start(&mut self, read: &Read) -> Option<SinceStart> {
        let [equation] = read.equations.as_slice() else {
            return None;
        };
        let difference = equation.residual.as_scalar()?.clone();
        let variables = difference.variables();
        let all: Vec<Variable> = variables
            .iter()
            .flat_map(|&v| self.theory.atoms.with_arguments(v))
            .collect();
        variables.into_iter().find_map(|rate| {
            let Atom::Part {
                entity,
                component: 0,
                order: 1,
            } = *self.theory.atoms.atom(rate)
            else {
                return None;
            };
            if !matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_)) {
                return None;
            }
            let value = self.theory.atoms.part(entity, 0, 0);
            let name = format!("{}_{{0}}", names::latex(&self.theory.atoms, value));
            let called = |v: &Variable| names::latex(&self.theory.atoms, *v) == name;
            let start = all.iter().copied().find(called)?;
            Some(SinceStart {
                difference: difference.clone(),
                rate,
                value,
                start,
            })
        })
    }
}
