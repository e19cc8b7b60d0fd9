//! Relations of the document that give no symbol a value: M₃ = |M| cos θ, where |M| is made of M₃; c·c = 1.
//!
//! They are used as they stand: what is left of an equation when every rule is put in may be a combination of them,
//! which a Gröbner basis finds (Buchberger 1965), within a budget.

use crate::algebra::{
    Budget, Combination, Fraction, Monomial, Polynomial, Reason, Reduction, Variable, reduce_where,
};
use crate::scalar::Prime;
use crate::verify::theory::certify::Elimination;
use crate::verify::theory::variety::Variety;
use crate::verify::theory::world::Drawn;
use crate::verify::theory::{Name, Theory};
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Shape;
use num_traits::{One, Zero};
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

/// The work for one equation.
const BUDGET: Budget = Budget {
    terms: 4_000,
    reductions: 600,
};
/// Terms of a relation that equations are held against.
const MOST_TERMS: usize = 120;
/// Facts that one equation is held against.
const MOST_FACTS: usize = 40;

/// A relation that could not be solved for a symbol.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    /// Whose word it is.
    pub name: Name,
    /// What vanishes, as written.
    pub written: Fraction,
    /// How many rules there were when it could not be solved.
    pub rules: usize,
}

/// All of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Relations {
    /// In the order in which they were met.
    pub kept: Vec<Kept>,
    /// The order of rates up to which worlds satisfy them.
    pub order: u8,
    /// Those that hang together, where that is known.
    pub varieties: Option<Arc<[Variety]>>,
    /// Points of varieties modulo the prime, by the place of the variety and the seed.
    pub points: HashMap<(usize, u64), Point<Prime>>,
    /// Worlds modulo the prime, by the seed.
    pub worlds: HashMap<u64, Drawn<Prime>>,
    /// Whether they contradict each other, where that is known.
    contradictory: Option<bool>,
}

/// A value for each variable of a variety; `None` where a seed leads to no point.
pub(crate) type Point<T> = Option<Arc<[(Variable, T)]>>;

impl Relations {
    /// Forgets what depends on the rules in force.
    pub(crate) fn forget(&mut self) {
        self.varieties = None;
        self.points.clear();
        self.worlds.clear();
    }
}

impl Theory {
    /// What a relation may be divided by: the functions of angles and the lengths that stand in every term, as long as
    /// terms are left, and what vanishes for no body. A product does not say which of its factors vanishes; a rate in
    /// every term may well be the one, as nothing moves.
    pub(crate) fn content(&self, relation: &Polynomial) -> Monomial {
        let nonzero = |&(v, _): &(Variable, u32)| {
            let function = matches!(self.atoms.atom(v), Atom::Kernel { .. });
            function && relation.len() > 1 || self.never_zero(&Polynomial::variable(v))
        };
        let common = relation.common_monomial();
        Monomial::from_powers(common.powers().into_iter().filter(nonzero))
    }

    /// Whether a symbol of the document stands in a relation that is kept, as written or with every rule put in. That a
    /// vector has a length ties it to nothing, and a law for its rate does not say what it is.
    pub(crate) fn is_in_relation(&mut self, entity: Entity) -> bool {
        if !matches!(self.atoms.info(entity).owner, Owner::Symbol(_)) {
            return false;
        }
        let vector = self.atoms.info(entity).shape == Shape::Vector;
        let kept = self.solution.relations.kept.clone();
        kept.into_iter().any(|kept| {
            if vector && self.has_rate_of(&kept.written, entity) {
                return false;
            }
            let mut variables = self.normal(&kept.written).variables();
            variables.extend(kept.written.variables());
            let entities = variables
                .into_iter()
                .filter_map(|v| self.atoms.entity_of(v));
            let entities: BTreeSet<Entity> = entities.collect();
            entities.contains(&entity) && !(vector && entities.len() == 1)
        })
    }

