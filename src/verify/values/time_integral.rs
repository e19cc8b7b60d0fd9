//! Definite integrals over time or another letter, of powers, sines and cosines, and exponentials of it.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::reason;
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::figures::is_pi;
use crate::verify::values::lower::{Lowered, Lowering, TroubleKind, constant, trouble};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use num_traits::{One, Zero};

/// The highest power of a function that is integrated.
const MOST: u32 = 12;

/// What a term of the integrand is made of beside a factor that does not change: t, and sine, cosine or exponential of
/// one multiple of it.
#[derive(Default)]
struct Parts {
    time: u32,
    sin: u32,
    cos: u32,
    exp: u32,
    /// The rate at which the argument grows.
    rate: Option<Fraction>,
    argument: Option<Fraction>,
}

impl Lowering<'_> {
    /// `\int_a^b f dt` by a primitive of f, over t or any other letter.
    pub(crate) fn between(
        &mut self,
        node: &Node,
        integrand: &Node,
        over: &Node,
        (from, to): (&Node, &Node),
    ) -> Lowered {
        let unsupported = || trouble(TroubleKind::Unsupported, node.span, reason::INTEGRAL);
        let over = self.value(over)?;
        let time = over.as_scalar().and_then(Fraction::as_variable);
        let time = time.ok_or_else(unsupported)?;
        let value = self.value(integrand)?;
        let value = value.as_scalar().ok_or_else(unsupported)?;
        let normal = self.theory.normal(value);
        let below = normal.denominator().clone();
        let depends = |v: Variable| self.theory.atoms.with_arguments(v).contains(&time);
        // What moves by a law that is not known here has no primitive.
        let moves = |v: Variable| match self.theory.atoms.atom(v) {
            Atom::Part { entity, .. } => {
                let info = self.theory.atoms.info(*entity);
                let of_body = matches!(info.owner, Owner::Quantity(Quantity::Inertia, _));
                v != time && !info.constant && !of_body
            }
            _ => !is_pi(&self.theory.atoms, v),
        };
        let inside = normal.variables();
        let all = inside
            .iter()
            .flat_map(|&v| self.theory.atoms.with_arguments(v));
        if below.variables().into_iter().any(depends) || all.into_iter().any(moves) {
            return Err(unsupported());
        }
        let mut sum = Fraction::zero();
        for (monomial, coefficient) in normal.numerator().terms() {
            let mut fixed = constant(coefficient.clone());
            let mut parts = Parts::default();
            for (variable, power) in monomial.powers() {
                if !self
                    .sort(variable, power, time, &mut parts)
                    .ok_or_else(unsupported)?
                {
                    fixed *= Fraction::from(Polynomial::variable(variable).pow(power));
                }
            }
            let gained = self.gain(&parts, time, from, to)?;
            sum += fixed * gained.ok_or_else(unsupported)?;
        }
        Ok(Value::scalar(sum / Fraction::from(below)))
    }

    /// Notes a factor that changes with time; false for one that does not, `None` for one that has no primitive here.
    fn sort(
        &self,
        variable: Variable,
        power: u32,
        time: Variable,
        parts: &mut Parts,
    ) -> Option<bool> {
        if variable == time {
            parts.time += power;
            return Some(true);
        }
        if !self.theory.atoms.with_arguments(variable).contains(&time) {
            return Some(false);
        }
        let Atom::Kernel { function, argument } = self.theory.atoms.atom(variable) else {
            return None;
        };
        let rate = argument.partial(time);
        let linear = !rate.variables().contains(&time) && power <= MOST;
        let same = parts
            .argument
            .as_ref()
            .is_none_or(|known| known == argument);
        if !linear || !same || rate.is_zero() {
            return None;
        }
        (parts.rate, parts.argument) = (Some(rate), Some(argument.clone()));
        match function {
            Function::Sin => parts.sin += power,
            Function::Cos => parts.cos += power,
            Function::Exp if power == 1 => parts.exp += power,
            _ => return None,
        }
        Some(true)
    }

    /// What the primitive of a term gains between the limits.
    fn gain(
        &mut self,
        parts: &Parts,
        time: Variable,
        from: &Node,
        to: &Node,
    ) -> Result<Option<Fraction>, crate::verify::values::lower::Trouble> {
        let lower = self.value(from)?.entries[0].clone();
        let endless = matches!(&to.kind, Kind::Symbol(s) if s.name == "infty");
        let t = variable_fraction(time);
        let (Some(rate), Some(argument)) = (&parts.rate, &parts.argument) else {
            let power = |x: &Fraction| (0..=parts.time).fold(Fraction::one(), |p, _| p * x.clone());
            let upper = self.value(to)?.entries[0].clone();
            let over = constant(Rational::from(i64::from(parts.time) + 1));
            return Ok((!endless).then(|| (power(&upper) - power(&lower)) / over));
        };
        if parts.time > 0 || parts.exp > 0 && parts.sin + parts.cos > 0 {
            return Ok(None);
        }
        let start = argument.clone() - rate.clone() * t.clone();
        let at = |limit: Fraction| start.clone() + rate.clone() * limit;
        if parts.exp > 0 {
            let before = self.kernel(Function::Exp, at(lower));
            let behind = match endless {
                true => dies_out(rate).then(Fraction::zero),
                false => {
                    let upper = self.value(to)?.entries[0].clone();
                    self.kernel(Function::Exp, at(upper))
                }
            };
            return Ok(behind.zip(before).map(|(b, a)| (b - a) / rate.clone()));
        }
        if endless {
            return Ok(None);
        }
        let upper = self.value(to)?.entries[0].clone();
        let ends = [at(lower.clone()), at(upper.clone())].map(|angle| {
            let angle = self.theory.normal(&angle);
            let sin = self.kernel(Function::Sin, angle.clone());
            sin.zip(self.kernel(Function::Cos, angle))
        });
        let [Some(first), Some(last)] = ends else {
            return Ok(None);
        };
        let powers = (parts.sin, parts.cos);
        let span = (upper - lower) * rate.clone();
        Ok(Some(turned(powers, &first, &last, &span) / rate.clone()))
    }
}

