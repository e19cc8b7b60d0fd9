//! Products, powers and norms.

use crate::algebra::{Fraction, Rational};
use crate::notation::ast::{Factor, Function, Kind, Node, Operator};
use crate::verify::letters::usage::inner;
use crate::verify::values::lower::{Lowered, Lowering, TroubleKind, constant, trouble};
use crate::verify::values::value::{ShapeMismatch, Value};
use num_traits::{One, Zero};

impl Lowering<'_> {
    /// Dots and crosses bind looser than juxtaposition, dots looser than crosses.
    pub(crate) fn product(&mut self, node: &Node, factors: &[Factor]) -> Lowered {
        let ill = |ShapeMismatch(message)| trouble(TroubleKind::IllTyped, node.span, message);
        let mut dotted: Vec<Value> = vec![];
        let mut crossed: Option<Value> = None;
        let mut run: Option<Value> = None;
        let mut crossing = false;
        let close = |run: Option<Value>, crossed: &mut Option<Value>, crossing: bool| {
            let Some(run) = run else { return Ok(()) };
            *crossed = Some(match crossed.take() {
                Some(left) if crossing => left.cross(&run)?,
                _ => run,
            });
            Ok(())
        };
        for (at, factor) in factors.iter().enumerate() {
            // In `a^T a\,1` the number is the unit matrix: nobody multiplies by 1.
            let unit = factor.operator == Operator::Juxtaposed
                && at > 0
                && is_one(&factor.node)
                && !matches!(factors[at - 1].node.kind, Kind::Number(_));
            let value = match unit {
                true => Value::identity(3),
                false => self.value(&factor.node)?,
            };
            // In `r × I · r` the dot is the product of the tensor with what stands behind it.
            let tensor = |run: &Value| run.rows == 3 && run.columns == 3;
            let applied = crossing && factor.operator == Operator::Dot && value.rows == 3;
            let operator = match run.as_ref().filter(|_| applied && crossed.is_some()) {
                Some(run) if tensor(run) => Operator::Juxtaposed,
                _ => factor.operator,
            };
            match operator {
                Operator::Juxtaposed => {
                    run = Some(match run.take() {
                        // Two vectors side by side are a dyad.
                        Some(left) if left.is_vector() && value.is_vector() => {
                            left.times(&value.transposed()).map_err(ill)?
                        }
                        Some(left) => self.juxtaposed(&left, &value).map_err(ill)?,
                        None => value,
                    });
                }
                Operator::Cross => {
                    close(run.take(), &mut crossed, crossing).map_err(ill)?;
                    (run, crossing) = (Some(value), true);
                }
                Operator::Dot => {
                    close(run.take(), &mut crossed, crossing).map_err(ill)?;
                    dotted.extend(crossed.take());
                    (run, crossing) = (Some(value), false);
                }
                Operator::Tensor => {
                    let left = run.take().unwrap_or_else(|| Value::scalar(Fraction::one()));
                    run = Some(match self.circled(&left, &value) {
                        Some(product) => product,
                        None => left.times(&value.transposed()).map_err(ill)?,
                    });
                }
            }
        }
        close(run.take(), &mut crossed, crossing).map_err(ill)?;
        dotted.extend(crossed);
        let mut values = dotted.into_iter();
        let first = values
            .next()
            .unwrap_or_else(|| Value::scalar(Fraction::one()));
        values
            .try_fold(first, |left, right| left.dot(&right))
            .map_err(ill)
    }

    pub(crate) fn power(&mut self, node: &Node, base: &Node, exponent: &Node) -> Lowered {
        let ill = |ShapeMismatch(message)| trouble(TroubleKind::IllTyped, node.span, message);
        let power = self.value(exponent)?;
        let power = power.as_scalar().filter(|power| power.is_polynomial());
        let power = power.and_then(|power| power.numerator().is_constant());
        if let Some(halves) = power.as_ref().and_then(half_power) {
            return self.power_of_root(base, halves);
        }
        let Some(power) = power.and_then(|p| p.to_integer()) else {
            return Err(trouble(
                TroubleKind::Unsupported,
                exponent.span,
                "only whole powers are known",
            ));
        };
        if let Some(square) = self.square_of_norm(base).filter(|_| power == 2) {
            return Ok(square);
        }
        let value = self.value(base)?;
        if power.unsigned_abs() > 16 {
            return Err(trouble(
                TroubleKind::Unsupported,
                exponent.span,
                "the power is too high",
            ));
        }
        if value.is_vector() && power == 2 {
            return value.dot(&value).map_err(ill);
        }
        if power == -1
            && let Some(inverse) = self.quaternion_inverse(&value)
        {
            return Ok(inverse);
        }
        if power == -1
            && let Some(inverse) = self.turned_inverse(base)
        {
            return Ok(inverse);
        }
        let base = if power < 0 {
            value.inverse().map_err(ill)?
        } else {
            value
        };
        let mut product = if base.is_scalar() {
            Value::scalar(Fraction::one())
        } else {
            Value::identity(base.rows)
        };
        for _ in 0..power.unsigned_abs() {
            product = product.times(&base).map_err(ill)?;
        }
        Ok(product)
    }

    /// `x^{3/2}`: so many powers of the root.
    fn power_of_root(&mut self, base: &Node, halves: i64) -> Lowered {
        let value = self.value(base)?;
        if !value.is_scalar() {
            let message = "a root of what is no number";
            return Err(trouble(TroubleKind::Unsupported, base.span, message));
        }
        let root = self.square_root(value.entries[0].clone());
        let power = (0..halves.unsigned_abs()).fold(Fraction::one(), |p, _| p * root.clone());
        Ok(Value::scalar(match halves < 0 {
            true => Fraction::one() / power,
            false => power,
        }))
    }

    /// What stands under the root of a length that is squared.
    fn square_of_norm(&mut self, base: &Node) -> Option<Value> {
        let Kind::Norm(inside) = &inner(base).kind else {
            return None;
        };
        let value = self.value(inside).ok()?;
        let number = value.as_scalar();
        if let Some((real, imaginary)) = number.and_then(|number| self.complex_parts(number)) {
            return Some(Value::scalar(
                real.clone() * real + imaginary.clone() * imaginary,
            ));
        }
        value.is_vector().then(|| value.dot(&value).ok())?
    }

    pub(crate) fn norm(&mut self, inside: &Node) -> Lowered {
        let value = self.value(inside)?;
        if value.rows == value.columns && !value.is_scalar() {
            let determinant = value.determinant();
            return determinant
                .map(Value::scalar)
                .map_err(|ShapeMismatch(m)| trouble(TroubleKind::IllTyped, inside.span, m));
        }
        if let Some(number) = value.as_scalar().cloned() {
            let size = self.kernel(Function::Abs, number);
            return Ok(size.map(Value::scalar).unwrap_or(value));
        }
        let square = value
            .entries
            .iter()
            .fold(Fraction::zero(), |sum, e| sum + e.clone() * e.clone());
        Ok(Value::scalar(self.square_root(square)))
    }

    /// The square root as a kernel of its normal form; of a constant square it is exact.
    pub(crate) fn square_root(&mut self, radicand: Fraction) -> Fraction {
        let radicand = self.theory.normal(&radicand);
        match radicand.to_rational().and_then(|r| r.exact_sqrt()) {
            Some(root) => constant(root),
            None => self.theory.kernel(Function::Sqrt, radicand),
        }
    }
}

/// Twice a power that is half an odd number, and not high.
fn half_power(power: &Rational) -> Option<i64> {
    let halves = (power.clone() * Rational::from(2)).to_integer()?;
    (halves % 2 != 0 && halves.abs() < 8).then_some(halves)
}

fn is_one(node: &Node) -> bool {
    matches!(&node.kind, Kind::Number(n) if n.decimals.is_none() && n.value.is_one())
}
