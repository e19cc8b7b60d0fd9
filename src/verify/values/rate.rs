//! Derivatives in time, seen from the axes used or from space.

use crate::algebra::Fraction;
use crate::notation::ast::{FrameLabel, Kind, Node};
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::lower::{Lowered, Lowering, TroubleKind, trouble};
use crate::verify::values::value::Value;

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
        let seen_from_space = at == Frame::Space && value.is_vector();
        for _ in 0..order {
            value = if seen_from_space {
                self.space_rate(&value)
            } else {
                self.plain_rate(&value)
            };
        }
        Ok(value)
    }

    /// The derivative of each entry.
    pub(crate) fn plain_rate(&mut self, value: &Value) -> Value {
        value.map(|entry| self.theory.atoms.derivative(entry))
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
