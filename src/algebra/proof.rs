//! The checker of whole proofs: it multiplies out, and does nothing else.
//!
//! An [`Argument`] is a list of facts (polynomials that are said to vanish, each with its reason) and of goals
//! (equations that follow from them). It may come from anywhere. [`Argument::checked`] is the only way to a
//! [`Proof`], and it believes nothing but the premises.

use crate::algebra::{Bound, Polynomial, Variable};
use num_traits::{One, Zero};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::Arc;

/// A quotient of polynomials, as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// Above the line.
    pub numerator: Polynomial,
    /// Below the line.
    pub denominator: Polynomial,
}

/// A variable that stands for a function of an argument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// `sin`, `cos`, `sqrt`, …
    pub function: &'static str,
    /// What it is a function of.
    pub argument: Ratio,
}

/// multiplier · value = Σ cofactor · fact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Combination {
    /// What the value is multiplied by.
    pub multiplier: Polynomial,
    /// Indices of facts with their cofactors.
    pub cofactors: Vec<(usize, Polynomial)>,
}

/// Why a polynomial vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// A law or a premise of the document says so; its name.
    Premise(String),
    /// It is s² + c² − 1 for the sine and the cosine of one argument.
    Circle {
        /// The variable of the sine.
        sine: Variable,
        /// The variable of the cosine.
        cosine: Variable,
    },
    /// It is d r² − n for the square root r of n/d.
    Root(Variable),
    /// It is the rate of an earlier fact, by the table of rates.
    Rate(usize),
    /// It is the difference of one function at two arguments, whose difference is an earlier fact.
    Congruence {
        /// The variable of the function at one argument.
        one: Variable,
        /// The variable of the function at the other.
        other: Variable,
        /// The fact that the arguments are equal.
        by: usize,
    },
    /// It is a combination of earlier facts.
    Combination(Combination),
}

/// A polynomial that vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// The polynomial.
    pub value: Polynomial,
    /// Why.
    pub reason: Reason,
}

/// An equation that is to be shown, one component of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Goal {
    /// The left side.
    pub left: Ratio,
    /// The right side.
    pub right: Ratio,
    /// How the numerator of left − right, over the product of both denominators, comes from the facts.
    pub by: Combination,
}

/// A proof as it is proposed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Argument {
    /// What vanishes; each rests on earlier ones alone.
    pub facts: Vec<Fact>,
    /// The time derivatives of variables.
    pub rates: BTreeMap<Variable, Ratio>,
    /// The functions that variables stand for.
    pub kernels: BTreeMap<Variable, Kernel>,
    /// What is to be shown.
    pub goals: Vec<Goal>,
    /// What numbers lie between.
    pub bounds: Vec<Bound>,
    /// What must not be zero: every divisor is a product of powers of these.
    pub conditions: Vec<Polynomial>,
}

/// Evidence that arguments were multiplied out and hold. Only the checker makes one.
///
/// ```
/// use polhode::algebra::{Argument, Combination, Fact, Goal, Polynomial, Ratio, Reason};
/// use num_traits::One;
/// let [x, y] = [0, 1].map(Polynomial::variable);
/// let whole = |numerator: &Polynomial| Ratio { numerator: numerator.clone(), denominator: Polynomial::one() };
/// // From x − y = 0 follows x² = y², with the cofactor x + y.
/// let by = |cofactor: Polynomial| Combination { multiplier: Polynomial::one(), cofactors: vec![(0, cofactor)] };
/// let argument = |cofactor| Argument {
///     facts: vec![Fact { value: x.clone() - y.clone(), reason: Reason::Premise("line 3".into()) }],
///     goals: vec![Goal { left: whole(&x.pow(2)), right: whole(&y.pow(2)), by: by(cofactor) }],
///     ..Argument::default()
/// };
/// assert!(argument(x.clone() + y.clone()).checked().is_ok());
/// assert!(argument(x.clone() - y.clone()).checked().is_err());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof(Arc<[Argument]>);

/// Why an argument does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The fact of this index does not follow as it says.
    Fact(usize),
    /// The goal of this index does not follow as it says.
    Goal(usize),
    /// The bound of this index does not hold.
    Bound(usize),
    /// There is no goal.
    Empty,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fact(index) => write!(f, "fact {index} does not follow as it says"),
            Self::Goal(index) => write!(f, "goal {index} does not follow as it says"),
            Self::Bound(index) => write!(f, "bound {index} does not hold"),
            Self::Empty => f.write_str("nothing is shown"),
        }
    }
}

impl std::error::Error for Fault {}

impl Argument {
    /// Checks everything by multiplying out.
    ///
    /// # Errors
    ///
    /// The first [`Fault`].
    pub fn checked(self) -> Result<Proof, Fault> {
        if self.goals.is_empty() {
            return Err(Fault::Empty);
        }
        for index in 0..self.facts.len() {
            self.fact_holds(index).ok_or(Fault::Fact(index))?;
        }
        for index in 0..self.goals.len() {
            self.goal_holds(index).ok_or(Fault::Goal(index))?;
        }
        for (index, bound) in self.bounds.iter().enumerate() {
            holds(bound.holds(&self.kernels)).ok_or(Fault::Bound(index))?;
        }
        Ok(Proof(Arc::new([self])))
    }

