//! The numbers that worlds are made of: a prime field for the filter, rational numbers for counterexamples, and both with
//! a root that they lack.

use crate::algebra::Rational;
use crate::scalar::{Prime, Surd};
use crate::verify::theory::kept::{Point, Relations};
use crate::verify::theory::world::{Drawn, Kind, Substance};
use num_traits::ToPrimitive;
use std::fmt::Display;

/// Radicands that a counterexample may have.
const RADICANDS: [i64; 12] = [2, 3, 5, 6, 7, 10, 11, 13, 14, 15, 17, 19];

/// A number that people can check a counterexample in.
pub(super) trait Witness: Substance + Display {
    /// Nearly the same as a float.
    fn approximate(&self) -> f64;
    /// Whether it can be told exactly.
    fn is_exact(&self) -> bool;
}

impl Witness for Rational {
    fn approximate(&self) -> f64 {
        self.to_big().to_f64().unwrap_or(f64::NAN)
    }
    fn is_exact(&self) -> bool {
        true
    }
}

impl Witness for Surd<Rational> {
    fn approximate(&self) -> f64 {
        let [whole, part, radicand] =
            [&self.whole, &self.part, &self.radicand].map(Witness::approximate);
        whole + part * radicand.sqrt()
    }
    fn is_exact(&self) -> bool {
        self.is_number()
    }
}

impl Substance for Prime {
    fn lift(value: &Rational) -> Option<Self> {
        value.to_prime()
    }
    fn root(&self) -> Option<Self> {
        // p ≡ 3 mod 4, so a root, if there is one, is the power (p + 1)/4.
        let root = self.pow((Self::MODULUS + 1) / 4);
        (root * root == *self).then_some(root)
    }
    fn draw(_: Kind, chance: u64) -> Self {
        Self::new(chance)
    }
    fn is_negative(&self) -> bool {
        false
    }
    fn recall(relations: &Relations, key: (usize, u64)) -> Option<Point<Self>> {
        relations.points.get(&key).cloned()
    }
    fn remember(relations: &mut Relations, key: (usize, u64), point: &Point<Self>) {
        relations.points.insert(key, point.clone());
    }
    fn recall_world(relations: &mut Relations, seed: u64) -> Option<Drawn<Self>> {
        relations.worlds.remove(&seed)
    }
    fn remember_world(relations: &mut Relations, seed: u64, drawn: Drawn<Self>) {
        relations.worlds.insert(seed, drawn);
    }
}

impl Substance for Rational {
    fn lift(value: &Rational) -> Option<Self> {
        Some(value.clone())
    }
    fn root(&self) -> Option<Self> {
        self.exact_sqrt()
    }
    fn draw(kind: Kind, chance: u64) -> Self {
        let below = |n: u64| (chance >> 8).rem_euclid(n) as i64;
        Self::from(match kind {
            Kind::Positive => 4 + below(4),
            Kind::Small => [-1, 1][below(2) as usize],
            Kind::Any | Kind::Signed => [1, 2, -1, 3, -2, 5][below(6) as usize],
            // A zero lets many a root be rational.
            Kind::Over(_) if chance & 1 == 0 => 0,
            Kind::Over(whole) => {
                let part = below(2 * whole.unsigned_abs() + 1) - whole;
                return Self::from((part, whole));
            }
        })
    }
    fn is_negative(&self) -> bool {
        *self < Self::from(0)
    }
}

/// A field that lacks roots of some of its numbers.
pub(super) trait Rootless: Substance {
    /// Numbers with the root of one of which times one of its own, a number that has no root may still have one.
    fn radicands() -> impl Iterator<Item = Self>;
}

impl Rootless for Prime {
    fn radicands() -> impl Iterator<Item = Self> {
        // 3 has no root in this field (quadratic reciprocity), and so any number without one is 3 times one with.
        std::iter::once(Self::new(3))
    }
}

impl Rootless for Rational {
    fn radicands() -> impl Iterator<Item = Self> {
        RADICANDS.into_iter().map(Self::from)
    }
}

impl<T: Rootless> Substance for Surd<T> {
    fn lift(value: &Rational) -> Option<Self> {
        T::lift(value).map(Self::from_field)
    }
    fn root(&self) -> Option<Self> {
        if self.part.is_zero() {
            let plain = self.whole.root().map(Self::from_field);
            return plain.or_else(|| {
                T::radicands().find_map(|d| {
                    let part = (self.whole.clone() / d.clone()).root()?;
                    Some(Self::new(T::zero(), part, d))
                })
            });
        }
        // (x + y√d)² = a + b√d where x² = (a ± √(a² − b² d))/2 and y = b/(2x).
        let norm = self.norm().root()?;
        let two = T::one() + T::one();
        [norm.clone(), -norm].into_iter().find_map(|norm| {
            let half = (self.whole.clone() + norm) / two.clone();
            let x = half.root().filter(|x| !x.is_zero())?;
            let y = self.part.clone() / (x.clone() + x.clone());
            Some(Self::new(x, y, self.radicand.clone()))
        })
    }
    fn draw(kind: Kind, chance: u64) -> Self {
        Self::from_field(T::draw(kind, chance))
    }
    fn is_negative(&self) -> bool {
        let [whole, part] = [&self.whole, &self.part].map(Substance::is_negative);
        match (whole, part || self.part.is_zero()) {
            (false, false) => false,
            (true, true) => true,
            // The greater square has its way.
            _ if self.part.is_zero() => whole,
            _ => self.norm().is_negative() != whole,
        }
    }
}
