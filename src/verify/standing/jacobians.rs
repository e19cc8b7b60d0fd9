//! Jacobians of vectors that sentences tell or lines define, and what lines say of motions nearby.

use crate::algebra::{Fraction, Place, Variable};
use crate::notation::ast::{Kind, Node};
use crate::notation::print::latex;
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::Nature;
use crate::verify::reading::{Jacobian, Premise};
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::letters::Reach;
use crate::verify::term::value::{Basis, Value};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// Jacobians of functions of more terms are not worked out.
const MOST_TERMS: usize = 2_000;

impl Judge<'_> {
    /// Works out the Jacobians of what is known by now.
    pub(super) fn take_jacobians(&mut self) {
        for jacobian in std::mem::take(&mut self.reading.sizes.changes.jacobians) {
            let source = Source::Declared(jacobian.sentence.clone());
            match self.slopes(&jacobian) {
                Some(equations) => equations
                    .into_iter()
                    .for_each(|equation| self.take_slope(equation, &source)),
                None => self.reading.sizes.changes.jacobians.push(jacobian),
            }
        }
    }

    /// Whether a link would tell a Jacobian that sentences tell and that is not worked out.
    pub(super) fn waits_for_jacobian(&self, held: &[Held]) -> bool {
        let jacobians = &self.reading.sizes.changes.jacobians;
        let waiting: Vec<String> = jacobians.iter().map(|j| latex(&j.letter)).collect();
        let tells = |held: &&Held| matches!(held.standing, Standing::Free | Standing::Settles);
        let mut unknown = held.iter().filter(tells).flat_map(|held| &held.unknown);
        unknown.any(|letter| waiting.contains(letter))
    }

    fn take_slope(&mut self, equation: Fraction, source: &Source) {
        let changes = &mut self.reading.sizes.changes;
        changes.definitions.push((equation.clone(), source.clone()));
        let atoms = &mut self.reading.system.atoms;
        if self.facts.extend(atoms, &equation, source).is_err() {
            self.facts.miss(source);
        }
        self.again.recalled = None;
        self.settled_taken.push(self.reading.settled.len());
        self.reading.settled.push(Premise {
            equation,
            source: source.clone(),
            reach: Reach::All,
        });
    }

    /// The entries of a Jacobian less the partial derivatives that they are.
    fn slopes(&mut self, jacobian: &Jacobian) -> Option<Vec<Fraction>> {
        let letter = self.told_value(&jacobian.letter, true)?;
        let mut inputs = vec![];
        for by in &jacobian.by {
            let value = self.told_value(by, false)?;
            self.is_on_axes(&value, &letter).then_some(())?;
            inputs.extend(value.entries);
        }
        let outputs = self.function(jacobian)?;
        let outputs = match self.is_on_axes(&outputs, &letter) {
            true => outputs.entries,
            false => match (outputs.vector_basis(), letter.basis) {
                (Basis::On(frame), [Basis::Written, _]) => {
                    self.reading
                        .system
                        .written_out(&outputs, frame)
                        .ok()?
                        .entries
                }
                _ => return None,
            },
        };
        let (rows, columns) = match jacobian.transposed {
            true => (inputs.len(), outputs.len()),
            false => (outputs.len(), inputs.len()),
        };
        (letter.rows == rows && letter.columns == columns).then_some(())?;
        let nodes = jacobian.by.iter().chain([&jacobian.of]);
        let unsure = self.unused_of(nodes).is_some();
        let slopes = self.partial_derivatives(&outputs, &inputs, unsure)?;
        let entry = |(at, own): (usize, &Fraction)| {
            let (row, column) = (at / columns, at % columns);
            let (output, input) = if jacobian.transposed {
                (column, row)
            } else {
                (row, column)
            };
            own.clone() - slopes[output][input].clone()
        };
        Some(letter.entries.iter().enumerate().map(entry).collect())
    }

    /// Whether the entries of a value are those on the axes of a matrix, or plain ones beside plain ones.
    fn is_on_axes(&self, value: &Value, matrix: &Value) -> bool {
        let plain = |basis| matches!(basis, Basis::Written | Basis::Any);
        let basis = value.vector_basis();
        match matrix.basis[0] {
            Basis::On(frame) => basis == Basis::On(frame) && frame == self.reading.system.work,
            Basis::Itself => basis == Basis::Itself,
            _ => plain(basis) || basis == Basis::On(self.reading.system.work),
        }
    }

    /// The value of a formula in which all letters are told by sentences or lines, or may be new.
    fn told_value(&mut self, node: &Node, new: bool) -> Option<Value> {
        let mut lowering = self.lowering();
        let value = lowering.value(node).ok()?;
        let mut unknown = lowering.unknown.keys();
        let told = new || unknown.all(|letter| lowering.known.shapes.contains_key(letter));
        told.then_some(value)
    }

    /// The vector of a Jacobian, by its letter, or as a function of what it is differentiated in.
    fn function(&mut self, jacobian: &Jacobian) -> Option<Value> {
        if let Some(value) = self.told_value(&jacobian.of, false) {
            return Some(value);
        }
        let kind = Kind::Call(Box::new(jacobian.of.clone()), jacobian.by.clone());
        let node = Node {
            kind,
            span: jacobian.of.span,
        };
        self.told_value(&node, false)
    }

    /// The partial derivatives of functions of some variables, by definitions and laws that hold in any motion: what is told
    /// of the motion at hand would be put in before they are taken.
    fn partial_derivatives(
        &mut self,
        outputs: &[Fraction],
        inputs: &[Fraction],
        unsure: bool,
    ) -> Option<Vec<Vec<Fraction>>> {
        let reading = &mut self.reading;
        let changes = &reading.sizes.changes;
        let mut facts = Facts::default();
        facts.extend_all(&mut reading.system.atoms, changes.definitions.clone());
        let laws = changes.laws.iter().map(|&place| &reading.premises[place]);
        let laws: Vec<_> = laws
            .map(|p| (p.equation.clone(), p.source.clone()))
            .collect();
        let (values, points) = match self.plain_functions(&mut facts, outputs, inputs) {
            Some(found) => found,
            // A sentence of which nothing was made may tell of another load.
            None if unsure => return None,
            None => {
                facts.extend_all(&mut self.reading.system.atoms, laws);
                self.plain_functions(&mut facts, outputs, inputs)?
            }
        };
        facts.missing().is_none().then_some(())?;
        let chosen: Option<Vec<Variable>> = (0..points.len())
            .map(|at| own_variable(&points, at))
            .collect();
        let chosen = chosen?;
        let system = &mut self.reading.system;
        let mut slopes = vec![];
        for value in &values {
            let row: Vec<Fraction> = chosen.iter().map(|v| system.partial(value, *v)).collect();
            for variable in points.iter().flat_map(Fraction::variables) {
                let parts = points.iter().zip(&row);
                let chain = parts.map(|(point, slope)| slope.clone() * point.partial(variable));
                let chain = chain.fold(Fraction::zero(), |sum, part| sum + part);
                let rest = system.partial(value, variable) - chain;
                system.atoms.with_squares(&rest).is_zero().then_some(())?;
            }
            slopes.push(row);
        }
        Some(slopes)
    }

    /// Functions and what they depend on in free variables, where no rate of these is left in the functions.
    fn plain_functions(
        &mut self,
        facts: &mut Facts,
        outputs: &[Fraction],
        inputs: &[Fraction],
    ) -> Option<(Vec<Fraction>, Vec<Fraction>)> {
        let atoms = &mut self.reading.system.atoms;
        let mut normal = |all: &[Fraction]| {
            let values = all.iter().map(|value| facts.normal(atoms, value).ok());
            let values: Option<Vec<Fraction>> = values.collect();
            values.filter(|all| all.iter().all(|v| v.numerator().len() <= MOST_TERMS))
        };
        let (values, points) = (normal(outputs)?, normal(inputs)?);
        let free: BTreeSet<Variable> = points.iter().flat_map(Fraction::variables).collect();
        let atoms = &self.reading.system.atoms;
        let is_plain = |variable: Variable| {
            let moves = atoms
                .antiderivatives(variable)
                .skip(1)
                .any(|v| free.contains(&v));
            let sums = matches!(atoms.atom(variable).nature, Nature::Sum(_));
            let driven = atoms.atom(variable).place == Place::Acceleration;
            !moves && !sums && !driven && !atoms.is_unknown(variable)
        };
        let variables = values.iter().chain(&points).flat_map(Fraction::variables);
        variables
            .into_iter()
            .all(is_plain)
            .then_some((values, points))
    }

    /// What a line defines is defined so in motions nearby.
    pub(super) fn vary_definition(&mut self, held: &Held, source: &Source) {
        let Some((_, left, right)) = &held.settles else {
            return;
        };
        let told = self.reading.sizes.changes.told;
        for (left, right) in left.entries.iter().zip(&right.entries) {
            let equation = left.clone() - right.clone();
            let definitions = &mut self.reading.sizes.changes.definitions;
            definitions.push((equation.clone(), source.clone()));
            let change = told
                .then(|| self.reading.system.atoms.change(&equation))
                .flatten();
            match change {
                Some(change) if !change.is_zero() => self.take_slope(change, source),
                _ => {}
            }
        }
    }

    /// Whether a denial speaks of motions nearby, and something that moves is told of the motion at hand alone: it may hold
    /// of the others as well.
    pub(super) fn may_hold_nearby(&mut self, residuals: &[Fraction]) -> bool {
        let reading = &mut self.reading;
        if !reading.sizes.changes.told {
            return false;
        }
        let mut variables = residuals.iter().flat_map(Fraction::variables);
        if !variables.any(|v| reading.system.atoms.is_change(v)) {
            return false;
        }
        let changes = &reading.sizes.changes;
        let atoms = &reading.system.atoms;
        let disturbed = |v: Variable| {
            atoms
                .antiderivatives(v)
                .any(|v| changes.disturbances.contains(&v))
        };
        if residuals
            .iter()
            .flat_map(Fraction::variables)
            .any(disturbed)
        {
            return true;
        }
        let declared = reading
            .taken
            .iter()
            .filter(|place| !changes.laws.contains(place));
        let declared = declared.map(|&place| &reading.premises[place].equation);
        let lines = self
            .settled_taken
            .iter()
            .map(|&place| &reading.settled[place].equation);
        let defined =
            |equation: &&Fraction| changes.definitions.iter().any(|(own, _)| own == *equation);
        let others: Vec<Fraction> = declared
            .chain(lines.filter(|e| !defined(e)))
            .cloned()
            .collect();
        let atoms = &mut self.reading.system.atoms;
        let mut variables = others.iter().flat_map(Fraction::variables);
        variables.any(|v| !atoms.is_change(v) && atoms.is_varied(v))
    }
}

/// A variable by which a value alone changes, as much as the variable itself.
fn own_variable(points: &[Fraction], at: usize) -> Option<Variable> {
    let own = |variable: &Variable| {
        let mut all = points.iter().enumerate();
        all.all(|(place, point)| {
            let slope = point.partial(*variable);
            if place == at {
                slope.is_one()
            } else {
                slope.is_zero()
            }
        })
    };
    points.get(at)?.variables().into_iter().rev().find(own)
}