    /// Everything that is divided by and is no number, each once.
    pub fn divisors(&self) -> Vec<Polynomial> {
        let mut all: Vec<&Polynomial> = vec![];
        for goal in &self.goals {
            all.extend([&goal.left.denominator, &goal.right.denominator]);
            all.push(&goal.by.multiplier);
        }
        all.extend(self.rates.values().map(|ratio| &ratio.denominator));
        all.extend(self.kernels.values().map(|k| &k.argument.denominator));
        all.extend(self.facts.iter().filter_map(|fact| match &fact.reason {
            Reason::Combination(by) => Some(&by.multiplier),
            _ => None,
        }));
        let mut found: Vec<Polynomial> = vec![];
        for divisor in all {
            if !divisor.variables().is_empty() && !found.contains(divisor) {
                found.push(divisor.clone());
            }
        }
        found
    }

    fn fact_holds(&self, index: usize) -> Option<()> {
        let Fact { value, reason } = &self.facts[index];
        let earlier = |i: usize| self.facts[..index].get(i).map(|fact| &fact.value);
        match reason {
            Reason::Premise(name) => holds(!name.is_empty()),
            Reason::Circle { sine, cosine } => {
                let (s, c) = (self.kernels.get(sine)?, self.kernels.get(cosine)?);
                holds(s.function == "sin" && c.function == "cos" && s.argument == c.argument)?;
                self.allows(&s.argument.denominator)?;
                let square = |v| Polynomial::variable(v) * Polynomial::variable(v);
                holds(*value == square(*sine) + square(*cosine) - Polynomial::one())
            }
            Reason::Root(root) => {
                let Kernel { function, argument } = self.kernels.get(root)?;
                holds(*function == "sqrt")?;
                self.allows(&argument.denominator)?;
                let square = Polynomial::variable(*root) * Polynomial::variable(*root);
                holds(*value == argument.denominator.clone() * square - argument.numerator.clone())
            }
            Reason::Rate(of) => {
                let before = earlier(*of)?;
                for variable in before.variables() {
                    self.allows(&self.rates.get(&variable)?.denominator)?;
                }
                holds(*value == rate(before, &self.rates)?)
            }
            Reason::Congruence { one, other, by } => {
                let (first, second) = (self.kernels.get(one)?, self.kernels.get(other)?);
                holds(first.function == second.function)?;
                let (first, second) = (&first.argument, &second.argument);
                self.allows(&first.denominator)?;
                self.allows(&second.denominator)?;
                holds(*earlier(*by)? == difference(first, second))?;
                holds(*value == Polynomial::variable(*one) - Polynomial::variable(*other))
            }
            Reason::Combination(combination) => self.combines(value, combination, index),
        }
    }

    fn goal_holds(&self, index: usize) -> Option<()> {
        let Goal { left, right, by } = &self.goals[index];
        self.allows(&left.denominator)?;
        self.allows(&right.denominator)?;
        self.combines(&difference(left, right), by, self.facts.len())
    }

    /// Whether multiplier · value = Σ cofactor · fact, with facts before `end` alone.
    fn combines(&self, value: &Polynomial, by: &Combination, end: usize) -> Option<()> {
        self.allows(&by.multiplier)?;
        let mut products = Vec::with_capacity(by.cofactors.len());
        for (fact, cofactor) in &by.cofactors {
            products.push((cofactor, &self.facts[..end].get(*fact)?.value));
        }
        let sum = Polynomial::sum_of_products(&products);
        holds(match by.multiplier.is_one() {
            true => sum == *value,
            false => sum == by.multiplier.clone() * value.clone(),
        })
    }

    /// Whether a divisor is a number that is not zero, times powers of conditions.
    fn allows(&self, divisor: &Polynomial) -> Option<()> {
        let mut rest = divisor.clone();
        for condition in &self.conditions {
            if rest.len() == 1 && rest.variables().is_empty() {
                break;
            }
            if condition.variables().is_empty() {
                continue;
            }
            while let Some(quotient) = rest.exact_quotient(condition).filter(|q| !q.is_zero()) {
                rest = quotient;
            }
        }
        holds(rest.len() == 1 && rest.variables().is_empty())
    }
}

fn holds(is_so: bool) -> Option<()> {
    is_so.then_some(())
}

/// The numerator of left − right over the product of both denominators.
pub fn difference(left: &Ratio, right: &Ratio) -> Polynomial {
    left.numerator.clone() * right.denominator.clone()
        - right.numerator.clone() * left.denominator.clone()
}

/// The rate of a polynomial by the rates of its variables, times every denominator among these once; `None` where the
/// rate of a variable is not in the table.
pub fn rate(polynomial: &Polynomial, rates: &BTreeMap<Variable, Ratio>) -> Option<Polynomial> {
    let variables = polynomial.variables();
    let mut sum = Polynomial::zero();
    for variable in &variables {
        let mut term = polynomial.partial(*variable) * rates.get(variable)?.numerator.clone();
        for other in variables.iter().filter(|other| *other != variable) {
            let below = &rates.get(other)?.denominator;
            if !below.is_one() {
                term *= below.clone();
            }
        }
        sum += term;
    }
    Some(sum)
}

impl Proof {
    /// Both together.
    pub fn and(&self, other: &Self) -> Self {
        Self(self.0.iter().chain(other.0.iter()).cloned().collect())
    }

    /// What was multiplied out.
    pub fn arguments(&self) -> &[Argument] {
        &self.0
    }

    /// The names of the premises that stand in it.
    pub fn premises(&self) -> BTreeSet<&str> {
        let facts = self.0.iter().flat_map(|argument| &argument.facts);
        facts
            .filter_map(|fact| match &fact.reason {
                Reason::Premise(name) => Some(name.as_str()),
                _ => None,
            })
            .collect()
    }
}
