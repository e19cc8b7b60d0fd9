//! Values in the author's letters, and letters where the author has none.

use crate::algebra::{Fraction, Place, Variable};
use crate::notation::ast::Kind;
use crate::notation::print;
use crate::verify::derivation::nouns::{declared, telling};
use crate::verify::derivation::text::{Text, node};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Facts;
use crate::verify::language::statement::{Declaration, Extent, NounPhrase, Statement, Term};
use crate::verify::model::atoms::{Key as Writing, Motion, Nature, Space};
use crate::verify::model::system::System;
use crate::verify::reading::Reading;
use crate::verify::term::letters::{At, Meaning, Reach, loosely};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// What is known of writings while a derivation is told.
pub(super) struct Letters {
    pub(super) reading: Reading,
    pub(super) facts: Facts,
    names: BTreeMap<Variable, Text>,
    /// Letters as they are printed, and as the author writes them.
    written: HashMap<String, String>,
    taken: BTreeSet<String>,
    /// The labels of components.
    labels: [&'static str; 3],
    /// Sentences about letters that the author has not.
    pub(super) sentences: Vec<String>,
}

/// The letter of a quantity.
#[derive(Clone, Debug)]
pub(super) struct Lettered {
    pub(super) latex: String,
    /// The sentence that says what it is, where the author has none.
    pub(super) sentence: Option<String>,
}

impl Letters {
    pub(super) fn new(
        mut reading: Reading,
        declarations: &[Declaration],
        labels: [&'static str; 3],
    ) -> Self {
        reading.system.set_dimensions(3);
        reading.taken = reading.active_premises(&At::default());
        let everywhere = reading.premises.iter().filter(|p| p.reach == Reach::All);
        let premises: Vec<(Fraction, Source)> = everywhere
            .map(|p| (p.equation.clone(), p.source.clone()))
            .collect();
        let mut facts = Facts::default();
        facts.extend_all(&mut reading.system.atoms, premises);
        let mut letters = Self {
            reading,
            facts,
            names: BTreeMap::new(),
            written: written_in(declarations),
            taken: BTreeSet::new(),
            labels,
            sentences: vec![],
        };
        letters.name_author_letters();
        letters
    }

    pub(super) fn system(&mut self) -> &mut System {
        &mut self.reading.system
    }

    /// The letters of the author that stand for one variable each.
    fn name_author_letters(&mut self) {
        for letter in &self.reading.letters.letters.clone() {
            self.taken
                .extend(node(&letter.latex).map(|node| loosely(&node)));
            let Meaning::Quantity(quantity) = &letter.meaning else {
                continue;
            };
            if letter.reach != Reach::All {
                continue;
            }
            let value = self.system().letter(&letter.latex, quantity);
            if let Ok(value) = value
                && value.is_scalar()
                && let Some(variable) = value.entries[0].as_variable()
            {
                self.name(variable, Text::of_letter(&letter.latex));
                self.hold_constant(variable);
            }
        }
        for letter in &self.reading.letters.letters.clone() {
            if let Meaning::Quantity(quantity) = &letter.meaning
                && letter.reach == Reach::All
                && let Ok(value) = self.system().value_of(quantity)
                && value.is_vector()
                && quantity.frame().is_none()
            {
                self.name_components(&letter.latex, &value.entries);
            }
        }
        let pi = Writing::new("\\pi");
        if let Some(pi) = self.reading.system.atoms.find(&pi) {
            self.name(pi, Text::of_letter("\\pi"));
        }
    }

    /// Names the components of a vector that are variables of their own.
    fn name_components(&mut self, latex: &str, entries: &[Fraction]) {
        for (entry, label) in entries.iter().zip(self.labels) {
            if let Some(variable) = entry.as_variable() {
                self.name(variable, Text::of_component(latex, label));
            }
        }
    }

    /// A property whose rate the facts prove to vanish has none.
    pub(super) fn hold_constant(&mut self, variable: Variable) {
        if self.reading.system.atoms.atom(variable).place != Place::Parameter {
            return;
        }
        let rate = self.system().atoms.rate(variable);
        if self.vanishes(&rate) {
            self.system().atoms.atom_mut(variable).motion = Motion::Constant;
        }
    }

    /// Gives a variable a name, if it has none.
    pub(super) fn name(&mut self, variable: Variable, text: Text) {
        if self.text_of(variable).is_none() {
            self.names.insert(variable, text);
        }
    }

    /// How a variable is written: by its letter, as the rate of one, or as the sine or cosine of an angle.
    pub(super) fn text_of(&self, variable: Variable) -> Option<Text> {
        let atoms = &self.reading.system.atoms;
        let (mut base, mut dots) = (variable, 0usize);
        loop {
            if let Some(known) = self.names.get(&base) {
                return match dots {
                    0 => Some(known.clone()),
                    _ => known.dotted(dots),
                };
            }
            if let Some(own) = self.own_writing(base) {
                return match dots {
                    0 => Some(own),
                    _ => own.dotted(dots),
                };
            }
            match atoms.atom(base).rate_of {
                Some(of) => (base, dots) = (of, dots + 1),
                None => break,
            }
        }
        if dots > 0 {
            return None;
        }
        let (function, angle) = match &atoms.atom(variable).nature {
            Nature::Sine(angle) => ("sin", angle),
            Nature::Cosine(angle) => ("cos", angle),
            _ => return None,
        };
        let angle = self.printed(angle)?;
        let bracketed = |text: &str| match text.contains([' ', '+', '-', '−']) {
            true => format!("({text})"),
            false => text.to_owned(),
        };
        Some(Text {
            latex: format!("\\{function} {}", bracketed(&angle.latex)),
            unicode: format!("{function} {}", bracketed(&angle.unicode)),
        })
    }

    /// A letter that sentences mention and say no more of: an angle, a distance.
    fn own_writing(&self, variable: Variable) -> Option<Text> {
        let atom = self.reading.system.atoms.atom(variable);
        if atom.key.order > 0 || atom.key.space != Space::Unknown {
            return None;
        }
        let written = self.written.get(&atom.key.text)?;
        Some(Text::of_letter(written))
    }

    /// Whether the laws, or else the facts, prove that two values are equal.
    pub(super) fn agree(&mut self, left: &Fraction, right: &Fraction) -> bool {
        use num_traits::Zero;
        let difference = left.clone() - right.clone();
        let by_laws = Facts::default().normal(&mut self.reading.system.atoms, &difference);
        by_laws.is_ok_and(|value| value.is_zero()) || self.vanishes(&difference)
    }

    /// Whether the facts prove that a value is zero.
    pub(super) fn vanishes(&mut self, value: &Fraction) -> bool {
        use num_traits::Zero;
        let normal = self.facts.normal(&mut self.reading.system.atoms, value);
        normal.is_ok_and(|value| value.is_zero())
    }

    /// A sum with the squares of sines put in, where that makes it shorter.
    pub(super) fn shortest(&self, of: &Fraction) -> Fraction {
        let lowered = self.reading.system.atoms.with_squares(of);
        match lowered.numerator().len() < of.numerator().len() {
            true => lowered,
            false => of.clone(),
        }
    }

    /// The author's letter for a quantity, or one of these that is still free.
    pub(super) fn letter(
        &mut self,
        noun: &NounPhrase,
        quantity: &Quantity,
        candidates: &[String],
    ) -> Option<Lettered> {
        if let Some(latex) = self.reading.letter_of(quantity) {
            return Some(Lettered {
                latex: latex.to_owned(),
                sentence: None,
            });
        }
        let latex = candidates.iter().find(|latex| self.is_free(latex))?.clone();
        self.take(&latex);
        let sentence = telling(&[&latex], noun.clone()).text;
        self.sentences.push(sentence.clone());
        Some(Lettered {
            latex,
            sentence: Some(sentence),
        })
    }

    pub(super) fn is_free(&self, latex: &str) -> bool {
        node(latex).is_some_and(|node| !self.taken.contains(&loosely(&node)))
    }

    pub(super) fn take(&mut self, latex: &str) {
        self.taken.extend(node(latex).map(|node| loosely(&node)));
    }

    /// Adds a sentence that holds for a part of the derivation.
    pub(super) fn declare(&mut self, statement: Statement, extent: Extent) {
        self.sentences.push(declared(statement, extent).text);
    }

    /// The value of a letter.
    pub(super) fn value(&mut self, latex: &str, quantity: &Quantity) -> Option<Value> {
        self.system().letter(latex, quantity).ok()
    }
}

/// Letters with an index, and the same without where there is one of the kind alone.
pub(super) fn candidates(letters: &[&str], index: Option<&str>) -> Vec<String> {
    let all = letters.iter();
    all.map(|letter| match index {
        Some(index) if index.chars().count() == 1 => format!("{letter}_{index}"),
        Some(index) => format!("{letter}_{{{index}}}"),
        None => (*letter).to_owned(),
    })
    .collect()
}

/// The letters that sentences write, by how they are printed.
fn written_in(declarations: &[Declaration]) -> HashMap<String, String> {
    let terms = declarations.iter().flat_map(|d| d.statement.terms());
    let formulas = terms.filter_map(|term| match term {
        Term::Formula(formula) => Some(formula.source.trim()),
        _ => None,
    });
    let letters = formulas.filter_map(|source| {
        let node = node(source)?;
        matches!(node.kind, Kind::Symbol(_)).then(|| (print::latex(&node), source.to_owned()))
    });
    letters.collect()
}
