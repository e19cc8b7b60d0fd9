//! The numbers for which a line fails, in the letters of its author.

use crate::algebra::{Fraction, Rational, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::facts::world::World;
use crate::verify::model::atoms::{Atoms, fraction};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Where and how a line fails.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// The component, by its place in the list.
    pub(crate) place: usize,
    /// The values of both sides there.
    pub(crate) left: Rational,
    pub(crate) right: Rational,
    /// The letters of that component with their values.
    pub(crate) letters: Vec<(Variable, Rational)>,
    /// Left less right, with what is known put in.
    pub(crate) residual: Fraction,
}

/// How many worlds are tried.
const TRIES: u64 = 16;

/// The first component that fails in a world, with all its letters; `None` where a letter gets no number.
pub(crate) fn shown(
    facts: &mut Facts,
    atoms: &mut Atoms,
    sides: &[(Fraction, Fraction)],
    residuals: &[Fraction],
    world: &World,
) -> Option<Shown> {
    let fails = |r: &Fraction| world.value(r).is_some_and(|value| !value.is_zero());
    let place = residuals.iter().position(fails)?;
    let (left, right) = sides.get(place)?;
    let letters: BTreeSet<Variable> = left
        .variables()
        .into_iter()
        .chain(right.variables())
        .collect();
    let letters: Vec<Variable> = letters.into_iter().collect();
    let mut normal = |of: &Fraction| facts.normal(atoms, of).ok();
    let ends = [normal(left)?, normal(right)?];
    let images = letters.iter().map(|&v| normal(&fraction(v)));
    let images = images.collect::<Option<Vec<_>>>()?;
    (0..TRIES).find_map(|seed| {
        let mut world = world.clone();
        world.complete(facts, atoms, ends.iter().chain(&images), seed)?;
        let values = images.iter().map(|image| world.value(image));
        let values = values.collect::<Option<Vec<_>>>()?;
        Some(Shown {
            place,
            left: world.value(&ends[0])?,
            right: world.value(&ends[1])?,
            letters: letters.iter().copied().zip(values).collect(),
            residual: residuals[place].clone(),
        })
    })
}
