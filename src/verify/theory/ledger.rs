//! The facts that proofs rest on: each law and each solved premise as a polynomial that vanishes, with its reason.
//!
//! A rule `v = n/d` of the theory becomes the fact d·v − n, its rates become rates of that fact, and a rule that was
//! solved from a line of the document becomes a combination of the line as written and of earlier rules.

use crate::algebra::{
    Combination, Fact, Fraction, Kernel, Polynomial, Ratio, Reason, Variable, rate,
};
use crate::verify::theory::certify::Elimination;
use crate::verify::theory::law::has_own_rate;
use crate::verify::theory::{HIGHEST_ORDER, MOMENTARY, Theory};
use crate::verify::values::atoms::{Atom, Entity};
use foldhash::{HashMap, HashSet};
use num_traits::One;
use std::collections::BTreeMap;
use std::sync::Arc;

/// d·v − n, as a fact.
#[derive(Clone, Debug)]
pub(crate) struct Relation {
    /// n.
    pub numerator: Polynomial,
    /// d.
    pub denominator: Polynomial,
    /// The fact's index in the ledger.
    pub fact: usize,
    /// How many rules stand below it, at most: it is put in before those.
    pub height: u32,
}

/// Where a rule of the document comes from.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    /// The residual of the premise, as written.
    pub residual: Fraction,
    /// How many rules were solved before.
    pub before: usize,
}

/// What was made of laws and premises so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ledger {
    /// Facts that vanish; each rests on earlier ones alone.
    pub facts: Vec<Fact>,
    /// What must not be zero.
    pub conditions: Vec<Polynomial>,
    /// The functions that variables stand for.
    pub kernels: BTreeMap<Variable, Kernel>,
    /// Rates of variables.
    pub rates: BTreeMap<Variable, Ratio>,
    /// The relations of variables, where they have one.
    relations: HashMap<Variable, Option<Arc<Relation>>>,
    /// Facts of laws; they do not depend on the premises in force.
    laws: HashMap<Variable, usize>,
    pub squares: HashMap<Variable, usize>,
    /// Facts of premises solved for a variable: each rests on the rules before it, whichever are in force.
    solved: HashMap<Variable, usize>,
    /// The rates of facts.
    rates_of: HashMap<usize, usize>,
    /// Facts of relations that are kept, by their place, and of their rates.
    pub kept: HashMap<(usize, bool), Option<usize>>,
    open: HashSet<Variable>,
}

/// A fraction as the checker takes it.
pub(crate) fn ratio(fraction: &Fraction) -> Ratio {
    Ratio {
        numerator: fraction.numerator().clone(),
        denominator: fraction.denominator().clone(),
    }
}

impl Ledger {
    pub(crate) fn push(&mut self, value: Polynomial, reason: Reason) -> usize {
        self.facts.push(Fact { value, reason });
        self.facts.len() - 1
    }

    /// Notes the factors of a divisor.
    pub(crate) fn divide_by(&mut self, divisor: &Polynomial) {
        if divisor.is_constant().is_some() {
            return;
        }
        let common = divisor.common_monomial();
        let mut factors: Vec<Polynomial> = common
            .powers()
            .into_iter()
            .map(|(v, _)| Polynomial::variable(v))
            .collect();
        let mut rest = divisor.divided_by(&common).primitive_part();
        for known in &self.conditions {
            while let Some(quotient) = rest.exact_quotient(known) {
                rest = quotient;
            }
        }
        if rest.is_constant().is_none() {
            factors.push(rest);
        }
        for factor in factors {
            if !self.conditions.contains(&factor) {
                self.conditions.push(factor);
            }
        }
    }
}

impl Theory {
    /// The relation that gives a variable, if a law or a premise does.
    pub(crate) fn relation(&mut self, variable: Variable) -> Option<Arc<Relation>> {
        if let Some(known) = self.solution.ledger.relations.get(&variable) {
            return known.clone();
        }
        // A rule that leads back to its own variable says nothing; the variable stays free.
        if !self.solution.ledger.open.insert(variable) {
            return None;
        }
        let found = self.new_relation(variable);
        let found = found.map(|mut relation| {
            let below = [&relation.numerator, &relation.denominator];
            let heights = below
                .into_iter()
                .flat_map(Polynomial::variables)
                .map(|v| self.relation(v).map_or(0, |r| r.height));
            relation.height = 1 + heights.max().unwrap_or(0);
            Arc::new(relation)
        });
        self.solution.ledger.open.remove(&variable);
        self.solution
            .ledger
            .relations
            .insert(variable, found.clone());
        found
    }

    fn new_relation(&mut self, variable: Variable) -> Option<Relation> {
        let fact = match *self.atoms.atom(variable) {
            Atom::Part {
                entity,
                component,
                order,
            } => self.fact_of_part(variable, (entity, component), order)?,
            Atom::Kernel { .. } => self.congruence(variable)?,
            _ => self.law_fact(variable)?,
        };
        self.solved_for(variable, fact)
    }

    /// A fact read as the value of a variable in which it is linear.
    fn solved_for(&mut self, variable: Variable, fact: usize) -> Option<Relation> {
        let value = self.solution.ledger.facts[fact].value.clone();
        if value.degree_in(variable) != 1 {
            return None;
        }
        let denominator = value.coefficient_of(variable, 1);
        self.solution.ledger.divide_by(&denominator);
        Some(Relation {
            numerator: -value.coefficient_of(variable, 0),
            denominator,
            fact,
            height: 0,
        })
    }

