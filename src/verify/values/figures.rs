//! What numerals stand for while a formula is lowered: units as factors, and rounded figures as what was rounded.

use crate::algebra::{Fraction, Rational, Variable};
use crate::notation::ast::{Function, Node, Number, Relation};
use crate::verify::letters::usage::Letter;
use crate::verify::theory::{Name, Theory};
use crate::verify::values::atoms::{Atom, Atoms, variable_fraction};
use crate::verify::values::lower::{Lowered, Lowering, constant};
use crate::verify::values::units::{Scale, scale};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// Another value that the author may have gone on with.
#[derive(Clone, Debug)]
pub(crate) struct Alternative {
    /// Whose value.
    pub variable: Variable,
    /// The value: as it was rounded, or in the unit that it was given in.
    pub value: Fraction,
    /// Its name as a premise.
    pub name: Name,
}

/// The numbers of a document.
#[derive(Clone, Debug, Default)]
pub(crate) struct Figures {
    /// The signs of relation of the line that is being decided.
    pub relations: Vec<Relation>,
    /// Values that differ from the exact ones.
    pub alternatives: Vec<Alternative>,
    /// Numerals that were shown for a value, with that value.
    pub shown: Vec<(Rational, Fraction)>,
    /// Letters that were given as one number, though vectors have the same letter.
    pub scalars: BTreeSet<Letter>,
    /// Whether some given number had a decimal point.
    pub decimals: bool,
    /// Whether units are passed over.
    pub raw: bool,
    /// Whether a numeral that was shown for a value stands for that value.
    pub unrounded: bool,
}

/// π.
pub(crate) fn pi(atoms: &mut Atoms) -> Fraction {
    let latex = "\\pi".to_owned();
    variable_fraction(atoms.special(Atom::Opaque { latex }))
}

/// Whether a variable stands for π.
pub(crate) fn is_pi(atoms: &Atoms, variable: Variable) -> bool {
    matches!(atoms.atom(variable), Atom::Opaque { latex } if latex == "\\pi")
}

/// Whether a fraction is a number: its variables stand for π and for functions of numbers.
pub(crate) fn is_number(atoms: &Atoms, fraction: &Fraction) -> bool {
    fraction.variables().into_iter().all(|variable| {
        is_pi(atoms, variable)
            || matches!(atoms.atom(variable), Atom::Kernel { argument, .. } if is_number(atoms, argument))
    })
}

impl Theory {
    /// Sine and cosine of a multiple of 15 degrees.
    pub(crate) fn known_angle(&mut self, angle: &Fraction) -> Option<(Fraction, Fraction)> {
        let pi = pi(&mut self.atoms);
        if !angle.variables().contains(&pi.as_variable()?) {
            return None;
        }
        let turn = (angle.clone() / pi).to_rational()? * Rational::from(12);
        let twelfths = turn.to_integer()?;
        let sine = self.sine_of_twelfths(twelfths);
        Some((sine, self.sine_of_twelfths(twelfths.checked_add(6)?)))
    }

    /// sin(nπ/12).
    fn sine_of_twelfths(&mut self, n: i64) -> Fraction {
        let n = n.rem_euclid(24);
        let (n, negative) = if n > 12 { (n - 12, true) } else { (n, false) };
        let mut root = |n: i64| self.kernel(Function::Sqrt, constant(Rational::from(n)));
        let part = |n: i64, d: i64| constant(Rational::from((n, d)));
        let value = match n.min(12 - n) {
            0 => Fraction::zero(),
            1 => root(2) * (root(3) - Fraction::one()) * part(1, 4),
            2 => part(1, 2),
            3 => root(2) * part(1, 2),
            4 => root(3) * part(1, 2),
            5 => root(2) * (root(3) + Fraction::one()) * part(1, 4),
            _ => Fraction::one(),
        };
        if negative { -value } else { value }
    }

    /// The number that a unit multiplies by.
    pub(crate) fn scale_value(&mut self, scale: &Scale) -> Fraction {
        let mut value = constant(scale.factor.clone());
        let pi = pi(&mut self.atoms);
        for _ in 0..scale.pi.unsigned_abs() {
            value = if scale.pi < 0 {
                value / pi.clone()
            } else {
                value * pi.clone()
            };
        }
        value
    }
}

impl Lowering<'_> {
    /// A number; one that was shown for a value may stand for it.
    pub(crate) fn number(&self, number: &Number) -> Fraction {
        let value = Rational::from(number.value.clone());
        let shown = || self.figures.shown.iter().rev().find(|(v, _)| *v == value);
        match shown().filter(|_| self.figures.unrounded && number.decimals.is_some()) {
            Some((_, exact)) => exact.clone(),
            None => constant(value),
        }
    }

    /// A number with a unit, in SI units.
    pub(crate) fn with_unit(&mut self, inside: &Node, unit: &str) -> Lowered {
        let value = self.value(inside)?;
        let scale = scale(unit);
        if scale.is_one() || self.figures.raw {
            return Ok(value);
        }
        let factor = self.theory.scale_value(&scale);
        Ok(value.scaled(&factor))
    }
}
