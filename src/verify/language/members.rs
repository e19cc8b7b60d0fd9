//! Bodies by their names, and members of families by their indices.

use super::bodies::singular;
use super::lexicon::{Entry, Inflection};
use super::reader::Reader;
use super::statement::{Formula, NounPhrase, Slot, Term};
use super::traits::Trait;
use super::words::Kind;
use crate::notation::ast;
use crate::notation::document::Row;

impl<'a> Reader<'a> {
    /// A body that the text introduces, or a member of a family of such.
    pub(super) fn body(&mut self, length: usize) -> Term {
        let words = self.following(0).get(..length).unwrap_or_default();
        let name = words.join(" ");
        self.at += length;
        match self.index() {
            Some(index) => Term::Member {
                family: singular(&name).unwrap_or(name),
                index,
            },
            None => Term::Name(name),
        }
    }

    /// The index of a member: "`$i$`", "2".
    pub(super) fn index(&mut self) -> Option<Formula> {
        let start = self.at;
        if self.kind() == Some(Kind::Number) {
            let number = self.peek().map(|token| token.text.as_str())?;
            self.at += 1;
            return self.formula(number, false);
        }
        let mut formulas = self.formulas();
        match (formulas.pop(), formulas.is_empty()) {
            (Some(index), true) => Some(index),
            _ => {
                self.at = start;
                None
            }
        }
    }

    /// A body: "the hub", "wheel $i$".
    pub(super) fn member(&mut self, entry: &'a Entry, inflection: Inflection) -> Term {
        if let Some(index) = self.index() {
            let many = entry.traits.has(Trait::Part) && inflection == Inflection::Ending;
            if many && is_name(&index) {
                let slots = vec![(Slot::Which, Term::Formula(index))];
                return Term::Phrase(Box::new(NounPhrase::new(entry.name, slots)));
            }
            let family = entry.name.to_owned();
            return Term::Member { family, index };
        }
        if self.at_name() {
            let slots = vec![(Slot::Which, self.name())];
            return Term::Phrase(Box::new(NounPhrase::new(entry.name, slots)));
        }
        Term::Name(match inflection {
            Inflection::Base => entry.name.to_owned(),
            _ => entry.ending.clone(),
        })
    }
}

/// Whether a letter is the name of a thing: a capital one, or one with a label. An index is a small one.
fn is_name(letter: &Formula) -> bool {
    match &letter.row {
        Row::Expression(node) => match &node.kind {
            ast::Kind::Symbol(symbol) => {
                let capital = symbol.name.chars().all(|c| c.is_ascii_uppercase());
                capital || !symbol.subscripts.is_empty()
            }
            _ => false,
        },
        _ => false,
    }
}
