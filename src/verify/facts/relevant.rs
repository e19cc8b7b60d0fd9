//! The premises that a goal needs. One that alone speaks of a letter only tells what this letter is, and the goal does not
//! ask.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::Source;
use crate::verify::model::atoms::{Atoms, Motion, Nature, fraction};
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};

/// Some of the premises in force.
#[derive(Clone, Debug)]
pub(crate) struct Relevant {
    pub(crate) premises: Vec<(Fraction, Source)>,
    /// Whether the others hold for some value of their letters, whatever the rest is: then what fails by these premises
    /// fails by all of them.
    pub(crate) exact: bool,
}

/// The premises without those that tell letters of which neither the goal nor another premise speaks. `None` where all are
/// needed.
pub(crate) fn relevant(
    atoms: &Atoms,
    premises: Vec<(Fraction, Source)>,
    goal: &[(Fraction, Fraction)],
) -> Option<Relevant> {
    let of_goal = goal.iter().flat_map(|(left, right)| [left, right]);
    let asked: BTreeSet<Variable> = of_goal.flat_map(|side| letters(atoms, side)).collect();
    let mut kept: Vec<(BTreeSet<Variable>, (Fraction, Source))> = premises
        .into_iter()
        .map(|premise| (letters(atoms, &premise.0), premise))
        .collect();
    let mut times: BTreeMap<Variable, usize> = BTreeMap::new();
    for letter in kept.iter().flat_map(|(letters, _)| letters) {
        *times.entry(*letter).or_default() += 1;
    }
    let (all, mut exact) = (kept.len(), true);
    loop {
        let own = |letters: &BTreeSet<Variable>| {
            let mut own = letters
                .iter()
                .filter(|l| times.get(l) == Some(&1) && !asked.contains(l));
            own.find(|&&letter| is_free(atoms, letter)).copied()
        };
        let found = kept
            .iter()
            .enumerate()
            .find_map(|(n, (letters, _))| Some((n, own(letters)?)));
        let Some((n, letter)) = found else { break };
        let (letters, (equation, _)) = kept.remove(n);
        exact &= has_solution(atoms, &equation, letter);
        for letter in letters {
            times.entry(letter).and_modify(|times| *times -= 1);
        }
    }
    let premises: Vec<_> = kept.into_iter().map(|(_, premise)| premise).collect();
    (premises.len() < all).then_some(Relevant { premises, exact })
}

/// The letters that a value speaks of: without dots, with those of the angles and roots in it and of what laws say.
fn letters(atoms: &Atoms, of: &Fraction) -> BTreeSet<Variable> {
    let mut waiting: Vec<Variable> = of.variables().into_iter().collect();
    let mut found = BTreeSet::new();
    while let Some(variable) = waiting.pop() {
        let mut letter = variable;
        while let Some(of) = atoms.atom(letter).rate_of {
            letter = of;
        }
        for variable in [letter, variable] {
            if !found.insert(variable) {
                continue;
            }
            let atom = atoms.atom(variable);
            waiting.extend(atom.law.iter().flat_map(|law| law.value.variables()));
            match &atom.nature {
                Nature::Sine(of) | Nature::Cosine(of) | Nature::Root(of) | Nature::UnitPart(of) => {
                    waiting.extend(of.variables());
                }
                Nature::Sum(product) => waiting.extend(product.factors().map(|(v, _)| v)),
                Nature::Quantity | Nature::Unknown => {}
            }
            if let Motion::Rate(rate) = &atom.motion {
                waiting.extend(rate.variables());
            }
        }
    }
    found
}

/// Whether no law and no other quantity gives a variable.
fn is_free(atoms: &Atoms, variable: Variable) -> bool {
    let atom = atoms.atom(variable);
    let own = matches!(atom.nature, Nature::Quantity | Nature::Unknown);
    own && atom.law.is_none() && atom.rate_of.is_none() && !matches!(atom.motion, Motion::Rate(_))
}

/// Whether an equation has a solution for a letter at some values of the others, and with them near these: it is linear in
/// the letter, or in the cosine of it as an angle, or tells its square.
fn has_solution(atoms: &Atoms, equation: &Fraction, letter: Variable) -> bool {
    let value = equation.numerator();
    let speaks = |v: &Variable| letters(atoms, &fraction(*v)).contains(&letter);
    let own: Vec<Variable> = value.variables().into_iter().filter(speaks).collect();
    let &[own] = own.as_slice() else {
        return false;
    };
    let is_cosine =
        matches!(&atoms.atom(own).nature, Nature::Cosine(angle) if angle.is_polynomial());
    let is_letter = own == letter;
    // A product that vanishes does not say which factor does.
    let (degree, rest) = (value.degree_in(own), value.coefficient_of(own, 0));
    if rest.is_zero() && !value.coefficient_of(own, degree).variables().is_empty() {
        return false;
    }
    match degree {
        1 => is_letter || is_cosine,
        2 => is_letter && value.coefficient_of(own, 1).is_zero(),
        _ => false,
    }
}
