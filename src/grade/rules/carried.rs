//! What an earlier slip leads to, on the key's own way.

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
        let span = crate::source::Span::default();
        Carried {
            entry: Entry {
                span,
                parts: Some(parts.into()),
                defines: false,
                by_unknown: false,
                number: None,
            },
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
        for step in self.route(line).to_vec() {
            let own = self.board.key[step].parts.clone();
            let own = own.as_deref().unwrap_or_default();
            let mut replaced = vec![];
            let known = wrong.len();
            for (at, part) in own.iter().enumerate() {
                let put = self.wrong_part(
                    Goal {
                        line: step,
                        part: at,
                    },
                    before,
                );
                replaced.push(match put {
                    Some((line, other)) => {
                        wrong.push(line);
                        other
                    }
                    None => part.clone(),
                });
            }
            if wrong.len() == known && depth < 12 {
                let deeper = self.carried_parts(step, before, wrong, depth + 1);
                if wrong.len() > known {
                    replaced = deeper;
                }
            }
            parts.extend(replaced);
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
        let part = self.entry(line).parts.as_ref()?.get(attempt.part)?.clone();
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
        if carried.wrong.is_empty() {
            return Some(vec![]);
        }
        let part = self.entry(line).parts.as_ref()?.get(attempt.part)?.clone();
        let follows = self.board.say_together(&[carried.entry], &[part])?;
        Some(if follows { carried.wrong } else { vec![] })
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
        let own = self
            .entry(line)
            .parts
            .as_ref()
            .and_then(|parts| parts.get(attempt.part));
        match (own, self.goal(attempt.goal)) {
            (Some(own), Some(key)) => own.terms().len() < key.terms().len(),
            _ => true,
        }
    }
}