    /// Whether a kept relation speaks of one instant alone.
    pub(crate) fn is_momentary(&self, kept: &Kept) -> bool {
        self.instants.contains_key(&kept.name)
    }

    /// The relation of an index, or its first rate, with every rule put in, as a fact; `None` where nothing is left of it.
    fn kept_fact(&mut self, index: usize, rate: bool) -> Option<usize> {
        if let Some(&known) = self.solution.ledger.kept.get(&(index, rate)) {
            return known;
        }
        let fact = self.new_kept_fact(index, rate);
        self.solution.ledger.kept.insert((index, rate), fact);
        fact
    }

    fn new_kept_fact(&mut self, index: usize, rate: bool) -> Option<usize> {
        let kept = self.solution.relations.kept.get(index)?.clone();
        let normal = self.normal(&kept.written);
        if rate && self.is_momentary(&kept) || self.is_heavy(&normal, rate) {
            return None;
        }
        let premise = Reason::Premise(kept.name);
        let written = kept.written.numerator().clone();
        let mut fact = self.solution.ledger.push(written, premise);
        if rate {
            fact = self.rate_of(fact)?;
        }
        let done = Elimination::of(self, self.solution.ledger.facts[fact].value.clone())?;
        if done.rest.is_zero() || done.rest.len() > MOST_TERMS {
            return None;
        }
        let content = self.content(&done.rest);
        let value = done.rest.divided_by(&content);
        let multiplier = Polynomial::term(content, One::one());
        self.solution.ledger.divide_by(&multiplier);
        let mut cofactors = vec![(fact, done.multiplier)];
        cofactors.extend(done.cofactors.into_iter().map(|(fact, c)| (fact, -c)));
        let reason = Reason::Combination(Combination {
            multiplier,
            cofactors,
        });
        Some(self.solution.ledger.push(value, reason))
    }

    fn order_of_kept(&mut self, index: usize) -> u8 {
        let written = self.solution.relations.kept[index].written.clone();
        let normal = self.normal(&written);
        self.highest_rate(&normal)
    }

    /// The facts that hang together with a polynomial: kept relations, the rates of those that are of a lower order, and
    /// the squares of functions.
    fn related_facts(&mut self, rest: &Polynomial, rates: bool) -> Vec<usize> {
        let orders = if rates { &[false, true][..] } else { &[false] };
        let highest = self.highest_rate(&Fraction::from(rest.clone()));
        let mut open: Vec<usize> = (0..self.solution.relations.kept.len())
            .flat_map(|index| orders.iter().map(move |&rate| (index, rate)))
            .filter_map(|(index, rate)| {
                let speaks = !rate || self.order_of_kept(index) < highest;
                speaks.then(|| self.kept_fact(index, rate))?
            })
            .collect();
        let mut variables: BTreeSet<Variable> = rest.variables().into_iter().collect();
        let mut squared: BTreeSet<Variable> = BTreeSet::new();
        let mut found: Vec<usize> = vec![];
        loop {
            for &variable in variables.difference(&squared.clone()) {
                squared.insert(variable);
                open.extend(self.square_relation(variable).map(|r| r.fact));
            }
            let touches = |theory: &Self, fact: usize| {
                let inside = theory.solution.ledger.facts[fact].value.variables();
                inside.iter().any(|v| variables.contains(v))
            };
            let Some(place) = open.iter().position(|&fact| touches(self, fact)) else {
                return found;
            };
            let fact = open.remove(place);
            variables.extend(self.solution.ledger.facts[fact].value.variables());
            if !found.contains(&fact) {
                found.push(fact);
            }
            if found.len() > MOST_FACTS {
                return found;
            }
        }
    }

    fn related_values(&mut self, rest: &Polynomial, rates: bool) -> (Vec<usize>, Vec<Polynomial>) {
        let facts = self.related_facts(rest, rates);
        let values = facts
            .iter()
            .map(|&fact| self.solution.ledger.facts[fact].value.clone());
        let values = values.collect();
        (facts, values)
    }

