//! Steps in time: relations between the angular velocities before and behind a step. A section on another method has
//! another step, and what the one before it said of the velocity behind the step is over.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node, Term};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::decide::passes_filter;
use crate::verify::theory::{Name, Premise};
use crate::verify::values::atoms::{Entity, Owner, variable_fraction};
use crate::verify::values::call::name_of_function;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::has_any;
use num_traits::Zero;
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
    "advance",
    "discreti",
    "we integrate",
    "integrated by",
    "integrate by",
    "march",
    "recursion",
    "difference quotient",
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
        // A half step gives another state.
        let lone = match &inner(&sides[0]).kind {
            Kind::Symbol(symbol) => self.entity_named(symbol),
            _ => None,
        };
        let steps = self.steps.iter();
        let (before, now): (Vec<_>, Vec<_>) = steps.partition(|(_, s)| *s < self.cases.place());
        let ended: BTreeSet<Name> = before.into_iter().map(|(name, _)| name.clone()).collect();
        let first = ended.is_empty() && role == Role::Claim;
        let now = now
            .into_iter()
            .any(|(name, _)| lone.is_none_or(|state| self.gives(name, state)));
        if now || first && !self.steps_to_new(sides) || holds(self) {
            return false;
        }
        self.steps.clear();
        self.end_premises(&ended);
        self.accept_definition(sides, finding)
    }

    /// Whether a premise speaks of a state.
    fn gives(&self, name: &Name, state: Entity) -> bool {
        let premises = self.theory.premises().iter();
        let mut said = premises
            .filter(|p| p.name == *name)
            .flat_map(|p| &p.residuals);
        said.any(|r| {
            r.variables()
                .iter()
                .any(|v| self.theory.atoms.entity_of(*v) == Some(state))
        })
    }

    /// Takes in a step that gives the state behind it by this state itself, or by a mean of both.
    pub(crate) fn steps_implicitly(
        &mut self,
        sides: &[Node],
        role: Role,
        finding: &mut Finding,
    ) -> bool {
        let [left, right] = sides else { return false };
        let behind = match &inner(left).kind {
            Kind::Symbol(symbol) => self.entity_named(symbol),
            _ => None,
        };
        let Some((behind, label)) = behind.and_then(|e| Some((e, self.label_of_state(e)?))) else {
            return false;
        };
        let Some((before, _)) = label.split_once('+') else {
            return false;
        };
        let Ok(value) = self.lowering(Frame::Moving).value(right) else {
            return false;
        };
        let known = value.entries.iter().map(|entry| self.theory.normal(entry));
        let known: BTreeSet<Variable> = known
            .collect::<Vec<_>>()
            .iter()
            .flat_map(Fraction::variables)
            .collect();
        let within: BTreeSet<Entity> = known
            .into_iter()
            .filter_map(|v| self.theory.atoms.entity_of(v))
            .collect();
        let of_mean = |entity: &Entity| {
            let label = self.label_of_state(*entity);
            *entity == behind || label.is_some_and(|label| label != before) && self.is_free(*entity)
        };
        within.iter().any(of_mean) && self.turns_to_step(&as_increment(left, right), role, finding)
    }

    /// The label of a velocity or a momentum.
    fn label_of_state(&self, entity: Entity) -> Option<String> {
        match &self.theory.atoms.info(entity).owner {
            Owner::Quantity(Quantity::AngularVelocity | Quantity::Momentum, label) => {
                Some(label.clone())
            }
            _ => None,
        }
    }

    /// Takes in the mean of the states before and behind a step, `\bar\omega = ½(ω_{k+1} + ω_k)`, of which the step that
    /// stands before it was made.
    pub(crate) fn names_the_mean(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let (Kind::Symbol(symbol), false) = (&inner(left).kind, self.steps.is_empty()) else {
            return false;
        };
        let Some(mean) = self.entity_named(symbol).filter(|mean| self.is_free(*mean)) else {
            return false;
        };
        let Owner::Quantity(quantity, _) = self.theory.atoms.info(mean).owner.clone() else {
            return false;
        };
        let Ok(value) = self.lowering(Frame::Moving).value(right) else {
            return false;
        };
        let atoms = &self.theory.atoms;
        let state = |v: Variable| {
            let entity = atoms.entity_of(v).filter(|entity| *entity != mean);
            matches!(atoms.owner(v), Some(Owner::Quantity(q, label)) if *q == quantity && !label.is_empty())
                && entity.is_some()
        };
        let half = Fraction::from_ratio(1, 2);
        let is_mean = |entry: &Fraction| match entry.variables().as_slice() {
            [one, two] if state(*one) && state(*two) => {
                let sum = variable_fraction(*one) + variable_fraction(*two);
                (half.clone() * sum - entry.clone()).is_zero()
            }
            _ => false,
        };
        let of_states = value.is_vector() && value.entries.iter().all(is_mean);
        if !of_states || !self.theory.mentions_entity(mean) {
            return false;
        }
        let now = self
            .steps
            .iter()
            .filter(|(_, place)| *place == self.cases.place());
        let now: BTreeSet<Name> = now.map(|(name, _)| name.clone()).collect();
        let premises = self.theory.premises().iter();
        let steps: Vec<Premise> = premises
            .filter(|p| now.contains(&p.name))
            .cloned()
            .collect();
        if steps.is_empty() {
            return false;
        }
        // The step is solved with the mean known.
        self.theory.retain(|premise| !now.contains(&premise.name));
        let accepted = self.accept_definition(sides, finding);
        for step in steps {
            self.theory.assume(step);
        }
        accepted
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
            self.steps.push((name, self.cases.place()));
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
        let body = count(Quantity::Inertia) > 0 || sides.iter().any(|side| self.calls_rate(side));
        velocities > 1 && body
            || count(Quantity::Momentum) > 1 && velocities + count(Quantity::Inertia) > 0
    }
}

impl Checker<'_> {
    /// Whether the f of a law \dot\omega = f(\omega) is called.
    fn calls_rate(&self, node: &Node) -> bool {
        let named = |head: &Node| match &inner(head).kind {
            Kind::Symbol(symbol) => self
                .functions
                .get(&name_of_function(&symbol.name, &symbol.subscripts))
                .is_some_and(|function| function.value.is_vector()),
            _ => false,
        };
        matches!(&node.kind, Kind::Call(head, _) if named(head))
            || node.children().any(|child| self.calls_rate(child))
    }
}

/// `a' = a + h f` as `a' - a = h f`: the step is not solved for what it does not give alone.
fn as_increment(left: &Node, right: &Node) -> [Node; 2] {
    let Kind::Sum(terms) = &inner(right).kind else {
        return [left.clone(), right.clone()];
    };
    let lone = |term: &Term| matches!(inner(&term.node).kind, Kind::Symbol(_));
    let (states, rest): (Vec<Term>, Vec<Term>) = terms.iter().cloned().partition(lone);
    if states.is_empty() || rest.is_empty() {
        return [left.clone(), right.clone()];
    }
    let whole = Term {
        negative: false,
        sign: left.span,
        node: left.clone(),
    };
    let states = states.into_iter().map(|term| Term {
        negative: !term.negative,
        ..term
    });
    let sum = |terms: Vec<Term>, span| Node {
        kind: Kind::Sum(terms),
        span,
    };
    [
        sum(std::iter::once(whole).chain(states).collect(), left.span),
        sum(rest, right.span),
    ]
}
