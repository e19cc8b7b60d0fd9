//! What is known at a line: the laws, and the premises of the document solved for a symbol each.
//!
//! Together they form a triangular set (Ritt, Wu): every rule gives one variable in terms of others, and a
//! formula is brought to normal form by putting all rules in.

pub(super) mod attitude_law;
pub(super) mod certify;
pub(super) mod cones;
pub(super) mod decide;
mod dropped;
pub(super) mod kept;
pub(super) mod kernel_facts;
pub(super) mod law;
pub(super) mod ledger;
pub(super) mod mentioned;
pub(super) mod more_moments;
pub(super) mod normal;
pub(super) mod parallel_axes;
pub(super) mod parts_of_body;
pub(super) mod point;
pub(super) mod roots;
pub(super) mod solution;
pub(super) mod solve;
mod substances;
mod turns;
pub(super) mod variety;
pub(super) mod wheels;
pub(super) mod world;

use crate::algebra::{Fraction, Variable};
use crate::verify::theory::law::{Setting, law};
use crate::verify::theory::ledger::Ledger;
use crate::verify::theory::mentioned::Mentioned;
use crate::verify::theory::solution::{Solution, Solutions};
use crate::verify::values::atoms::{Atom, Atoms};
use crate::verify::values::figures::Alternative;
use crate::verify::values::quantity::Quantity;
use foldhash::HashMap;
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The name of a premise as it appears in `uses`: a law, `line 12`, or words of the document.
pub(super) type Name = String;

/// A variable's value by a law or a premise.
#[derive(Clone, Debug)]
pub(super) struct Rule {
    /// Whose word it is.
    pub name: Name,
    /// The value.
    pub value: Arc<Fraction>,
}

/// An equation of the document that is in force: each residual is zero.
#[derive(Clone, Debug)]
pub(super) struct Premise {
    /// Its name.
    pub name: Name,
    /// Left less right, component by component.
    pub residuals: Vec<Fraction>,
    /// The variables of the left side, which the author probably solves for.
    pub preferred: Vec<Variable>,
    /// A definition is taken in before assumptions on the motion.
    pub definition: bool,
}

/// What became of a premise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Taken {
    /// It says something new, now solved.
    Solved,
    /// It follows from what was known.
    Known,
    /// It is new but could not be solved for a symbol; it is kept as a relation.
    Kept,
    /// Nothing satisfies it together with what was known.
    Contradiction,
}

/// Terms of a value whose rate is still taken.
const MOST_TERMS_OF_A_RATE: usize = 400;
/// The highest order of a rate that a premise or a fact is differentiated for.
pub(super) const HIGHEST_ORDER: u8 = 6;

/// Marks the component of a rule that holds at one instant, so that a rule for the rate can stand beside it.
pub(super) const MOMENTARY: u8 = 0x80;

/// Laws and premises in force.
#[derive(Clone, Debug)]
pub(super) struct Theory {
    /// The variables.
    pub atoms: Atoms,
    /// What the laws depend on.
    pub setting: Setting,
    /// Names of laws and premises that are left out, to see whether a proof needs them.
    pub left_out: BTreeSet<Name>,
    /// Values that stand in the place of what laws and premises give.
    pub(super) fixed: Vec<Alternative>,
    /// Premises that say what something is at one instant, and whether words say so: nothing follows from them for its
    /// rate.
    pub(super) instants: BTreeMap<Name, bool>,
    pub(super) premises: Vec<Premise>,
    mentioned: Mentioned,
    /// The turn of the premise that was solved last.
    last_turn: Option<turns::Turn>,
    /// Angles that a vector makes with the axis of symmetry, and which vector; the axis, where it is named by its letter.
    pub(super) cones: BTreeMap<Variable, (Quantity, Option<u8>)>,
    /// Premises that turned out to speak of a rate, by what they gave.
    of_rates: HashMap<Name, u8>,
    /// Whether a rule for a rate gave way to one for the value.
    lost_rate: bool,
    /// What they come to.
    pub(super) solution: Box<Solution>,
    solutions: Solutions,
    /// What the laws say of variables, whichever are left out.
    laws: HashMap<Variable, Option<(&'static str, Arc<Fraction>)>>,
    open: BTreeSet<Variable>,
    /// Whether some normal form was given up because it grew beyond the budget.
    pub exhausted: bool,
    /// Terms that may still be written, where a reading of the document is only tried.
    pub(super) terms_left: Option<usize>,
}

impl Theory {
    /// The laws alone.
    pub(super) fn new(setting: Setting) -> Self {
        Self {
            atoms: Atoms::default(),
            setting,
            left_out: BTreeSet::new(),
            fixed: vec![],
            instants: BTreeMap::new(),
            premises: vec![],
            mentioned: Mentioned::default(),
            last_turn: None,
            cones: BTreeMap::new(),
            of_rates: HashMap::default(),
            lost_rate: false,
            solution: Box::default(),
            solutions: Solutions::default(),
            laws: HashMap::default(),
            open: BTreeSet::new(),
            exhausted: false,
            terms_left: None,
        }
    }

