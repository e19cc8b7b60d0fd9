//! Residuals of an implicit step: what words call so is no position, and vanishes "at the root of the residual".

use crate::notation::ast::Symbol;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::Letter;
use crate::verify::theory::Premise;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::has_any;

/// Whether the last word before a symbol calls it a residual.
pub(crate) fn names_a_residual(before: &str) -> bool {
    let mut words = before
        .split(|c: char| !c.is_alphanumeric() && c != '⟨')
        .rev();
    let word = words.find(|word| !matches!(*word, "" | "is" | "vector" | "function" | "by"));
    word.is_some_and(|word| matches!(word, "residual" | "residuum" | "defect"))
}

/// Words of where an iteration ends.
const AT_THE_ROOT: &[&str] = &[
    "at the root",
    "at its root",
    "at a root",
    "at the solution",
    "at convergence",
    "after convergence",
    "iteration has converged",
    "iterations have converged",
    "has converged",
    "where the residual vanishes",
    "when the residual vanishes",
];

impl Checker<'_> {
    /// "At the root of the residual": the only residual that the document has defined vanishes from here on.
    pub(crate) fn residual_vanishes(&mut self, sentence: &str, span: Span) {
        let mut letters = self.reading.residuals.iter();
        let (Some(letter), None) = (letters.next().cloned(), letters.next()) else {
            return;
        };
        if !has_any(sentence, AT_THE_ROOT) {
            return;
        }
        let Letter { name, .. } = &letter;
        let mut symbol = Symbol {
            name: name.clone(),
            ..Symbol::default()
        };
        symbol.style.vector = self.reading.usage.get(&letter).vector > 0;
        let Meaning::Whole(entity) = self.meaning_of(&symbol) else {
            return;
        };
        let count = self.theory.atoms.info(entity).shape.components();
        if self.is_free(entity) {
            return;
        }
        let residuals = (0..count)
            .map(|c| self.theory.atoms.value(entity, c, 0))
            .collect();
        let name = format!(
            "the residual {} vanishes",
            self.theory.atoms.info(entity).latex
        );
        if self
            .theory
            .premises()
            .iter()
            .any(|premise| premise.name == name)
        {
            return;
        }
        self.theory.assume(Premise {
            name: name.clone(),
            residuals,
            preferred: vec![],
            definition: false,
        });
        self.keep(&name, false);
        self.tell(span, name);
    }
}
