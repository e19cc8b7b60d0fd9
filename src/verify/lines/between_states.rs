//! What keeps the momentum between two states of a body: `I_1 ω_1 = I_2 ω_2` where the words say that it is conserved.

use crate::algebra::Fraction;
use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::Entity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::has_any;
use std::collections::BTreeSet;

const LAW: &str = "the angular momentum is the same before and after";
/// Words that keep a momentum.
const KEPT: &[&str] = &[
    "conserved",
    "conservation",
    "constant",
    "unchanged",
    "does not change",
    "is kept",
    "stays the same",
    "remains the same",
    "is the same",
    "is preserved",
];

impl Checker<'_> {
    /// Supposes that two states have one momentum, where the words say so, or that nothing acts.
    pub(crate) fn keep_momentum_between_states(&mut self) {
        let Some(states) = self.reading.states.clone() else {
            return;
        };
        let text = self.text.lower();
        let kept = text
            .split(['.', ';', '\n'])
            .any(|sentence| sentence.contains("momentum") && has_any(sentence, KEPT));
        if !kept && !self.reading.speaks_of_no_torque {
            return;
        }
        let mut parts = vec![];
        for symbol in states.symbols().iter().flatten() {
            let (entity, place) = match self.meaning_of(symbol) {
                Meaning::Whole(entity) => (entity, 0),
                Meaning::Component(entity, place) => (entity, place),
                _ => return,
            };
            parts.push(self.theory.atoms.value(entity, place, 0));
        }
        let [inertia, rate, other, behind] = parts.as_slice() else {
            return;
        };
        let residual = other.clone() * behind.clone() - inertia.clone() * rate.clone();
        self.theory.assume(Premise {
            name: LAW.to_owned(),
            residuals: vec![residual],
            preferred: behind.as_variable().into_iter().collect(),
            definition: true,
        });
    }

    /// Whether a difference sets two states against each other, and nothing says what lies between them.
    pub(crate) fn is_between_states(&mut self, read: &Read) -> Option<String> {
        let states = self.reading.states.clone()?;
        let kept = self.theory.premises().iter().any(|p| p.name == LAW);
        let of_state: Vec<BTreeSet<Entity>> = states
            .symbols()
            .iter()
            .map(|both| both.iter().filter_map(|s| self.entity_named(s)).collect())
            .collect();
        let variables: Vec<u32> = read.residuals().flat_map(Fraction::variables).collect();
        let met = |entities: &BTreeSet<Entity>| {
            let mut all = variables
                .iter()
                .filter_map(|&v| self.theory.atoms.entity_of(v));
            all.any(|entity| entities.contains(&entity))
        };
        let both = !kept && of_state.iter().all(met);
        both.then(|| "nothing before says what is the same in the two states".to_owned())
    }
}
