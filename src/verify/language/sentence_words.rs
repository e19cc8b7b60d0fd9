//! The words of a sentence by their places, for readers of clauses whose parts stand in any order.

use super::words::{Kind, Token};

/// A sentence, and its words in lower case.
pub(super) struct Words<'t> {
    pub(super) tokens: &'t [Token],
    pub(super) lower: Vec<&'t str>,
}

impl<'t> Words<'t> {
    pub(super) fn of(tokens: &'t [Token]) -> Self {
        let lower = tokens.iter().map(|t| t.lower.as_str()).collect();
        Self { tokens, lower }
    }

    /// The word at a place; none where a formula or a sign stands there.
    pub(super) fn word(&self, at: usize) -> &'t str {
        match self.tokens.get(at) {
            Some(token) if token.kind == Kind::Word => self.lower[at],
            _ => "",
        }
    }

    pub(super) fn is(&self, at: usize, kind: Kind) -> bool {
        self.tokens.get(at).is_some_and(|token| token.kind == kind)
    }

    /// Where the clause behind a joint begins: behind a sign, "and", or both.
    pub(super) fn joint(&self, at: usize) -> Option<usize> {
        let sign = self.is(at, Kind::Comma) || self.is(at, Kind::Semicolon);
        let sign = usize::from(sign);
        let and = usize::from(self.word(at + sign) == "and");
        (sign + and > 0).then_some(at + sign + and)
    }
}
