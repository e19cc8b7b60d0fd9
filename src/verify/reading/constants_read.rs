//! What does not change: letters, quantities, gravity.

use crate::algebra::Fraction;
use crate::verify::language::heads::OF_BEARINGS;
use crate::verify::language::statement::{Declaration, NounPhrase, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::is_marked_vector;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// Letters of their own that do not change; of a quantity the rate vanishes.
    /// "The kinetic energy of P is constant": its rate vanishes.
    fn hold_constant(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<()> {
        let quantity = self.quantity(phrase, declaration)?;
        let value = self.system().value_of(&quantity).ok()?.to_scalar().ok()?;
        let rate = self.system().atoms.derivative(&value);
        self.hold(rate, declaration);
        Some(())
    }

    pub(super) fn read_constants(&mut self, subjects: &[Term], declaration: &Declaration) {
        for subject in subjects {
            if let Term::Phrase(phrase) = subject
                && self.hold_constant(phrase, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
        for formula in formulas(subjects) {
            let quantity = self.quantity_of(formula, declaration);
            let value = match &quantity {
                Some(quantity) => self.system().value_of(quantity).ok(),
                // A letter by which a frame turns or a point is placed stands in the model already.
                None if self.is_told(formula, declaration) => {
                    self.mentioned_value(formula, declaration)
                }
                None => None,
            };
            match (value, quantity) {
                (Some(value), _) => {
                    for entry in self.rates_of_constant(formula, &value) {
                        self.hold(entry, declaration);
                    }
                }
                (None, Some(_)) => {}
                (None, None) => {
                    let text = formula.source.clone();
                    let quantity = Quantity::Scalar {
                        text,
                        constant: true,
                    };
                    self.denote(formula, Meaning::Quantity(quantity), declaration);
                }
            }
        }
    }

    /// g: a vector that does not change in space, or its size along the vertical.
    pub(super) fn read_gravity(&mut self, subjects: &[Term], declaration: &Declaration) {
        let Some(formula) = formulas(subjects).next().cloned() else {
            return;
        };
        let vector = is_marked_vector(&formula);
        let ground = self.reading.system.ground;
        let text = formula.source.clone();
        if vector {
            let quantity = Quantity::Vector {
                text,
                carried: Some(ground),
            };
            self.gravity = Some(quantity.clone());
            return self.denote(&formula, Meaning::Quantity(quantity), declaration);
        }
        let quantity = Quantity::Scalar {
            text,
            constant: true,
        };
        self.denote(&formula, Meaning::Quantity(quantity.clone()), declaration);
        // Where a sentence on it was not understood, nothing else tells where up is.
        let mut all = self.declarations.iter();
        if self.bearings.vertical.is_none() && all.any(|d| d.may_speak_of(&OF_BEARINGS)) {
            return;
        }
        let size = self
            .system()
            .value_of(&quantity)
            .ok()
            .and_then(|v| v.to_scalar().ok());
        let vertical = self.vertical();
        let axis = match self.has_plane_anyhow() {
            true => Quantity::UnitVector {
                text: "\\text{up}".into(),
                carried: Some(ground),
            },
            false => Quantity::Axis(vertical.frame, vertical.axis),
        }
        .boxed();
        // How great it is, in the direction in which things fall.
        if let Some(g) = &size {
            self.system().atoms.set_positive(g);
        }
        let along = |g: Fraction| if vertical.points_down { g } else { -g };
        self.gravity = size.map(|g| Quantity::Scaled(axis, along(g)));
    }
}
