//! What does not change, by its value at the start: `2T = A p_0^2 + B q_0^2 + C r_0^2` for a body that no torque acts on.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::symbols;
use crate::verify::lines::growth::lasts;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::theory::{Name, Theory};
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::lower::put_in;
use crate::verify::verdict::{Finding, Role};
use std::collections::{BTreeSet, HashMap};

/// Words for the time that a 0 under a symbol means.
const START: &[&str] = &[
    "at the start",
    "at the beginning",
    "at first",
    "initial",
    "t = 0",
    "t=0",
    "released",
];

/// What moves, and what it was at the start.
type Beginnings = HashMap<Variable, Fraction>;

impl Checker<'_> {
    /// Decides a line with values at the start by what its other sides were then, where these do not change.
    pub(crate) fn holds_from_the_start(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        if sides.len() < 2 || !self.text.says(START) {
            return false;
        }
        let beginnings = self.beginnings(sides);
        if beginnings.is_empty() {
            return false;
        }
        let mut lowering = self.lowering(Frame::Moving);
        let values = sides.iter().map(|side| lowering.scalar(side));
        let Some(values) = values.collect::<Option<Vec<Fraction>>>() else {
            return false;
        };
        // What lines before say of both may hold for them at one time, but not of what they are made of.
        let ties = self.premises_with(&beginnings);
        let starts = self.theory.without(ties, |theory| {
            let starts = values.iter();
            let starts = starts.map(|value| value_at_the_start(theory, value, &beginnings));
            starts.collect::<Option<Vec<Fraction>>>()
        });
        let Some(starts) = starts else {
            finding.reason = Some("nothing before ties the start to what comes later".to_owned());
            return true;
        };
        let equation = |pair: &[Fraction]| Equation::of_scalars(pair[0].clone(), pair[1].clone());
        let equations: Vec<Equation> = starts.windows(2).map(equation).collect();
        match decide(&mut self.theory, &equations) {
            Decision::True(_) => {
                self.accept(sides, Role::Given, finding);
                let how = "what does not change has the value that it had at the start";
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

    /// The components that stand in some sides with a 0 behind their index, and what these were at the start.
    fn beginnings(&mut self, sides: &[Node]) -> Beginnings {
        let mut found = HashMap::new();
        for symbol in sides.iter().flat_map(symbols) {
            let mut moving = symbol.clone();
            let Some(index) = moving.subscripts.pop() else {
                continue;
            };
            let Some(index) = index.strip_suffix('0') else {
                continue;
            };
            let index = index.trim_end_matches([',', ' ']);
            moving
                .subscripts
                .extend((!index.is_empty()).then(|| index.to_owned()));
            let [moving, start] =
                [&moving, symbol].map(|symbol| self.value_of(symbol, sides[0].span)?.as_variable());
            let (Some(moving), Some(start)) = (moving, start) else {
                continue;
            };
            let [from, to] = [moving, start].map(|v| self.theory.atoms.entity_of(v));
            if let Some(entity) = to.filter(|_| from != to) {
                self.theory.atoms.info_mut(entity).constant = true;
                found.insert(moving, variable_fraction(start));
            }
        }
        found
    }

    /// The premises that speak of values at the start and of more.
    fn premises_with(&self, beginnings: &Beginnings) -> BTreeSet<Name> {
        let starts: BTreeSet<Variable> =
            beginnings.values().flat_map(Fraction::variables).collect();
        let speaks = |residual: &Fraction| {
            let met = residual.variables();
            met.len() > 1 && met.iter().any(|v| starts.contains(v))
        };
        let premises = self.theory.premises().iter();
        let found = premises.filter(|p| p.residuals.iter().any(speaks));
        found.map(|p| p.name.clone()).collect()
    }
}

/// What a value was at the start; `None` where it is not known to have kept it.
fn value_at_the_start(
    theory: &mut Theory,
    value: &Fraction,
    beginnings: &Beginnings,
) -> Option<Fraction> {
    let value = theory.normal(value);
    let mut variables = value.variables().into_iter();
    let known = lasts(theory, &value)
        && variables.all(|v| beginnings.contains_key(&v) || lasts(theory, &variable_fraction(v)));
    known.then(|| put_in(&value, beginnings))
}
