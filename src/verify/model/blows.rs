//! Blows: places and attitudes stay as they are, and velocities change at once.
//!
//! What a velocity is just before a blow and just after it are two variables, beside the one that it is at any time.

use crate::algebra::{Fraction, Place, Polynomial, Variable, compose_by};
use crate::verify::model::atoms::{Atoms, Key, Motion, Nature, fraction, whole};
use crate::verify::model::loads::Lasting;
use crate::verify::model::system::{System, Turn, Vector};
use num_traits::Zero;
use std::collections::BTreeMap;

/// Values of more terms are not put in.
const MOST_TERMS: usize = 2_000;

/// A side of a blow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Side {
    Before,
    After,
}

impl Side {
    /// How a letter is marked there.
    fn mark(self) -> &'static str {
        match self {
            Self::Before => "^{-}",
            Self::After => "^{+}",
        }
    }
}

impl Atoms {
    /// "`$\\theta$` is zero just before the impact."
    pub(crate) fn set_none_at_blow(&mut self, coordinate: Variable) {
        self.coordinates.none_at_blow.insert(coordinate);
    }
}

impl System {
    /// What a value is at a side of a blow; none where accelerations or letters tell it of which nothing is told.
    pub(crate) fn at_blow(&mut self, value: &Fraction, side: Side) -> Option<Fraction> {
        let mut images = BTreeMap::new();
        for variable in value.variables() {
            images.insert(variable, self.variable_at_blow(variable, side)?);
        }
        let put = |p: &Polynomial| compose_by(p, |v| images.get(&v), MOST_TERMS);
        let (above, below) = (put(value.numerator()).ok()?, put(value.denominator()).ok()?);
        (!below.is_zero()).then(|| above / below)
    }

    /// The same of the components of a vector.
    pub(crate) fn vector_at_blow(&mut self, vector: &Vector, side: Side) -> Option<Vector> {
        let [x, y, z] = [0, 1, 2].map(|axis| self.at_blow(&vector[axis], side));
        Some(Vector::new(x?, y?, z?))
    }

    fn variable_at_blow(&mut self, variable: Variable, side: Side) -> Option<Fraction> {
        if self.atoms.coordinates.none_at_blow.contains(&variable) {
            return Some(Fraction::zero());
        }
        let atom = self.atoms.atom(variable).clone();
        if let Some(law) = &atom.law {
            return self.at_blow(&law.value, side);
        }
        let fixed = atom.key.blow.is_some() || matches!(atom.motion, Motion::Constant);
        match &atom.nature {
            Nature::Unknown => None,
            Nature::Root(of) => {
                let of = self.at_blow(of, side)?;
                self.atoms.root(&of)
            }
            Nature::Sum(product) => {
                let mut factors = product.factors();
                let moves = factors.any(|(v, _)| self.atoms.atom(v).place == Place::Rate);
                (!moves).then(|| fraction(variable))
            }
            _ if fixed => Some(fraction(variable)),
            Nature::Sine(of) | Nature::Cosine(of) => match self.at_blow(of, side)? {
                then if then == *of => Some(fraction(variable)),
                then if then.is_zero() => {
                    let cosine = matches!(atom.nature, Nature::Cosine(_));
                    Some(whole(i64::from(cosine)))
                }
                _ => None,
            },
            _ if atom.place == Place::Acceleration => None,
            _ if atom.place == Place::Rate || self.is_rate(variable)? => {
                let text = format!("{}{}", atom.key.text, side.mark());
                let blow = Some(side);
                let key = Key {
                    text,
                    blow,
                    ..atom.key
                };
                let then = self.atoms.variable(key, atom.place, Motion::Free);
                Some(fraction(then))
            }
            Nature::Quantity if self.stays(variable) => Some(fraction(variable)),
            _ => None,
        }
    }

    /// Whether a variable tells where something is, or is brought by the blow. What another letter tells may be of the
    /// velocities, and jump as they do.
    pub(crate) fn stays(&self, variable: Variable) -> bool {
        let angles = self.frames.iter().filter_map(|frame| match &frame.turn {
            Turn::Angle(_, angle) | Turn::About(_, angle) => Some(angle.as_ref()),
            _ => None,
        });
        let placed = self.points.iter().filter_map(|point| point.placed.as_ref());
        let ways = placed.flat_map(|(_, way)| way.iter());
        let blows = self
            .loads
            .iter()
            .filter(|load| load.lasting == Lasting::Blow);
        let brought = blows.flat_map(|load| load.value.iter());
        let mut values = angles.chain(ways).chain(brought);
        matches!(self.atoms.atom(variable).motion, Motion::Rate(_))
            || values.any(|value| value.variables().contains(&variable))
    }

    /// Whether a letter is how fast something turns or moves; none where it only belongs to that.
    fn is_rate(&self, variable: Variable) -> Option<bool> {
        let turns = self.frames.iter().filter_map(|frame| match &frame.turn {
            Turn::Rate(_, rate) => Some(rate.as_ref()),
            _ => None,
        });
        let moves = (0..self.atoms.len()).filter_map(|place| {
            match &self.atoms.atom(Variable::try_from(place).ok()?).motion {
                Motion::Rate(rate) if rate.as_variable().is_some() => Some(rate),
                _ => None,
            }
        });
        let mut told = turns
            .chain(moves)
            .filter(|rate| rate.variables().contains(&variable));
        match told.next() {
            None => Some(false),
            Some(rate) => rate.as_variable().map(|_| true),
        }
    }

    /// Whether a value is of neither side: something in it moves, or is an acceleration.
    pub(crate) fn moves_at_blow(&mut self, value: &Fraction) -> bool {
        self.at_blow(value, Side::Before).as_ref() != Some(value)
            || value.variables().into_iter().any(|variable| {
                let atom = self.atoms.atom(variable);
                atom.place == Place::Acceleration
                    || atom.key.blow.is_some() && atom.rate_of.is_some()
            })
    }
}
