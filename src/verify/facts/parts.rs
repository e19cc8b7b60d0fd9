//! Facts by some of the premises alone, kept as long as the premises are in force.

use crate::algebra::Fraction;
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::Atoms;

/// Some of the premises, and what they say once they were put in.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    premises: Vec<(Fraction, Source)>,
    facts: Option<Facts>,
}

impl Part {
    pub(crate) fn of(premises: Vec<(Fraction, Source)>) -> Self {
        Self {
            premises,
            facts: None,
        }
    }

    /// Whether it is made of these premises.
    pub(crate) fn is_of(&self, premises: &[(Fraction, Source)]) -> bool {
        self.premises == premises
    }

    /// Takes out what they say.
    pub(crate) fn take(&mut self, atoms: &mut Atoms) -> Facts {
        self.facts.take().unwrap_or_else(|| {
            let mut facts = Facts::default();
            facts.extend_all(atoms, self.premises.clone());
            facts
        })
    }

    /// Keeps what they say, with all that was found by it.
    pub(crate) fn keep(&mut self, facts: Facts) {
        self.facts = Some(facts);
    }
}
