//! Whether variables are as they were, so that what was worked out by them holds still.

use crate::algebra::{Fraction, Variable};
use crate::verify::model::atoms::{Atom, Atoms, Law, Motion, Nature};

/// What happened to the variables since they were first looked at so.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Changes {
    /// How often something changed.
    count: u64,
    /// How many of the first variables are untouched; `None` where all are.
    untouched: Option<usize>,
}

impl Changes {
    /// A variable is new or changed.
    pub(super) fn note(&mut self, variable: Variable) {
        self.count += 1;
        let before = self.untouched.unwrap_or(usize::MAX);
        self.untouched = Some(before.min(variable as usize));
    }

    /// What is told of all variables changed.
    pub(super) fn note_all(&mut self) {
        self.note(0);
    }
}

/// The variables behind those with which many documents begin.
#[derive(Clone, Debug)]
pub(crate) struct Added(Vec<Atom>);

/// Rates of longer laws are brought up where a document asks for them.
const MOST_OF_RATED_LAW: usize = 40;

impl Atoms {
    /// Brings up the rates of all variables, those aside whose laws are long.
    pub(crate) fn bring_up_rates(&mut self) {
        for variable in 0..self.len() as Variable {
            let law = self.atom(variable).law.as_ref();
            if law.is_none_or(|law| law.value.numerator().len() <= MOST_OF_RATED_LAW) {
                self.rate(variable);
            }
        }
    }

    /// Looks from now on at what changes.
    pub(crate) fn watch(&mut self) {
        self.changes.untouched = None;
    }

    /// A number that is another one after each change.
    pub(crate) fn changes(&self) -> u64 {
        self.changes.count
    }

    /// Whether the first variables are as they were since changes are looked at.
    pub(crate) fn are_untouched(&self, first: usize) -> bool {
        self.changes.untouched.is_none_or(|least| least >= first)
    }

    /// The variables from one on.
    pub(crate) fn added(&self, first: usize) -> Added {
        Added(self.from(first).to_vec())
    }

    /// Brings up variables that another document brought up in the same order, more of them than there are.
    pub(crate) fn bring_up(&mut self, first: usize, added: &Added) {
        self.changes.note(first as Variable);
        self.replace_from(first, &added.0);
    }

    /// Whether the variables from one on are these.
    pub(crate) fn has_added(&self, first: usize, added: &Added) -> bool {
        let own = self.from(first);
        own.len() == added.0.len() && own.iter().zip(&added.0).all(|(a, b)| is_same(a, b))
    }
}

/// Whether two variables are one in every respect.
fn is_same(a: &Atom, b: &Atom) -> bool {
    let law = match (&a.law, &b.law) {
        (Some(a), Some(b)) => is_same_law(a, b),
        (None, None) => true,
        _ => false,
    };
    let motion = match (&a.motion, &b.motion) {
        (Motion::Rate(a), Motion::Rate(b)) => is_written_alike(a, b),
        (Motion::Constant, Motion::Constant) | (Motion::Free, Motion::Free) => true,
        _ => false,
    };
    law && motion
        && is_same_nature(&a.nature, &b.nature)
        && (&a.key, a.place, &a.square, a.rate_of, a.positive)
            == (&b.key, b.place, &b.square, b.rate_of, b.positive)
}

fn is_same_law(a: &Law, b: &Law) -> bool {
    a.name == b.name && is_written_alike(&a.value, &b.value)
}

fn is_same_nature(a: &Nature, b: &Nature) -> bool {
    match (a, b) {
        (Nature::Sine(a), Nature::Sine(b))
        | (Nature::Cosine(a), Nature::Cosine(b))
        | (Nature::Root(a), Nature::Root(b))
        | (Nature::UnitPart(a), Nature::UnitPart(b)) => is_written_alike(a, b),
        (a, b) => a == b,
    }
}

/// Equal values may be written in several ways, and be shown so.
fn is_written_alike(a: &Fraction, b: &Fraction) -> bool {
    a.numerator() == b.numerator() && a.denominator() == b.denominator()
}