    /// The premises in force.
    pub(super) fn premises(&self) -> &[Premise] {
        &self.premises
    }

    /// Changes the setting; what was solved is solved again.
    pub(super) fn set(&mut self, change: impl FnOnce(&mut Setting)) {
        self.set_aside(Box::default());
        change(&mut self.setting);
        self.laws.clear();
        self.solve_again();
    }

    /// Leaves premises out by name for as long as `work` runs.
    pub(super) fn without<R>(
        &mut self,
        names: BTreeSet<Name>,
        work: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let left_out = std::mem::replace(&mut self.left_out, names);
        let before = self.solve_again();
        let premises = self.premises.len();
        let result = work(self);
        self.left_out = left_out;
        self.set_aside(before);
        if self.premises.len() != premises {
            self.rebuild();
        }
        result
    }

    /// Works with normal forms that come to so many terms, all together, and to no more.
    pub(super) fn within<R>(&mut self, terms: usize, work: impl FnOnce(&mut Self) -> R) -> R {
        let before = self.terms_left;
        let given = before.map_or(terms, |left| left.min(terms));
        self.terms_left = Some(given);
        let result = work(self);
        let spent = given - self.terms_left.unwrap_or(0);
        self.terms_left = before.map(|left| left - spent);
        self.exhausted = false;
        result
    }

    /// Keeps the premises for which `keep` holds.
    pub(super) fn retain(&mut self, keep: impl FnMut(&Premise) -> bool) {
        let before = self.premises.len();
        self.premises.retain(keep);
        if self.premises.len() != before {
            self.solutions.clear();
            self.mentioned = Mentioned::default();
            for (place, premise) in self.premises.iter().enumerate() {
                self.mentioned.add(place, premise, &self.atoms);
            }
            self.rebuild();
        }
    }

    /// Takes a premise in.
    pub(super) fn assume(&mut self, premise: Premise) -> Taken {
        let residuals: Vec<_> = premise.residuals.iter().map(|r| self.normal(r)).collect();
        if residuals.iter().all(Zero::is_zero) {
            return Taken::Known;
        }
        // A definition may have told that a symbol moves.
        self.laws.clear();
        self.solutions.clear();
        self.solution.case = None;
        let last = self.comes_last(&premise);
        self.premises.push(premise.clone());
        let taken = if last {
            self.solution.ledger = Ledger::default();
            self.lost_rate = false;
            let taken = self.solve(&premise);
            if taken == Taken::Solved && !self.exhausted {
                self.solution.case = self.case_at_hand();
            }
            match self.lost_rate {
                true => self.rebuild(),
                false => taken,
            }
        } else {
            self.rebuild()
        };
        if taken == Taken::Contradiction {
            self.premises.pop();
            self.rebuild();
        } else {
            self.mentioned
                .add(self.premises.len() - 1, &premise, &self.atoms);
        }
        taken
    }

    /// The value of a variable by a premise or a law, one step down; `None` for a free one.
    pub(super) fn rule(&mut self, variable: Variable) -> Option<Rule> {
        match *self.atoms.atom(variable) {
            Atom::Part {
                entity,
                component,
                order,
            } => {
                let momentary = (entity, component | MOMENTARY);
                let at_once = self.solution.rules.get(&momentary).filter(|_| order == 0);
                let ruled = at_once.or_else(|| self.solution.rules.get(&(entity, component)));
                if let Some((ruled, rule)) = ruled.cloned()
                    && ruled <= order
                {
                    let mut value = rule.value;
                    for _ in ruled..order {
                        // Rules that lead from each rate to a higher one would go on without end.
                        if order > HIGHEST_ORDER || value.numerator().len() > MOST_TERMS_OF_A_RATE {
                            self.exhausted = true;
                            return None;
                        }
                        value = Arc::new(self.atoms.derivative(&value));
                        self.spend(value.numerator().len());
                    }
                    return Some(Rule {
                        name: rule.name,
                        value,
                    });
                }
            }
            Atom::Kernel {
                function,
                ref argument,
            } => {
                let argument = argument.clone();
                let value = self.reduced_kernel(variable, function, &argument)?;
                return Some(Rule {
                    name: String::new(),
                    value: Arc::new(value),
                });
            }
            _ => {}
        }
        let (name, value) = self.law(variable)?;
        let name = name.to_owned();
        (!self.left_out.contains(&name)).then_some(Rule { name, value })
    }

    /// What a law says of a variable, whether it is left out or not.
    pub(super) fn law(&mut self, variable: Variable) -> Option<(&'static str, Arc<Fraction>)> {
        if let Some(known) = self.laws.get(&variable) {
            return known.clone();
        }
        let found = law(&mut self.atoms, self.setting, variable);
        let found = found.map(|(name, value)| (name, Arc::new(value)));
        self.laws.insert(variable, found.clone());
        found
    }
}
