//! Letters of tensors and vectors that stand for numbers in a line that gives something a name.

use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::Letter;
use crate::verify::values::quantity::{Quantity, Shape};
use std::collections::BTreeSet;

impl Checker<'_> {
    /// Whether a side is read as a tensor or a vector and is none: the C of `M = C n\Omega` is only ever a number, and the
    /// L of `p = L/I_1` has a mark wherever it is a vector.
    pub(crate) fn is_made_of_numbers(&mut self, side: &Node, bare: &BTreeSet<Letter>) -> bool {
        let Ok(value) = self.lowering(Frame::Moving).value(side) else {
            return false;
        };
        let vector = value.is_vector();
        // A matrix in front of it is no factor of a number.
        let met = self.entities([side]);
        let mut shapes = met.iter().map(|&e| self.theory.atoms.info(e).shape);
        if vector
            && shapes
                .any(|shape| !matches!(shape, Shape::Scalar | Shape::Vector | Shape::Symmetric))
        {
            return false;
        }
        let quantity = |letter: &Letter| self.reading.quantities.get(letter).copied();
        let several =
            |letter: &&Letter| quantity(letter).is_some_and(|q| q.shape() != Shape::Scalar);
        let letters: Vec<&Letter> = bare.iter().filter(several).collect();
        let number = |letter: &&Letter| {
            let used = self.reading.usage.get(letter);
            match quantity(letter) {
                Some(Quantity::Inertia) => !vector && !used.is_directed(),
                Some(q) => {
                    let marked = used.vector > 0 && used.crossed_bare == 0;
                    vector && q.shape() == Shape::Vector && marked
                }
                None => false,
            }
        };
        let tensor = value.rows == 3 && value.columns == 3;
        (vector || tensor) && !letters.is_empty() && letters.iter().all(number)
    }
}
