//! Whether a polynomial vanishes wherever others do, with the certificate that shows it.
//!
//! Premises that are linear in a variable are solved for it one after the other (the triangular sets of Ritt and
//! Wu); what remains goes through a Gröbner basis. The search remembers cofactors, so that its result can be checked
//! by multiplying out.

use super::combination::{Budget, Combination, Exhausted, Meter, Solved};
use super::groebner::Basis;
use crate::algebra::{Certificate, Polynomial, Variable};
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// What a reduction came to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reduction {
    /// The target vanishes wherever the premises do and the multiplier does not.
    Zero(Certificate),
    /// What is left of the target, up to a factor.
    Residue(Polynomial),
    /// The premises have no common zero: the certificate shows that 1 vanishes. Anything would follow.
    Contradiction(Certificate),
    /// The budget did not suffice.
    OutOfBudget,
}

/// Reduces a target by premises.
///
/// The multiplier of a certificate never vanishes by the premises themselves, as far as the reduction can tell: a
/// proof that rests on dividing by zero is not given.
///
/// ```
/// use polhode::algebra::{Budget, Polynomial, Reduction, reduce};
/// let [x, y, z] = [0, 1, 2].map(Polynomial::variable);
/// // From x = y z and y² = 1 follows x² = z².
/// let premises = [x.clone() - y.clone() * z.clone(), y.clone() * y - Polynomial::constant(1.into())];
/// let target = x.clone() * x - z.clone() * z;
/// let Reduction::Zero(certificate) = reduce(&target, &premises, Budget::default()) else { panic!("it follows") };
/// assert!(certificate.holds(&target, &premises));
/// ```
pub fn reduce(target: &Polynomial, premises: &[Polynomial], budget: Budget) -> Reduction {
    let mut meter = Meter::new(budget);
    attempt(target, premises, &mut meter).unwrap_or(Reduction::OutOfBudget)
}

/// Reduces a target by premises, dividing by nothing but products of variables that are said not to be zero.
///
/// Where the premises hold on several branches, what is zero on one of them alone is not found to vanish, unless the
/// branches differ by such a variable.
///
/// ```
/// use polhode::algebra::{Budget, Polynomial, Reduction, reduce_where};
/// let [x, y, z] = [0, 1, 2].map(Polynomial::variable);
/// // From z x = z y follows x = y where z is not zero, and z = 0 where it may be zero does not follow.
/// let premises = [z.clone() * x.clone() - z.clone() * y.clone()];
/// let nonzero = [2].into();
/// let reduced = |target: Polynomial| reduce_where(&target, &premises, &nonzero, Budget::default());
/// assert!(matches!(reduced(x - y), Reduction::Zero(_)));
/// assert!(matches!(reduced(z), Reduction::Residue(_)));
/// ```
pub fn reduce_where(
    target: &Polynomial,
    premises: &[Polynomial],
    nonzero: &BTreeSet<Variable>,
    budget: Budget,
) -> Reduction {
    let mut meter = Meter::new(budget);
    let attempt = |slopes, meter: &mut Meter| {
        System::new(premises, slopes, meter)?.reduce(target, premises.len(), meter)
    };
    attempt(Slopes::Products(nonzero), &mut meter).unwrap_or(Reduction::OutOfBudget)
}

fn attempt(
    target: &Polynomial,
    premises: &[Polynomial],
    meter: &mut Meter,
) -> Result<Reduction, Exhausted> {
    let system = System::new(premises, Slopes::Any, meter)?;
    let reduction = system.reduce(target, premises.len(), meter)?;
    let divided = match &reduction {
        Reduction::Zero(certificate) => certificate.multiplier.clone(),
        _ => return Ok(reduction),
    };
    if divided.is_constant().is_some() {
        return Ok(reduction);
    }
    // What was divided by must not be zero itself; else the proof is sought without divisions.
    let system = System::new(premises, Slopes::Any, meter)?;
    if !matches!(
        system.reduce(&divided, premises.len(), meter)?,
        Reduction::Zero(_)
    ) {
        return Ok(reduction);
    }
    System::new(premises, Slopes::Numbers, meter)?.reduce(target, premises.len(), meter)
}

