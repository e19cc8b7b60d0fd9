//! Whether a line follows from others, by algebra and by what is taken in.

use crate::algebra::{Fraction, Monomial, Place, Polynomial, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Extended;
use crate::verify::model::atoms::{Atoms, Nature};
use crate::verify::standing::apart::Apart;
use num_traits::Zero;

/// No rate of a letter is higher.
const MOST_RATES: usize = 8;

impl Apart<'_> {
    /// Whether it can be seen without working it out that these equations, without their rates, say nothing of a goal.
    ///
    /// An equation is solved for a variable that stands alone in a term, and the goal changes only if that is in it. One
    /// equation makes the goal vanish only if it divides the goal; then no variable has a higher power in it than there.
    /// This holds of free variables, none of which is told by another, and of equations without a number as a term: with
    /// that, one may come to stand alone where another is put in.
    pub(crate) fn are_beside(&self, from: &[&Fraction], goal: &Fraction) -> bool {
        let atoms = &self.judge.reading.system.atoms;
        let goal = goal.numerator();
        let is_free = |v: &Variable| {
            let atom = atoms.atom(*v);
            let plain = matches!(atom.nature, Nature::Quantity | Nature::Unknown);
            plain && atom.square.is_none() && self.facts.square(*v).is_none()
        };
        let rates = |v: &Variable| std::iter::successors(Some(*v), |&v| atoms.known_rate(v));
        let is_tied = |v: &Variable| {
            let mut rates = rates(v).skip(1).take(MOST_RATES);
            rates.any(|rate| self.facts.rule(rate).is_some() || goal.degree_in(rate) > 0)
        };
        let equations = || from.iter().map(|equation| equation.numerator());
        let variables: Vec<Variable> = equations().flat_map(Polynomial::variables).collect();
        let stands_alone = |v: &Variable| {
            let lone = |m: &Monomial| m.degree() == 1 && m.exponent(*v) == 1;
            equations().any(|own| own.terms().iter().any(|(m, _)| lone(m)))
        };
        let has_number = || equations().any(|own| own.terms().iter().any(|(m, _)| m.degree() == 0));
        let untouched = || {
            let mut in_goal = variables.iter().filter(|v| goal.degree_in(**v) > 0);
            !in_goal.any(stands_alone) && !has_number()
        };
        let divides = || match from {
            [one] => variables
                .iter()
                .all(|&v| one.numerator().degree_in(v) <= goal.degree_in(v)),
            _ => true,
        };
        (untouched() || !divides())
            && !variables.iter().any(is_tied)
            && variables.iter().chain(&goal.variables()).all(is_free)
    }

    /// Whether these vanish if those do, with the rates of those or without; `None` where it is not worked out, or where
    /// those contradict each other.
    pub(crate) fn follow(
        &mut self,
        goals: &[Fraction],
        from: &[Fraction],
        rates: bool,
    ) -> Option<bool> {
        let atoms = &mut self.judge.reading.system.atoms;
        let mut facts = self.facts.clone();
        let source = Source::Line(None, 0);
        let mut left = vec![];
        let mut whole = true;
        for equation in from {
            // A product that vanishes does not say which of its factors does.
            if !facts.normal(atoms, equation).is_ok_and(|e| is_plain(&e)) {
                whole = false;
                left.push(equation);
                continue;
            }
            let put = match rates {
                true => facts.extend(atoms, equation, &source),
                false => facts.put(atoms, equation, &source),
            };
            match put {
                Ok(Extended::Contradicts) => return None,
                Ok(Extended::Unsolved) | Err(_) => whole = false,
                Ok(_) => {}
            }
        }
        let left = left.into_iter().map(|e| facts.normal(atoms, e));
        let left: Vec<Fraction> = left.filter_map(Result::ok).collect();
        let left = left
            .iter()
            .map(|e| without_parameters(atoms, e.numerator()));
        let left: Vec<Polynomial> = left.collect();
        let mut all = true;
        for goal in goals {
            let goal = facts.normal(atoms, goal).ok()?;
            let own = without_parameters(atoms, goal.numerator());
            all &= goal.is_zero() || left.iter().any(|one| is_multiple(one, &own));
        }
        (all || whole).then_some(all)
    }
}

/// An equation without the masses and lengths that all of its terms have, none of which is zero.
fn without_parameters(atoms: &Atoms, equation: &Polynomial) -> Polynomial {
    let monomials = equation
        .terms()
        .iter()
        .map(|(monomial, _)| monomial.clone());
    let Some(common) = monomials.reduce(|common, other| common.gcd(&other)) else {
        return equation.clone();
    };
    let others = common.powers().into_iter().map(|(variable, _)| variable);
    let others = others.filter(|&v| atoms.atom(v).place != Place::Parameter);
    let common = others.fold(common.clone(), |common, v| common.without(v));
    equation.divided_by(&common)
}

/// Whether two equations are the same up to a number.
fn is_multiple(one: &Polynomial, other: &Polynomial) -> bool {
    match (one.terms().first(), other.terms().first()) {
        (Some((_, a)), Some((_, b))) => one.scaled(b) == other.scaled(a),
        _ => false,
    }
}

/// Whether an equation says what one variable is, whatever the others are; or nothing at all.
fn is_plain(equation: &Fraction) -> bool {
    let value = equation.numerator();
    let plain = |v: &Variable| {
        value.degree_in(*v) == 1 && value.coefficient_of(*v, 1).is_constant().is_some()
    };
    value.is_constant().is_some() || value.variables().iter().any(plain)
}
