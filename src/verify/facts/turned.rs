//! Laws turned round: a letter stays, and a constant of the model that stands in its law is told by it.
//!
//! The moment of inertia of a whole is a long expression in the masses, places and moments of its parts. What is said of
//! the whole is short in its own letters.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::premises::{Facts, size};
use crate::verify::model::atoms::{Atoms, Motion, Nature, Space, fraction};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Laws of more letters are not turned round.
const MOST_LETTERS: usize = 40;

/// The letters of a goal and of premises that laws tell, and the constants of which the goal speaks: none of these is to
/// be told anew.
pub(crate) fn spoken_of(
    atoms: &Atoms,
    premises: &[(Fraction, Source)],
    goal: &[(Fraction, Fraction)],
) -> BTreeSet<Variable> {
    let of_premises = premises
        .iter()
        .flat_map(|(equation, _)| equation.variables());
    let told = |v: &Variable| atoms.atom(*v).law.is_some();
    let of_goal = goal.iter().flat_map(|(left, right)| [left, right]);
    let of_goal = of_goal.flat_map(Fraction::variables);
    let of_goal = of_goal.filter(|v| told(v) || is_free_constant(atoms, *v));
    of_premises.filter(told).chain(of_goal).collect()
}

impl Facts {
    /// Facts of which nothing is put in yet but the laws of these letters, turned round where that can be done. No
    /// letter is told anew.
    pub(crate) fn keeping(atoms: &mut Atoms, letters: &BTreeSet<Variable>) -> Self {
        let mut facts = Self::default();
        let mut laws: Vec<(usize, Variable)> = letters
            .iter()
            .filter(|&&letter| is_written(atoms, letter))
            .filter_map(|&letter| Some((size(&atoms.atom(letter).law.as_ref()?.value), letter)))
            .collect();
        // The shorter ones first: what they tell may stand in the longer ones.
        laws.sort_unstable();
        for (_, letter) in laws.into_iter().take(MOST_LETTERS) {
            facts.turn_round(atoms, letter, letters);
        }
        facts
    }

    /// Whether a law was turned round.
    pub(crate) fn turns_any(&self) -> bool {
        !self.turned.is_empty()
    }

    /// Turns the law of a letter round, if a constant of the model can be told by it.
    fn turn_round(
        &mut self,
        atoms: &mut Atoms,
        letter: Variable,
        letters: &BTreeSet<Variable>,
    ) -> Option<()> {
        let law = atoms.atom(letter).law.clone()?;
        let value = self.normal(atoms, &law.value).ok()?;
        let mut free = value.numerator().variables().into_iter();
        let told = free.find(|&v| {
            is_free_constant(atoms, v) && !letters.contains(&v) && is_alone(&value, v)
        })?;
        let equation = fraction(letter) - law.value;
        self.turned.insert(letter);
        let put = self.put_solved(atoms, &equation, told, &Source::Law(law.name));
        if put.is_none() {
            self.turned.remove(&letter);
        }
        put
    }
}

/// Whether a letter is one of the text that a law tells.
fn is_written(atoms: &Atoms, letter: Variable) -> bool {
    let atom = atoms.atom(letter);
    matches!(atom.key.space, Space::Letter(_)) && atom.key.order == 0 && atom.law.is_some()
}

fn is_constant(atoms: &Atoms, variable: Variable) -> bool {
    match &atoms.atom(variable).motion {
        Motion::Constant => true,
        Motion::Rate(rate) => rate.is_zero(),
        Motion::Free => false,
    }
}

/// Whether a variable is a constant of the model of which no law tells anything.
fn is_free_constant(atoms: &Atoms, variable: Variable) -> bool {
    let atom = atoms.atom(variable);
    atom.nature == Nature::Quantity
        && matches!(
            atom.key.space,
            Space::Model | Space::Number | Space::UntoldProduct(_)
        )
        && atom.law.is_none()
        && is_constant(atoms, variable)
}

/// Whether a value is a number times a variable, and more without it.
fn is_alone(value: &Fraction, variable: Variable) -> bool {
    let (top, bottom) = (value.numerator(), value.denominator());
    let slope = top.coefficient_of(variable, 1);
    let number = slope.exact_quotient(bottom);
    top.degree_in(variable) == 1
        && bottom.degree_in(variable) == 0
        && number.is_some_and(|number: Polynomial| number.is_constant().is_some())
}
