//! Functions of what is stepped, behind the step.

use crate::algebra::{Polynomial, Variable, compose};
use crate::verify::facts::premises::Facts;
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::model::atoms::Motion;
use crate::verify::reading::builder::{Builder, MOST_TERMS};
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::written;
use crate::verify::reading::steps_read::{STEP, next_letter};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use std::collections::HashMap;

/// A letter for the value of another one at a step.
struct AtStep {
    index: String,
    letter: Formula,
    of: Formula,
    declaration: Declaration,
}

impl Builder<'_> {
    /// "`$E_k$` is the value of `$E$` at step `$k$`", where all that moves in E is stepped: `$E_{k+1}$` is E behind the step.
    pub(super) fn step_functions(&mut self) {
        if !self.steps_explicitly() {
            return;
        }
        let all = self.values_at_steps();
        for at in &all {
            if self.is_time(&at.of) || self.moves(&at.of, &at.declaration) {
                continue;
            }
            let next = next_letter(&at.letter, &at.index);
            if let (Some(next), Some(value)) = (next, self.stepped(at, &all)) {
                let known = Meaning::Quantity(Quantity::Known(value));
                self.denote(&next, known, &at.declaration);
            }
        }
    }

    fn values_at_steps(&self) -> Vec<AtStep> {
        let mut all = vec![];
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let (Some(Term::Phrase(step)), Some(Term::Formula(of))) =
                (what.slot(Slot::At), what.slot(Slot::Of))
            else {
                continue;
            };
            let (STEP, Some(Term::Formula(index))) = (step.head, step.slot(Slot::Which)) else {
                continue;
            };
            all.extend(formulas(subjects).map(|letter| AtStep {
                index: index.source.clone(),
                letter: letter.clone(),
                of: of.clone(),
                declaration: declaration.clone(),
            }));
        }
        all
    }

    /// What a number is behind an explicit step, where sentences tell how all is stepped that moves in it.
    fn stepped(&mut self, own: &AtStep, all: &[AtStep]) -> Option<Value> {
        let value = self.mentioned_value(&own.of, &own.declaration)?;
        let atoms = &mut self.reading.system.atoms;
        let value = Facts::default()
            .normal(atoms, &value.to_scalar().ok()?)
            .ok()?;
        let size = written(&self.step_size()?)?;
        let size = self
            .mentioned_value(&size, &own.declaration)?
            .to_scalar()
            .ok()?;
        let mut images = HashMap::new();
        for other in all.iter().filter(|other| other.index == own.index) {
            if !self.moves(&other.of, &other.declaration) {
                continue;
            }
            let rate = written(&format!("\\frac{{d}}{{dt}}{}", other.of.source))?;
            let now = self.mentioned_value(&other.of, &other.declaration)?;
            let rate = self.mentioned_value(&rate, &other.declaration)?;
            (now.basis == rate.basis).then_some(())?;
            for (entry, rate) in now.entries.iter().zip(&rate.entries) {
                let next = entry.clone() + size.clone() * rate.clone();
                images.insert(entry.as_variable()?, next);
            }
        }
        let atoms = &self.reading.system.atoms;
        let is_told = |v: &Variable| {
            let fixed = matches!(atoms.atom(*v).motion, Motion::Constant);
            images.contains_key(v) || fixed && !atoms.is_unknown(*v)
        };
        value.variables().iter().all(is_told).then_some(())?;
        let put = |p: &Polynomial| compose(p, &images, MOST_TERMS).ok();
        Some(Value::scalar(
            put(value.numerator())? / put(value.denominator())?,
        ))
    }
}
