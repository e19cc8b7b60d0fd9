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
#[derive(Clone, Debug, Default)]
pub(crate) struct Solution {
    pub rules: HashMap<(Entity, u8), (u8, Rule)>,
    pub normals: Normals,
    /// Where the rules come from.
    pub sources: HashMap<(Entity, u8), Source>,
    /// Relations that could not be solved for a symbol.
    pub relations: Relations,
    /// Facts for proofs.
    pub ledger: Ledger,
    /// What this is the solution of; `None` where more was put in since.
    pub case: Option<Case>,
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
#[expect(
    clippy::vec_box,
    reason = "a solution goes in and out of force by its box"
)]
pub(crate) struct Solutions(Vec<Box<Solution>>);

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

    /// Keeps a solution, if it is still that of the premises.
    fn keep(&mut self, solution: Box<Solution>) {
        if solution.case.is_none() {
            return;
        }
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
    ) -> Option<Box<Solution>> {
        let same = |case: &Case| {
            case.counts == counts && case.setting == setting && case.left_out == *left_out
        };
        let mut cases = self.0.iter().map(|known| &known.case);
        let place = cases.position(|case| case.as_ref().is_some_and(same))?;
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

    /// Puts a solution in force, and sets the one that was aside.
    pub(crate) fn set_aside(&mut self, other: Box<Solution>) {
        let solution = std::mem::replace(&mut self.solution, other);
        self.solutions.keep(solution);
    }

    /// Works with one premise more, solved behind all others; `None` where it gives no symbol a value.
    pub(crate) fn supposing<R>(
        &mut self,
        premise: &Premise,
        work: impl FnOnce(&mut Self) -> R,
    ) -> Option<R> {
        let other = Solution {
            rules: self.solution.rules.clone(),
            normals: self.solution.normals.clone(),
            sources: self.solution.sources.clone(),
            relations: self.solution.relations.clone(),
            ..Solution::default()
        };
        let before = std::mem::replace(&mut self.solution, Box::new(other));
        let solved = self.solve(premise) == Taken::Solved;
        let result = solved.then(|| work(self));
        self.solution = before;
        result
    }

    /// Puts the solution for what is in force now in the place of another, as it was set aside or anew.
    pub(crate) fn solve_again(&mut self) -> Box<Solution> {
        let counts = self.counts();
        let known = match self.fixed.is_empty() {
            true => self.solutions.take(self.setting, &self.left_out, counts),
            false => None,
        };
        let anew = known.is_none();
        let before = std::mem::replace(&mut self.solution, known.unwrap_or_default());
        if anew {
            self.rebuild();
        }
        before
    }
}
