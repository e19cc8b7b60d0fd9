//! Unit quaternions: columns of four, with Hamilton's product.

use crate::algebra::Fraction;
use crate::mechanics::{quaternion_conjugate, quaternion_product};
use crate::notation::ast::{Style, Symbol};
use crate::verify::model::system::{FrameId, System};
use crate::verify::term::labels::plain;
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::{Basis, Trouble, Value, Valued, beyond};
use nalgebra::Vector4;
use num_traits::Zero;

/// Superscripts that make the conjugate of a quaternion.
const STARS: [&str; 4] = ["*", "ast", "star", "dagger"];

/// Where the scalar stands among the entries of a quaternion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Layout {
    #[default]
    ScalarFirst,
    ScalarLast,
}

impl Layout {
    /// The place of the scalar part, and that of the first entry of the vector part.
    pub(crate) fn places(self) -> (usize, usize) {
        match self {
            Self::ScalarFirst => (0, 1),
            Self::ScalarLast => (3, 0),
        }
    }

    /// The entries as they are written.
    fn written(self, q: &Vector4<Fraction>) -> Value {
        let order = match self {
            Self::ScalarFirst => [0, 1, 2, 3],
            Self::ScalarLast => [1, 2, 3, 0],
        };
        Value::written(4, 1, order.map(|at| q[at].clone()).to_vec())
    }

    /// A column of four as a quaternion, a vector as one without a scalar part.
    fn read(self, value: &Value) -> Vector4<Fraction> {
        let (scalar, vector) = match value.is_quaternion() {
            true => self.places(),
            false => (usize::MAX, 0),
        };
        let entry = |at: usize| value.entries.get(at).cloned();
        let scalar = entry(scalar).unwrap_or_else(Fraction::zero);
        let [x, y, z] = [0, 1, 2].map(|k| entry(vector + k).unwrap_or_else(Fraction::zero));
        Vector4::new(scalar, x, y, z)
    }
}

impl Value {
    /// Whether it is a column of four.
    pub(crate) fn is_quaternion(&self) -> bool {
        (self.rows, self.columns) == (4, 1)
    }

    /// The conjugate of a quaternion.
    pub(crate) fn conjugate(&self, layout: Layout) -> Self {
        layout.written(&quaternion_conjugate(&layout.read(self)))
    }
}

impl System {
    /// The unit quaternion by which q v q* takes components on one frame to components on another, where one of them turns
    /// freely against the other.
    pub(crate) fn quaternion(
        &mut self,
        to: FrameId,
        from: FrameId,
        layout: Layout,
    ) -> Option<Value> {
        let q = self.unit_quaternion(to, from)?;
        Some(layout.written(&q))
    }

    /// Hamilton's product of quaternions; a list of three is one without a scalar part, and so is an array.
    pub(crate) fn quaternion_product(&mut self, a: &Value, b: &Value, layout: Layout) -> Valued {
        let (a, b) = (self.as_list(a)?, self.as_list(b)?);
        let product = quaternion_product(&layout.read(&a), &layout.read(&b));
        Ok(layout.written(&product))
    }

    /// A vector beside a quaternion as one without a scalar part.
    pub(crate) fn without_scalar(&mut self, value: &Value, layout: Layout) -> Valued {
        let list = self.as_list(value)?;
        Ok(layout.written(&layout.read(&list)))
    }

    /// The entries of an array, on its own axes.
    pub(crate) fn as_list(&mut self, value: &Value) -> Valued {
        match value.basis[0] {
            Basis::Itself if !value.is_zero() => {
                beyond("a vector beside a quaternion whose components are on no frame")
            }
            Basis::On(frame) => self.written_out(value, frame),
            _ => Ok(value.clone()),
        }
    }
}

impl Lowering<'_> {
    /// Two values that are added or compared, both as quaternions where one of them is.
    pub(crate) fn beside_quaternions(
        &mut self,
        a: Value,
        b: Value,
    ) -> Result<(Value, Value), Trouble> {
        match a.is_quaternion() || b.is_quaternion() {
            true => Ok((self.as_quaternion(a)?, self.as_quaternion(b)?)),
            false => Ok((a, b)),
        }
    }

    /// A value beside a quaternion: a number is one without a vector part, a vector one without a scalar part, and a row of four
    /// is a list as a column is.
    fn as_quaternion(&mut self, value: Value) -> Valued {
        let layout = self.letters.customs.layout;
        match value.is_vector() {
            true => self.system.without_scalar(&value, layout),
            false if value.is_scalar() && !value.is_zero() => {
                let scalar = value.to_scalar()?;
                let zero = Fraction::zero;
                Ok(layout.written(&Vector4::new(scalar, zero(), zero(), zero())))
            }
            false if (value.rows, value.columns) == (1, 4) => Ok(value.transposed()),
            false => Ok(value),
        }
    }

    /// q*, q̄: the conjugate of a quaternion.
    pub(super) fn conjugate(&mut self, symbol: &Symbol) -> Result<Option<Value>, Trouble> {
        let mut base = symbol.clone();
        let star = symbol.superscripts.last().map(|label| plain(label));
        if star.is_some_and(|star| STARS.contains(&star.as_str())) {
            base.superscripts.pop();
        } else if symbol.style.bar {
            base.style = Style {
                bar: false,
                vector: false,
                ..base.style
            };
        } else {
            return Ok(None);
        }
        let value = self.known(&base)?.map(|(value, _)| value);
        let quaternion = value.filter(Value::is_quaternion);
        Ok(quaternion.map(|q| q.conjugate(self.letters.customs.layout)))
    }

    /// q*/|q|².
    pub(super) fn inverse_quaternion(&mut self, value: &Value) -> Valued {
        let custom = self.custom();
        let square = self.system.dot(value, value, custom)?;
        let conjugate = value.conjugate(self.letters.customs.layout);
        self.system.quotient(&conjugate, &square)
    }
}
