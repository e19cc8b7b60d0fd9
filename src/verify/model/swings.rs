//! Small oscillations about where a letter is zero: their frequency and period by an equation of motion.

use crate::algebra::{Fraction, Place, Polynomial, Variable, compose};
use crate::verify::model::atoms::{Motion, Nature, fraction, whole};
use crate::verify::model::system::System;
use num_traits::{One, Zero};
use std::collections::HashMap;

/// Values of more terms are not worked out.
const MOST_TERMS: usize = 100_000;

/// What is told of small oscillations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pace {
    /// How long one takes.
    Period,
    /// How many there are in a unit of time.
    Frequency,
    /// The same times 2π.
    AngularFrequency,
}

/// A letter that the equations of motion tell by the rule of small oscillations.
#[derive(Clone, Debug)]
pub(crate) struct Swing {
    /// What swings.
    pub(crate) of: Variable,
    pub(crate) pace: Pace,
    /// What the true equations of motion make of it.
    pub(crate) told: Fraction,
}

impl System {
    /// −∂ẍ/∂x where x and its rate are zero and stay so, by what ẍ is, if nothing but constants stands there.
    pub(crate) fn stiffness(&mut self, acceleration: &Fraction, x: Variable) -> Option<Fraction> {
        let rate = self.atoms.rate(x).as_variable()?;
        let told = self.expanded(acceleration, &[x, rate]);
        let slope = self.partial(&told, x);
        let damping = self.partial(&told, rate);
        let [rest, slope, damping] =
            [told, slope, damping].map(|value| self.at_rest(&value, x, rate));
        let constant = |f: &Fraction| {
            let mut variables = f.variables().into_iter();
            variables.all(|v| {
                let atom = self.atoms.atom(v);
                atom.place == Place::Parameter || matches!(atom.motion, Motion::Constant)
            })
        };
        let slope = slope.filter(|slope| constant(slope) && !slope.is_zero())?;
        (rest?.is_zero() && damping?.is_zero()).then(|| -slope)
    }

    /// A value where a variable and its rate are zero.
    fn at_rest(&self, value: &Fraction, x: Variable, rate: Variable) -> Option<Fraction> {
        let mut images: HashMap<Variable, Fraction> = HashMap::new();
        images.insert(x, Fraction::zero());
        images.insert(rate, Fraction::zero());
        for kernel in value.variables() {
            match &self.atoms.atom(kernel).nature {
                Nature::Sine(of) if *of == fraction(x) => images.insert(kernel, Fraction::zero()),
                Nature::Cosine(of) if *of == fraction(x) => images.insert(kernel, Fraction::one()),
                _ => None,
            };
        }
        let put = |p: &Polynomial| compose(p, &images, MOST_TERMS).ok();
        let below = put(value.denominator())?;
        (!below.is_zero()).then_some(put(value.numerator())? / below)
    }

    /// A pace by the angular frequency.
    pub(crate) fn pace(&mut self, pace: Pace, angular_frequency: Fraction) -> Fraction {
        let turn = self.atoms.pi() * whole(2);
        match pace {
            Pace::Period => turn / angular_frequency,
            Pace::Frequency => angular_frequency / turn,
            Pace::AngularFrequency => angular_frequency,
        }
    }

    /// The angular frequency by a pace.
    pub(crate) fn angular_frequency(&mut self, pace: Pace, value: Fraction) -> Fraction {
        let turn = self.atoms.pi() * whole(2);
        match pace {
            Pace::Period => turn / value,
            Pace::Frequency => turn * value,
            Pace::AngularFrequency => value,
        }
    }

    /// What an equation of motion, which vanishes, says of the acceleration of x.
    pub(crate) fn acceleration_by(&self, equation: &Fraction, x: Variable) -> Option<Fraction> {
        let rate = self.atoms.known_rate(x)?;
        let acceleration = self.atoms.known_rate(rate)?;
        let equation = equation.numerator();
        if equation.degree_in(acceleration) != 1 {
            return None;
        }
        let slope = equation.coefficient_of(acceleration, 1);
        Fraction::new(-equation.coefficient_of(acceleration, 0), slope)
    }
}
