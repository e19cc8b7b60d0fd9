//! From facts to a proof that a small checker multiplies out.
//!
//! Each variable that is not free has a fact that says what it is in free variables; such a fact is a combination of one
//! premise (a law, a line, a declaration) and of the facts of the variables in it. A goal is reduced by them to zero, and
//! the cofactors are kept.

use crate::algebra::{
    Argument, Combination, Fact, Fraction, Goal, Kernel, Polynomial, Proof, Ratio, Reason, Variable,
};
use crate::verify::facts::premises::{Facts, Rule};
use crate::verify::facts::small::Small;
use crate::verify::model::atoms::{Atoms, Nature};
use crate::verify::model::powers::lowered;
use num_traits::{One, Zero};
use std::collections::{BTreeMap, HashMap};

/// Cofactors of more terms than this are not kept; the proof is then not given.
const MOST_TERMS: usize = 60_000;

/// How many variables are put in at most.
const MOST_STEPS: usize = 400;

/// Builds one argument.
pub(super) struct Prover<'a> {
    facts: &'a mut Facts,
    pub(super) atoms: &'a mut Atoms,
    small: &'a Small,
    argument: Argument,
    /// The fact that tells a variable, by its place in the argument.
    told: HashMap<Variable, usize>,
    squares: HashMap<Variable, usize>,
}

/// A polynomial that is being reduced: multiplier · start = Σ cofactor · fact + value.
pub(super) struct Reduced {
    pub(super) value: Polynomial,
    multiplier: Polynomial,
    pub(super) cofactors: BTreeMap<usize, Polynomial>,
}

/// A proof that each pair is equal; `None` where it does not come out, or grows too large.
///
/// Of what is small the squares and products are dropped, each by a premise that says so.
pub(crate) fn prove(
    facts: &mut Facts,
    atoms: &mut Atoms,
    sides: &[(Fraction, Fraction)],
    small: &Small,
) -> Option<Proof> {
    let mut prover = Prover {
        facts: &mut *facts,
        atoms: &mut *atoms,
        small,
        argument: Argument::default(),
        told: HashMap::new(),
        squares: HashMap::new(),
    };
    for (left, right) in sides {
        prover.goal(left, right)?;
    }
    let mut argument = prover.argument;
    argument.conditions = factors(&argument.divisors());
    // A proof that divides by what vanishes is none, and neither is one to first order that divides by what is small:
    // that makes a first order of a second one.
    for condition in &argument.conditions {
        // Nor is one that hangs on where points lie of which nobody tells it.
        if atoms.hangs_on_places(condition) {
            return None;
        }
        let condition = Fraction::from(condition.clone());
        if facts
            .normal(atoms, &condition)
            .is_ok_and(|value| value.is_zero() || small.vanishes(atoms, value.numerator()))
        {
            return None;
        }
    }
    argument.checked().ok()
}

fn ratio(of: &Fraction) -> Ratio {
    Ratio {
        numerator: of.numerator().clone(),
        denominator: of.denominator().clone(),
    }
}