    fn fact_of_part(&mut self, variable: Variable, part: (Entity, u8), order: u8) -> Option<usize> {
        let momentary = (part.0, part.1 | MOMENTARY);
        if order == 0 && self.solution.rules.contains_key(&momentary) {
            return self.solved_fact(variable, momentary);
        }
        let ruled = self.solution.rules.get(&part).map(|(ruled, _)| *ruled);
        match ruled.filter(|&ruled| ruled <= order) {
            Some(ruled) if ruled == order => self.solved_fact(variable, part),
            Some(_) => self.rate_fact(part, order),
            None => {
                // The rate of a law's own value is the rate of that law.
                let at_once = order == 1 && self.solution.rules.contains_key(&momentary);
                if order > 0 && !at_once && !has_own_rate(&self.atoms, part.0, order) {
                    let lower = self.atoms.part(part.0, part.1, order - 1);
                    if self.law(lower).is_some() {
                        return self.rate_fact(part, order);
                    }
                }
                self.law_fact(variable)
            }
        }
    }

    fn law_fact(&mut self, variable: Variable) -> Option<usize> {
        if let Some(&fact) = self.solution.ledger.laws.get(&variable) {
            return Some(fact);
        }
        let (name, value) = self.law(variable)?;
        if self.left_out.contains(name) {
            return None;
        }
        let fact = implicit(variable, &value);
        let fact = self
            .solution
            .ledger
            .push(fact, Reason::Premise(name.to_owned()));
        self.solution.ledger.laws.insert(variable, fact);
        Some(fact)
    }

    /// The rate of the fact that gives the derivative one order lower.
    fn rate_fact(&mut self, part: (Entity, u8), order: u8) -> Option<usize> {
        let lower = self.atoms.part(part.0, part.1, order.checked_sub(1)?);
        if order > HIGHEST_ORDER {
            return None;
        }
        let before = self.relation(lower)?.fact;
        self.rate_of(before)
    }

    /// The rate of a fact.
    pub(crate) fn rate_of(&mut self, before: usize) -> Option<usize> {
        if let Some(&known) = self.solution.ledger.rates_of.get(&before) {
            return Some(known);
        }
        let value = self.solution.ledger.facts[before].value.clone();
        for variable in value.variables() {
            let known = self.atoms.rate(variable);
            self.note_kernels(&known);
            self.solution.ledger.divide_by(known.denominator());
            self.solution.ledger.rates.insert(variable, ratio(&known));
        }
        let rate = rate(&value, &self.solution.ledger.rates)?;
        let fact = self.solution.ledger.push(rate, Reason::Rate(before));
        self.solution.ledger.rates_of.insert(before, fact);
        Some(fact)
    }

    fn solved_fact(&mut self, variable: Variable, part: (Entity, u8)) -> Option<usize> {
        if let Some(&known) = self.solution.ledger.solved.get(&variable) {
            return Some(known);
        }
        let fact = self.premise_fact(variable, part)?;
        self.solution.ledger.solved.insert(variable, fact);
        Some(fact)
    }

    /// A rule that was solved from a premise: what is left of the premise when the rules before are put in.
    fn premise_fact(&mut self, variable: Variable, part: (Entity, u8)) -> Option<usize> {
        let rule = self.solution.rules.get(&part)?.1.clone();
        let source = self.solution.sources.get(&part)?.clone();
        let written = source.residual.numerator().clone();
        let solved = implicit(variable, &rule.value);
        let premise = Reason::Premise(rule.name);
        if written == solved {
            return Some(self.solution.ledger.push(written, premise));
        }
        let premise = self.solution.ledger.push(written.clone(), premise);
        let done =
            self.with_rules_before(source.before, |theory| Elimination::of(theory, written))?;
        let extra = done.rest.exact_quotient(&solved)?;
        self.solution.ledger.divide_by(&extra);
        let mut cofactors = vec![(premise, done.multiplier)];
        cofactors.extend(done.cofactors.into_iter().map(|(fact, c)| (fact, -c)));
        let combination = Combination {
            multiplier: extra,
            cofactors,
        };
        Some(
            self.solution
                .ledger
                .push(solved, Reason::Combination(combination)),
        )
    }

    /// Works with the rules alone that were solved before a place in their order.
    fn with_rules_before<R>(&mut self, before: usize, work: impl FnOnce(&mut Self) -> R) -> R {
        let fewer = self
            .solution
            .rules
            .iter()
            .filter(|(part, _)| {
                self.solution
                    .sources
                    .get(part)
                    .is_some_and(|s| s.before < before)
            })
            .map(|(part, rule)| (*part, rule.clone()))
            .collect();
        let rules = std::mem::replace(&mut self.solution.rules, fewer);
        let normals = std::mem::take(&mut self.solution.normals);
        let relations = std::mem::take(&mut self.solution.ledger.relations);
        let open = std::mem::take(&mut self.solution.ledger.open);
        let result = work(self);
        self.solution.rules = rules;
        self.solution.normals = normals;
        self.solution.ledger.relations = relations;
        self.solution.ledger.open = open;
        result
    }

    /// Forgets what rests on premises.
    pub(crate) fn forget_relations(&mut self) {
        self.solution.ledger.relations.clear();
        self.solution.ledger.open.clear();
        self.solution.ledger.kept.clear();
    }
}

/// d·v − n for v = n/d.
fn implicit(variable: Variable, value: &Fraction) -> Polynomial {
    let top = value.numerator().clone();
    if value.denominator().is_one() {
        return Polynomial::variable(variable) - top;
    }
    value.denominator().clone() * Polynomial::variable(variable) - top
}
