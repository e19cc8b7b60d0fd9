//! Steps in time: relations between the angular velocities before and behind a step. A section on another method has
//! another step, and what the one before it said of the velocity behind the step is over.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::Name;
use crate::verify::theory::decide::passes_filter;
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::has_any;
use std::collections::BTreeSet;

/// Words of a sentence that says what a step is.
const STEP: &[&str] = &[
    "step",
    "method",
    "scheme",
    "update",
    "rule",
    "integrator",
    "iteration",
    "implicit",
    "explicit",
    "new value",
    "new state",
];

impl Checker<'_> {
    /// Takes in what a sentence calls a step, where no step of this section gives the velocity behind it yet.
    pub(crate) fn turns_to_step(
        &mut self,
        sides: &[Node],
        role: Role,
        finding: &mut Finding,
    ) -> bool {
        let words = self.sentence.to_lowercase();
        let said = role != Role::Claim || has_any(&words, STEP);
        // What a derivative of the residual is, is for rules to say.
        let slope = matches!(inner(&sides[0]).kind, Kind::Derivative { .. });
        if slope || !said || !self.displayed || !self.relates_steps(sides) {
            return false;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let holds = |checker: &mut Self| {
            let mut equations = read.equations.iter();
            equations.all(|e| passes_filter(&mut checker.theory, &e.residual) == Some(true))
        };
        let steps = self.steps.iter();
        let (before, now): (Vec<_>, Vec<_>) = steps.partition(|(_, s)| *s < self.cases.section());
        let ended: BTreeSet<Name> = before.into_iter().map(|(name, _)| name.clone()).collect();
        let first = ended.is_empty() && role == Role::Claim;
        if !now.is_empty() || first && !self.steps_to_new(sides) || holds(self) {
            return false;
        }
        self.steps.clear();
        self.end_premises(&ended);
        self.accept_definition(sides, finding)
    }

    /// Whether a line leads to an angular velocity, or a momentum, that only names have been given with: a mean.
    fn steps_to_new(&mut self, sides: &[Node]) -> bool {
        let said = self.theory.premises().iter().filter(|p| !p.definition);
        let said = said
            .flat_map(|p| &p.residuals)
            .flat_map(Fraction::variables);
        let said: BTreeSet<Option<Entity>> = said.map(|v| self.theory.atoms.entity_of(v)).collect();
        self.entities(sides).into_iter().any(|entity| {
            let owner = &self.theory.atoms.info(entity).owner;
            let state = matches!(owner, Owner::Quantity(Quantity::AngularVelocity | Quantity::Momentum, step) if step.contains('+'));
            state && !said.contains(&Some(entity))
        })
    }

    /// Leaves the energy behind a step open: it is that of the state there, which no line gives it.
    pub(crate) fn is_energy_behind_a_step(&self, left: &Node, finding: &mut Finding) -> bool {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let energy = self.reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Energy);
        let behind = symbol.subscripts.iter().any(|label| label.contains('+'));
        if energy && behind {
            finding.reason =
                Some("nothing before says what the energy is behind a step".to_owned());
        }
        energy && behind
    }

    /// Notes a line that was taken in as a step.
    pub(crate) fn note_step(&mut self, sides: &[Node], finding: &Finding) {
        if finding.verdict == Verdict::Accepted && self.relates_steps(sides) {
            let name = self.line_name(finding);
            self.steps.push((name, self.cases.section()));
            self.now_known(sides);
        }
    }

    /// Whether a line sets angular velocities before and behind a step against each other by the body that it speaks of, or
    /// momenta by the velocity that they turn with.
    fn relates_steps(&mut self, sides: &[Node]) -> bool {
        let entities: BTreeSet<Entity> = self.entities(sides).into_iter().collect();
        let owner = |entity: &Entity| self.theory.atoms.info(*entity).owner.clone();
        let owners: Vec<Owner> = entities.iter().map(owner).collect();
        let is = |owner: &&Owner, of: Quantity| matches!(owner, Owner::Quantity(q, _) if *q == of);
        let count = |of: Quantity| owners.iter().filter(|o| is(o, of)).count();
        let velocities = count(Quantity::AngularVelocity);
        velocities > 1 && count(Quantity::Inertia) > 0
            || count(Quantity::Momentum) > 1 && velocities > 0
    }
}