impl Prover<'_> {
    fn goal(&mut self, left: &Fraction, right: &Fraction) -> Option<()> {
        let (left, right) = (ratio(left), ratio(right));
        let target = crate::algebra::difference(&left, &right);
        let mut reduced = self.reduce(target, usize::MAX)?;
        self.drop_small(&mut reduced);
        if !reduced.value.is_zero() {
            return None;
        }
        let by = Combination {
            multiplier: reduced.multiplier,
            cofactors: reduced.cofactors.into_iter().collect(),
        };
        self.argument.goals.push(Goal { left, right, by });
        Some(())
    }

    /// Reduces by everything that was told before a time, one variable after the other.
    fn reduce(&mut self, start: Polynomial, before: usize) -> Option<Reduced> {
        let mut reduced = Reduced::of(start);
        for _ in 0..MOST_STEPS {
            let told = |v: &Variable| {
                self.facts
                    .told_at(self.atoms, *v)
                    .is_some_and(|time| time < before)
            };
            let Some(variable) = reduced.value.variables().into_iter().rev().find(told) else {
                if self.lower_squares(&mut reduced, before)? {
                    continue;
                }
                return Some(reduced);
            };
            let value = self.facts.told(self.atoms, variable)?;
            let fact = self.fact_of(variable, &value)?;
            if let Some(quotient) = reduced.put_in(variable, &value) {
                reduced.add(fact, quotient);
                continue;
            }
            let division =
                reduced
                    .value
                    .pseudo_division(variable, value.numerator(), value.denominator());
            reduced.scale(&division.multiplier);
            reduced.add(fact, division.quotient);
            reduced.value = division.remainder;
            if reduced.value.len() > MOST_TERMS {
                return None;
            }
        }
        None
    }

    /// Puts in what is known of squares, and says whether there was anything.
    pub(super) fn lower_squares(&mut self, reduced: &mut Reduced, before: usize) -> Option<bool> {
        let mut any = false;
        for _ in 0..32 {
            let next = reduced.value.variables().into_iter().rev().find_map(|v| {
                let told = self.facts.square(v).filter(|rule| rule.time < before);
                let told = told.map(|rule| rule.value.numerator().clone());
                let square = told.or_else(|| self.atoms.atom(v).square.clone())?;
                (reduced.value.degree_in(v) > 1).then_some((v, square))
            });
            let Some((variable, square)) = next else {
                return Some(any);
            };
            any = true;
            let fact = self.fact_of_square(variable, &square)?;
            let quotient = quotient_by_square(&reduced.value, variable, &square);
            reduced.value = lowered(&reduced.value, variable, &square);
            reduced.add(fact, quotient);
        }
        None
    }

    /// The fact that d·v − n vanishes, for what is told of a variable.
    fn fact_of(&mut self, variable: Variable, value: &Fraction) -> Option<usize> {
        if let Some(&known) = self.told.get(&variable) {
            return Some(known);
        }
        let solved = Polynomial::variable(variable) * value.denominator().clone()
            - value.numerator().clone();
        let place = match self.facts.rule(variable).cloned() {
            Some(rule) => self.solved_from(&rule, solved)?,
            None => {
                let name = self.name_of(variable)?;
                self.push(solved, Reason::Premise(name))
            }
        };
        self.told.insert(variable, place);
        Some(place)
    }

    /// The fact that a rule tells: a combination of its premise and of what was told before.
    fn solved_from(&mut self, rule: &Rule, solved: Polynomial) -> Option<usize> {
        let name = rule.source.text();
        if rule.equation == solved {
            return Some(self.push(solved, Reason::Premise(name)));
        }
        let start = self.push(rule.equation.clone(), Reason::Premise(name));
        let reduced = self.reduce(rule.equation.clone(), rule.time)?;
        // multiplier · premise − Σ cofactor · fact is what is left, a multiple of the solved form.
        let mut reduced = reduced;
        let factor = match reduced.value.exact_quotient(&solved) {
            Some(factor) => factor,
            None => self.other_root(&mut reduced, &solved, rule.time)?,
        };
        if factor.is_zero() {
            return None;
        }
        let mut cofactors: Vec<(usize, Polynomial)> = reduced
            .cofactors
            .into_iter()
            .map(|(fact, c)| (fact, -c))
            .collect();
        cofactors.push((start, reduced.multiplier));
        let reason = Reason::Combination(Combination {
            multiplier: factor,
            cofactors,
        });
        Some(self.push(solved, reason))
    }

    /// Who says what is told of a variable.
    fn name_of(&self, variable: Variable) -> Option<String> {
        let mut at = variable;
        loop {
            if let Some(law) = &self.atoms.atom(at).law {
                return Some(law.name.to_owned());
            }
            if let Some(rule) = self.facts.rule(at) {
                return Some(format!("the rate of {}", rule.source.text()));
            }
            at = self.atoms.atom(at).rate_of?;
        }
    }

    fn fact_of_square(&mut self, variable: Variable, square: &Polynomial) -> Option<usize> {
        if let Some(&known) = self.squares.get(&variable) {
            return Some(known);
        }
        let v = Polynomial::variable(variable);
        let value = v.clone() * v - square.clone();
        let place = match self.facts.square(variable) {
            Some(rule) => {
                let rule = rule.clone();
                self.solved_from(&rule, value)?
            }
            None => {
                let reason = self.reason_of_square(variable)?;
                let value = match &reason {
                    Reason::Circle { sine, cosine } => {
                        let square = |v: &Variable| Polynomial::variable(*v).pow(2);
                        square(sine) + square(cosine) - Polynomial::one()
                    }
                    _ => value,
                };
                self.push(value, reason)
            }
        };
        self.squares.insert(variable, place);
        Some(place)
    }

    /// The relation of a sine or a root.
    fn reason_of_square(&mut self, variable: Variable) -> Option<Reason> {
        let atom = self.atoms.atom(variable).clone();
        match &atom.nature {
            Nature::Sine(angle) => {
                let cosine = (0..self.atoms.len() as Variable).find(
                    |&v| matches!(&self.atoms.atom(v).nature, Nature::Cosine(a) if a == angle),
                )?;
                let kernel = |function| Kernel {
                    function,
                    argument: ratio(angle),
                };
                self.argument.kernels.insert(variable, kernel("sin"));
                self.argument.kernels.insert(cosine, kernel("cos"));
                Some(Reason::Circle {
                    sine: variable,
                    cosine,
                })
            }
            Nature::UnitPart(_) => Some(Reason::Premise("unit vector".into())),
            Nature::Root(inside) => {
                let kernel = Kernel {
                    function: "sqrt",
                    argument: ratio(inside),
                };
                self.argument.kernels.insert(variable, kernel);
                Some(Reason::Root(variable))
            }
            _ => None,
        }
    }

    /// Drops what is of a higher order, and puts in what kernels of small angles are.
    fn drop_small(&mut self, reduced: &mut Reduced) {
        let name = || Reason::Premise(self.small.premise().into());
        for (variable, value) in self.small.kernels(self.atoms, &reduced.value) {
            let fact = self.push(Polynomial::variable(variable) - value.clone(), name());
            let division = reduced
                .value
                .pseudo_division(variable, &value, &Polynomial::one());
            reduced.add(fact, division.quotient);
            reduced.value = division.remainder;
        }
        for (product, cofactor) in self.small.dropped(self.atoms, &reduced.value) {
            reduced.value -= product.clone() * cofactor.clone();
            let fact = self.push(product, name());
            reduced.add(fact, cofactor);
        }
    }

    fn push(&mut self, value: Polynomial, reason: Reason) -> usize {
        self.argument.facts.push(Fact { value, reason });
        self.argument.facts.len() - 1
    }
}

