//! The signs of letters.

use crate::verify::language::statement::{Declaration, NounPhrase, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;

impl Builder<'_> {
    /// "`$a$` is positive", "`$a$` is not negative".
    pub(super) fn read_sign(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        match (what.head, what.is("not")) {
            ("positive", false) => self.read_positive(subjects, declaration),
            ("negative", true) => self.read_not_negative(subjects, declaration),
            _ => self.say_unused(declaration),
        }
    }

    pub(super) fn read_positive(&mut self, subjects: &[Term], declaration: &Declaration) {
        for formula in formulas(subjects) {
            // That it is positive does not say what a letter is.
            let value = self.mentioned_value(&formula.clone(), declaration);
            for entry in value.into_iter().flat_map(|value| value.entries) {
                self.system().atoms.set_positive(&entry);
            }
        }
    }

    /// What is no less than zero may be zero: it is the root of its square, and nothing is divided by it.
    pub(super) fn read_not_negative(&mut self, subjects: &[Term], declaration: &Declaration) {
        for formula in formulas(subjects) {
            let value = self.mentioned_value(&formula.clone(), declaration);
            let entry = value.and_then(|value| value.to_scalar().ok());
            match entry.and_then(|entry| entry.as_variable()) {
                Some(letter) => self.system().atoms.set_length(letter),
                None => self.say_unused(declaration),
            }
        }
    }
}
