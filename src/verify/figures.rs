//! What numerals stand for while a formula is lowered: units as factors, and rounded figures as what was rounded.

use crate::algebra::{Fraction, Rational, Variable};
use crate::notation::ast::{Node, Number, Relation};
use crate::verify::atoms::{Atom, Atoms, variable_fraction};
use crate::verify::lower::{Lowered, Lowering, constant};
use crate::verify::theory::{Name, Theory};
use crate::verify::units::{Scale, scale};
use crate::verify::usage::Letter;
use num_traits::One;
use std::collections::BTreeSet;

/// Another value that the author may have gone on with.
#[derive(Clone, Debug)]
pub(super) struct Alternative {
    /// Whose value.
    pub variable: Variable,
    /// The value: as it was rounded, or in the unit that it was given in.
    pub value: Fraction,
    /// Its name as a premise.
    pub name: Name,
}

/// The numbers of a document.
#[derive(Clone, Debug, Default)]
pub(super) struct Figures {
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
pub(super) fn pi(atoms: &mut Atoms) -> Fraction {
    let latex = "\\pi".to_owned();
    variable_fraction(atoms.special(Atom::Opaque { latex }))
}

/// Whether a variable stands for π.
pub(super) fn is_pi(atoms: &Atoms, variable: Variable) -> bool {
    matches!(atoms.atom(variable), Atom::Opaque { latex } if latex == "\\pi")
}

/// Whether a fraction is a number: its variables stand for π and for functions of numbers.
pub(super) fn is_number(atoms: &Atoms, fraction: &Fraction) -> bool {
    fraction.variables().into_iter().all(|variable| {
        is_pi(atoms, variable)
            || matches!(atoms.atom(variable), Atom::Kernel { argument, .. } if is_number(atoms, argument))
    })
}

impl Theory {
    /// The number that a unit multiplies by.
    pub(super) fn scale_value(&mut self, scale: &Scale) -> Fraction {
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
    pub(super) fn number(&self, number: &Number) -> Fraction {
        let value = Rational::from(number.value.clone());
        let shown = || self.figures.shown.iter().rev().find(|(v, _)| *v == value);
        match shown().filter(|_| self.figures.unrounded && number.decimals.is_some()) {
            Some((_, exact)) => exact.clone(),
            None => constant(value),
        }
    }

    /// A number with a unit, in SI units.
    pub(super) fn with_unit(&mut self, inside: &Node, unit: &str) -> Lowered {
        let value = self.value(inside)?;
        let scale = scale(unit);
        if scale.is_one() || self.figures.raw {
            return Ok(value);
        }
        let factor = self.theory.scale_value(&scale);
        Ok(value.scaled(&factor))
    }

    /// Sine and cosine of a multiple of 30 or 45 degrees.
    pub(super) fn known_angle(
        &mut self,
        coefficient: &Rational,
        monomial: &Fraction,
        denominator: &Fraction,
    ) -> Option<(Fraction, Fraction)> {
        let pi = pi(&mut self.theory.atoms);
        if *monomial != pi {
            return None;
        }
        let turn = coefficient.clone() / denominator.to_rational()? * Rational::from(12);
        let twelfths = turn.to_integer()?;
        let sine = self.sine_of_twelfths(twelfths)?;
        let cosine = self.sine_of_twelfths(twelfths.checked_add(6)?)?;
        Some((sine, cosine))
    }

    /// sin(nπ/12) for the n at which it is the half of a root.
    fn sine_of_twelfths(&mut self, n: i64) -> Option<Fraction> {
        let n = n.rem_euclid(24);
        let (n, negative) = if n > 12 { (n - 12, true) } else { (n, false) };
        let square = match n.min(12 - n) {
            0 => 0,
            2 => 1,
            3 => 2,
            4 => 3,
            6 => 4,
            _ => return None,
        };
        let root = self.square_root(constant(Rational::from(square)));
        let half = root * constant(Rational::from((1, 2)));
        let value = if square == 4 { Fraction::one() } else { half };
        Some(if negative { -value } else { value })
    }
}
