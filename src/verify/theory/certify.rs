//! Finds the cofactors of a proof by putting the rules in one after the other.
//!
//! Dividing by d·v − n leaves the polynomial with n/d put in for v, and the quotient is the cofactor of that fact.

use crate::algebra::{
    Argument, Bound, Combination, Fraction, Goal, Kernel, Polynomial, Proof, Ratio, Reason,
    Variable, difference,
};
use crate::verify::theory::Theory;
use crate::verify::theory::decide::Equation;
use crate::verify::theory::ledger::{Relation, ratio};
use num_traits::{One, Zero};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Terms that a polynomial on the way may have.
const MOST_TERMS: usize = 40_000;
/// Rules that are put in for one goal.
const MOST_STEPS: usize = 400;

/// multiplier · start = Σ cofactor · fact + rest.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    /// What is left.
    pub rest: Polynomial,
    /// The product of everything that was divided by.
    pub multiplier: Polynomial,
    /// By fact.
    pub cofactors: BTreeMap<usize, Polynomial>,
}

impl Elimination {
    /// Puts rules in, the highest first, until nothing is left or no rule applies; `None` beyond the budget.
    pub(crate) fn of(theory: &mut Theory, start: Polynomial) -> Option<Self> {
        let mut done = Self {
            rest: start,
            multiplier: Polynomial::one(),
            cofactors: BTreeMap::new(),
        };
        for _ in 0..MOST_STEPS {
            if done.rest.is_zero() {
                return Some(done);
            }
            match next(theory, &done.rest) {
                Some((variable, relation)) => done.put_in(variable, &relation)?,
                None => match next_square(theory, &done.rest) {
                    Some((variable, relation)) => done.put_square_in(variable, &relation)?,
                    None => return Some(done),
                },
            }
        }
        None
    }

    /// What is left vanishes too: multiplier · rest = Σ cofactor · fact.
    pub(crate) fn vanishes_by(
        &mut self,
        multiplier: Polynomial,
        cofactors: impl Iterator<Item = (usize, Polynomial)>,
    ) -> Option<()> {
        self.scale(&multiplier)?;
        for (fact, cofactor) in cofactors.filter(|(_, cofactor)| !cofactor.is_zero()) {
            self.add(fact, cofactor);
        }
        self.rest = Polynomial::zero();
        Some(())
    }

    /// The proof that the start vanishes, where nothing is left.
    pub(crate) fn combination(self) -> Combination {
        Combination {
            multiplier: self.multiplier,
            cofactors: self.cofactors.into_iter().collect(),
        }
    }

    fn put_in(&mut self, variable: Variable, relation: &Relation) -> Option<()> {
        let degree = self.rest.degree_in(variable);
        let (top, bottom) = (&relation.numerator, &relation.denominator);
        let growth = top.len().max(bottom.len()).max(1);
        let size = (0..degree).try_fold(self.rest.len(), |size, _| size.checked_mul(growth));
        if size.is_none_or(|size| size > MOST_TERMS) {
            return None;
        }
        let division = self.rest.pseudo_division(variable, top, bottom);
        self.scale(&division.multiplier)?;
        self.add(relation.fact, division.quotient);
        self.rest = division.remainder;
        Some(())
    }

    fn put_square_in(&mut self, variable: Variable, relation: &Relation) -> Option<()> {
        let v = Polynomial::variable(variable);
        loop {
            let degree = self.rest.degree_in(variable);
            if degree < 2 {
                return Some(());
            }
            let quotient = self.rest.coefficient_of(variable, degree) * v.pow(degree - 2);
            let square = relation.denominator.clone() * v.clone() * v.clone();
            let fact = square - relation.numerator.clone();
            if quotient.len().checked_mul(fact.len())? > MOST_TERMS {
                return None;
            }
            self.scale(&relation.denominator)?;
            self.rest = self.rest.clone() * relation.denominator.clone() - quotient.clone() * fact;
            self.add(relation.fact, quotient);
        }
    }

    fn scale(&mut self, factor: &Polynomial) -> Option<()> {
        if factor.is_one() {
            return Some(());
        }
        self.multiplier = self.multiplier.product_within(factor, MOST_TERMS)?;
        for cofactor in self.cofactors.values_mut() {
            *cofactor = cofactor.product_within(factor, MOST_TERMS)?;
        }
        Some(())
    }

    fn add(&mut self, fact: usize, quotient: Polynomial) {
        *self.cofactors.entry(fact).or_default() += quotient;
    }
}

/// The variable that a rule gives and that no other rule leads to.
fn next(theory: &mut Theory, rest: &Polynomial) -> Option<(Variable, Arc<Relation>)> {
    let variables = rest.variables().into_iter();
    let found = variables.filter_map(|v| Some((v, theory.relation(v)?)));
    found.max_by_key(|(v, relation)| (relation.height, std::cmp::Reverse(*v)))
}

/// A sine or a root in a power above one.
fn next_square(theory: &mut Theory, rest: &Polynomial) -> Option<(Variable, Relation)> {
    let mut variables = rest.variables().into_iter();
    variables.find_map(|v| {
        let high = rest.degree_in(v) >= 2;
        Some((v, theory.square_relation(v).filter(|_| high)?))
    })
}

