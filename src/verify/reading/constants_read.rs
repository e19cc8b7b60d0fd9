//! What does not change: letters, quantities, gravity.

use crate::verify::language::heads::OF_BEARINGS;
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{is_marked_vector, node_of, tells_gravity};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// "The kinetic energy of P is constant": its rate vanishes.
    fn hold_constant(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<()> {
        let quantity = self.quantity(phrase, declaration)?;
        let value = self.system().value_of(&quantity).ok()?.to_scalar().ok()?;
        let rate = self.system().atoms.derivative(&value);
        self.hold(rate, declaration);
        Some(())
    }

    /// "`$k$` is a positive constant."
    pub(super) fn read_constants_said(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        self.read_constants(subjects, declaration);
        if what.is("positive") {
            self.read_positive(subjects, declaration);
        }
    }

    /// Letters of their own that do not change; of a quantity the rate vanishes.
    pub(super) fn read_constants(&mut self, subjects: &[Term], declaration: &Declaration) {
        for subject in subjects {
            if let Term::Phrase(phrase) = subject
                && self.hold_constant(phrase, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
        for formula in formulas(subjects) {
            self.name_defined_by_line(formula, declaration);
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
                    self.denote_number(formula, declaration);
                }
            }
        }
    }

    /// A letter that nothing but a line tells is one everywhere: here it does not change.
    fn name_defined_by_line(&mut self, formula: &Formula, declaration: &Declaration) {
        let told =
            self.quantity_of(formula, declaration).is_some() || self.is_told(formula, declaration);
        if told || !node_of(formula).is_some_and(|node| self.has_defined_by_line(node)) {
            return;
        }
        let quantity = Quantity::Scalar {
            text: formula.source.clone(),
            constant: false,
        };
        let everywhere = Declaration {
            extent: Extent::Document,
            ..declaration.clone()
        };
        self.denote(formula, Meaning::Quantity(quantity), &everywhere);
    }

    /// "`$k$` is a scalar": a number of its own that may change, where nothing else tells what it is.
    pub(super) fn read_scalars(&mut self, subjects: &[Term], declaration: &Declaration) {
        for formula in formulas(subjects) {
            if self.quantity_of(formula, declaration).is_none()
                && !self.is_told(formula, declaration)
            {
                let quantity = Quantity::Scalar {
                    text: formula.source.clone(),
                    constant: false,
                };
                self.denote(formula, Meaning::Quantity(quantity), declaration);
            }
        }
    }

    /// g: a vector that does not change in space, or its size along the vertical.
    pub(super) fn read_gravity(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let Some(formula) = formulas(subjects).next().cloned() else {
            return;
        };
        let on = what.slot(Slot::On).and_then(|on| self.frame(on));
        let ground = self.reading.system.ground;
        let text = formula.source.clone();
        if is_marked_vector(&formula) || on.is_some() {
            let free = Quantity::Vector {
                text,
                carried: Some(ground),
            };
            let size = self.size_of_gravity();
            let quantity = match self.bearings.vertical {
                Some(_) => self.along_vertical(&size.unwrap_or_else(own_gravity)),
                None => {
                    if let Some(size) = size {
                        self.tie_gravity(&free, &size, declaration);
                    }
                    None
                }
            };
            let quantity = quantity.unwrap_or(free);
            self.gravity = Some(quantity.clone());
            let quantity = match on {
                Some(frame) => Quantity::On(quantity.boxed(), frame),
                None => quantity,
            };
            return self.denote(&formula, Meaning::Quantity(quantity), declaration);
        }
        let quantity = self.denote_number(&formula, declaration);
        if !matches!(self.gravity, Some(Quantity::Vector { .. })) {
            self.gravity = self.along_vertical(&quantity);
        }
    }

    /// The letter of how great gravity is, where a sentence of its own tells it.
    fn size_of_gravity(&self) -> Option<Quantity> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what }
                if tells_gravity(what) && what.slot(Slot::On).is_none() =>
            {
                let letter = formulas(subjects).find(|letter| !is_marked_vector(letter))?;
                Some(Quantity::Scalar {
                    text: letter.source.clone(),
                    constant: true,
                })
            }
            _ => None,
        })
    }

    /// The square of a vector is that of its size.
    fn tie_gravity(&mut self, vector: &Quantity, size: &Quantity, declaration: &Declaration) {
        let Some(vector) = self.vector_of(vector) else {
            return;
        };
        let size = self.system().value_of(size).ok();
        if let Some(size) = size.and_then(|size| size.to_scalar().ok()) {
            self.system().atoms.set_positive(&size);
            self.hold(vector.dot(&vector) - size.clone() * size, declaration);
        }
    }

    /// The acceleration of gravity; where weights are spoken of and no sentence tells its letter, it has one of its own.
    pub(super) fn gravity(&mut self) -> Option<Quantity> {
        let mut said = self.declarations.iter();
        let told =
            said.any(|d| matches!(&d.statement, Statement::Is { what, .. } if tells_gravity(what)));
        if self.gravity.is_none() && !told {
            self.gravity = self.along_vertical(&own_gravity());
        }
        self.gravity.clone()
    }

    /// How great gravity is, in the direction in which things fall.
    fn along_vertical(&mut self, size: &Quantity) -> Option<Quantity> {
        // Where no sentence tells where up is, or one on it was not understood, nothing else does.
        let mut all = self.declarations.iter();
        let told = self.tells_vertical() || self.has_plane_anyhow();
        if self.bearings.vertical.is_none() && (!told || all.any(|d| d.may_speak_of(&OF_BEARINGS)))
        {
            return None;
        }
        let size = self.system().value_of(size).ok()?.to_scalar().ok()?;
        let vertical = self.vertical();
        let axis = match self.has_plane_anyhow() {
            true => Quantity::UnitVector {
                text: "\\text{up}".into(),
                carried: Some(self.reading.system.ground),
            },
            false => Quantity::Axis(vertical.frame, vertical.axis),
        };
        self.system().atoms.set_positive(&size);
        let along = if vertical.points_down { size } else { -size };
        Some(Quantity::Scaled(axis.boxed(), along))
    }
}

/// How great gravity is, where no sentence tells its letter.
fn own_gravity() -> Quantity {
    Quantity::Scalar {
        text: "\\text{gravity}".into(),
        constant: true,
    }
}
