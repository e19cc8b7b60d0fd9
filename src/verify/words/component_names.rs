//! Letters that words give to the components of a vector: "let the nadir unit vector have the components ⟨c_1⟩, ⟨c_2⟩,
//! ⟨c_3⟩", with the vector's own letter before them or, where the document has one unit vector alone, without.

use crate::notation::ast::Symbol;
use crate::notation::document::{Item, Row};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::Letter;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::quantity::Shape;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::points_in_words::lone;

/// Words right before the letters.
const BEFORE: &[&str] = &[
    "components",
    "components are",
    "components be",
    "direction cosines",
    "direction cosines are",
    "direction cosines be",
];
/// Axes that are not those of the body.
const ELSEWHERE: &[&str] = &["space", "inertial", "fixed", "orbit frame", "orbital frame"];

/// What a sentence has named so far.
#[derive(Default)]
struct Sentence {
    words: String,
    vector: Option<Symbol>,
    letters: Vec<Symbol>,
}

impl Checker<'_> {
    /// Ties letters that the words call components to their vector.
    pub(crate) fn name_components(&mut self) {
        let document = self.document;
        let mut sentence = Sentence::default();
        for item in &document.items {
            match item {
                Item::Prose { text, span } => {
                    let words = lowered(text);
                    if !matches!(words.trim(), "," | "and" | ", and") {
                        self.end_of_letters(&mut sentence, &words, *span);
                    }
                    match words.rsplit_once(['.', ';', ':']) {
                        Some((_, last)) => {
                            sentence = Sentence {
                                words: last.to_owned(),
                                ..Sentence::default()
                            }
                        }
                        None => sentence.words.push_str(&words),
                    }
                }
                Item::Formula(formula) if !formula.display => {
                    for row in &formula.rows {
                        match row {
                            Row::Expression(node) => match lone(node) {
                                Some(symbol) if symbol.style.vector || symbol.style.hat => {
                                    sentence.vector = Some(symbol.clone());
                                }
                                Some(symbol) if ends_in(&sentence.words, BEFORE) => {
                                    sentence.letters.push(symbol.clone());
                                }
                                _ => sentence.letters.clear(),
                            },
                            _ => sentence = Sentence::default(),
                        }
                    }
                }
                _ => sentence = Sentence::default(),
            }
        }
    }

    fn end_of_letters(&mut self, sentence: &mut Sentence, behind: &str, span: Span) {
        let letters = std::mem::take(&mut sentence.letters);
        let clause = behind.split(['.', ';']).next().unwrap_or_default();
        let Ok(letters) = <[Symbol; 3]>::try_from(letters) else {
            return;
        };
        let elsewhere = has_any(clause, ELSEWHERE) || has_any(&sentence.words, ELSEWHERE);
        let plain = |symbol: &Symbol| {
            let letter = Letter::of(symbol);
            let quantity = self.reading.quantities.contains_key(&letter)
                || self.reading.components.contains_key(&letter);
            !symbol.style.vector && !quantity
        };
        if elsewhere || !letters.iter().all(plain) {
            return;
        }
        let vector = match &sentence.vector {
            Some(vector) => self.own_vector(vector),
            None if sentence.words.contains("unit vector") => self.only_unit_vector(),
            None => None,
        };
        let Some(vector) = vector else { return };
        let parts = letters.each_ref().map(|letter| self.meaning_of(letter));
        let own = |part: &Meaning| part.entity() == Some(vector);
        if parts.iter().any(own) {
            return;
        }
        let atoms = &mut self.theory.atoms;
        let values = parts.map(|part| match part {
            Meaning::Whole(entity) => Some(atoms.value(entity, 0, 0)),
            Meaning::Component(entity, place) => Some(atoms.value(entity, place, 0)),
            _ => None,
        });
        let [Some(first), Some(second), Some(third)] = values else {
            return;
        };
        for entity in parts.iter().filter_map(Meaning::entity) {
            atoms.info_mut(entity).constant = false;
        }
        let preferred = [0, 1, 2].map(|c| atoms.part(vector, c, 0));
        let values = (0..).zip([first, second, third]);
        let residuals = values.map(|(c, value)| atoms.value(vector, c, 0) - value);
        let residuals = residuals.collect();
        let name = format!(
            "the letters of the components of {}",
            atoms.info(vector).latex
        );
        let taken = self.theory.assume(Premise {
            name: name.clone(),
            residuals,
            preferred: preferred.to_vec(),
            definition: true,
        });
        if taken == Taken::Solved {
            self.keep(&name, true);
            self.known.insert(vector);
            self.known.extend(parts.iter().filter_map(Meaning::entity));
            self.tell(span, name);
        }
    }

    /// The entity of a vector of the document that no quantity of the theory is.
    fn own_vector(&mut self, symbol: &Symbol) -> Option<Entity> {
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return None;
        };
        let info = self.theory.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Vector;
        own.then_some(entity)
    }

    /// The unit vector with a letter of its own, where a document has but one.
    fn only_unit_vector(&mut self) -> Option<Entity> {
        let hatted = |s: &&Symbol| s.style.hat && s.subscripts.is_empty();
        let hatted: Vec<&Symbol> = every_symbol(self.document)
            .into_iter()
            .filter(hatted)
            .collect();
        let mut found: Vec<Entity> = hatted
            .into_iter()
            .filter_map(|symbol| self.own_vector(symbol))
            .collect();
        found.dedup();
        match found.as_slice() {
            [one] => Some(*one),
            _ => None,
        }
    }
}

fn ends_in(words: &str, ends: &[&str]) -> bool {
    let words = words.trim_end().trim_end_matches([',', ' ']);
    let words = words.strip_suffix(" and").unwrap_or(words);
    let words = words.trim_end().trim_end_matches([',', ' ']);
    ends.iter().any(|end| words.ends_with(end))
}
