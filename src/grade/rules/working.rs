//! A milestone needs lines that lead to it.

use crate::grade::matching::Entry;
use crate::grade::paper::Worth;
use crate::grade::result::Outcome;
use crate::grade::rules::{Decision, Goal, Marker, decision};

impl Marker<'_> {
    /// A true line reaches a goal; is there working that leads to it?
    pub(super) fn reached(&mut self, goal: Goal, line: usize) -> Decision {
        let carried = self.carried_into(goal, line);
        let full = |reason: String| decision(Outcome::Full, Some(line), reason);
        if !carried.wrong.is_empty() {
            let parts = self.goal(goal).cloned();
            let follows = self.board.say_together(&[carried.entry], parts.as_slice());
            let wrong = self.name(carried.wrong[0]);
            return match (follows, self.key.policy.working) {
                (Some(true), _) => full(format!(
                    "{} is true, and what is wrong in {wrong} drops out",
                    self.name(line)
                )),
                (_, false) => full(format!("{} is true", self.name(line))),
                _ => decision(
                    Outcome::Human,
                    Some(line),
                    format!(
                        "{} is true, but it does not follow from {wrong}, which should lead to it",
                        self.name(line)
                    ),
                ),
            };
        }
        if let Some(leap) = self.leap(line) {
            return decision(Outcome::None, Some(line), leap);
        }
        let reason = format!("{} is true", self.name(line));
        let needs = self.key.policy.working && self.needs_working(goal.line);
        if !needs || self.led_to(goal, line) {
            return full(reason);
        }
        let before = (0..line).any(|at| {
            matches!(self.worth(at), Worth::True | Worth::Defined) && !self.is_same(at, goal)
        });
        match before {
            false => decision(
                Outcome::None,
                Some(line),
                format!("{reason}, but it is only asserted: no line leads to it"),
            ),
            true => decision(
                Outcome::Human,
                Some(line),
                format!(
                    "{reason}, but the lines before it do not lead to it as those of the key do"
                ),
            ),
        }
    }

    /// What to say of a line that uses more named rules at once than the key allows: rules that no earlier line used.
    fn leap(&self, line: usize) -> Option<String> {
        let most = self.key.policy.most_rules?;
        let uses = |line: usize| self.paper.lines[line].found[self.stage].uses.iter();
        let true_before = (0..line).filter(|&at| self.worth(at) == Worth::True);
        let known: Vec<&String> = true_before.flat_map(uses).collect();
        // The name of a rule is one word; premises and lines are said in several.
        let new = uses(line).filter(|rule| !rule.contains(' ') && !known.contains(rule));
        let new: Vec<&str> = new.map(String::as_str).collect();
        (new.len() > most).then(|| {
            format!(
                "{} is true, but it uses more rules at once ({}) than the key allows, which is {most}",
                self.name(line),
                new.join(", ")
            )
        })
    }

    /// Whether lines must lead to a line of the key.
    fn needs_working(&self, line: usize) -> bool {
        let routes = &self.key.stages[self.stage].routes;
        routes
            .get(line)
            .is_some_and(|route| !route.lines.is_empty() && !route.by_rule)
    }

    pub(super) fn route(&self, line: usize) -> &[usize] {
        let routes = &self.key.stages[self.stage].routes;
        routes.get(line).map_or(&[], |route| &route.lines)
    }

    /// Whether a line says a goal alone, and so is no working for it.
    pub(super) fn is_same(&mut self, line: usize, goal: Goal) -> bool {
        let entry = self.entry(line).clone();
        let Some(part) = self.goal(goal).cloned() else {
            return false;
        };
        self.board.says(&entry, &part)
    }

    /// Whether earlier true lines lead to a goal: it follows from them, or one of them is a line of the key's own way to it.
    pub(super) fn led_to(&mut self, goal: Goal, line: usize) -> bool {
        let before: Vec<usize> = (0..line)
            .filter(|&at| self.worth(at) == Worth::True && !self.is_same(at, goal))
            .collect();
        let way = self.way_to(goal.line);
        for &at in &before {
            let entry = self.entry(at).clone();
            for &step in &way {
                let key = self.board.key.clone();
                if key[step]
                    .components()
                    .iter()
                    .any(|part| self.board.says(&entry, part))
                {
                    return true;
                }
            }
        }
        let mut entries: Vec<Entry> = before.iter().map(|&at| self.entry(at).clone()).collect();
        entries.push(Entry::of(self.laws_to(goal.line)));
        let part = self.goal(goal).cloned();
        self.board.say_together(&entries, part.as_slice()) == Some(true)
    }

    /// All lines of the key on its way to one of its lines.
    pub(super) fn way_to(&self, line: usize) -> Vec<usize> {
        let mut way: Vec<usize> = self.route(line).to_vec();
        let mut at = 0;
        while let Some(&step) = way.get(at) {
            let more = self.route(step).iter().filter(|line| !way.contains(line));
            let more: Vec<usize> = more.copied().collect();
            way.extend(more);
            at += 1;
        }
        way
    }
}
