//! An attitude matrix that a line writes out, for an example: `R = \begin{bmatrix} \cos\theta & … \end{bmatrix}`.
//!
//! Its entries are then what the line says and no polynomials in a quaternion, and the angular velocity follows from them.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::{Atom, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::Finding;
use num_traits::{One, Zero};

impl Checker<'_> {
    /// Turns to the matrix that a line gives as the attitude, where it is orthogonal; whether it does.
    pub(crate) fn writes_attitude_out(&mut self, sides: &[Node]) -> bool {
        let given = self.attitude_written_out(sides).is_some();
        if given {
            self.theory.set(|setting| setting.attitude_given = true);
        }
        given
    }

    fn attitude_written_out(&mut self, sides: &[Node]) -> Option<Value> {
        let [left, right] = sides else { return None };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return None;
        };
        let attitude = self.theory.atoms.quantity(Quantity::Attitude);
        if !matches!(self.meaning_of(symbol), Meaning::Whole(entity) if entity == attitude) {
            return None;
        }
        let written = self.lowering(Frame::Moving).value(right).ok()?;
        let product = written.transposed().times(&written);
        let unit = product.and_then(|product| product.plus(&Value::identity(3), true));
        let orthogonal = unit.is_ok_and(|rest| {
            let mut rests = rest.entries.iter();
            rests.all(|entry| self.theory.normal(entry).is_zero())
        });
        let own = |v: Variable| !self.is_of_attitude(v);
        let variables = written.entries.iter().flat_map(|entry| entry.variables());
        let given = orthogonal && written.entries.len() == 9 && variables.into_iter().all(own);
        given.then_some(written)
    }

    /// Takes in, of words that claim nothing, the matrix of a turn about one axis by a positive angle.
    pub(crate) fn gives_a_turn(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let free = !self.asserted && !self.theory.setting.attitude_given;
        let Some(written) = self.attitude_written_out(sides).filter(|_| free) else {
            return false;
        };
        let to_space = match self.theory.setting.attitude.matrix_to_body {
            true => written.transposed(),
            false => written,
        };
        let is_sine = |entry: &Fraction| {
            let atom = entry.as_variable().map(|v| self.theory.atoms.atom(v));
            matches!(
                atom,
                Some(Atom::Kernel {
                    function: Function::Sin,
                    ..
                })
            )
        };
        let either = self.reading.turned_primes;
        let about = |k: usize| {
            let [up, down] = [(k + 2, k + 1), (k + 1, k + 2)];
            let positive = |(r, c): (usize, usize)| is_sine(to_space.at(r % 3, c % 3));
            to_space.at(k, k).is_one() && (positive(up) || either && positive(down))
        };
        if !(0..3).any(about) {
            return false;
        }
        self.given(sides, finding);
        true
    }

    /// Leaves the matrix of an example, where no line in force gives it any more.
    pub(crate) fn end_given_attitude(&mut self) {
        if !self.theory.setting.attitude_given {
            return;
        }
        let premises = self.theory.premises().iter();
        let mut variables = premises
            .flat_map(|p| &p.residuals)
            .flat_map(|r| r.variables());
        if !variables.any(|v| self.is_of_attitude(v)) {
            self.theory.set(|setting| setting.attitude_given = false);
        }
    }

    fn is_of_attitude(&self, variable: Variable) -> bool {
        let owner = self.theory.atoms.owner(variable);
        matches!(
            owner,
            Some(Owner::Quantity(
                Quantity::Attitude | Quantity::Quaternion,
                _
            ))
        )
    }
}
