//! What the judge says of a part of the document, in the author's letters.

use crate::algebra::{Fraction, Monomial, Polynomial, Proof, Rational, Variable};
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::correction::search::corrections;
use crate::verify::declared::own::OwnLetters;
use crate::verify::language::statement::Declaration;
use crate::verify::standing::judge::{Judge, Judged};
use crate::verify::standing::parts::parts;
use crate::verify::standing::shown::Shown;
use crate::verify::verdict::{Counterexample, Diagnosis};
use std::collections::HashMap;

/// A residual of more terms than this is not shown.
const LONGEST_RESIDUAL: usize = 40;

/// The lines of a part of the document, judged.
pub(super) struct Judgment<'a> {
    pub(super) judge: Judge<'a>,
    own: OwnLetters,
    /// What would put refuted lines right.
    pub(super) corrections: HashMap<Span, Diagnosis>,
    /// The number of its first variable.
    first: usize,
}

/// Each part of a document, judged by what is declared of it. No two parts have a variable in common.
pub(super) fn judgments<'a>(
    document: &'a Document,
    declarations: &[Declaration],
) -> Vec<Judgment<'a>> {
    let mut first = 0;
    let judged = parts(document, declarations).into_iter().map(|part| {
        let mut judge = Judge::new(document, part, first);
        judge.run();
        let own = OwnLetters::of(document, &mut judge.reading);
        let before = std::mem::replace(&mut first, judge.reading.system.atoms.len());
        Judgment {
            judge,
            own,
            corrections: HashMap::new(),
            first: before,
        }
    });
    judged.collect()
}

impl Judgment<'_> {
    /// Looks for what would put its refuted lines right.
    pub(super) fn correct(&mut self) {
        self.corrections = corrections(&mut self.judge);
    }

    /// What its variables stand for, in LaTeX.
    pub(super) fn variables(&self) -> Vec<String> {
        let atoms = &self.judge.reading.system.atoms;
        let numbers = self.first as Variable..atoms.len() as Variable;
        numbers.map(|v| self.own.anywhere(atoms, v)).collect()
    }

    pub(super) fn conditions(&self, proof: &Proof, judged: &Judged, source: &str) -> Vec<String> {
        let mut found: Vec<String> = vec![];
        let arguments = proof.arguments().iter();
        let conditions = arguments.flat_map(|argument| &argument.conditions);
        for condition in conditions.filter(|condition| !is_positive(condition)) {
            let condition = Fraction::from(condition.clone());
            let text = format!("{} \\ne 0", self.printed(&condition, judged, source));
            if !found.contains(&text) {
                found.push(text);
            }
        }
        found
    }

    fn printed(&self, of: &Fraction, judged: &Judged, source: &str) -> String {
        let atoms = &self.judge.reading.system.atoms;
        self.own.printed(of, atoms, &judged.at, source)
    }

    /// Left less right as written, or with what is known put in where that is too long.
    pub(super) fn residual(&self, judged: &Judged, shown: &Shown, source: &str) -> Option<String> {
        let (left, right) = judged.sides.get(shown.place)?;
        let written = left.clone() - right.clone();
        let short = |f: &&Fraction| f.numerator().len() + f.denominator().len() <= LONGEST_RESIDUAL;
        let chosen = [&written, &shown.residual].into_iter().find(short);
        chosen.map(|chosen| self.printed(chosen, judged, source))
    }

    pub(super) fn counterexample(&self, judged: &Judged, shown: &Shown, source: &str) -> Counterexample {
        let atoms = &self.judge.reading.system.atoms;
        let letters = shown.letters.iter().map(|(letter, value)| {
            let name = self.own.on_line(atoms, *letter, &judged.at, source);
            let value = match self.own.is_opposite(atoms, *letter) {
                true => -value.clone(),
                false => value.clone(),
            };
            (name, value.to_string())
        });
        Counterexample {
            symbols: letters.collect(),
            component: component(judged.sides.len(), shown.place),
            left: shown.left.to_string(),
            right: shown.right.to_string(),
        }
    }
}


/// The name of a component: its number in a vector, row and column in a matrix.
fn component(count: usize, place: usize) -> Option<String> {
    if count <= 1 {
        return None;
    }
    Some(match (3..=8).find(|size| size * size == count) {
        Some(size) => format!("row {}, column {}", place / size + 1, place % size + 1),
        None => (place + 1).to_string(),
    })
}

/// Whether a polynomial is positive for all real numbers: a positive number and squares.
fn is_positive(of: &Polynomial) -> bool {
    let square = |(monomial, coefficient): &(Monomial, Rational)| {
        let even = monomial.powers().iter().all(|(_, power)| power % 2 == 0);
        even && !coefficient.is_negative()
    };
    let is_number = |(monomial, _): &(Monomial, Rational)| monomial.powers().is_empty();
    of.terms().iter().all(square) && of.terms().iter().any(is_number)
}
