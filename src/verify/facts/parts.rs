//! Facts by some of the premises alone, kept as long as the premises are in force.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::Atoms;
use std::collections::BTreeSet;

/// Some of the premises, and what they say once they were put in.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    premises: Vec<(Fraction, Source)>,
    /// Letters that stay, where their laws can be turned round.
    letters: BTreeSet<Variable>,
    facts: Option<Facts>,
}

impl Part {
    pub(crate) fn of(premises: Vec<(Fraction, Source)>) -> Self {
        Self {
            premises,
            letters: BTreeSet::new(),
            facts: None,
        }
    }

    /// The same where letters stay.
    pub(crate) fn keeping(self, letters: BTreeSet<Variable>) -> Self {
        Self { letters, ..self }
    }

    /// Whether it is made of the same premises, and the same letters stay.
    pub(crate) fn is_as(&self, other: &Self) -> bool {
        self.premises == other.premises && self.letters == other.letters
    }

    /// Takes out what they say.
    pub(crate) fn take(&mut self, atoms: &mut Atoms) -> Facts {
        self.facts.take().unwrap_or_else(|| {
            let mut facts = Facts::keeping(atoms, &self.letters);
            facts.extend_all(atoms, self.premises.clone());
            facts
        })
    }

    /// Keeps what they say, with all that was found by it.
    pub(crate) fn keep(&mut self, facts: Facts) {
        self.facts = Some(facts);
    }
}
