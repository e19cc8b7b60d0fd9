//! Solutions of the premises that are set aside while others are in force.
//!
//! To see what a proof needs, laws and premises are left out in turn, and for a derivative the moment equation is solved
//! the other way round. Each time all premises would be solved anew, so what came out is kept for as long as it holds.

use crate::verify::theory::kept::Relations;
use crate::verify::theory::law::Setting;
use crate::verify::theory::ledger::{Ledger, Source};
use crate::verify::theory::normal::Normals;
use crate::verify::theory::{Name, Premise, Rule, Taken, Theory};
use crate::verify::values::atoms::Entity;
use foldhash::HashMap;
use std::collections::BTreeSet;

/// Solutions that are kept at most.
const MOST: usize = 32;

/// What the premises in force came to, and what was made of that since.
#[derive(Debug, Default)]
pub(crate) struct Solution {
    rules: HashMap<(Entity, u8), (u8, Rule)>,
    normals: Normals,
    sources: HashMap<(Entity, u8), Source>,
    relations: Relations,
    ledger: Ledger,
    case: Option<Case>,
}

/// What was solved, besides which premises there are.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    setting: Setting,
    left_out: BTreeSet<Name>,
    /// What solutions rest on besides. Each of these only grows, or is put back as it was.
    counts: [usize; 4],
}

/// Solutions that hold for the premises as they are, the one that was used last behind.
#[derive(Debug, Default)]
pub(crate) struct Solutions(Vec<Solution>);

/// A copy goes other ways, and solves anew.
impl Clone for Solutions {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Solutions {
    /// Forgets all, as the premises change.
    pub(crate) fn clear(&mut self) {
        self.0.clear();
    }

    fn keep(&mut self, solution: Solution) {
        if self.0.len() == MOST {
            self.0.remove(0);
        }
        self.0.push(solution);
    }

    fn take(
        &mut self,
        setting: Setting,
        left_out: &BTreeSet<Name>,
        counts: [usize; 4],
    ) -> Option<Solution> {
        let same = |known: &Solution| {
            known.case.as_ref().is_some_and(|case| {
                case.counts == counts && case.setting == setting && case.left_out == *left_out
            })
        };
        let place = self.0.iter().position(same)?;
        Some(self.0.remove(place))
    }
}

impl Theory {
    /// What is to be solved here; `None` where other values stand in the place of what premises give.
    pub(crate) fn case_at_hand(&self) -> Option<Case> {
        self.fixed.is_empty().then(|| Case {
            setting: self.setting,
            left_out: self.left_out.clone(),
            counts: self.counts(),
        })
    }

    /// How much is known of which premises speak of rates, and of how high ones; it only grows.
    pub(crate) fn rates_met(&self) -> usize {
        let orders = self.of_rates.values();
        orders.map(|&order| 1 + usize::from(order)).sum()
    }

    fn counts(&self) -> [usize; 4] {
        [
            self.atoms.changes(),
            self.rates_met(),
            self.instants.len(),
            self.cones.len(),
        ]
    }

    /// Puts a solution in force, in exchange for the one that was.
    pub(crate) fn exchange(&mut self, other: &mut Solution) {
        use std::mem::swap;
        swap(&mut self.rules, &mut other.rules);
        swap(&mut self.normals, &mut other.normals);
        swap(&mut self.sources, &mut other.sources);
        swap(&mut self.relations, &mut other.relations);
        swap(&mut self.ledger, &mut other.ledger);
        swap(&mut self.case, &mut other.case);
    }

    /// Sets the solution in force aside, if it is still that of the premises; none is in force then.
    pub(crate) fn set_aside(&mut self) {
        let mut solution = Solution::default();
        self.exchange(&mut solution);
        if solution.case.is_some() {
            self.solutions.keep(solution);
        }
    }

    /// Works with one premise more, solved behind all others; `None` where it gives no symbol a value.
    pub(crate) fn supposing<R>(
        &mut self,
        premise: &Premise,
        work: impl FnOnce(&mut Self) -> R,
    ) -> Option<R> {
        let mut other = Solution {
            rules: self.rules.clone(),
            normals: self.normals.clone(),
            sources: self.sources.clone(),
            relations: self.relations.clone(),
            ..Solution::default()
        };
        self.exchange(&mut other);
        let solved = self.solve(premise) == Taken::Solved;
        let result = solved.then(|| work(self));
        self.exchange(&mut other);
        result
    }

    /// Puts the solution for what is in force now in the place of none, as it was set aside or anew.
    pub(crate) fn solve_again(&mut self) {
        let counts = self.counts();
        let known = match self.fixed.is_empty() {
            true => self.solutions.take(self.setting, &self.left_out, counts),
            false => None,
        };
        match known {
            Some(mut known) => self.exchange(&mut known),
            None => {
                self.rebuild();
            }
        }
    }
}
