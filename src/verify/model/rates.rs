//! What variables are the rates of, and which are small with all their rates.

use crate::algebra::Variable;
use crate::verify::model::atoms::Atoms;

impl Atoms {
    /// Says that a letter is small: what it stands beside is told by it, and not the other way round.
    pub(crate) fn set_small(&mut self, letter: Variable) {
        self.changes.note_all();
        self.small.insert(letter);
    }

    /// Whether a variable is said to be small, or is a rate of one that is.
    pub(crate) fn is_small(&self, variable: Variable) -> bool {
        let mut chain = self.antiderivatives(variable);
        !self.small.is_empty() && chain.any(|v| self.small.contains(&v))
    }

    /// A variable, what it is the rate of, and so on.
    pub(crate) fn antiderivatives(&self, of: Variable) -> impl Iterator<Item = Variable> {
        std::iter::successors(Some(of), |of| self.atom(*of).rate_of)
    }
}
