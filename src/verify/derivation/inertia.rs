//! Inertia tensors in letters: those of the author, or new ones.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::derivation::nouns::telling;
use crate::verify::derivation::plan::Subject;
use crate::verify::derivation::story::Story;
use crate::verify::derivation::text::Text;
use crate::verify::language::heads;
use crate::verify::language::statement::{NounPhrase, Slot, Term};
use crate::verify::model::system::{FrameId, Matrix, PointId};
use crate::verify::term::letters::{Meaning, Reach};
use crate::verify::term::quantity::{Quantity, Whole};
use num_traits::Zero;

/// Row and column of the six numbers of a tensor.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl Story {
    /// The tensor of a body about a point, on the axes used. Where a moment has no letter it gets one, if asked.
    pub(super) fn tensor(
        &mut self,
        subject: &Subject,
        about: PointId,
        lettered: bool,
    ) -> Option<Matrix> {
        if let Some(known) = self.tensors.get(&(subject.body, about)) {
            return Some(known.clone());
        }
        let frame = self.letters.reading.system.bodies[subject.body].frame?;
        let own = self.tensor_on(subject, about, frame, lettered)?;
        let axes = self.plan.axes;
        let tensor = match frame == axes {
            true => own,
            false => {
                let turn = self.letters.system().rotation(axes, frame);
                let turned = mechanics::inertia_in_axes(&turn, &own);
                turned.map(|entry| self.letters.reading.system.atoms.with_squares(&entry))
            }
        };
        if lettered {
            self.tensors.insert((subject.body, about), tensor.clone());
        }
        Some(tensor)
    }

    /// The tensor on the axes of the body.
    fn tensor_on(
        &mut self,
        subject: &Subject,
        about: PointId,
        on: FrameId,
        lettered: bool,
    ) -> Option<Matrix> {
        let tensor = Quantity::Inertia {
            of: Whole::Body(subject.body),
            about,
        };
        let entry = |(row, column): (usize, usize)| Quantity::Entry {
            of: tensor.clone().boxed(),
            row,
            column,
            on,
            integral: false,
        };
        let mut values = vec![];
        for place in ENTRIES {
            let value = self.letters.system().value_of(&entry(place)).ok()?;
            values.push(value.to_scalar().ok()?);
        }
        let told = |story: &mut Self, value: &Fraction| {
            if story.letters.vanishes(value) {
                return Some(Fraction::zero());
            }
            let own = story.own_moment(value);
            own.or_else(|| story.letters.printed(value).map(|_| value.clone()))
        };
        let known: Vec<Option<Fraction>> = values.iter().map(|v| told(self, v)).collect();
        let entries = match known.iter().cloned().collect::<Option<Vec<Fraction>>>() {
            Some(entries) => entries,
            None if !lettered => {
                let each = known.into_iter().zip(values);
                each.map(|(known, value)| known.unwrap_or(value)).collect()
            }
            None => self.new_moments(subject, about, on, &values)?,
        };
        let place = |r: usize, c: usize| {
            let at = ENTRIES.iter().position(|p| *p == (r.min(c), r.max(c)));
            entries[at.unwrap_or(0)].clone()
        };
        Some(Matrix::from_fn(place))
    }

    /// The letter of the author for a moment or product of inertia of this value.
    fn own_moment(&mut self, value: &Fraction) -> Option<Fraction> {
        for letter in &self.letters.reading.letters.letters.clone() {
            let quantity = match &letter.meaning {
                Meaning::Quantity(quantity) if letter.reach == Reach::All => quantity,
                _ => continue,
            };
            let of_inertia = match quantity {
                Quantity::Entry { of, .. } | Quantity::Along { of, .. } => {
                    matches!(**of, Quantity::Inertia { .. })
                }
                _ => false,
            };
            if !of_inertia {
                continue;
            }
            let own = self.letters.value(&letter.latex, quantity)?;
            let own = own.to_scalar().ok()?;
            if self.letters.agree(&own, value) {
                return Some(own);
            }
        }
        None
    }

    /// New letters for a tensor: principal moments, or the tensor itself.
    fn new_moments(
        &mut self,
        subject: &Subject,
        about: PointId,
        on: FrameId,
        values: &[Fraction],
    ) -> Option<Vec<Fraction>> {
        let products: Vec<bool> = values[3..]
            .iter()
            .map(|v| self.letters.vanishes(v))
            .collect();
        let principal = products.into_iter().all(|vanishes| vanishes);
        let index = |latex: &str, label: &str| Text::of_component(latex, label).latex;
        let base = ["I", "J", "\\Theta"].into_iter().find(|base| {
            let labels = self.plan.labels;
            self.letters.is_free(base) && self.letters.is_free(&index(base, labels[0]))
        })?;
        let base = match self.plan.bodies.len() {
            1 => base.to_owned(),
            _ => index(base, &self.label_of_body(subject)),
        };
        let about_term = match about == subject.about {
            true => subject.about_term.clone(),
            false => subject.centre_term.clone(),
        };
        let on_term = self.plan.frames.iter().find(|(f, _)| *f == on)?.1.clone();
        let slots = vec![
            (Slot::Of, subject.term.clone()),
            (Slot::About, about_term),
            (Slot::On, on_term),
        ];
        match principal {
            true => self.principal_letters(&base, slots, subject, about, on, values),
            false => self.tensor_letters(&base, slots, values),
        }
    }

    /// "I_x, I_x, I_z are the principal moments of the top about O on B": equal ones have one letter.
    fn principal_letters(
        &mut self,
        base: &str,
        slots: Vec<(Slot, Term)>,
        subject: &Subject,
        about: PointId,
        on: FrameId,
        values: &[Fraction],
    ) -> Option<Vec<Fraction>> {
        let mut moments: Vec<(String, Fraction)> = vec![];
        for axis in 0..3 {
            let earlier = (0..axis).find(|&j| self.letters.agree(&values[j], &values[axis]));
            let told = match earlier {
                Some(earlier) => moments[earlier].clone(),
                None => {
                    let text = Text::of_component(base, self.plan.labels[axis]);
                    let of = Quantity::Inertia {
                        of: Whole::Body(subject.body),
                        about,
                    };
                    let quantity = Quantity::Entry {
                        of: of.boxed(),
                        row: axis,
                        column: axis,
                        on,
                        integral: false,
                    };
                    let value = self.letters.value(&text.latex, &quantity)?;
                    let value = value.to_scalar().ok()?;
                    self.letters.take(&text.latex);
                    self.letters.name(value.as_variable()?, text.clone());
                    self.letters.hold_constant(value.as_variable()?);
                    (text.latex, value)
                }
            };
            moments.push(told);
        }
        let letters: Vec<&str> = moments.iter().map(|(latex, _)| latex.as_str()).collect();
        let sentence = telling(&letters, NounPhrase::new(heads::PRINCIPAL_MOMENTS, slots)).text;
        self.say(sentence);
        let mut entries: Vec<Fraction> = moments.into_iter().map(|(_, value)| value).collect();
        entries.extend([Fraction::zero(), Fraction::zero(), Fraction::zero()]);
        Some(entries)
    }

    /// "I is the inertia tensor of the body about G on B", whose entries have two labels.
    fn tensor_letters(
        &mut self,
        base: &str,
        slots: Vec<(Slot, Term)>,
        values: &[Fraction],
    ) -> Option<Vec<Fraction>> {
        let integrals = self.letters.reading.letters.customs.integrals;
        let labels = self.plan.labels;
        let mut entries = vec![];
        for ((row, column), value) in ENTRIES.into_iter().zip(values) {
            let label = format!("{}{}", labels[row], labels[column]);
            let text = Text::of_component(base, &label);
            let negative = row != column && integrals;
            let written = match negative {
                true => -value.clone(),
                false => value.clone(),
            };
            let law = crate::verify::model::atoms::Law {
                name: "inertia",
                value: written.clone(),
            };
            let letter = match written.as_variable() {
                Some(variable) => variable,
                None => {
                    let place = crate::algebra::Place::Parameter;
                    let atoms = &mut self.letters.system().atoms;
                    atoms.determined(&text.latex, place, law)
                }
            };
            self.letters.name(letter, text);
            self.letters.hold_constant(letter);
            let letter = crate::verify::model::atoms::fraction(letter);
            entries.push(if negative { -letter } else { letter });
        }
        self.letters.take(base);
        let sentence = telling(&[base], NounPhrase::new(heads::INERTIA_TENSOR, slots)).text;
        self.say(sentence);
        Some(entries)
    }
}
