//! What is to be looked for in a formula, by what sentences tell of writings.

use crate::verify::term::letters::{Letter, Letters, Reach};

impl Letters {
    /// Whether anything but lone symbols has a meaning.
    pub(crate) fn has_wholes(&self) -> bool {
        !self.means.is_empty() || self.letters.iter().any(|l| l.whole)
    }

    /// Whether several symbols side by side have a meaning.
    pub(crate) fn has_phrases(&self) -> bool {
        let phrase = |l: &Letter| l.whole && l.spelled.contains(' ');
        !self.means.is_empty() || self.letters.iter().any(phrase)
    }

    /// Whether every writing means the same wherever it stands.
    pub(crate) fn is_uniform(&self) -> bool {
        let letters = self.letters.iter().map(|l| &l.reach);
        let marks = self.marks.iter().map(|rule| &rule.reach);
        let labels = self.labels.iter().map(|rule| &rule.reach);
        let indices = self.indices.iter().map(|rule| &rule.reach);
        let rules = marks.chain(labels).chain(indices);
        let mut reaches = letters.chain(rules);
        self.means.is_empty()
            && self.customs.dimensions.is_empty()
            && self
                .customs
                .summed
                .iter()
                .all(|said| *said == (Reach::All, true))
            && reaches.all(|reach| *reach == Reach::All)
    }
}
