//! What an earlier slip leads to on the student's own way, where the key says no line between.

use crate::grade::matching::{Entry, Part};
use crate::grade::paper::Worth;
use crate::grade::rules::{Goal, Marker};

/// A way from an earlier line of the key to a goal, for which the student has that line wrong.
struct OwnWay {
    /// The wrong line.
    slip: usize,
    /// What leads from there to the goal: true lines of the student, and other members of the key's own chain.
    links: Vec<Entry>,
    /// What the student says in place of the key's line.
    wrong: Entry,
}

impl Marker<'_> {
    /// The wrong line before a line from which a part follows, as the goal does from the key's own.
    pub(super) fn carried_by_own_way(
        &mut self,
        goal: Goal,
        before: usize,
        part: &Part,
    ) -> Option<usize> {
        let ways = self.own_ways(goal, before);
        let part = std::slice::from_ref(part);
        let mut follows = ways.into_iter().filter(|way| {
            let mut from = way.links.clone();
            from.push(way.wrong.clone());
            self.board.say_together(&from, part) == Some(true)
        });
        follows.next().map(|way| way.slip)
    }

    /// A wrong line that should lead to a goal, and from which it does not follow.
    pub(super) fn denied_by_own_way(&mut self, goal: Goal, before: usize) -> Option<usize> {
        let part = self.goal(goal)?.clone();
        let ways = self.own_ways(goal, before);
        let mut denies = ways.into_iter().filter(|way| {
            let mut from = way.links.clone();
            from.push(way.wrong.clone());
            self.board.say_together(&from, std::slice::from_ref(&part)) == Some(false)
        });
        denies.next().map(|way| way.slip)
    }

    /// The ways to a goal from wrong lines, the last first: with the key's line in place of the wrong one each gives the goal,
    /// and without it none does.
    fn own_ways(&mut self, goal: Goal, before: usize) -> Vec<OwnWay> {
        let steps: Vec<usize> = (0..goal.line)
            .rev()
            .filter(|step| {
                let mut wrong = self.attempts[..before].iter().flatten();
                wrong.any(|attempt| attempt.goal.line == *step)
            })
            .collect();
        let Some(part) = self.goal(goal).cloned().filter(|_| !steps.is_empty()) else {
            return vec![];
        };
        let links = self.links_to(goal, before, &part);
        let goal = std::slice::from_ref(&part);
        if links.is_empty() || self.board.say_together(&links, goal) == Some(true) {
            return vec![];
        }
        let mut ways = vec![];
        for step in steps {
            let mut slips = vec![];
            let wrong = Entry::of(self.with_wrong(step, 0, before, &mut slips));
            let mut right = links.clone();
            right.push(self.board.key[step].clone());
            if let Some(&slip) = slips.first()
                && self.board.say_together(&right, goal) == Some(true)
            {
                let links = links.clone();
                ways.push(OwnWay { slip, links, wrong });
            }
        }
        ways
    }

    fn links_to(&mut self, goal: Goal, before: usize, part: &Part) -> Vec<Entry> {
        let own: Vec<usize> = (0..before)
            .filter(|&at| self.worth(at) == Worth::True && !self.is_same(at, goal))
            .collect();
        let mut links: Vec<Entry> = own.into_iter().map(|at| self.entry(at).clone()).collect();
        let key = self.board.key[goal.line].clone();
        if !key.ends.is_empty() {
            let members = key.components().iter();
            for member in members.map(|member| Entry::of(vec![member.clone()])) {
                if !self.board.says(&member, part) {
                    links.push(member);
                }
            }
        }
        links
    }
}
