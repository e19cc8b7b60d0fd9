//! What can be told of a sentence that is not understood: of which letters it speaks.

use super::clause::as_formula;
use super::phrase::NOUNS;
use super::reader::{ARTICLES, COPULAS, Read, Reader};
use super::statement::Formula;

impl Reader<'_> {
    /// The letters of a sentence that only says what quantities they are: "`$s$` and `$t$` are … rates …".
    pub(crate) fn letters_told(&mut self) -> Read<Vec<Formula>> {
        let subjects = self.terms()?;
        let formulas: Option<Vec<Formula>> = subjects.iter().map(as_formula).collect();
        if !self.take_any(&COPULAS) || !ARTICLES.contains(&self.word()) {
            return Ok(vec![]);
        }
        let nouns = (self.at..self.tokens.len()).filter_map(|at| {
            self.at = at;
            self.find(&NOUNS)
        });
        let names = nouns.take(1).all(|noun| noun.entry.only_names());
        Ok(formulas.filter(|_| names).unwrap_or_default())
    }

    /// The formulas of a sentence; `None` if it may be a rule of notation, which any letter may obey.
    pub(crate) fn mentioned(&mut self) -> Option<Vec<Formula>> {
        let start = self.at;
        let mut formulas = vec![];
        let mut rule = false;
        self.at = 0;
        let told = self.at_formula();
        while !self.done() {
            match self.at_formula() {
                true => formulas.extend(self.formulas()),
                false => {
                    rule |= self.at_rule(told);
                    self.at += 1;
                }
            }
        }
        self.at = start;
        (!rule).then_some(formulas)
    }
}
