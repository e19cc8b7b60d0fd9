//! Premises solved for a symbol each: which symbol, and when none can be had.

use crate::algebra::{Fraction, Monomial, Polynomial, Variable};
use crate::verify::theory::kept::{Kept, Relations};
use crate::verify::theory::law::Dynamics;
use crate::verify::theory::ledger::{Ledger, Source};
use crate::verify::theory::{MOMENTARY, Name, Premise, Rule, Taken, Theory};
use crate::verify::values::atoms::{Atom, Atoms, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Terms of a relation that is tried again.
const MOST_TERMS: usize = 12;

impl Theory {
    /// Solves all premises anew.
    pub(crate) fn rebuild(&mut self) -> Taken {
        let exhausted = std::mem::take(&mut self.exhausted);
        let taken = self.solve_all();
        self.solution.case = self.case_at_hand().filter(|_| !self.exhausted);
        self.exhausted |= exhausted;
        taken
    }

    /// Solves definitions first, then conditions without rates, then the rest.
    fn solve_all(&mut self) -> Taken {
        self.solution.rules.clear();
        self.solution.normals.clear();
        self.solution.relations = Relations::default();
        self.solution.sources.clear();
        self.solution.ledger = Ledger::default();
        self.put_fixed();
        let mut order: Vec<Premise> = self
            .premises
            .iter()
            .filter(|p| !self.left_out.contains(&p.name))
            .cloned()
            .collect();
        order.sort_by_key(|premise| self.turn(premise));
        if self.left_out.is_empty() {
            self.last_turn = order.last().map(|premise| self.turn(premise));
        }
        let rates = self.rates_met();
        let mut worst = Taken::Solved;
        for premise in &order {
            match self.solve(premise) {
                Taken::Contradiction => return Taken::Contradiction,
                Taken::Kept => worst = Taken::Kept,
                _ => {}
            }
        }
        if self.rates_met() > rates {
            return self.solve_all();
        }
        match worst {
            Taken::Kept => self.solve_kept(&order),
            _ => worst,
        }
    }

    /// Tries again what was kept, where rules came after it: they may have simplified it.
    fn solve_kept(&mut self, order: &[Premise]) -> Taken {
        let rules = self.solution.sources.len();
        let simple =
            |kept: &Kept| kept.rules < rules && kept.written.numerator().len() < MOST_TERMS;
        let names: BTreeSet<Name> = self
            .solution
            .relations
            .kept
            .iter()
            .filter(|kept| simple(kept))
            .map(|kept| kept.name.clone())
            .collect();
        self.solution
            .relations
            .kept
            .retain(|kept| !names.contains(&kept.name));
        for premise in order.iter().filter(|p| names.contains(&p.name)) {
            if self.solve(premise) == Taken::Contradiction {
                return Taken::Contradiction;
            }
        }
        match self.solution.relations.kept.is_empty() {
            true => Taken::Solved,
            false => Taken::Kept,
        }
    }

    /// Solves the residuals of a premise one after the other, simplest first.
    pub(crate) fn solve(&mut self, premise: &Premise) -> Taken {
        let in_force = premise.residuals.iter().filter(|r| !self.is_dropped(r));
        let mut left: Vec<(Fraction, &Fraction)> = in_force.map(|r| (r.clone(), r)).collect();
        let mut taken = Taken::Known;
        while !left.is_empty() {
            left = left
                .iter()
                .map(|(r, written)| (self.normal(r), *written))
                .filter(|(r, _)| !r.is_zero())
                .collect();
            left.retain(|(r, written)| !self.is_left_out_of_account(r, written));
            if left
                .iter()
                .any(|(r, _)| r.numerator().is_constant().is_some())
            {
                return Taken::Contradiction;
            }
            left.sort_by_key(|(r, _)| r.numerator().len());
            let solution = left
                .iter()
                .enumerate()
                .find_map(|(i, (r, _))| Some((i, self.solution(r, premise)?)));
            let Some((index, (variable, value))) = solution else {
                break;
            };
            let (_, written) = left.remove(index);
            self.insert(
                variable,
                written,
                Rule {
                    name: premise.name.clone(),
                    value: value.into(),
                },
            );
            taken = Taken::Solved;
        }
        if left.is_empty() {
            return taken;
        }
        let kept = left.iter().map(|(_, written)| Kept {
            name: premise.name.clone(),
            written: (*written).clone(),
            rules: self.solution.sources.len(),
        });
        self.solution.relations.kept.extend(kept);
        self.solution.relations.forget();
        self.solution.case = None;
        Taken::Kept
    }

    pub(crate) fn insert(&mut self, variable: Variable, written: &Fraction, rule: Rule) {
        if let Atom::Part {
            entity,
            component,
            order,
        } = *self.atoms.atom(variable)
        {
            let source = Source {
                residual: written.clone(),
                before: self.solution.sources.len(),
            };
            let momentary = order == 0 && self.instants.contains_key(&rule.name);
            let mark = if momentary { MOMENTARY } else { 0 };
            let part = (entity, component | mark);
            // A rate that a premise gave, and now follows from the value, must not be lost: its turn is behind this one.
            if let Some((ruled, of_rate)) = self.solution.rules.get(&part)
                && *ruled > order
            {
                let known = self.of_rates.entry(of_rate.name.clone()).or_default();
                *known = (*known).max(ruled.saturating_add(1));
                self.lost_rate = true;
            }
            self.solution.case = None;
            self.solution.sources.insert(part, source);
            self.solution.rules.insert(part, (order, rule));
            self.solution.normals.clear();
            self.solution.relations.forget();
            self.forget_relations();
        }
    }

    /// A variable of a residual in which it is linear, and its value.
    fn solution(&self, residual: &Fraction, premise: &Premise) -> Option<(Variable, Fraction)> {
        let polynomial = residual.numerator();
        // Of κ² = … the body does not follow, which κ is made of.
        let is_squared = |v: &Variable| polynomial.degree_in(*v) > 1;
        let of_body = |v: &Variable| {
            let owner = self.atoms.owner(*v);
            matches!(owner, Some(Owner::Quantity(Quantity::Inertia, _)))
        };
        let squared = premise.definition && premise.preferred.iter().any(is_squared);
        let variables = polynomial.variables().into_iter();
        let variables = variables.filter(|v| !squared || !of_body(v));
        let variables = variables.filter(|&v| !self.turns_with(v, premise));
        let candidates = variables.filter_map(|variable| {
            let score = self.solvable(polynomial, variable)?;
            let wanted = match premise.preferred.contains(&variable) {
                // A definition says what its symbol is, and nothing of what that is made of.
                true if premise.definition => 64,
                // The rule for a rate would be lost.
                true if !self.has_rule_of_rate(variable) => 8,
                _ => 0,
            };
            let behind = self.is_behind_a_mean(polynomial, variable);
            Some((score + wanted + u32::from(behind) * 128, variable))
        });
        let (_, variable) = candidates.max_by_key(|&(score, v)| (score, std::cmp::Reverse(v)))?;
        let coefficient = Fraction::from(polynomial.coefficient_of(variable, 1));
        let rest = Fraction::from(polynomial.coefficient_of(variable, 0));
        Some((variable, -rest / coefficient))
    }

    /// Whether a premise is a law for the rate of a vector of the document, of which a variable is a component: of
    /// M = dD/dt + ω × D with D₁ known nothing follows for D₂.
    fn turns_with(&self, variable: Variable, premise: &Premise) -> bool {
        let entity = self.atoms.entity_of(variable);
        self.order_of(variable) == 0 && entity.is_some_and(|e| self.is_law_of_rate(premise, e))
    }

    fn is_law_of_rate(&self, premise: &Premise, entity: Entity) -> bool {
        let info = self.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Vector;
        let mut residuals = premise.residuals.iter();
        own && residuals.any(|r| self.has_rate_of(r, entity))
    }

    /// Whether a law for the rate of a vector of the document is in force, which leaves open what it is.
    pub(crate) fn gives_rate_alone(&self, entity: Entity) -> bool {
        let mut premises = self.premises.iter();
        premises.any(|premise| self.is_law_of_rate(premise, entity))
    }

    /// Whether a rate of a symbol stands in what vanishes.
    pub(crate) fn has_rate_of(&self, residual: &Fraction, entity: Entity) -> bool {
        let mut met = residual.numerator().variables().into_iter();
        met.any(|v| self.atoms.entity_of(v) == Some(entity) && self.order_of(v) > 0)
    }

    /// Whether a premise gave a rate of a variable.
    fn has_rule_of_rate(&self, variable: Variable) -> bool {
        let atom = self.atoms.atom(variable);
        matches!(*atom, Atom::Part { entity, component, order }
            if self.solution.rules.get(&(entity, component)).is_some_and(|(ruled, _)| *ruled > order))
    }

    /// How well a polynomial can be solved for a variable; `None` where it cannot.
    fn solvable(&self, polynomial: &Polynomial, variable: Variable) -> Option<u32> {
        let Atom::Part {
            entity,
            component,
            order,
        } = *self.atoms.atom(variable)
        else {
            return None;
        };
        let info = self.atoms.info(entity);
        if info.owner == Owner::Quantity(Quantity::Time, String::new())
            || polynomial.degree_in(variable) != 1
        {
            return None;
        }
        // A lower order that is ruled already gives this one too.
        if self
            .solution
            .rules
            .get(&(entity, component))
            .is_some_and(|(ruled, _)| *ruled <= order)
        {
            return None;
        }
        // Solved for ω with ω̇ on the other side, a rule would lead from each derivative to a higher one, without end.
        let higher = |v: &Variable| match *self.atoms.atom(*v) {
            Atom::Part {
                entity: e,
                order: o,
                ..
            } => e == entity && o > order,
            _ => false,
        };
        let variables = polynomial.variables();
        if variables.iter().any(higher) || variables.iter().any(|&v| self.wraps(v, variable)) {
            return None;
        }
        let coefficient = polynomial.coefficient_of(variable, 1);
        let rest = polynomial.coefficient_of(variable, 0);
        let constant = coefficient.is_constant().is_some();
        let vanishes = rest.is_zero() && !constant;
        if vanishes
            && !self.never_zero(&coefficient)
            && !(order > 0 && self.seldom_zero(&coefficient))
        {
            return None;
        }
        let inertial = matches!(info.owner, Owner::Quantity(Quantity::Inertia, _));
        // Of (I₁ − I₂) ω₁ω₂ = 0 nothing says which factor vanishes, least of all that the body is another one.
        if inertial && vanishing_with_a_rate(&self.atoms, polynomial) {
            return None;
        }
        // What moves follows from what is given of the body, and not the other way round.
        let turns = matches!(info.owner, Owner::Quantity(Quantity::AngularVelocity, _));
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Scalar;
        let moves = turns || own && !info.constant;
        // Of an implicit step, what the body turned like before is a simple function of what it turns like behind.
        let of_a_step = matches!(&info.owner, Owner::Quantity(Quantity::AngularVelocity, step) if !step.is_empty());
        let small = coefficient.len() < 3;
        // A step gives the velocity that it is linear in: the one behind an explicit step, the one before an implicit one.
        let stepped = turns && small && self.is_stepped(polynomial, entity);
        // Of several rates, one whose factor vanishes nowhere.
        let everywhere = order > 0 && !constant && self.never_zero(&coefficient);
        Some(
            u32::from(constant) * 32
                + u32::from(order) * 4
                + u32::from(small)
                + u32::from(moves)
                + u32::from(inertial && component >= 3) * 2
                + u32::from(of_a_step && small) * 3
                + u32::from(stepped) * 4
                + u32::from(everywhere) * 2,
        )
    }

    /// Whether a symbol is the velocity behind a step that a mean value is made of: solved for that, the step is linear in
    /// the velocity before it. Where derivatives are taken, the mean is what is made of the two.
    fn is_behind_a_mean(&self, relation: &Polynomial, variable: Variable) -> bool {
        let behind = match self.atoms.owner(variable) {
            Some(Owner::Quantity(_, name)) => name.contains('+') || name.ends_with('\''),
            _ => false,
        };
        behind && self.setting.dynamics != Dynamics::Forward && self.is_mean(relation)
    }

    /// Whether a relation is linear and between three angular velocities, as before and behind a step and their mean.
    pub(crate) fn is_mean(&self, relation: &Polynomial) -> bool {
        let variant = |v: Variable| match self.atoms.owner(v) {
            Some(Owner::Quantity(Quantity::AngularVelocity, variant)) => Some(variant.as_str()),
            _ => None,
        };
        let names = relation.variables().into_iter().map(variant);
        let names: Option<BTreeSet<&str>> = names.collect();
        let mut terms = relation.terms().iter();
        terms.all(|(monomial, _)| monomial.degree() == 1) && names.is_some_and(|n| n.len() == 3)
    }

    /// Whether a relation is between angular velocities before and behind a step, and linear in this one.
    fn is_stepped(&self, relation: &Polynomial, entity: Entity) -> bool {
        let velocity = |v: &Variable| {
            let entity = self.atoms.entity_of(*v)?;
            let owner = &self.atoms.info(entity).owner;
            matches!(owner, Owner::Quantity(Quantity::AngularVelocity, _)).then_some(entity)
        };
        let several = relation
            .variables()
            .iter()
            .filter_map(velocity)
            .any(|e| e != entity);
        let degree = |monomial: &Monomial| -> u32 {
            let powers = monomial.powers().into_iter();
            let own = powers.filter(|(v, _)| self.atoms.entity_of(*v) == Some(entity));
            own.map(|(_, power)| power).sum()
        };
        several
            && relation
                .terms()
                .iter()
                .all(|(monomial, _)| degree(monomial) <= 1)
    }

    /// Whether a kernel has a variable in its argument: solved for that, it would stand for itself.
    fn wraps(&self, kernel: Variable, variable: Variable) -> bool {
        let Atom::Kernel { argument, .. } = self.atoms.atom(kernel) else {
            return false;
        };
        let inside = argument.variables();
        inside.contains(&variable) || inside.iter().any(|&v| self.wraps(v, variable))
    }

    /// Whether a polynomial vanishes at single angles alone, if at all: what it multiplies all the time is zero.
    fn seldom_zero(&self, polynomial: &Polynomial) -> bool {
        let angle = |v: &Variable| matches!(self.atoms.atom(*v), Atom::Kernel { .. });
        let [(monomial, _)] = polynomial.terms() else {
            return false;
        };
        let mut others = monomial.factors().map(|(v, _)| v).filter(|v| !angle(v));
        others.all(|v| self.never_zero(&Polynomial::variable(v)))
    }

    /// Whether a polynomial vanishes for no possible body: products of moments, masses and the document's own
    /// parameters.
    pub(crate) fn never_zero(&self, polynomial: &Polynomial) -> bool {
        let positive = |variable: Variable| match self.atoms.atom(variable) {
            Atom::Part {
                entity,
                component,
                order: 0,
            } => match &self.atoms.info(*entity).owner {
                Owner::Quantity(Quantity::Inertia, _) => *component < 3,
                Owner::Quantity(Quantity::Mass, _) => true,
                Owner::Symbol(_) => self.atoms.info(*entity).constant,
                Owner::Quantity(..) => false,
            },
            _ => false,
        };
        polynomial.len() == 1 && polynomial.variables().into_iter().all(positive)
    }
}

/// Whether a rate of turning is a factor of a polynomial, or a symbol of the document that moves.
fn vanishing_with_a_rate(atoms: &Atoms, polynomial: &Polynomial) -> bool {
    let turns = |v: Variable| match atoms.owner(v) {
        Some(Owner::Quantity(quantity, _)) => *quantity == Quantity::AngularVelocity,
        Some(Owner::Symbol(_)) => {
            let entity = atoms.entity_of(v);
            entity.is_some_and(|entity| !atoms.info(entity).constant)
        }
        None => false,
    };
    polynomial
        .common_monomial()
        .factors()
        .any(|(v, _)| turns(v))
}
