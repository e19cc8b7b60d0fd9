//! Letters that words put for others: "we write ⟨n⟩ for ⟨\omega_3⟩", "denote ⟨\omega_3⟩ by ⟨n⟩".

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::lowered;

/// Words before the new letter, and between it and what it stands for.
const WRITE: &[&str] = &[
    "write",
    "writing",
    "put",
    "use",
    "using",
    "let",
    "letter",
    "symbol",
    "abbreviation",
    "shorthand",
];
const FOR: &[&str] = &[
    "for",
    "stand for",
    "stands for",
    "in place of",
    "instead of",
    "be short for",
];
/// Words before what gets a new letter, and between the two.
const CALL: &[&str] = &[
    "call",
    "calling",
    "denote",
    "denoting",
    "abbreviate",
    "abbreviating",
    "rename",
];
const BY: &[&str] = &["by", "as", "simply", "just", "simply by"];

impl Checker<'_> {
    /// Takes in that a lone symbol is another one, where the words between the two and before them say so.
    pub(crate) fn note_abbreviation(&mut self, node: &Node) {
        let Some(last) = self.last_alone.replace(node.clone()) else {
            return;
        };
        let (Kind::Symbol(first), Kind::Symbol(second)) = (&inner(&last).kind, &inner(node).kind)
        else {
            return;
        };
        let said = lowered(&self.sentence);
        let Some((lead, between)) = said.rsplit_once("⟨⟩") else {
            return;
        };
        let heard = lowered(&self.as_heard(last.span));
        let Some(before) = lead.trim_end().strip_suffix(heard.trim()) else {
            return;
        };
        let before = before.trim_end();
        let leads = |words: &[&str]| words.iter().any(|word| before.ends_with(word));
        let between = between.trim();
        // "For the spin ⟨ω_3⟩."
        let described = between.split_whitespace().count() <= 4;
        let stands = |word: &&str| {
            let rest = between.strip_prefix(*word);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(" the ") && described)
        };
        let (name, of) = if leads(WRITE) && FOR.iter().any(stands) {
            (first.clone(), second.clone())
        } else if leads(CALL) && BY.contains(&between) {
            (second.clone(), first.clone())
        } else {
            return;
        };
        self.stands_for(&name, &of, node);
    }

    fn stands_for(&mut self, name: &Symbol, of: &Symbol, at: &Node) {
        let (Meaning::Whole(own), Meaning::Component(entity, place)) =
            (self.meaning_of(name), self.meaning_of(of))
        else {
            return;
        };
        if !self.is_new(name) {
            return;
        }
        let own = self.theory.atoms.part(own, 0, 0);
        let value = self.theory.atoms.value(entity, place, 0);
        let premise = Premise {
            name: "the letter that the words put for another".to_owned(),
            residuals: vec![variable_fraction(own) - value],
            preferred: vec![own],
            definition: true,
        };
        if self.take_from_words(premise, at.span) {
            self.now_known([at]);
        }
    }
}
