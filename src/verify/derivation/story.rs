//! Goes through a system from its frames to its equations.

use crate::algebra::Fraction;
use crate::verify::derivation::letters::{Lettered, Letters, candidates};
use crate::verify::derivation::nouns::{Key, Nouns};
use crate::verify::derivation::plan::{Plan, Subject, called};
use crate::verify::derivation::text::Text;
use crate::verify::derivation::{Derived, Law, Part, Row, Step, Subject as About};
use crate::verify::language::statement::Declaration;
use crate::verify::model::system::{BodyId, Matrix, PointId, Vector};
use crate::verify::reading::Reading;
use crate::verify::term::quantity::Quantity;
use num_traits::Zero;
use std::collections::HashMap;

/// A derivation under way.
pub(super) struct Story {
    pub(super) letters: Letters,
    pub(super) nouns: Nouns,
    pub(super) plan: Plan,
    vectors: HashMap<Key, Known>,
    scalars: HashMap<Key, (Text, Fraction)>,
    pub(super) tensors: HashMap<(BodyId, PointId), Matrix>,
    parts: Vec<Part>,
    steps: Vec<Step>,
    /// Sentences about letters that the next step tells.
    new: Vec<String>,
}

/// A vector with the letters of its components.
#[derive(Clone, Debug)]
pub(super) struct Known {
    pub(super) texts: [Text; 3],
    /// In letters; the value of a component that has none is itself.
    pub(super) entries: Vector,
}

/// A row: how the left side is written, what it is, and what it comes to.
pub(super) type Claim = (Text, Fraction, Fraction);

impl Story {
    pub(super) fn new(reading: Reading, nouns: Nouns, plan: Plan, said: &[Declaration]) -> Self {
        Self {
            letters: Letters::new(reading, said, plan.labels),
            nouns,
            plan,
            vectors: HashMap::new(),
            scalars: HashMap::new(),
            tensors: HashMap::new(),
            parts: vec![],
            steps: vec![],
            new: vec![],
        }
    }

    pub(super) fn tell_all(&mut self) {
        self.tell_frames();
        for subject in self.plan.bodies.clone() {
            self.tell_motion(&subject);
            self.tell_dynamics(&subject);
            self.tell_energy(&subject);
            self.end(About::Body(called(&subject.term)));
        }
    }

    /// Closes a part.
    pub(super) fn end(&mut self, subject: About) {
        let steps = std::mem::take(&mut self.steps);
        if !steps.is_empty() {
            self.parts.push(Part { subject, steps });
        }
    }

    /// Closes a part that says something without steps too.
    pub(super) fn close(&mut self, subject: About) {
        let steps = std::mem::take(&mut self.steps);
        self.parts.push(Part { subject, steps });
    }

    pub(super) fn finish(self, sought: Option<String>) -> Derived {
        Derived {
            sought,
            axes: self.plan.name_of_axes(),
            sentences: self.letters.sentences,
            parts: self.parts,
        }
    }

    /// Tells a law with the rows that the facts prove and that say something.
    pub(super) fn step(&mut self, law: Law, claims: impl IntoIterator<Item = Claim>) {
        let mut rows: Vec<Row> = vec![];
        for (left, value, right) in claims {
            if value.is_zero() && right.is_zero() {
                continue;
            }
            let right = self.letters.shortest(&right);
            let told = self.letters.printed(&right);
            if let Some(right_text) = told
                && right_text != left
                && self.letters.agree(&value, &right)
            {
                let row = Row {
                    left,
                    right: right_text,
                };
                let told = self.steps.iter().any(|step| step.rows.contains(&row));
                if !told {
                    rows.push(row);
                }
            }
        }
        if !rows.is_empty() {
            let letters = std::mem::take(&mut self.new);
            self.steps.push(Step { law, letters, rows });
        }
    }

    /// Tells a row by letters alone.
    pub(super) fn tell_row(&mut self, law: Law, left: Text, right: Text) {
        let letters = std::mem::take(&mut self.new);
        let rows = vec![Row { left, right }];
        self.steps.push(Step { law, letters, rows });
    }

