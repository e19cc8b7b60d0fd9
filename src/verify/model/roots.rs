//! Roots: variables with a relation, which they are functions of.

use crate::algebra::{Fraction, Monomial, Place, Polynomial, Rational, Variable};
use crate::verify::model::atoms::{Atoms, Key, Motion, Nature, fraction, whole};
use crate::verify::model::powers::with_one_square;
use num_traits::One;

impl Atoms {
    /// The square root of a value where it needs no letter of its own: a length by its letter, or what is squared.
    pub(crate) fn known_root(&self, of: &Fraction) -> Option<Fraction> {
        let of = &self.with_squares(of);
        if let Some((_, length)) = self.lengths.iter().find(|(square, _)| square == of) {
            return Some(fraction(*length));
        }
        // The root of x² is |x|, and no x whose sign is not known.
        let perfect = |of| self.not_negative(self.perfect_root(of)?);
        let root = perfect(of.numerator())?;
        Fraction::new(root, perfect(of.denominator())?)
    }

    /// One of the two roots of a value: what is squared as a factor stands before the root.
    pub(crate) fn root_of_either_sign(&mut self, of: &Fraction) -> Option<Fraction> {
        let common = of.numerator().common_monomial();
        let powers = common.powers().into_iter();
        let squares = powers.map(|(v, power)| (v, power / 2));
        let outside = Monomial::from_powers(squares.collect::<Vec<_>>());
        let rest = of.numerator().divided_by(&outside).divided_by(&outside);
        let rest = Fraction::new(rest, of.denominator().clone())?;
        let outside = Fraction::from(Polynomial::term(outside, Rational::one()));
        Some(outside * self.root(&rest)?)
    }

    /// Whether all angles whose sines stand in a value are constant.
    pub(crate) fn has_steady_sines(&self, value: &Fraction) -> bool {
        let steady = |v: Variable| matches!(self.atom(v).motion, Motion::Constant);
        value
            .variables()
            .into_iter()
            .all(|v| match &self.atom(v).nature {
                Nature::Sine(angle) => angle.variables().into_iter().all(steady),
                _ => true,
            })
    }

    /// The square root of a value, taken as not negative.
    pub(crate) fn root(&mut self, of: &Fraction) -> Option<Fraction> {
        if let Some(root) = self.known_root(of) {
            return Some(root);
        }
        let of = &self.with_squares(of);
        let inside = Fraction::from(of.numerator().clone() * of.denominator().clone());
        // √(x/2) and √(2x) have one variable: no square and no denominator stays below the root.
        let (outer, rest) = match inside.numerator().content().abs().without_square() {
            Some((root, _)) if !root.is_one() => {
                let inverse = Rational::one() / (root.clone() * root.clone());
                (root, Fraction::from(inside.numerator().scaled(&inverse)))
            }
            _ => (Rational::one(), inside),
        };
        let text = format!("\\sqrt{{{}}}", self.angle_text(&rest));
        let key = Key {
            member: self.member_of(&rest),
            ..Key::new(text)
        };
        let root = match self.find(&key) {
            Some(root) => root,
            None => {
                let rate = self.derivative(&rest);
                let root = self.variable(key, Place::Coordinate, Motion::Free);
                let rate = rate / (whole(2) * fraction(root));
                let atom = self.atom_mut(root);
                atom.motion = Motion::Rate(rate);
                atom.square = Some(rest.numerator().clone());
                atom.nature = Nature::Root(rest);
                root
            }
        };
        let outer = Fraction::from(Polynomial::constant(outer));
        Some(outer * fraction(root) / Fraction::from(of.denominator().clone()))
    }

    /// A fraction with the squares of roots and sines put in.
    pub(crate) fn with_squares(&self, of: &Fraction) -> Fraction {
        let mut top = of.numerator().clone();
        for _ in 0..16 {
            let Some(next) = with_one_square(&top, |v| self.atom(v).square.as_ref()) else {
                break;
            };
            top = next;
        }
        Fraction::new(top, of.denominator().clone()).unwrap_or_else(|| of.clone())
    }

    /// The root of a number, or of a product of even powers: what stands in a length is taken as not negative.
    pub(super) fn perfect_root(&self, of: &Polynomial) -> Option<Polynomial> {
        if let Some(number) = of.is_constant() {
            return number.exact_sqrt().map(Polynomial::constant);
        }
        let [(monomial, coefficient)] = of.terms() else {
            return self.root_by_sine(of);
        };
        let mut product = Polynomial::constant(coefficient.exact_sqrt()?);
        for (variable, power) in monomial.powers() {
            if power % 2 != 0 {
                return None;
            }
            product *= Polynomial::variable(variable).pow(power / 2);
        }
        Some(product)
    }

    /// The root of a perfect square times 1 − cos² of an angle: its sine, which no length has negative.
    fn root_by_sine(&self, of: &Polynomial) -> Option<Polynomial> {
        let common = of.common_monomial();
        let rest = of.divided_by(&common);
        let one = rest.terms().iter().find(|(m, _)| m.powers().is_empty())?;
        let factor = one.1.clone();
        let square = rest.scaled(&(Rational::one() / factor.clone()));
        let sine = (0..self.len() as Variable).find(|&v| {
            let atom = self.atom(v);
            matches!(atom.nature, Nature::Sine(_)) && atom.square.as_ref() == Some(&square)
        })?;
        let outer = self.perfect_root(&Polynomial::term(common, factor))?;
        Some(outer * Polynomial::variable(sine))
    }
}
