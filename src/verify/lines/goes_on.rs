//! Lines that say how something goes on in time from its value at the beginning: `\omega_3 = s + \tau t / I`, and what
//! keeps the value that it had: `J\Omega = J_0\Omega_0`.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{inner, undotted};
use crate::verify::lines::growth::{LONGEST, lasts};
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::theory::Theory;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Entity, Owner, variable_fraction};
use crate::verify::values::lower::put_in;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;
use std::collections::HashMap;

/// Terms that the rate of a difference may come to.
const MOST_TERMS: usize = 2_000;

/// Words for a body that does not turn at the beginning.
const STARTS_FROM_REST: &[&str] = &[
    "from rest",
    "starts at rest",
    "initially at rest",
    "at rest initially",
];

/// Whether a difference does not change in time.
fn keeps(theory: &mut Theory, difference: &Fraction) -> bool {
    // In the normal form a constant torque may be what it causes, of which the rate is not known to vanish.
    let forms = [theory.normal(difference), difference.clone()];
    forms.into_iter().any(|form| {
        if form.numerator().len() > LONGEST {
            return false;
        }
        let rate = theory.atoms.derivative(&form);
        theory.normal(&rate).is_zero()
    })
}

impl Checker<'_> {
    /// Takes in a line whose sides change at the same rate and are equal at the beginning.
    pub(crate) fn goes_on(&mut self, sides: &[Node], read: &Read, finding: &mut Finding) -> bool {
        let entries = read.residuals().filter(|entry| !entry.is_zero());
        let entries: Vec<Fraction> = entries.cloned().collect();
        entries.iter().for_each(|entry| self.keep_beginnings(entry));
        let same = self.theory.within(MOST_TERMS, |theory| {
            let mut entries = entries.iter();
            entries.all(|entry| keeps(theory, entry)) && !theory.exhausted
        });
        if !same || entries.is_empty() {
            return false;
        }
        let starts = match self.value_at_the_beginning(sides) {
            Some(starts) => starts,
            None => {
                let vanishes = |checker: &mut Self, entry| {
                    let start = checker.at_zero(entry);
                    start.is_some_and(|start| checker.theory.normal(&start).is_zero())
                };
                entries.iter().all(|entry| vanishes(self, entry)) || self.names_beginning(sides)
            }
        };
        if starts {
            self.accept(sides, Role::Given, finding);
            if finding.verdict == Verdict::Accepted {
                let how = "both sides change at the same rate, and are equal at the beginning";
                finding.remarks.push(how.to_owned());
            }
        }
        if !starts && self.starts_otherwise(sides, entries, finding) {
            return true;
        }
        starts && finding.verdict == Verdict::Accepted
    }

    /// Refutes a line of which the difference keeps a value that it is known to have had at the beginning, and not zero.
    fn starts_otherwise(
        &mut self,
        sides: &[Node],
        differences: Vec<Fraction>,
        finding: &mut Finding,
    ) -> bool {
        let starts = differences.iter().map(|entry| self.at_zero(entry));
        let Some(starts) = starts.collect::<Option<Vec<Fraction>>>() else {
            return false;
        };
        let nothing = Fraction::zero;
        let equations = starts
            .into_iter()
            .map(|start| Equation::of_scalars(start, nothing()));
        let read = Read::of(equations.collect());
        let decision = decide(&mut self.theory, &read.equations);
        let refuted = matches!(decision, Decision::False(_));
        if refuted {
            self.failed(sides, &read, decision, finding);
            finding
                .remarks
                .push("what does not change is otherwise at the beginning".to_owned());
        }
        refuted
    }

    /// Whether the right side has the value at t = 0 that an earlier line gives the left; `None` where there is none.
    fn value_at_the_beginning(&mut self, sides: &[Node]) -> Option<bool> {
        let [left, right] = sides else { return None };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return None;
        };
        let starts = self.reading.starts.iter();
        let (_, start) = starts.clone().find(|(named, _)| named == symbol)?.clone();
        let value = self.lowering(Frame::Moving).value(right).ok()?;
        let start = self.lowering(Frame::Moving).value(&start).ok()?;
        let value = value.map(|entry| self.without_time(entry));
        let rest = value.plus(&start, true).ok()?;
        Some(
            rest.entries
                .iter()
                .all(|entry| self.theory.normal(entry).is_zero()),
        )
    }

    /// An `\omega_{3,0}` or an `\omega_0` is a value at the beginning, which does not change.
    fn keep_beginnings(&mut self, value: &Fraction) {
        for variable in value.variables() {
            if let Some(Owner::Quantity(_, label)) = self.theory.atoms.owner(variable)
                && label == "0"
                && let Some(entity) = self.theory.atoms.entity_of(variable)
            {
                self.theory.atoms.info_mut(entity).constant = true;
            }
        }
    }

    /// Whether the right side of `\omega_3 = \omega_0 + a t` is at t = 0 a symbol that nothing has spoken of: the value of
    /// the left side there.
    fn names_beginning(&mut self, sides: &[Node]) -> bool {
        let [left, right] = sides else { return false };
        let lone = matches!(undotted(left).kind, Kind::Symbol(_) | Kind::Call(..));
        let Ok(value) = self.lowering(Frame::Moving).value(right) else {
            return false;
        };
        let timed = value.entries.iter().flat_map(Fraction::variables);
        let timed = timed.into_iter().any(|v| self.is_time(v));
        let [entry] = value.entries.as_slice() else {
            return false;
        };
        let start = self.without_time(entry);
        let start = self.theory.normal(&start).as_variable();
        let Some(entity) = start.and_then(|v| self.theory.atoms.entity_of(v)) else {
            return false;
        };
        lone && timed
            && !self.theory.mentions_entity(entity)
            && !self.entities([left]).contains(&entity)
    }

    /// A value at t = 0, with what moves in it as it stands.
    fn without_time(&mut self, value: &Fraction) -> Fraction {
        self.at_time_zero(value, |_, _| None)
    }

    /// A value at t = 0, with what starts otherwise by a function of its variables.
    pub(crate) fn at_time_zero(
        &mut self,
        value: &Fraction,
        start: fn(&mut Self, Variable) -> Option<Fraction>,
    ) -> Fraction {
        let mut images: HashMap<Variable, Fraction> = HashMap::new();
        for variable in value.variables() {
            let image = match self.theory.atoms.atom(variable).clone() {
                _ if self.is_time(variable) => Some(Fraction::zero()),
                Atom::Kernel { function, argument } => {
                    let argument = self.at_time_zero(&argument, start);
                    self.lowering(Frame::Moving).kernel(function, argument)
                }
                _ => start(self, variable),
            };
            images.extend(image.map(|image| (variable, image)));
        }
        put_in(value, &images)
    }

    /// A value with what moves in it as it was at the beginning, where lines say that: `s(0) = 0`.
    fn at_zero(&mut self, value: &Fraction) -> Option<Fraction> {
        let value = self.theory.normal(value);
        let mut images: HashMap<Variable, Fraction> = HashMap::new();
        let mut moved = false;
        for variable in value.variables() {
            let Atom::Part { entity, order, .. } = *self.theory.atoms.atom(variable) else {
                return None;
            };
            if order == 0 && self.theory.atoms.info(entity).constant {
                continue;
            }
            if self.is_time(variable) || self.starts_at_rest(entity, order) {
                images.insert(variable, Fraction::zero());
                moved = true;
                continue;
            }
            if lasts(&mut self.theory, &variable_fraction(variable)) {
                continue;
            }
            let start = names::at_instant(&mut self.theory.atoms, variable, "0");
            self.theory.mentions_entity(start).then_some(())?;
            images.insert(variable, self.theory.atoms.value(start, 0, 0));
            moved = true;
        }
        moved.then(|| put_in(&value, &images))
    }

    /// Whether something is a rate of turning, and words say that the body starts from rest.
    fn starts_at_rest(&self, entity: Entity, order: u8) -> bool {
        let rate = match self.theory.atoms.info(entity).owner {
            Owner::Quantity(Quantity::AngularVelocity, _) => order == 0,
            Owner::Symbol(_) => order == 1,
            _ => false,
        };
        rate && self.text.says(STARTS_FROM_REST)
    }
}