    /// Notes that a letter is new.
    pub(super) fn hear(&mut self, letter: &Lettered) {
        if let Some(sentence) = &letter.sentence
            && !self.new.contains(sentence)
        {
            self.new.push(sentence.clone());
        }
    }

    /// Declares letters, and tells of them in the next step.
    pub(super) fn say(&mut self, sentence: String) {
        self.letters.sentences.push(sentence.clone());
        self.new.push(sentence);
    }

    /// The vector of a noun, with its letters.
    pub(super) fn vector(&mut self, key: Key) -> Option<Known> {
        if let Some(known) = self.vectors.get(&key) {
            return Some(known.clone());
        }
        let (noun, quantity) = self.nouns.of(key).cloned()?;
        let free = candidates(key.letters(), self.index(key).as_deref());
        let letter = self.letters.letter(&noun, &quantity, &free)?;
        self.hear(&letter);
        let value = self.letters.value(&letter.latex, &quantity)?;
        let mut entries = value.to_vector().ok()?;
        let labels = self.plan.labels;
        let mut texts = [0, 1, 2].map(|k| Text::of_component(&letter.latex, labels[k]));
        for axis in 0..3 {
            let component = Quantity::Component {
                of: quantity.clone().boxed(),
                axis,
                on: self.plan.axes,
            };
            if let Some(own) = self
                .letters
                .reading
                .letter_of(&component)
                .map(str::to_owned)
                && let Some(value) = self.letters.value(&own, &component)
            {
                texts[axis] = Text::of_letter(&own);
                entries[axis] = value.entries[0].clone();
            }
            if self.letters.vanishes(&entries[axis]) {
                entries[axis] = Fraction::zero();
            }
            if let Some(variable) = entries[axis].as_variable() {
                self.letters.name(variable, texts[axis].clone());
            }
        }
        let known = Known { texts, entries };
        self.vectors.insert(key, known.clone());
        Some(known)
    }

    /// The number of a noun, with its letter.
    pub(super) fn scalar(&mut self, key: Key) -> Option<(Text, Fraction)> {
        if let Some(known) = self.scalars.get(&key) {
            return Some(known.clone());
        }
        let (noun, quantity) = self.nouns.of(key).cloned()?;
        let free = candidates(key.letters(), self.index(key).as_deref());
        let letter = self.letters.letter(&noun, &quantity, &free)?;
        self.hear(&letter);
        let value = self.letters.value(&letter.latex, &quantity)?;
        let text = Text::of_letter(&letter.latex);
        if let Some(variable) = value.to_scalar().ok()?.as_variable() {
            self.letters.name(variable, text.clone());
        }
        let known = (text, value.to_scalar().ok()?);
        self.scalars.insert(key, known.clone());
        Some(known)
    }

    /// The angular velocity of the axes used, in letters.
    pub(super) fn turn_of_axes(&mut self) -> Vector {
        let axes = self.plan.axes;
        match self.vector(Key::Turn(axes)) {
            Some(known) => known.entries,
            None => Vector::zeros(),
        }
    }

    /// The rate seen from the inertial frame, by the transport law.
    pub(super) fn rate(&mut self, of: &Vector) -> Vector {
        let turn = self.turn_of_axes();
        let rate = self.letters.system().rate(of);
        crate::mechanics::transport(&rate, &turn, of)
    }

    /// The claims that a vector has these components.
    pub(super) fn claims(known: &Known, values: &Vector) -> Vec<Claim> {
        let rows = [0, 1, 2].map(|k| {
            (
                known.texts[k].clone(),
                known.entries[k].clone(),
                values[k].clone(),
            )
        });
        rows.into_iter().collect()
    }

    /// Whether a vector can be written in letters.
    pub(super) fn is_written(&self, vector: &Vector) -> bool {
        vector.iter().all(|e| self.letters.printed(e).is_some())
    }

    pub(super) fn subject(&self, body: usize) -> Option<Subject> {
        let mut bodies = self.plan.bodies.iter();
        bodies.find(|subject| subject.body == body).cloned()
    }
}
