//! Whether a line follows from others, by algebra and by what is taken in.

use crate::algebra::{Fraction, Monomial, Place, Polynomial, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::premises::Extended;
use crate::verify::model::atoms::{Atoms, Motion, Nature};
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

    /// Whether it can be seen without working it out that an equation and its rates do not make a goal vanish.
    ///
    /// The equation is solved for a variable that stands alone in a term, and then that one and its rates are told and
    /// nothing else: what it says of the rates of others is had from it by differentiating. So the goal stays as it is
    /// where none of these is in it. One that is not solved may make vanish what is a multiple of it. Both are in free
    /// variables already, and none of these is told by another.
    pub(crate) fn is_far_from(&self, equation: &Fraction, goal: &Fraction) -> bool {
        let own = equation.numerator();
        if goal.is_zero() || own.is_constant().is_some() {
            return false;
        }
        let atoms = &self.judge.reading.system.atoms;
        if !is_plain(equation) {
            if own.len() != goal.numerator().len() {
                return true;
            }
            let [own, goal] = [own, goal.numerator()].map(|value| without_parameters(atoms, value));
            return !is_multiple(&own, &goal);
        }
        let rates = |v: Variable| {
            let rates = std::iter::successors(Some(v), |&v| atoms.known_rate(v));
            rates.take(MOST_RATES)
        };
        let is_free = |v: Variable| {
            let atom = atoms.atom(v);
            let plain = matches!(atom.nature, Nature::Quantity | Nature::Unknown)
                && !matches!(&atom.motion, Motion::Rate(rate) if rate.as_variable().is_none());
            plain && atom.square.is_none() && rates(v).all(|v| self.facts.is_untold(atoms, v))
        };
        let in_goal = goal.variables();
        let is_in_goal = |v: Variable| rates(v).any(|v| in_goal.contains(&v));
        let lone = own.terms().iter().map(|(monomial, _)| monomial);
        let lone = lone.filter(|monomial| monomial.degree() == 1);
        let mut told = lone.flat_map(|monomial| monomial.powers());
        let mut all = own.variables().into_iter().chain(in_goal.iter().copied());
        !told.any(|(v, _)| is_in_goal(v))
            && goal.is_polynomial()
            && self.facts.has_no_squares()
            && all.all(is_free)
    }

    /// Works out whether these vanish if those do, with the rates of those or without; `None` where it is not worked out, or where
    /// those contradict each other.
    pub(super) fn works_out(
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
    let terms = equation.numerator().terms();
    let others_have = |v: Variable| terms.iter().filter(|(m, _)| m.exponent(v) > 0).count() > 1;
    let mut lone = terms.iter().filter(|(monomial, _)| monomial.degree() == 1);
    let is_constant = equation.numerator().is_constant().is_some();
    is_constant || lone.any(|(m, _)| m.powers().iter().any(|(v, _)| !others_have(*v)))
}
