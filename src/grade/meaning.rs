//! What a key declares of submissions, and what its own lines say by that: worked out once for a class.

use crate::algebra::Fraction;
use crate::grade::matching::Sheet;
use crate::grade::remembered::Remembered;
use crate::notation::document::Document;
use crate::verify::{
    self, Apart, Declared, Finding, Report, Said, Shared, Withheld, WorkedOut, Written,
    written_symbols,
};
use std::cell::OnceCell;

/// What submissions mean.
#[derive(Clone, Debug)]
pub(super) struct Meaning {
    shared: Shared,
    /// What lines are held against each other without.
    withheld: Withheld,
    key: OnceCell<KeyLines>,
}

/// What the lines of the key say, and what was worked out to find it.
#[derive(Clone, Debug)]
pub(super) struct KeyLines {
    pub(super) worked_out: WorkedOut,
    pub(super) said: Vec<Said>,
    /// What laws say of the quantities in its lines.
    pub(super) laws: Vec<Fraction>,
    /// What lines came to beside them.
    pub(super) remembered: Remembered,
}

impl Meaning {
    /// By these sentences, written in the notation of a document without a line.
    pub(super) fn new(declared: Declared, bare: Document, withheld: &Withheld) -> Self {
        Self {
            shared: Shared::new(declared, bare),
            withheld: withheld.clone(),
            key: OnceCell::new(),
        }
    }

    pub(super) fn declared(&self) -> &Declared {
        &self.shared.declared
    }

    /// A check of a document: in the new house where its meaning is declared.
    pub(super) fn check(&self, document: &Document, written: &Written) -> Report {
        match self.declared().is_empty() {
            true => verify::check(document),
            false => self.shared.check(document, written),
        }
    }

    /// The same without looking for what would put false lines right, where that is not asked for.
    pub(super) fn judge(&self, document: &Document, written: &Written) -> Report {
        match self.declared().is_empty() {
            true => verify::check(document),
            false => self.shared.judge(document, written, &[]),
        }
    }

    /// The same with some lines taken as claimed, where a meaning is declared.
    pub(super) fn judge_as_claimed(
        &self,
        document: &Document,
        written: &Written,
        claimed: &[&Finding],
    ) -> Report {
        self.shared.judge(document, written, claimed)
    }

    /// What the lines of the key say.
    pub(super) fn key_lines(&self, key: &Sheet<'_, '_>) -> &KeyLines {
        self.key.get_or_init(|| {
            let mut apart = Apart::new(key.document, &self.declared().declarations, &self.withheld);
            let said = apart.lines(key.document, &written_symbols(key.document), key.entries);
            KeyLines {
                laws: apart.laws(),
                worked_out: apart.worked_out(&key.given_of(&said)),
                said,
                remembered: Remembered::default(),
            }
        })
    }
}
