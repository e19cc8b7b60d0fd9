//! Lines of a document whose plain letters stand on space axes.
//!
//! A line in plain letters alone is decided on axes that do not turn, Ω = 0, where the inertia changes by
//! İ = \[ω\]× I − I \[ω\]×. A line with a symbol on the body's axes is decided there, with R a and R I Rᵀ for the plain
//! letters. What the document supposes on one set of axes is not known on the other, unless it says that a vector
//! vanishes.

use crate::notation::ast::{Line, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::theory::Premise;
use crate::verify::theory::law::Axes;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::verdict::{Finding, Role, Verdict};
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Decides a line on the axes that its symbols stand on, and keeps what it says.
    pub(crate) fn line(&mut self, line: &Line, role: Role) {
        self.end_limits();
        if self.reading.space_axes.is_none() {
            return self.line_as_set(line, role);
        }
        let before = line.continues.then_some(self.last_side.clone()).flatten();
        let sides: Vec<Node> = before.into_iter().chain(line.sides.clone()).collect();
        let axes = self.reading.space_axes.as_mut();
        let beside_body = axes.is_some_and(|axes| {
            axes.beside_body = axes.labels_any(&sides) && !axes.left;
            axes.beside_body || axes.left
        });
        let label = self.reading.space_axes.as_ref().filter(|_| beside_body);
        self.theory.atoms.body_label = label.map(|axes| axes.label.clone());
        let dots = self.dots.replace(Frame::Moving);
        let axes = if beside_body { Axes::Body } else { Axes::Space };
        if self.theory.setting.axes != axes
            || self.theory.setting.attitude.rate_in_space == beside_body
        {
            self.theory.set(|setting| {
                setting.axes = axes;
                setting.attitude.rate_in_space = !beside_body;
            });
        }
        let apart = self.part_premises(beside_body);
        let found = self.findings.len();
        let known = self.theory.premises().len();
        if beside_body {
            self.recall_on_body();
        }
        self.line_as_set(line, role);
        self.dots = dots;
        let elsewhere = !beside_body && !self.on_body.is_empty();
        let restricts = elsewhere || apart.iter().any(|premise| self.restricts(premise, &apart));
        if let Some(finding) = self.findings.get_mut(found).filter(|_| restricts) {
            leave_open(finding);
        }
        if beside_body {
            self.part_after(known);
        }
        for premise in apart {
            self.theory.assume(premise);
        }
        if let Some(axes) = &mut self.reading.space_axes {
            axes.beside_body = false;
        }
        self.theory.atoms.body_label = None;
    }

    /// Takes out what is supposed on the other axes.
    fn part_premises(&mut self, beside_body: bool) -> Vec<Premise> {
        let by_words = |premise: &Premise| !premise.name.contains("line ");
        let parted: Vec<Premise> = self
            .theory
            .premises()
            .iter()
            .filter(|premise| by_words(premise) != beside_body && !self.holds_on_all_axes(premise))
            .cloned()
            .collect();
        let names: Vec<&str> = parted.iter().map(|p| p.name.as_str()).collect();
        self.theory
            .retain(|premise| !names.contains(&premise.name.as_str()));
        parted
    }

    /// Whether a premise says that a vector vanishes, or speaks of numbers alone.
    pub(crate) fn holds_on_all_axes(&self, premise: &Premise) -> bool {
        let atoms = &self.theory.atoms;
        let part = |v: u32| match atoms.atom(v) {
            Atom::Part { entity, order, .. } => Some((atoms.info(*entity), *order)),
            _ => None,
        };
        let numbers = premise
            .residuals
            .iter()
            .flat_map(|r| r.variables())
            .all(|v| {
                part(v).is_some_and(|(info, _)| match info.owner {
                    Owner::Symbol(_) => info.shape == Shape::Scalar,
                    Owner::Quantity(quantity, _) => {
                        matches!(quantity, Quantity::Mass | Quantity::Time)
                    }
                })
            });
        let vanishes = premise.residuals.len() == 3
            && premise.residuals.iter().all(|residual| {
                let whole = residual.as_variable().and_then(part);
                whole.is_some_and(|(info, order)| info.shape == Shape::Vector && order == 0)
            });
        numbers || vanishes
    }

    /// Whether a premise says more than what a symbol of the document is, or that the axes are principal.
    fn restricts(&self, premise: &Premise, apart: &[Premise]) -> bool {
        let atoms = &self.theory.atoms;
        let own = |premise: &Premise| -> BTreeSet<Entity> {
            let variables = premise.residuals.iter().flat_map(|r| r.variables());
            let entities = variables.filter_map(|v| atoms.entity_of(v));
            let own = |e: &Entity| matches!(atoms.info(*e).owner, Owner::Symbol(_));
            entities.filter(own).collect()
        };
        let others = apart.iter().filter(|other| other.name != premise.name);
        let others: BTreeSet<Entity> = others.flat_map(own).collect();
        let names = premise.definition || own(premise).difference(&others).next().is_some();
        !names && !self.says_principal(premise)
    }

    /// Whether a premise says that products of inertia vanish: a tensor of which that is true on the body's axes may be
    /// any symmetric one on others.
    fn says_principal(&self, premise: &Premise) -> bool {
        let atoms = &self.theory.atoms;
        premise.residuals.iter().all(|residual| {
            let whole = residual.as_variable().map(|v| atoms.atom(v));
            matches!(whole, Some(Atom::Part { entity, component: 3.., order: 0 })
                if atoms.info(*entity).shape == Shape::Symmetric)
        })
    }

    /// Takes in again what lines on the body's axes have brought in, as far as it is still in force.
    fn recall_on_body(&mut self) {
        let scopes = &self.scopes;
        let in_force = |premise: &Premise| scopes.iter().any(|(name, _)| *name == premise.name);
        self.on_body.retain(in_force);
        for premise in std::mem::take(&mut self.on_body) {
            self.theory.assume(premise);
        }
    }

    /// Keeps what lines on the body's axes have brought in apart, for other such lines.
    fn part_after(&mut self, known: usize) {
        let news = self.theory.premises().get(known..).unwrap_or_default();
        self.on_body = news.to_vec();
        let names: Vec<&String> = self.on_body.iter().map(|premise| &premise.name).collect();
        self.theory
            .retain(|premise| !names.contains(&&premise.name));
    }
}

/// A difference need not be a mistake where something is supposed on other axes.
fn leave_open(finding: &mut Finding) {
    if finding.verdict != Verdict::Refuted {
        return;
    }
    finding.verdict = Verdict::Undecided;
    finding.diagnosis = None;
    finding.counterexample = None;
    finding.follows_from = None;
    finding.reason = Some("what is supposed above is said on other axes".to_owned());
}
