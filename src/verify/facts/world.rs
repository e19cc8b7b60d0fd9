//! Small exact worlds: numbers for the free variables in which a false line fails.

use crate::algebra::{Fraction, Rational, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::model::atoms::{Atoms, Nature};
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// How many worlds are tried.
const TRIES: u64 = 48;

/// Values of variables.
#[derive(Clone, Debug, Default)]
pub(crate) struct World {
    values: BTreeMap<Variable, Rational>,
}

/// Cosine and sine of an angle, by the sides of a right triangle.
const TURNS: [[i64; 3]; 6] = [
    [3, 4, 5],
    [4, 3, 5],
    [5, 12, 13],
    [-3, 4, 5],
    [12, 5, 13],
    [8, 15, 17],
];

impl World {
    /// A world in which the fractions are numbers and one of them is not zero, and in which nothing of `orders` is less
    /// than zero; all are in free variables.
    pub(crate) fn refuting(
        facts: &Facts,
        atoms: &Atoms,
        residuals: &[Fraction],
        orders: &[Fraction],
    ) -> Option<Self> {
        (0..TRIES).find_map(|seed| {
            let mut world = Self::default();
            let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
            for residual in residuals {
                for variable in residual.variables() {
                    world.draw(facts, atoms, variable, &mut state)?;
                }
            }
            world.complete(facts, atoms, orders.iter(), state)?;
            let obeys = |order| world.value(order).is_some_and(|v| v > Rational::zero());
            if !orders.iter().all(obeys) {
                return None;
            }
            let values = residuals.iter().map(|r| world.value(r));
            let values = values.collect::<Option<Vec<_>>>()?;
            values.iter().any(|v| !v.is_zero()).then_some(world)
        })
    }

    /// Draws numbers for the variables of more fractions.
    pub(crate) fn complete<'f>(
        &mut self,
        facts: &Facts,
        atoms: &Atoms,
        of: impl Iterator<Item = &'f Fraction>,
        seed: u64,
    ) -> Option<()> {
        let mut state = seed;
        for variable in of.flat_map(Fraction::variables) {
            self.draw(facts, atoms, variable, &mut state)?;
        }
        Some(())
    }

    /// Draws a number for a variable, by its relation where it has one.
    fn draw(
        &mut self,
        facts: &Facts,
        atoms: &Atoms,
        variable: Variable,
        state: &mut u64,
    ) -> Option<()> {
        if self.values.contains_key(&variable) {
            return Some(());
        }
        let atom = atoms.atom(variable);
        match &atom.nature {
            Nature::Sine(angle) | Nature::Cosine(angle) => {
                let pick = TURNS[(next(state) % TURNS.len() as u64) as usize];
                let all = (0..atoms.len() as Variable).filter(|&v| match &atoms.atom(v).nature {
                    Nature::Sine(a) | Nature::Cosine(a) => a == angle,
                    _ => false,
                });
                for v in all.collect::<Vec<_>>() {
                    let side = usize::from(matches!(atoms.atom(v).nature, Nature::Sine(_)));
                    self.values.insert(v, Rational::from((pick[side], pick[2])));
                }
                return Some(());
            }
            _ => {}
        }
        let own = atom.square.clone().map(Fraction::from);
        if let Some(square) = facts.free_square(variable).cloned().or(own) {
            for inner in square.variables() {
                self.draw(facts, atoms, inner, state)?;
            }
            let root = self.value(&square)?.exact_sqrt()?;
            self.values.insert(variable, root);
            return Some(());
        }
        let unit_part = (0..atoms.len() as Variable).any(|v| {
            let told = facts.free_square(v);
            let own = match &atoms.atom(v).nature {
                Nature::UnitPart(square) => Some(square),
                _ => None,
            };
            let mut squares = told.into_iter().chain(own);
            squares.any(|square| square.variables().contains(&variable))
        });
        let value = match unit_part {
            true => {
                Rational::from([(2, 3), (1, 3), (2, 7), (3, 7), (6, 7)][(next(state) % 5) as usize])
            }
            false => Rational::from((1 + (next(state) % 7) as i64, 1)),
        };
        self.values.insert(variable, value);
        Some(())
    }

    /// The value of a fraction in free variables; `None` where one is missing or a denominator vanishes.
    pub(crate) fn value(&self, of: &Fraction) -> Option<Rational> {
        let missing = of.variables().iter().any(|v| !self.values.contains_key(v));
        if missing {
            return None;
        }
        let at = |v: Variable| self.values.get(&v).cloned().unwrap_or_else(Rational::one);
        let top = of.numerator().evaluate(at, Clone::clone);
        let bottom = of.denominator().evaluate(at, Clone::clone);
        (!bottom.is_zero()).then(|| top / bottom)
    }
}

/// The next number of a fixed sequence (splitmix64, Steele, Lea and Flood 2014).
fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