    /// Shows that what is left of an elimination is a combination of kept relations; `None` where none was found.
    pub(crate) fn vanishes_by_relations(
        &mut self,
        done: &mut Elimination,
        divisors: &[&Polynomial],
    ) -> Option<()> {
        if self.solution.relations.kept.is_empty() || self.is_contradictory() {
            return None;
        }
        [false, true].into_iter().find_map(|rates| {
            let (facts, values) = self.related_values(&done.rest, rates);
            let nonzero = self.nonzero(&done.rest, &values, divisors);
            // What the equation divides by, det I say, the relations may be multiplied by.
            let sums = divisors.iter().filter(|d| d.len() > 1);
            let factors = std::iter::once(Polynomial::one()).chain(sums.map(|&d| d.clone()));
            factors.into_iter().find_map(|factor| {
                let rest = done.rest.product_within(&factor, MOST_TERMS * 4)?;
                let reduction = reduce_where(&rest, &values, &nonzero, BUDGET);
                let Reduction::Zero(certificate) = reduction else {
                    return None;
                };
                let multiplier = certificate.multiplier * factor;
                self.solution.ledger.divide_by(&multiplier);
                done.vanishes_by(multiplier, facts.iter().copied().zip(certificate.cofactors))
            })
        })
    }

    /// Whether the kept relations say that one of some conditions vanishes: what holds where none does then holds nowhere.
    pub(crate) fn leaves_nothing(&mut self, conditions: &[Polynomial]) -> bool {
        if self.solution.relations.kept.is_empty() || conditions.is_empty() {
            return false;
        }
        let mut product = Polynomial::one();
        for condition in conditions {
            let Some(next) = product.product_within(condition, MOST_TERMS) else {
                return true;
            };
            product = next;
        }
        let values = self.related_values(&product, false).1;
        let all: BTreeSet<Variable> = values.iter().flat_map(Polynomial::variables).collect();
        for variable in all.into_iter().map(Polynomial::variable) {
            if self.never_zero(&variable) && product.len() <= MOST_TERMS {
                product *= variable;
            }
        }
        let Some(square) = product.product_within(&product, BUDGET.terms) else {
            return true;
        };
        let vanishes = reduce_where(&square, &values, &BTreeSet::new(), BUDGET);
        !matches!(vanishes, Reduction::Residue(_))
    }

    /// Variables that an equation may be divided by: those that vanish for no body, functions of an angle and roots, and
    /// what the equation itself divides by.
    fn nonzero(
        &self,
        rest: &Polynomial,
        values: &[Polynomial],
        divisors: &[&Polynomial],
    ) -> BTreeSet<Variable> {
        let below: BTreeSet<Variable> = divisors
            .iter()
            .flat_map(|d| d.common_monomial().powers())
            .map(|(v, _)| v)
            .collect();
        let all = values.iter().chain([rest]).flat_map(Polynomial::variables);
        all.filter(|&v| {
            below.contains(&v)
                || matches!(self.atoms.atom(v), Atom::Kernel { .. })
                || self.never_zero(&Polynomial::variable(v))
        })
        .collect()
    }

    /// Whether kept relations contradict each other, as rounded numbers may: from such nothing is concluded.
    fn is_contradictory(&mut self) -> bool {
        if let Some(known) = self.solution.relations.contradictory {
            return known;
        }
        let mut found = false;
        for index in 0..self.solution.relations.kept.len() {
            let Some(fact) = self.kept_fact(index, false) else {
                continue;
            };
            let value = self.solution.ledger.facts[fact].value.clone();
            let values = self.related_values(&value, false).1;
            let nothing = reduce_where(&Polynomial::one(), &values, &BTreeSet::new(), BUDGET);
            found |= matches!(nothing, Reduction::Zero(_) | Reduction::Contradiction(_));
        }
        self.solution.relations.contradictory = Some(found);
        found
    }
}