/// What a variable's coefficient may be for an element to be solved for it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Slopes<'a> {
    /// Numbers alone: nothing is divided by.
    Numbers,
    /// Products of these variables.
    Products(&'a BTreeSet<Variable>),
    /// Any polynomial.
    Any,
}

impl Slopes<'_> {
    /// Whether an element may be divided by its coefficient of a variable. An element of one term is a product that
    /// vanishes: which of its factors does is not said.
    fn allow(self, slope: &Polynomial, element: &Polynomial) -> bool {
        slope.is_constant().is_some()
            || match self {
                Self::Numbers => false,
                Self::Products(nonzero) => {
                    let variables = slope.variables();
                    let all = variables.iter().all(|v| nonzero.contains(v));
                    slope.len() == 1 && element.len() > 1 && all
                }
                Self::Any => true,
            }
    }
}

/// Premises solved where linear, and the rest.
struct System {
    solved: Vec<Solved>,
    rest: Vec<Combination>,
}

impl System {
    fn new(
        premises: &[Polynomial],
        slopes: Slopes<'_>,
        meter: &mut Meter,
    ) -> Result<Self, Exhausted> {
        let generator = |(i, p): (usize, &Polynomial)| Combination::generator(i, p.clone());
        let mut rest: Vec<_> = premises.iter().enumerate().map(generator).collect();
        let mut solved = vec![];
        loop {
            rest.retain(|element| !element.value.is_zero());
            let Some((index, variable)) = best(&rest, slopes) else {
                break;
            };
            let next = Solved::new(rest.remove(index), variable);
            for element in &mut rest {
                if element.value.degree_in(variable) > 0 {
                    *element = element.without(&next, meter)?;
                }
            }
            solved.push(next);
        }
        Ok(Self { solved, rest })
    }

    /// Reduces a target, which counts as the generator `index` behind the premises.
    fn reduce(
        self,
        target: &Polynomial,
        index: usize,
        meter: &mut Meter,
    ) -> Result<Reduction, Exhausted> {
        let mut target = Combination::generator(index, target.clone());
        for solved in &self.solved {
            target = target.without(solved, meter)?;
        }
        let mut basis = Basis::new(self.rest);
        if basis.unit().is_none() {
            basis.reduce(&mut target, meter)?;
        }
        if let Some(unit) = basis.unit() {
            return Ok(Reduction::Contradiction(certificate(
                unit,
                index,
                Polynomial::one(),
                false,
            )));
        }
        if !target.value.is_zero() {
            return Ok(Reduction::Residue(target.value.primitive_part()));
        }
        let multiplier = target.cofactors.get(&index).cloned().unwrap_or_default();
        Ok(Reduction::Zero(certificate(
            &target, index, multiplier, true,
        )))
    }
}

/// The certificate of a combination; the target's own side has the other sign.
fn certificate(
    combination: &Combination,
    premises: usize,
    multiplier: Polynomial,
    negative: bool,
) -> Certificate {
    let cofactor = |i: usize| {
        let cofactor = combination.cofactors.get(&i).cloned().unwrap_or_default();
        if negative { -cofactor } else { cofactor }
    };
    Certificate {
        multiplier,
        cofactors: (0..premises).map(cofactor).collect(),
    }
}

/// The element and the variable that are solved next: a number before a short coefficient before a long one, and
/// short elements first.
fn best(elements: &[Combination], slopes: Slopes<'_>) -> Option<(usize, Variable)> {
    let mut found: Option<((bool, usize, usize), usize, Variable)> = None;
    for (index, element) in elements.iter().enumerate() {
        for variable in element.value.variables() {
            if element.value.degree_in(variable) != 1 {
                continue;
            }
            let slope = element.value.coefficient_of(variable, 1);
            if !slopes.allow(&slope, &element.value) {
                continue;
            }
            let symbolic = slope.is_constant().is_none();
            let cost = (symbolic, slope.len(), element.value.len());
            if found.as_ref().is_none_or(|(least, ..)| cost < *least) {
                found = Some((cost, index, variable));
            }
        }
    }
    found.map(|(_, index, variable)| (index, variable))
}
