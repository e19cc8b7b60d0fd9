//! What a statement speaks of.

use super::statement::{Slot, Statement, Term};

impl Statement {
    /// What a clause is about.
    pub(crate) fn subjects(&self) -> &[Term] {
        match self {
            Self::Is { subjects, .. }
            | Self::Same { subjects, .. }
            | Self::Does { subjects, .. } => subjects,
            _ => &[],
        }
    }

    /// All terms of a clause, those inside phrases as well.
    pub(crate) fn terms(&self) -> Vec<&Term> {
        let (first, slots): (Vec<&Term>, &[(Slot, Term)]) = match self {
            Self::Is { subjects, what } => (subjects.iter().collect(), &what.slots),
            Self::Same { subjects, others } => (subjects.iter().chain(others).collect(), &[]),
            Self::Does {
                subjects, slots, ..
            } => (subjects.iter().collect(), slots),
            Self::Premise(phrase) => (vec![], &phrase.slots),
            _ => (vec![], &[]),
        };
        let mut terms = first;
        terms.extend(slots.iter().map(|(_, term)| term));
        let mut at = 0;
        while let Some(&term) = terms.get(at) {
            if let Term::Phrase(phrase) = term {
                terms.extend(phrase.slots.iter().map(|(_, term)| term));
            }
            at += 1;
        }
        terms
    }

    /// What a clause is about, and what hangs on its noun or verb.
    pub(crate) fn terms_mut(&mut self) -> Vec<&mut Term> {
        fn slots(slots: &mut [(Slot, Term)]) -> Vec<&mut Term> {
            slots.iter_mut().map(|(_, term)| term).collect()
        }
        let (mut terms, hanging): (Vec<&mut Term>, Vec<&mut Term>) = match self {
            Self::Is { subjects, what } => (subjects.iter_mut().collect(), slots(&mut what.slots)),
            Self::Same { subjects, others } => {
                (subjects.iter_mut().chain(others).collect(), vec![])
            }
            Self::Does {
                subjects,
                slots: own,
                ..
            } => (subjects.iter_mut().collect(), slots(own)),
            Self::Premise(phrase) => (vec![], slots(&mut phrase.slots)),
            _ => (vec![], vec![]),
        };
        terms.extend(hanging);
        terms
    }
}