/// A proof that equations hold, multiplied out; `None` where none was found.
pub(crate) fn certify(theory: &mut Theory, equations: &[Equation]) -> Option<Proof> {
    certify_within(theory, equations, vec![])
}

/// A proof that equations hold and that numbers lie within bounds.
pub(crate) fn certify_within(
    theory: &mut Theory,
    equations: &[Equation],
    bounds: Vec<Bound>,
) -> Option<Proof> {
    let mut goals = vec![];
    for equation in equations {
        for place in 0..equation.residual.entries.len() {
            let left = side(&equation.left.entries, place)?;
            let right = side(&equation.right.entries, place)?;
            theory.solution.ledger.divide_by(&left.denominator);
            theory.solution.ledger.divide_by(&right.denominator);
            let mut done = Elimination::of(theory, difference(&left, &right))?;
            if !done.rest.is_zero() {
                let divisors = [&left.denominator, &right.denominator];
                theory.vanishes_by_relations(&mut done, &divisors)?;
            }
            let by = done.combination();
            goals.push(Goal { left, right, by });
        }
    }
    let argument = argument(theory, goals, bounds);
    if theory.leaves_nothing(&argument.conditions) {
        return None;
    }
    let proof = argument.checked();
    debug_assert!(
        proof.is_ok(),
        "a search that finds wrong cofactors: {proof:?}"
    );
    proof.ok()
}

/// A side at a place; a lone zero stands for a whole grid of them.
fn side(entries: &[Fraction], place: usize) -> Option<Ratio> {
    let fraction = match entries {
        [only] if only.is_zero() => only,
        _ => entries.get(place)?,
    };
    fraction.is_valid().then(|| ratio(fraction))
}

/// The goals with the facts, rates, kernels and conditions that they need, and no others.
fn argument(theory: &Theory, mut goals: Vec<Goal>, bounds: Vec<Bound>) -> Argument {
    let ledger = &theory.solution.ledger;
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    let mut open: Vec<usize> = goals.iter().flat_map(|g| indices(&g.by)).collect();
    while let Some(fact) = open.pop() {
        if needed.insert(fact) {
            match &ledger.facts[fact].reason {
                Reason::Rate(of) => open.push(*of),
                Reason::Congruence { by, .. } => open.push(*by),
                Reason::Combination(by) => open.extend(indices(by)),
                _ => {}
            }
        }
    }
    let place: BTreeMap<usize, usize> = needed.iter().copied().zip(0..).collect();
    let moved = |by: &mut Combination| {
        for (fact, _) in &mut by.cofactors {
            *fact = place[fact];
        }
    };
    let mut argument = Argument::default();
    for &index in &needed {
        let mut fact = ledger.facts[index].clone();
        match &mut fact.reason {
            Reason::Rate(of) => {
                for variable in ledger.facts[*of].value.variables() {
                    if let Some(rate) = ledger.rates.get(&variable) {
                        argument.rates.insert(variable, rate.clone());
                    }
                }
                *of = place[of];
            }
            Reason::Congruence { by, .. } => *by = place[by],
            Reason::Combination(by) => moved(by),
            _ => {}
        }
        argument.facts.push(fact);
    }
    goals.iter_mut().for_each(|goal| moved(&mut goal.by));
    argument.goals = goals;
    argument.bounds = bounds;
    argument.kernels = kernels(&argument, &ledger.kernels);
    argument.conditions = conditions(&argument, &ledger.conditions);
    argument
}

/// The kernels that stand in an argument, with those in their arguments.
fn kernels(argument: &Argument, known: &BTreeMap<Variable, Kernel>) -> BTreeMap<Variable, Kernel> {
    let mut found = BTreeMap::new();
    if known.is_empty() {
        return found;
    }
    let facts = argument.facts.iter().map(|fact| &fact.value);
    let sides = argument.goals.iter().flat_map(|g| [&g.left, &g.right]);
    let rates = argument.rates.values();
    let ratios = sides
        .chain(rates)
        .chain(argument.bounds.iter().map(|bound| &bound.value))
        .flat_map(|r| [&r.numerator, &r.denominator]);
    let mut open: Vec<Variable> = facts
        .chain(ratios)
        .flat_map(Polynomial::variables)
        .collect();
    while let Some(variable) = open.pop() {
        if let Some(kernel) = known.get(&variable)
            && found.insert(variable, kernel.clone()).is_none()
        {
            open.extend(kernel.argument.numerator.variables());
            open.extend(kernel.argument.denominator.variables());
        }
    }
    found
}

fn indices(by: &Combination) -> impl Iterator<Item = usize> {
    by.cofactors.iter().map(|(fact, _)| *fact)
}

/// The conditions that an argument needs.
fn conditions(argument: &Argument, known: &[Polynomial]) -> Vec<Polynomial> {
    let divisors = argument.divisors();
    let divides = |condition: &&Polynomial| {
        divisors
            .iter()
            .any(|d| d.exact_quotient(condition).is_some())
    };
    known.iter().filter(divides).cloned().collect()
}
