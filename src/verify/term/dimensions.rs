//! Quantities where space has another number of dimensions than three.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::model::system::{FrameId, System};
use crate::verify::term::quantity::{Quantity, Spot};
use crate::verify::term::value::Trouble::Beyond;
use crate::verify::term::value::{Basis, Trouble, Value, Valued};
use nalgebra::{DMatrix, DVector};
use num_traits::{One, Zero};

/// Why something has no value in this space.
pub(super) fn beyond_space() -> Trouble {
    Beyond("this is worked out in three dimensions alone".into())
}

fn itself(vector: &DVector<Fraction>) -> Value {
    Value {
        basis: [Basis::Itself, Basis::Any],
        ..Value::written(vector.len(), 1, vector.iter().cloned().collect())
    }
}

impl System {
    /// The identity matrix, with its indices on these axes.
    pub(super) fn identity(&self, basis: [Basis; 2]) -> Value {
        let size = self.dimensions();
        let entry = |at: usize| match at / size == at % size {
            true => Fraction::one(),
            false => Fraction::zero(),
        };
        Value {
            basis,
            ..Value::written(size, size, (0..size * size).map(entry).collect())
        }
    }

    /// The matrix that takes what a frame carries to its rate, seen from another frame: `[ω]×`.
    pub(super) fn turning(&mut self, of: FrameId, relative: FrameId, basis: Basis) -> Valued {
        if self.dimensions() == 3 {
            let omega = self.angular_velocity(of, relative);
            return Ok(Value::matrix(&mechanics::skew(&omega), [basis; 2]));
        }
        let matrix: DMatrix<Fraction> = self
            .angular_velocity_matrix(of, relative)
            .ok_or_else(beyond_space)?;
        let entries = matrix.transpose().iter().cloned().collect();
        Ok(Value {
            basis: [basis; 2],
            ..Value::written(matrix.nrows(), matrix.ncols(), entries)
        })
    }

    /// The value of a quantity in space of another number of dimensions.
    pub(super) fn value_in_space(&mut self, quantity: &Quantity) -> Valued {
        let rate = |of: Quantity, seen: FrameId| Quantity::Rate {
            of: of.boxed(),
            seen,
        };
        match quantity {
            Quantity::Identity => Ok(self.identity([Basis::Any; 2])),
            Quantity::Rotation { from, to } => {
                Ok(self.identity([Basis::On(*to), Basis::On(*from)]))
            }
            Quantity::Vector { text, carried } => {
                let vector = self.vector_in_space(text, *carried);
                Ok(itself(&vector.ok_or_else(beyond_space)?))
            }
            Quantity::Position {
                of: Spot::Point(of),
                from,
            } => {
                let way = self.position_in_space(*of, *from);
                Ok(itself(&way.ok_or_else(beyond_space)?))
            }
            Quantity::Velocity { of, relative } => {
                let from = self.fixed_point(*relative);
                let of = of.clone();
                self.composed(&rate(Quantity::Position { of, from }, *relative))
            }
            Quantity::Acceleration { of, relative } => {
                let (of, relative) = (of.clone(), *relative);
                self.composed(&rate(Quantity::Velocity { of, relative }, relative))
            }
            Quantity::Rate { .. } | Quantity::On(..) | Quantity::Scaled(..) | Quantity::Sum(_) => {
                self.composed(quantity)
            }
            Quantity::Scalar { .. } => self.value_of_letter(quantity),
            Quantity::Known(value) | Quantity::ByRule(value) if value.is_scalar() => {
                Ok(value.clone())
            }
            _ => Err(beyond_space()),
        }
    }
}
