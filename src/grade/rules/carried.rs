//! What an earlier slip leads to, on the key's own way.

use crate::grade::key::Route;
use crate::grade::matching::{Entry, Part};
use crate::grade::paper::Worth;
use crate::grade::result::Outcome;
use crate::grade::rules::{Attempt, Decision, Goal, Marker, decision};
use crate::grade::slip::{self, Mending};

/// Parts of lines that take the place of the key's own, and the wrong lines that they come from.
pub(super) struct Carried {
    pub(super) entry: Entry,
    pub(super) wrong: Vec<usize>,
}

impl Marker<'_> {
    /// The key's way to a goal, with the wrong lines of the student before a line in place of those that they are meant
    /// to be.
    pub(super) fn carried_into(&mut self, goal: Goal, before: usize) -> Carried {
        let mut wrong = vec![];
        let parts = self.carried_parts(goal.line, before, &mut wrong, 0);
        Carried {
            entry: Entry::of(parts),
            wrong,
        }
    }

    pub(super) fn carried_parts(
        &mut self,
        line: usize,
        before: usize,
        wrong: &mut Vec<usize>,
        depth: usize,
    ) -> Vec<Part> {
        let mut parts = vec![];
        let key = self.key;
        let routes = &key.stages[self.stage].routes;
        let (steps, laws) = routes.get(line).map_or((&[][..], &[][..]), Route::carriers);
        for &step in steps {
            let known = wrong.len();
            let ends = self.wrong_ends(step, before, wrong);
            let mut replaced = match ends.is_empty() {
                true => self.with_wrong(step, 0, before, wrong),
                false => ends,
            };
            if wrong.len() == known && depth < 12 {
                let deeper = self.carried_parts(step, before, wrong, depth + 1);
                if wrong.len() > known {
                    replaced = deeper;
                }
            }
            parts.extend(replaced);
        }
        // What lines say tells letters first.
        parts.extend_from_slice(laws);
        parts
    }

    /// What the ends of a chain of the key say, if the student has one of that wrong.
    fn wrong_ends(&mut self, step: usize, before: usize, wrong: &mut Vec<usize>) -> Vec<Part> {
        let known = wrong.len();
        let links = self.board.key[step].components().len();
        let ends = self.with_wrong(step, links, before, wrong);
        if wrong.len() > known { ends } else { vec![] }
    }

    /// The components of a line of the key or, from the number of these on, what its ends say, with wrong ones of the student
    /// in place of those that they are meant to be.
    fn with_wrong(
        &mut self,
        step: usize,
        from: usize,
        before: usize,
        wrong: &mut Vec<usize>,
    ) -> Vec<Part> {
        let entry = self.board.key[step].clone();
        let own = match from {
            0 => entry.components(),
            _ => &*entry.ends,
        };
        let mut parts = vec![];
        for (at, part) in own.iter().enumerate() {
            let goal = Goal {
                line: step,
                part: from + at,
            };
            parts.push(match self.wrong_part(goal, before) {
                Some((line, other)) => {
                    wrong.push(line);
                    other
                }
                None => part.clone(),
            });
        }
        parts
    }

    /// The last wrong part before a line that is meant to be a goal, unless a true line has taken its place since.
    pub(super) fn wrong_part(&mut self, goal: Goal, before: usize) -> Option<(usize, Part)> {
        let line = self
            .wrong_at(goal)
            .into_iter()
            .rfind(|&line| line < before)?;
        let attempt = self.attempts[line].iter().find(|a| a.goal == goal)?;
        let part = self.entry(line).part(attempt.part)?.clone();
        let mended =
            (line + 1..before).any(|at| self.worth(at) == Worth::True && self.is_same(at, goal));
        (!mended).then_some((line, part))
    }

    /// Whether a wrong line only carries on an earlier one, as the key's own line follows from its own; `None` where that
    /// is not worked out.
    pub(in crate::grade) fn carries(
        &mut self,
        attempt: Attempt,
        line: usize,
    ) -> Option<Vec<usize>> {
        let carried = self.carried_into(attempt.goal, line);
        let part = self.entry(line).part(attempt.part)?.clone();
        if !carried.wrong.is_empty() {
            let part = std::slice::from_ref(&part);
            match self.board.say_together(&[carried.entry], part) {
                Some(true) => return Some(carried.wrong),
                None => return None,
                Some(false) => {}
            }
        }
        let own = self.law_of_own(attempt.goal, line);
        let by_own = own.into_iter().find(|&law| {
            let lines = self.with_law_of_own(attempt.goal, line, law);
            self.board.say_together(&lines, std::slice::from_ref(&part)) == Some(true)
        });
        Some(by_own.into_iter().collect())
    }

    /// Wrong lines before a line that stand for a law which the key's way to a goal needs and no line of the key says.
    fn law_of_own(&mut self, goal: Goal, before: usize) -> Vec<usize> {
        let by_law = self.key.stages[self.stage].routes.get(goal.line);
        if by_law.is_none_or(|route| route.carriers().1.is_empty()) {
            return vec![];
        }
        let wrong = (0..before).filter(|&line| self.worth(line) == Worth::False);
        wrong
            .filter(|&line| self.attempts[line].is_empty())
            .collect()
    }

    /// The key's way to a goal with the student's own wrong lines, and with one more in place of the law.
    fn with_law_of_own(&mut self, goal: Goal, before: usize, law: usize) -> Vec<Entry> {
        let steps = self.route(goal.line).to_vec();
        let mut parts = vec![];
        for step in steps {
            parts.extend(self.with_wrong(step, 0, before, &mut vec![]));
        }
        vec![self.entry(law).clone(), Entry::of(parts)]
    }

    /// A wrong line that stands for a law, and by which a goal would not hold.
    pub(super) fn denied_by_own_law(&mut self, goal: Goal, before: usize) -> Option<usize> {
        let part = self.goal(goal)?.clone();
        self.law_of_own(goal, before).into_iter().find(|&law| {
            let mut lines = self.with_law_of_own(goal, before, law);
            let alone = self.board.say_together(&lines, std::slice::from_ref(&part));
            lines.push(Entry::of(vec![part.clone()]));
            // With the goal they contradict each other.
            let goal = std::slice::from_ref(&part);
            alone == Some(false) && self.board.say_together(&lines, goal).is_none()
        })
    }

    /// A goal is written wrong.
    pub(super) fn written_wrong(&mut self, goal: Goal, line: usize) -> Decision {
        let name = self.name(line);
        let attempt = self.attempts[line].iter().find(|a| a.goal == goal).copied();
        let Some(attempt) = attempt else {
            return decision(Outcome::None, Some(line), format!("{name} is refuted"));
        };
        match self.carries(attempt, line) {
            None => decision(
                Outcome::Human,
                Some(line),
                format!("{name} is refuted, and may carry on an earlier slip"),
            ),
            Some(wrong) if wrong.is_empty() => match self.repeats(goal, line) {
                Some(first) => decision(
                    Outcome::FollowThrough,
                    Some(line),
                    format!("{name} repeats the slip in {}", self.name(first)),
                ),
                None => decision(Outcome::None, Some(line), format!("{name} is refuted")),
            },
            Some(wrong) => {
                let slip = self.name(wrong[0]);
                match self.is_easier(attempt, line) {
                    true => decision(
                        Outcome::None,
                        Some(line),
                        format!(
                            "{name} follows from the slip in {slip}, which made the problem easier"
                        ),
                    ),
                    false => decision(
                        Outcome::FollowThrough,
                        Some(line),
                        format!("{name} follows from the slip in {slip} as it should"),
                    ),
                }
            }
        }
    }

    /// The earlier wrong line, meant to be something else, that the same change to the same term puts right.
    fn repeats(&self, goal: Goal, line: usize) -> Option<usize> {
        let own = self.mending(line)?;
        let earlier = (0..line).filter(|&at| self.worth(at) == Worth::False);
        let mut others = earlier.filter(|&at| self.attempts(at).iter().all(|a| a.goal != goal));
        others.find(|&at| self.mending(at).is_some_and(|mending| mending == own))
    }

    fn mending(&self, line: usize) -> Option<Mending> {
        let line = &self.paper.lines[line];
        slip::mending(
            &self.paper.documents[line.document],
            &line.found[self.stage],
        )
    }

    /// Whether a wrong line has a slip that stands before it too, in the same term.
    pub(in crate::grade) fn is_repeated(&self, line: usize) -> bool {
        let own = self.mending(line);
        let mut earlier = (0..line).filter(|&at| self.worth(at) == Worth::False);
        own.is_some() && earlier.any(|at| self.mending(at) == own)
    }

    /// Whether a term of the key's line is gone.
    pub(super) fn is_easier(&self, attempt: Attempt, line: usize) -> bool {
        let own = self.entry(line).part(attempt.part);
        match (own, self.goal(attempt.goal)) {
            (Some(own), Some(key)) => own.terms().len() < key.terms().len(),
            _ => true,
        }
    }
}
