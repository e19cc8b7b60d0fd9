//! What does not change, and what is so by custom alone.

use crate::algebra::{Fraction, Place, Variable};
use crate::verify::model::atoms::{Atoms, Motion};
use num_traits::Zero;

impl Atoms {
    /// Whether a value is made up of what never changes.
    pub(crate) fn is_constant(&self, value: &Fraction) -> bool {
        let constant = |v| {
            let atom = self.atom(v);
            let rests = match &atom.motion {
                Motion::Constant => true,
                Motion::Rate(rate) => rate.is_zero(),
                Motion::Free => false,
            };
            rests || atom.place == Place::Parameter
        };
        value.variables().into_iter().all(constant)
    }

    /// Takes a letter as constant because nothing tells that it changes.
    pub(crate) fn hold_by_custom(&mut self, letter: Variable) {
        let atom = self.atom(letter);
        let known = matches!(atom.motion, Motion::Constant) || self.by_custom.contains_key(&letter);
        if !known {
            self.by_custom.insert(letter, false);
            self.set_motion(letter, Place::Parameter, Motion::Constant);
        }
    }

    /// Whether a letter is constant by custom alone.
    pub(crate) fn is_held_by_custom(&self, letter: Variable) -> bool {
        self.by_custom.get(&letter) == Some(&false)
    }

    /// Something tells that a letter changes, if it was constant by custom alone.
    pub(crate) fn let_change(&mut self, letter: Variable) {
        if self.is_held_by_custom(letter) {
            self.by_custom.insert(letter, true);
            self.set_motion(letter, Place::Coordinate, Motion::Free);
        }
    }

    /// A sentence tells that a letter is constant: no custom is needed, and nothing else counts.
    pub(crate) fn hold_by_word(&mut self, letter: Variable) {
        if self.by_custom.remove(&letter) == Some(true) {
            self.set_motion(letter, Place::Parameter, Motion::Constant);
        }
    }

    fn set_motion(&mut self, letter: Variable, place: Place, motion: Motion) {
        let atom = self.atom_mut(letter);
        (atom.place, atom.motion) = (place, motion);
    }
}
