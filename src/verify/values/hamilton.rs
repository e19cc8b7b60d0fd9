//! Quaternions in formulas: columns of four in the document's own layout, and Hamilton's product of them.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::notation::ast::{Kind, Node};
use crate::verify::letters::attitude_reading::Part;
use crate::verify::letters::usage::inner;
use crate::verify::values::atoms::Entity;
use crate::verify::values::lower::Lowering;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::{Meaning, meaning};
use crate::verify::values::value::{ShapeMismatch, Value};
use nalgebra::Vector4;
use num_traits::Zero;

impl Lowering<'_> {
    /// The value of a part of the attitude quaternion.
    pub(crate) fn quaternion_part(&mut self, entity: Entity, part: Part) -> Value {
        let whole = Vector4::from_fn(|i, _| self.theory.atoms.value(entity, i as u8, 0));
        match part {
            Part::Whole => self.column_of_four(&whole),
            Part::Conjugate => self.column_of_four(&mechanics::quaternion_conjugate(&whole)),
            Part::Vector => Value::column([whole[1].clone(), whole[2].clone(), whole[3].clone()]),
            Part::Number(at) => Value::scalar(whole[usize::from(at) % 4].clone()),
        }
    }

    /// Whether this is a quaternion, in a document that has such.
    fn is_quaternion(&self, value: &Value) -> bool {
        self.reading.attitude.quaternion.is_some() && (value.rows, value.columns) == (4, 1)
    }

    /// The product by Hamilton's rule where one factor is a quaternion and the other one too, or a vector.
    pub(crate) fn hamilton(&self, left: &Value, right: &Value) -> Option<Value> {
        let one = self.is_quaternion(left) || self.is_quaternion(right);
        let fits = |value: &Value| self.is_quaternion(value) || value.is_vector();
        if !(one && fits(left) && fits(right)) {
            return None;
        }
        let (left, right) = (self.scalar_first(left)?, self.scalar_first(right)?);
        Some(self.column_of_four(&mechanics::quaternion_product(&left, &right)))
    }

    /// The same for `\otimes`, which in a document that multiplies quaternions by it makes no dyad of two vectors either.
    pub(crate) fn circled(&self, left: &Value, right: &Value) -> Option<Value> {
        if !(self.reading.attitude.circled && left.is_vector() && right.is_vector()) {
            return self.hamilton(left, right);
        }
        let (left, right) = (self.scalar_first(left)?, self.scalar_first(right)?);
        Some(self.column_of_four(&mechanics::quaternion_product(&left, &right)))
    }

    /// Juxtaposed factors: of quaternions, of matrices, of numbers.
    pub(crate) fn juxtaposed(&self, left: &Value, right: &Value) -> Result<Value, ShapeMismatch> {
        match self.hamilton(left, right) {
            Some(value) => Ok(value),
            None => left.times(right),
        }
    }

    /// Two summands, or two sides, of which one is a quaternion or makes one with the other: a number stands for the
    /// scalar part, a vector for the vector part.
    pub(crate) fn aligned(&self, left: Value, right: Value) -> (Value, Value) {
        let scalar = |value: &Value| value.is_scalar() && !value.is_zero();
        let mixed = (scalar(&left) && right.is_vector()) || (left.is_vector() && scalar(&right));
        let one = self.is_quaternion(&left) || self.is_quaternion(&right);
        let fits = |value: &Value| self.is_quaternion(value) || value.is_vector() || scalar(value);
        let speaks = self.reading.attitude.quaternion.is_some();
        if !speaks || !(mixed || one) || !(fits(&left) && fits(&right)) {
            return (left, right);
        }
        match (self.scalar_first(&left), self.scalar_first(&right)) {
            (Some(a), Some(b)) => (self.column_of_four(&a), self.column_of_four(&b)),
            _ => (left, right),
        }
    }

    /// The sides of a line: where one is a quaternion, numbers and vectors beside it are too.
    pub(crate) fn sides_aligned(&self, sides: Vec<Value>) -> Vec<Value> {
        match sides.iter().find(|side| self.is_quaternion(side)).cloned() {
            Some(like) => sides
                .into_iter()
                .map(|side| self.aligned(side, like.clone()).0)
                .collect(),
            None => sides,
        }
    }

    /// A quaternion to the power −1: its conjugate over the square of its length.
    pub(crate) fn quaternion_inverse(&self, value: &Value) -> Option<Value> {
        let q = self
            .is_quaternion(value)
            .then(|| self.scalar_first(value))??;
        let square = q.dot(&q);
        let inverse = mechanics::quaternion_conjugate(&q).map(|part| part / square.clone());
        Some(self.column_of_four(&inverse))
    }

    /// `R(q)`: the attitude matrix of a quaternion.
    pub(crate) fn matrix_of(&mut self, head: &Node, at: &Value) -> Option<Value> {
        let Kind::Symbol(symbol) = &inner(head).kind else {
            return None;
        };
        let Meaning::Whole(entity) = meaning(symbol, self.reading, &mut self.theory.atoms) else {
            return None;
        };
        let attitude = self.theory.atoms.quantity(Quantity::Attitude);
        if entity != attitude || !self.is_quaternion(at) {
            return None;
        }
        let convention = self.theory.setting.attitude;
        let q = self.scalar_first(at)?;
        let square = self.theory.normal(&q.dot(&q));
        let turned = mechanics::rotation(&q).map(|entry| entry / square.clone());
        let turned = match convention.matrix_to_body == convention.quaternion_to_body {
            true => turned,
            false => turned.transpose(),
        };
        Some(Value::from_fn(3, 3, |r, c| turned[(r, c)].clone()))
    }

    /// Numbers and columns in one list: `(η, ε)`.
    pub(crate) fn stacked(&self, values: &[Value]) -> Option<Value> {
        let columns = values.iter().all(|v| v.columns == 1);
        let several = values.iter().any(|v| v.rows > 1);
        (columns && several).then(|| {
            let entries: Vec<Fraction> = values.iter().flat_map(|v| v.entries.clone()).collect();
            Value::column(entries)
        })
    }

    /// The four numbers, scalar first.
    fn scalar_first(&self, value: &Value) -> Option<Vector4<Fraction>> {
        let e = |i: usize| value.entries[i].clone();
        match value.entries.len() {
            1 => Some(Vector4::new(
                e(0),
                Fraction::zero(),
                Fraction::zero(),
                Fraction::zero(),
            )),
            3 => Some(Vector4::new(Fraction::zero(), e(0), e(1), e(2))),
            4 if self.reading.attitude.scalar_last => Some(Vector4::new(e(3), e(0), e(1), e(2))),
            4 => Some(Vector4::new(e(0), e(1), e(2), e(3))),
            _ => None,
        }
    }

    fn column_of_four(&self, q: &Vector4<Fraction>) -> Value {
        let [w, x, y, z] = [0, 1, 2, 3].map(|i| q[i].clone());
        if self.reading.attitude.scalar_last {
            Value::column([x, y, z, w])
        } else {
            Value::column([w, x, y, z])
        }
    }
}
