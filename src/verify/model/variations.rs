//! First-order changes: the motion is one of a family of motions, and the change of a quantity is its derivative along the
//! family. It commutes with rates in time, and constants have one only where a sentence tells it.

use crate::algebra::{Fraction, Place, Variable};
use crate::verify::model::atoms::{Atoms, Key, Motion, Nature, Space, fraction, whole};
use num_traits::Zero;

/// What stands before the name of a variable in that of its change: no letter of a document is written so.
const CHANGE: &str = "\\delta\\,";

impl Atoms {
    /// The change of a fraction; `None` where it is not worked out.
    pub(crate) fn change(&mut self, of: &Fraction) -> Option<Fraction> {
        let mut sum = Fraction::zero();
        for variable in of.variables() {
            let change = self.change_of(variable)?;
            if !change.is_zero() {
                sum += of.partial(variable) * change;
            }
        }
        Some(sum)
    }

    /// Says that a constant may have another value in other motions.
    pub(crate) fn vary_constant(&mut self, variable: Variable) {
        let key = self.key_of_change(variable);
        self.variable(key, Place::Parameter, Motion::Constant);
    }

    /// Whether a constant may be another one in other motions by itself.
    pub(crate) fn may_vary(&self, variable: Variable) -> bool {
        let atom = self.atom(variable);
        let own = matches!(atom.nature, Nature::Quantity | Nature::Unknown);
        own && atom.law.is_none()
            && atom.square.is_none()
            && matches!(atom.motion, Motion::Constant)
    }

    /// The variables of which one is a function, or itself.
    pub(crate) fn roots(&self, variable: Variable) -> Vec<Variable> {
        match &self.atom(variable).nature {
            Nature::Sine(of) | Nature::Cosine(of) | Nature::Root(of) | Nature::UnitPart(of) => {
                let inner = of.variables().into_iter().filter(|v| *v != variable);
                inner.flat_map(|v| self.roots(v)).collect()
            }
            _ => vec![variable],
        }
    }

    /// Whether a variable is a change, or a rate of one.
    pub(crate) fn is_change(&self, variable: Variable) -> bool {
        self.atom(variable).key.text.starts_with(CHANGE)
    }

    /// Whether a variable is another one in other motions of the family.
    pub(crate) fn is_varied(&mut self, variable: Variable) -> bool {
        let change = self.change_of(variable);
        change.is_none_or(|change| !change.is_zero())
    }

    fn key_of_change(&self, variable: Variable) -> Key {
        let key = self.atom(variable).key.clone();
        // One text may be a quantity of the model, a number and a letter of which nothing is told.
        let space = match key.space {
            Space::Model | Space::UntoldProduct(_) => "",
            Space::Number => "\\,",
            Space::Letter(_) => "\\;",
            Space::Unknown => "\\:",
        };
        let text = format!("{CHANGE}{space}{}", key.text);
        Key { text, ..key }
    }

    fn change_of(&mut self, variable: Variable) -> Option<Fraction> {
        let key = self.key_of_change(variable);
        if let Some(known) = self.find(&key) {
            return Some(fraction(known));
        }
        let atom = self.atom(variable).clone();
        if let Some(law) = &atom.law {
            return self.change(&law.value);
        }
        if let Some(of) = atom.rate_of {
            let change = self.change_of(of)?;
            return Some(self.derivative(&change));
        }
        match &atom.nature {
            Nature::Sine(angle) | Nature::Cosine(angle) => {
                let (cosine, sine) = self.cosine_sine(angle)?;
                let change = self.change(angle)?;
                Some(match atom.nature {
                    Nature::Sine(_) => cosine * change,
                    _ => -sine * change,
                })
            }
            Nature::Root(inside) | Nature::UnitPart(inside) => {
                Some(self.change(inside)? / (whole(2) * fraction(variable)))
            }
            Nature::Sum(_) => None,
            Nature::Quantity | Nature::Unknown => {
                let untold = atom.square.is_some() || atom.key.blow.is_some();
                (!untold).then(|| self.change_in_motion(variable, key))?
            }
        }
    }

    /// The change of a variable that no law tells, by how it moves.
    fn change_in_motion(&mut self, variable: Variable, key: Key) -> Option<Fraction> {
        let atom = self.atom(variable).clone();
        match &atom.motion {
            Motion::Constant => Some(Fraction::zero()),
            _ if self.known_time() == Some(variable) => Some(Fraction::zero()),
            Motion::Free => {
                let change = self.variable(key, atom.place, Motion::Free);
                self.atom_mut(change).nature = atom.nature;
                Some(fraction(change))
            }
            // Its rate is told by others; they may hang on the variable itself.
            Motion::Rate(rate) => {
                let change = self.variable(key, atom.place, Motion::Constant);
                self.atom_mut(change).nature = atom.nature;
                let rate = self.change(rate);
                self.atom_mut(change).motion = rate.map_or(Motion::Free, Motion::Rate);
                Some(fraction(change))
            }
        }
    }
}
