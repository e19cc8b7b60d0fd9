//! What is in force at a place: declared premises, and what accepted lines say.

use crate::algebra::{Fraction, Variable};
use crate::verify::Role;
use crate::verify::facts::Source;
use crate::verify::facts::premises::{Extended, Facts, OutOfBudget};
use crate::verify::reading::Premise;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::{Answer, Standing};
use crate::verify::term::letters::Reach;

impl Judge<'_> {
    /// Puts in the declared premises that reach this place, and takes out those that do not.
    pub(super) fn take_premises(&mut self) {
        self.take_premises_but(None);
    }

    /// The same without what one source says.
    pub(super) fn take_premises_but(&mut self, own: Option<&Source>) {
        let active = self.reading.active_premises(&self.at);
        let reaching = |p: &Premise| p.reach.covers(&self.at, 0) && Some(&p.source) != own;
        let settled: Vec<usize> = (0..self.reading.settled.len())
            .filter(|&i| reaching(&self.reading.settled[i]))
            .collect();
        let instants = &self.reading.instants;
        let instant = instants.at(&self.at);
        let instant = instant.map(|at| (at, instants.all[at].values.len()));
        let same = active == self.reading.taken && settled == self.settled_taken;
        if same && instant == instants.taken {
            return;
        }
        self.reading.taken = active;
        self.settled_taken = settled;
        self.reading.instants.taken = instant;
        let all = self.premises();
        self.facts = Facts::default();
        self.facts.extend_all(&mut self.reading.system.atoms, all);
        if let Some((at, _)) = instant {
            self.take_values_at(at, own);
        }
    }

    /// Puts in what is told of the instant at which the line holds.
    fn take_values_at(&mut self, instant: usize, own: Option<&Source>) {
        let values = &self.reading.instants.all[instant].values;
        let values = values.iter().filter(|(_, source)| Some(source) != own);
        for (value, source) in values.cloned().collect::<Vec<_>>() {
            let atoms = &mut self.reading.system.atoms;
            self.facts.put_at_instant(atoms, &value, &source);
        }
    }

    /// What is declared or was accepted, and is in force.
    pub(super) fn premises(&self) -> Vec<(Fraction, Source)> {
        let declared = self.reading.premises_in_force().into_iter();
        let lines = self.settled_taken.iter().map(|&i| &self.reading.settled[i]);
        let lines = lines.map(|p| (p.equation.clone(), p.source.clone()));
        declared.chain(lines).collect()
    }

    /// Takes what an accepted line says into the facts.
    pub(super) fn settle(&mut self, held: &Held, source: &Source, role: Role) -> Answer {
        let says_no_more = matches!(
            held.standing,
            Standing::Entailed | Standing::Open | Standing::Differs
        );
        if held.at_instants {
            self.reading.instants.labelled |= !says_no_more;
            return Answer::Accepted;
        }
        // What holds at one instant tells nothing of the others.
        let instant = self.reading.instants.at(&self.at);
        // The facts are others from here on, or letters have shapes.
        self.again.recalled = None;
        if let Some(at) = instant {
            let values = held.sides.iter();
            let values = values.map(|(left, right)| (left.clone() - right.clone(), source.clone()));
            self.reading.instants.all[at].values.extend(values);
        } else if let Some((letter, left, _)) = &held.settles {
            self.known.shapes.insert(letter.clone(), left.shape());
        }
        let elsewhere = !self.part.is_case_of(&self.at) && held.standing != Standing::Settles;
        if instant.is_some() || elsewhere || says_no_more {
            return Answer::Accepted;
        }
        let before = self.reading.settled.len();
        for (left, right) in &*held.sides {
            let equation = left.clone() - right.clone();
            if self.is_of_undisturbed_motion(&equation) {
                continue;
            }
            let atoms = &mut self.reading.system.atoms;
            match self.facts.extend(atoms, &equation, source) {
                Ok(Extended::Contradicts) => {
                    self.take_back(before);
                    return Answer::Refuted;
                }
                Ok(Extended::Follows) => continue,
                Ok(Extended::Solved(_) | Extended::Square) => {}
                Ok(Extended::Unsolved) => self.facts.leave(&equation, source),
                Err(OutOfBudget) => self.facts.miss(source),
            }
            let reach = match held.standing {
                Standing::Settles => Reach::All,
                _ => self.reading.reach_of_line(&self.at, role == Role::Assume),
            };
            self.settled_taken.push(self.reading.settled.len());
            self.reading.settled.push(Premise {
                equation,
                source: source.clone(),
                reach,
            });
        }
        if held.standing == Standing::Settles {
            self.vary_definition(held, source);
        }
        Answer::Accepted
    }

    /// Whether an equation without disturbances says that there are none: it is one of the motion that is disturbed elsewhere.
    fn is_of_undisturbed_motion(&mut self, equation: &Fraction) -> bool {
        let disturbances = &self.reading.sizes.disturbances;
        let is_small = |v: &Variable| disturbances.contains(v);
        if disturbances.is_empty() || equation.variables().iter().any(is_small) {
            return false;
        }
        let atoms = &mut self.reading.system.atoms;
        let Ok(value) = self.facts.normal(atoms, equation) else {
            return false;
        };
        let variables = value.variables();
        !variables.is_empty() && variables.iter().all(is_small)
    }

    /// What is refuted tells nothing, in no component: takes back what was accepted behind a number of premises.
    fn take_back(&mut self, before: usize) {
        if self.reading.settled.len() == before {
            return;
        }
        self.reading.settled.truncate(before);
        self.settled_taken.retain(|taken| *taken < before);
        let kept = self.premises();
        self.facts = Facts::default();
        self.facts.extend_all(&mut self.reading.system.atoms, kept);
    }
}