/// Whether an exponential of so much t goes to zero: the rate is the negative of a product of positive numbers.
fn dies_out(rate: &Fraction) -> bool {
    let sign = |p: &Polynomial| match p.terms() {
        [(_, coefficient)] => Some(*coefficient < Rational::from(0)),
        _ => None,
    };
    sign(rate.numerator())
        .zip(sign(rate.denominator()))
        .is_some_and(|(a, b)| a != b)
}

/// ∫ sinᵐ x cosⁿ x dx between angles given by sine and cosine, by parts.
fn turned(
    (m, n): (u32, u32),
    first: &(Fraction, Fraction),
    last: &(Fraction, Fraction),
    span: &Fraction,
) -> Fraction {
    let power = |x: &Fraction, k: u32| (0..k).fold(Fraction::one(), |p, _| p * x.clone());
    let at = |(s, c): &(Fraction, Fraction), a: u32, b: u32| power(s, a) * power(c, b);
    let gain = |a: u32, b: u32| at(last, a, b) - at(first, a, b);
    let ratio = |a: u32, b: u32| constant(Rational::from((i64::from(a), i64::from(b))));
    match (m, n) {
        (0, 0) => span.clone(),
        (0, 1) => gain(1, 0),
        (0, _) => {
            ratio(1, n) * gain(1, n - 1) + ratio(n - 1, n) * turned((0, n - 2), first, last, span)
        }
        (1, _) => -(ratio(1, n + 1) * gain(0, n + 1)),
        (_, _) => {
            ratio(m - 1, m + n) * turned((m - 2, n), first, last, span)
                - ratio(1, m + n) * gain(m - 1, n + 1)
        }
    }
}
