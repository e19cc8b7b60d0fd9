//! Letters that are lengths of vectors: each is told by its square.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::statement::{Declaration, Extent, Formula};
use crate::verify::reading::builder::Builder;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::{Quantity, Spot};
use crate::verify::term::value::Value;
use num_traits::Zero;

impl Builder<'_> {
    /// The square of a length that is no root of its own.
    pub(super) fn square_of_length(&mut self, quantity: &Quantity) -> Option<Fraction> {
        let across = match quantity {
            Quantity::Magnitude(of) if !of.is_indexed() => self.vector_of(of)?,
            Quantity::Distance { of, from, axis } if !matches!(of, Spot::Member(..)) => {
                let way = self.system().place(of, *from);
                let axis = self.vector_of(axis)?;
                mechanics::cross(&axis, &way)
            }
            _ => return None,
        };
        Some(across.dot(&across))
    }

    /// A length is a letter of its own, whose square is told.
    pub(super) fn read_length(
        &mut self,
        formula: &Formula,
        square: Fraction,
        declaration: &Declaration,
    ) {
        if let Some(root) = self.system().atoms.known_root(&square)
            && self.reading.system.atoms.has_steady_sines(&root)
        {
            let known = Quantity::Known(Value::scalar(root));
            return self.denote(formula, Meaning::Quantity(known), declaration);
        }
        let rate = self.system().atoms.derivative(&square);
        // In a part of the document it may be another length than elsewhere: a letter of its own, written alike.
        let text = match &declaration.extent {
            Extent::Document => formula.source.clone(),
            _ => format!("{}\\,", formula.source),
        };
        let quantity = Quantity::Scalar {
            text,
            constant: rate.is_zero(),
        };
        let Ok(value) = self.system().value_of(&quantity) else {
            return;
        };
        self.denote(formula, Meaning::Quantity(quantity), declaration);
        let letter = value.entries[0].clone();
        if let Some(length) = letter.as_variable() {
            self.system().atoms.set_length(length);
        }
        if let (Extent::Document, Some(length)) = (&declaration.extent, letter.as_variable()) {
            self.system().atoms.tell_root(square.clone(), length);
        }
        self.hold(letter.clone() * letter - square, declaration);
    }
}
