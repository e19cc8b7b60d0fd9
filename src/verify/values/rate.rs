//! Derivatives in time, seen from the axes used or from space.

use crate::algebra::Fraction;
use crate::notation::ast::{FrameLabel, Kind, Node};
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::lower::{Lowered, Lowering, TroubleKind, trouble};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::{ShapeMismatch, Value};

impl Lowering<'_> {
    pub(crate) fn time_derivative(
        &mut self,
        operand: &Node,
        order: u8,
        label: Option<&FrameLabel>,
    ) -> Lowered {
        let written_out = matches!(&inner(operand).kind, Kind::Matrix(_) | Kind::Tuple(_));
        let mut value = self.value(operand)?;
        let at = match label {
            Some(label) => self.reading.frames.of_label(label).ok_or_else(|| {
                trouble(
                    TroubleKind::Unsupported,
                    label.span,
                    format!("the frame `{}` is not known", label.text),
                )
            })?,
            None if written_out || self.is_column_of_numbers(operand) => Frame::Moving,
            None => {
                self.met_unlabelled |= value.is_vector();
                self.unlabelled
            }
        };
        // A component is a number: every frame sees the same rate.
        let tensor = (value.rows, value.columns) == (3, 3) && label.is_some() && !written_out;
        let seen_from_space = at == Frame::Space;
        for _ in 0..order {
            value = match seen_from_space {
                true if value.is_vector() => self.space_rate(&value),
                true if tensor => self
                    .space_rate_of_tensor(&value)
                    .map_err(|mismatch| trouble(TroubleKind::IllTyped, operand.span, mismatch.0))?,
                _ => self.plain_rate(&value),
            };
        }
        Ok(value)
    }

    /// The derivative of each entry.
    pub(crate) fn plain_rate(&mut self, value: &Value) -> Value {
        value.map(|entry| self.theory.atoms.derivative(entry))
    }

    /// (dA/dt)_space of a tensor with the columns `A_j`: those of (`dA_j`/dt)_space, less A \[Ω\]×.
    fn space_rate_of_tensor(&mut self, value: &Value) -> Result<Value, ShapeMismatch> {
        let columns: [Value; 3] = [0, 1, 2].map(|j| {
            let column = [0, 1, 2].map(|i| value.at(i, j).clone());
            self.space_rate(&Value::column(column))
        });
        let turning = self.theory.atoms.quantity(Quantity::FrameRate);
        let turning = Value::column(self.theory.atoms.vector(turning, 0));
        let turned = value.times(&turning.skew()?)?;
        Value::from_fn(3, 3, |i, j| columns[j].entries[i].clone()).plus(&turned, true)
    }

    /// The rate of a vector seen from space, as variables that the transport law determines.
    pub(crate) fn space_rate(&mut self, value: &Value) -> Value {
        let of: [Fraction; 3] = [0, 1, 2].map(|i| value.entries[i].clone());
        Value::from_fn(3, 1, |r, _| {
            let atom = Atom::SpaceRate {
                of: Box::new(of.clone()),
                component: r as u8,
            };
            variable_fraction(self.theory.atoms.special(atom))
        })
    }
}
