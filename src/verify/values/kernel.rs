//! Functions that no polynomial is: sines, roots, exponentials, and derivatives in something other than time.

use crate::algebra::{Fraction, Rational};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::letters::usage::inner;
use crate::verify::reason;
use crate::verify::theory::kernel_facts::turned;
use crate::verify::theory::law::Dynamics;
use crate::verify::values::atoms::Atom;
use crate::verify::values::lower::{Lowering, Trouble, TroubleKind, constant};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::meaning;
use crate::verify::values::value::Value;
use num_traits::{One, Zero};

/// The most that an angle is multiplied out: sin 8x and no more.
const MOST_TURNS: i64 = 8;
/// Angles of a sum that the addition theorem takes apart: each doubles the terms.
const MOST_ANGLES: usize = 5;
/// Terms above times terms below of a fraction that is differentiated.
const MOST_TERMS: usize = 4_000;

impl Lowering<'_> {
    /// A function of an argument in normal form; `None` where nothing is known of it.
    pub(crate) fn kernel(&mut self, function: Function, argument: Fraction) -> Option<Fraction> {
        match function {
            Function::Sin => self.sine_cosine(&argument).map(|(sin, _)| sin),
            Function::Cos => self.sine_cosine(&argument).map(|(_, cos)| cos),
            Function::Tan => self.sine_cosine(&argument).map(|(sin, cos)| sin / cos),
            Function::Cot => self.sine_cosine(&argument).map(|(sin, cos)| cos / sin),
            Function::Sec => self
                .sine_cosine(&argument)
                .map(|(_, cos)| Fraction::one() / cos),
            Function::Csc => self
                .sine_cosine(&argument)
                .map(|(sin, _)| Fraction::one() / sin),
            Function::Sqrt => Some(self.square_root(argument)),
            Function::Abs => {
                let square = match self.complex_parts(&argument) {
                    Some((real, imaginary)) => real.clone() * real + imaginary.clone() * imaginary,
                    None => argument.clone() * argument,
                };
                Some(self.square_root(square))
            }
            Function::Exp if let Some((real, angle)) = self.complex_parts(&argument) => {
                let (sin, cos) = self.sine_cosine(&angle)?;
                let size = self.kernel(Function::Exp, real)?;
                Some(size * (cos + self.imaginary_unit() * sin))
            }
            Function::Exp | Function::Ln if argument.is_zero() && function == Function::Exp => {
                Some(Fraction::one())
            }
            Function::Exp | Function::Ln => Some(self.theory.kernel(function, argument)),
            Function::Sinh | Function::Cosh => {
                let (up, down) = (
                    self.theory.kernel(Function::Exp, argument.clone()),
                    self.theory.kernel(Function::Exp, -argument),
                );
                let half = constant(Rational::from((1, 2)));
                Some(if function == Function::Sinh {
                    (up - down) * half
                } else {
                    (up + down) * half
                })
            }
            _ => None,
        }
    }

    /// The root of −1.
    pub(crate) fn imaginary_unit(&mut self) -> Fraction {
        let minus_one = constant(Rational::from(-1));
        self.theory.kernel(Function::Sqrt, minus_one)
    }

    /// The real and the imaginary part of an expression in real symbols with the imaginary unit in it.
    pub(crate) fn complex_parts(&mut self, value: &Fraction) -> Option<(Fraction, Fraction)> {
        if !self.reading.imaginary {
            return None;
        }
        let unit = self.imaginary_unit().as_variable()?;
        let value = self.theory.normal(value);
        let (above, below) = (value.numerator(), value.denominator());
        if !above.variables().contains(&unit) || below.variables().contains(&unit) {
            return None;
        }
        let part = |power| {
            Fraction::from(above.coefficient_of(unit, power)) / Fraction::from(below.clone())
        };
        Some((part(0), part(1)))
    }

    /// Sine and cosine of a sum of angles, by the addition theorem; each angle is a whole multiple of a monomial, or of half
    /// of one in a document that writes halves, so that sin x and sin 2x meet in the same kernels.
    fn sine_cosine(&mut self, argument: &Fraction) -> Option<(Fraction, Fraction)> {
        // A function of a function stays as it is: taken apart, each one inside would double the work.
        let inside = argument.variables();
        let nested = |&v: &u32| matches!(self.theory.atoms.atom(v), Atom::Kernel { .. });
        let apart = argument.numerator().len() > MOST_ANGLES || inside.iter().any(nested);
        if apart && self.theory.known_angle(argument).is_none() {
            return Some(self.one_angle(argument.clone()));
        }
        let mut total = (Fraction::zero(), Fraction::one());
        let denominator = Fraction::from(argument.denominator().clone());
        for (coefficient, monomial) in argument.numerator().split() {
            let angle = Fraction::from(monomial.clone());
            let whole = angle.clone() * constant(coefficient.clone()) / denominator.clone();
            if let Some((sin, cos)) = self.theory.known_angle(&whole) {
                let (s, c) = total;
                total = (
                    s.clone() * cos.clone() + c.clone() * sin.clone(),
                    c * cos - s * sin,
                );
                continue;
            }
            if let Some((v, n)) = angle.as_variable().zip(coefficient.to_integer())
                && denominator.is_one()
                && n.abs() <= MOST_TURNS
                && let Some(one) = self.theory.cone(v)
            {
                total = turned(total, &one, n);
                continue;
            }
            let parts = if self.theory.setting.half_angles {
                2
            } else {
                1
            };
            let turns = (coefficient.clone() * Rational::from(parts)).to_integer();
            let turns = turns.filter(|n| n.abs() <= parts * MOST_TURNS);
            let (angle, turns) = match turns {
                Some(n) => (
                    Fraction::from(monomial) * constant(Rational::from((1, parts))),
                    n,
                ),
                None => (Fraction::from(monomial) * constant(coefficient), 1),
            };
            let one = self.one_angle(angle / denominator.clone());
            total = turned(total, &one, turns);
        }
        Some(total)
    }

    fn one_angle(&mut self, angle: Fraction) -> (Fraction, Fraction) {
        let sin = self.theory.kernel(Function::Sin, angle.clone());
        (sin, self.theory.kernel(Function::Cos, angle))
    }

    /// ∂ of an operand in scalars or vectors, everything else that is free held fixed.
    pub(crate) fn derivative(
        &mut self,
        node: &Node,
        operand: &Node,
        variables: &[Node],
    ) -> Result<Value, Trouble> {
        let unsupported = |span, message: &str| Trouble {
            kind: TroubleKind::Unsupported,
            message: message.to_owned(),
            span,
        };
        let mut value = self.value(operand)?;
        for variable in variables {
            let time = matches!(&variable.kind, Kind::Symbol(s) if s.name == "t" && s.subscripts.is_empty());
            if time && value.is_vector() {
                // ∂L/∂t beside dL/dt: the rate on the axes that turn.
                value = self.plain_rate(&value);
                continue;
            }
            let by = self.value(variable)?;
            if self.is_of_another_step(operand, variable, &value, &by) {
                let message = "nothing before says at which step the derivative is taken";
                return Err(unsupported(variable.span, message));
            }
            if variables.len() == 1
                && let Some(slope) = self.slope_behind_a_step(operand, &value, &by)
            {
                return Ok(slope);
            }
            if variables.len() == 1
                && let Some(slope) = self.slope_of_function(operand, &by)
            {
                return Ok(slope);
            }
            // The moment is held fixed beside the angular velocity, as ω̇ is what follows from both; not where the moment
            // itself is derived.
            let left_out = self.theory.leave_out_point(&by);
            let held = match self.is_moment(operand) {
                true => Dynamics::Inverse,
                false => Dynamics::Forward,
            };
            let places: Option<Vec<u32>> = by.entries.iter().map(Fraction::as_variable).collect();
            let result = self.with_dynamics(held, |lowering| {
                let jacobian = places.map(|places| lowering.slope(&value, &by, &places));
                lowering.theory.left_out = left_out;
                jacobian
            });
            let symbols_only = Err("a derivative is taken in symbols only");
            match result.unwrap_or(symbols_only) {
                Ok(Some(jacobian)) => value = jacobian,
                Ok(None) => return Err(unsupported(variable.span, reason::BUDGET)),
                Err(message) => return Err(unsupported(variable.span, message)),
            }
            if value.entries.is_empty() {
                return Err(unsupported(node.span, "this derivative has no entries"));
            }
        }
        Ok(value)
    }

    /// The Jacobian of a value in symbols, `None` inside where it is too long.
    fn slope(
        &mut self,
        value: &Value,
        by: &Value,
        places: &[u32],
    ) -> Result<Option<Value>, &'static str> {
        // Sine and cosine of the angle of a cone follow from the motion.
        let free = places
            .iter()
            .all(|&p| self.theory.rule(p).is_none() && self.theory.cone(p).is_none());
        let written = value.entries.iter().flat_map(Fraction::variables);
        let stands = written.into_iter().any(|v| places.contains(&v));
        let jacobian = match free {
            true => Some(self.jacobian(value, places)),
            false if stands => self.slope_as_written(value, by, places).map(Some),
            false => self.slope_in_momentum(value, places).map(Some),
        };
        jacobian
            .ok_or("this symbol is determined by others; the derivative in it is not defined here")
    }

    /// Works with the moment or the rate following from the other.
    pub(crate) fn with_dynamics<R>(
        &mut self,
        dynamics: Dynamics,
        work: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let before = self.theory.setting.dynamics;
        self.theory.set(|setting| setting.dynamics = dynamics);
        let result = work(self);
        self.theory.set(|setting| setting.dynamics = before);
        result
    }

    fn is_moment(&mut self, operand: &Node) -> bool {
        let Kind::Symbol(symbol) = &inner(operand).kind else {
            return false;
        };
        let entity = meaning(symbol, self.reading, &mut self.theory.atoms).entity();
        entity == Some(self.theory.atoms.quantity(Quantity::Moment))
    }

    /// Rows are the entries of the value, columns the variables; a gradient of a scalar is a column. `None` where an
    /// entry is too long a fraction.
    pub(crate) fn jacobian(&mut self, value: &Value, places: &[u32]) -> Option<Value> {
        let entries: Vec<Fraction> = value
            .entries
            .iter()
            .map(|entry| self.theory.normal(entry))
            .collect();
        let long =
            |entry: &Fraction| entry.numerator().len() * entry.denominator().len() > MOST_TERMS;
        if entries.iter().any(long) {
            return None;
        }
        let (rows, columns) = if value.is_scalar() {
            (places.len(), 1)
        } else {
            (entries.len(), places.len())
        };
        Some(Value::from_fn(rows, columns, |r, c| {
            let (entry, place) = if value.is_scalar() {
                (&entries[0], places[r])
            } else {
                (&entries[r], places[c])
            };
            self.partial(entry, place)
        }))
    }

    /// The partial derivative of a fraction in a variable, kernels by the chain rule.
    pub(crate) fn partial(&mut self, fraction: &Fraction, place: u32) -> Fraction {
        let mut slope = fraction.partial(place);
        let variables: Vec<u32> = fraction.variables();
        for variable in variables {
            let Atom::Kernel { function, argument } = self.theory.atoms.atom(variable).clone()
            else {
                continue;
            };
            let inner = self.partial(&argument, place);
            if !inner.is_zero() {
                slope += fraction.partial(variable)
                    * self.theory.atoms.kernel_slope(function, &argument)
                    * inner;
            }
        }
        slope
    }
}
