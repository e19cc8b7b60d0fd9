//! What the sentences of a key tell of letters, for sentences of a student to be held against.

use crate::grade::key::Key;
use crate::grade::key::axes::{is_told, stands};
use crate::notation::ast::Node;
use crate::notation::document::Row;
use crate::verify::language::statement::{Extent, NounPhrase, Statement, Term};

impl Key {
    /// What a letter is said to be.
    pub(in crate::grade) fn told_of(&self, letter: &Term) -> Option<&NounPhrase> {
        let mut each = self.told_letters();
        each.find(|(subject, _)| is_same(subject, letter))
            .map(|(_, what)| what)
    }

    /// The one letter that is said to be this, or this more closely told.
    pub(in crate::grade) fn letter_for(&self, what: &NounPhrase) -> Option<String> {
        let fits = |own: &NounPhrase| {
            own.head == what.head
                && what.slots.iter().all(|slot| own.slots.contains(slot))
                && what
                    .adjectives
                    .iter()
                    .all(|word| own.adjectives.contains(word))
        };
        let mut each = self.told_letters().filter(|(_, own)| fits(own));
        match (each.next(), each.next()) {
            (Some((Term::Formula(formula), _)), None) => Some(formula.source.clone()),
            _ => None,
        }
    }

    /// Whether a letter stands in a sentence or in a line of it.
    pub(in crate::grade) fn speaks_of(&self, letter: &Node) -> bool {
        let meaning = &self.stages[0].meaning[usize::from(self.entries)];
        is_told(meaning.declared(), letter) || stands(&self.document, letter)
    }

    /// Whether a sentence is understood beside those of the key.
    pub(in crate::grade) fn understands(&self, sentence: &str) -> bool {
        let more = [sentence.to_owned()];
        let meaning = self.meaning(0, self.entries, &more);
        meaning.declared().misunderstood.is_empty()
    }

    fn told_letters(&self) -> impl Iterator<Item = (&Term, &NounPhrase)> {
        let meaning = &self.stages[0].meaning[usize::from(self.entries)];
        let all = meaning.declared().declarations.iter();
        let whole = all.filter(|said| said.extent == Extent::Document);
        whole.flat_map(|said| {
            let told = match &said.statement {
                Statement::Is { subjects, what } => Some((subjects, what)),
                _ => None,
            };
            told.into_iter()
                .flat_map(|(subjects, what)| subjects.iter().map(move |own| (own, what)))
        })
    }
}

fn is_same(one: &Term, other: &Term) -> bool {
    match (one, other) {
        (Term::Formula(one), Term::Formula(other)) => match (&one.row, &other.row) {
            (Row::Expression(one), Row::Expression(other)) => one.kind == other.kind,
            _ => false,
        },
        _ => false,
    }
}
