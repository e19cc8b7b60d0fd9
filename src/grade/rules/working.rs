//! A milestone needs lines that lead to it.

use crate::grade::key::rules_of;
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
        if let Some(leap) = self.leap(goal, line) {
            return decision(Outcome::None, Some(line), leap);
        }
        if self.key.policy.working
            && let Some(law) = self.denied_by_own_law(goal, line)
        {
            let (own, law) = (self.name(line), self.name(law));
            let reason = format!(
                "{own} is true, but it does not follow from {law}, which should lead to it"
            );
            return decision(Outcome::Human, Some(line), reason);
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
                    "{reason}, but the lines before it do not lead to it as those of the key do{}",
                    self.lacking(goal, line)
                ),
            ),
        }
    }

    /// What to say of a line that uses more named rules at once than the key allows: rules that no earlier line used. No
    /// line need use fewer than the key's own.
    fn leap(&self, goal: Goal, line: usize) -> Option<String> {
        let own = self.key.rules.get(goal.line).copied().unwrap_or(0);
        let most = self.key.policy.most_rules?.max(own);
        let uses = |line: usize| rules_of(&self.paper.lines[line].found[self.stage]);
        let true_before = (0..line).filter(|&at| self.worth(at) == Worth::True);
        let known: Vec<&str> = true_before.flat_map(uses).collect();
        let new: Vec<&str> = uses(line).filter(|rule| !known.contains(rule)).collect();
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

    /// Whether earlier true lines lead to a goal: it follows from them, or they say all that the key's own line follows from.
    pub(super) fn led_to(&mut self, goal: Goal, line: usize) -> bool {
        let before = self.leading(goal, line);
        let mut entries: Vec<Entry> = before.iter().map(|&at| self.entry(at).clone()).collect();
        for at in self.constants.clone() {
            if at < goal.line {
                entries.push(self.board.key[at].clone());
            }
        }
        let part = self.goal(goal).cloned();
        let routes = &self.key.stages[self.stage].routes;
        let needed = routes.get(goal.line).map(|route| route.laws.clone());
        if let Some(needed) = needed.filter(|laws| !laws.is_empty()) {
            let all = self.board.laws();
            // Another way may need other laws, but laws alone are no working.
            let whole = self
                .board
                .say_together(std::slice::from_ref(&all), part.as_slice());
            entries.push(match whole {
                Some(false) => all,
                _ => Entry::of(needed),
            });
        }
        match self.board.say_together(&entries, part.as_slice()) {
            Some(true) => true,
            _ => self.not_given(goal, line).is_empty(),
        }
    }

    /// The true lines before a line that may lead to a goal.
    fn leading(&mut self, goal: Goal, line: usize) -> Vec<usize> {
        let before = 0..line;
        before
            .filter(|&at| self.worth(at) == Worth::True && !self.is_same(at, goal))
            .collect()
    }

    /// The lines from which the key's own follows and which no line before a line gives. One that carries no marks may be
    /// left out where others are given.
    fn not_given(&mut self, goal: Goal, line: usize) -> Vec<usize> {
        let before = self.leading(goal, line);
        let mut steps = self.route(goal.line).to_vec();
        let (mut missing, mut at, mut any) = (vec![], 0, false);
        while let Some(&step) = steps.get(at) {
            at += 1;
            if self.is_given(step, &before) {
                any = true;
                continue;
            }
            let mut milestones = self.key.milestones.iter();
            let marked = milestones.any(|milestone| milestone.lines.contains(&step));
            let own = self.route(step).to_vec();
            match marked {
                true => missing.push(step),
                false => {
                    let new = own.into_iter().filter(|own| !steps.contains(own));
                    let new: Vec<usize> = new.collect();
                    steps.extend(new);
                }
            }
        }
        match any {
            true => missing,
            false => steps,
        }
    }

    /// Whether some of these lines give all that a line of the key says.
    fn is_given(&mut self, step: usize, by: &[usize]) -> bool {
        let parts = self.board.key[step].components().to_vec();
        let mut parts = parts.iter().filter(|part| part.says_something());
        parts.all(|part| {
            by.iter().any(|&at| {
                let entry = self.entry(at).clone();
                self.board.says(&entry, part)
            })
        })
    }

    /// What the lines before a line lack that should lead to a goal.
    fn lacking(&mut self, goal: Goal, line: usize) -> String {
        let missing = self.not_given(goal, line);
        let labels = self
            .key
            .milestones
            .iter()
            .filter(|milestone| milestone.lines.iter().any(|line| missing.contains(line)));
        let labels: Vec<&str> = labels.map(|milestone| milestone.label.as_str()).collect();
        match labels.as_slice() {
            [] => String::new(),
            labels => format!("; no line gives all of {}", labels.join(", ")),
        }
    }
}