impl Reduced {
    /// Of which nothing is reduced yet.
    pub(super) fn of(start: Polynomial) -> Self {
        Self {
            value: start,
            multiplier: Polynomial::one(),
            cofactors: BTreeMap::new(),
        }
    }

    /// Puts in the value of a variable, and returns the cofactor of its fact d·v − n, where the denominator d divides the
    /// coefficients already: multiplied again for each variable over d, its powers would pile up.
    fn put_in(&mut self, variable: Variable, value: &Fraction) -> Option<Polynomial> {
        let (top, bottom) = (value.numerator(), value.denominator());
        if bottom.is_constant().is_some() {
            return None;
        }
        let (mut rest, mut quotient) = (self.value.clone(), Polynomial::zero());
        for power in (1..=rest.degree_in(variable)).rev() {
            let slope = rest.coefficient_of(variable, power);
            if slope.is_zero() {
                continue;
            }
            let lower = Polynomial::variable(variable).pow(power - 1);
            let part = slope.exact_quotient(bottom)? * lower.clone();
            rest -= slope * lower * Polynomial::variable(variable);
            rest += part.clone() * top.clone();
            quotient += part;
        }
        self.value = rest;
        Some(quotient)
    }

    pub(super) fn scale(&mut self, factor: &Polynomial) {
        if factor.is_one() {
            return;
        }
        self.multiplier *= factor.clone();
        for cofactor in self.cofactors.values_mut() {
            *cofactor *= factor.clone();
        }
    }

    pub(super) fn add(&mut self, fact: usize, cofactor: Polynomial) {
        if !cofactor.is_zero() {
            *self.cofactors.entry(fact).or_default() += cofactor;
        }
    }
}

/// (p − lowered p) / (v² − square).
fn quotient_by_square(of: &Polynomial, variable: Variable, square: &Polynomial) -> Polynomial {
    let v = Polynomial::variable(variable);
    let mut sum = Polynomial::zero();
    for power in 2..=of.degree_in(variable) {
        let coefficient = of.coefficient_of(variable, power);
        if coefficient.is_zero() {
            continue;
        }
        let odd = if power % 2 == 1 {
            v.clone()
        } else {
            Polynomial::one()
        };
        let half = power / 2;
        let mut inner = Polynomial::zero();
        for j in 0..half {
            inner += v.pow(2 * j) * square.pow(half - 1 - j);
        }
        sum += coefficient * odd * inner;
    }
    sum
}

/// What must not vanish for none of these to vanish: their variables where they are products, and what is left.
fn factors(divisors: &[Polynomial]) -> Vec<Polynomial> {
    let mut found: Vec<Polynomial> = vec![];
    let mut rests: Vec<Polynomial> = vec![];
    for divisor in divisors {
        let common = divisor.common_monomial();
        for (variable, _) in common.factors() {
            let factor = Polynomial::variable(variable);
            if !found.contains(&factor) {
                found.push(factor);
            }
        }
        rests.push(divisor.divided_by(&common));
    }
    // Shorter ones first: they may be what longer ones are made of.
    rests.sort_by_key(Polynomial::len);
    for mut rest in rests {
        for known in &found {
            while let Some(quotient) = rest.exact_quotient(known).filter(|q| !q.is_zero()) {
                rest = quotient;
            }
        }
        if rest.is_constant().is_none() {
            found.push(rest);
        }
    }
    found
}

/// The sources that a proof names, sorted.
pub(crate) fn uses(proof: &Proof) -> Vec<String> {
    proof.premises().into_iter().map(str::to_owned).collect()
}
