//! What a careful marker does with one milestone.
//!
//! Everything here speaks of one *goal*: one component of one line of the key. A milestone is as good as its worst goal.

use crate::grade::key::{Key, Milestone};
use crate::grade::matching::{Board, Entry, Part, Sheet};
use crate::grade::paper::{Paper, Worth};
use crate::grade::result::Outcome;
use crate::notation::document::line_name;
use std::ops::Range;

mod carried;
mod doubts;
mod working;

/// More wrong attempts at one milestone are no working.
const MOST_ATTEMPTS: usize = 4;

/// A component of a line of the key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Goal {
    pub(super) line: usize,
    pub(super) part: usize,
}

/// That a part of a wrong line is meant to be a goal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt {
    pub(super) part: usize,
    pub(super) goal: Goal,
}

/// What becomes of a goal or of a milestone.
#[derive(Clone, Debug)]
pub(super) struct Decision {
    pub(super) outcome: Outcome,
    /// The line that decides it, by its number among the lines of the student.
    pub(super) line: Option<usize>,
    pub(super) reason: String,
}

/// The work of one student beside the key, at one stage.
pub(super) struct Marker<'a> {
    key: &'a Key,
    paper: &'a Paper<'a>,
    stage: usize,
    board: Board<'a>,
    /// The lines of the key about what never changes.
    constants: Vec<usize>,
    /// For each line of the student that is wrong, what it is meant to be.
    attempts: Vec<Vec<Attempt>>,
}

/// How many components a line has.
fn components(entry: &Entry) -> usize {
    entry.components().len()
}

fn decision(outcome: Outcome, line: Option<usize>, reason: impl Into<String>) -> Decision {
    Decision {
        outcome,
        line,
        reason: reason.into(),
    }
}

impl<'a> Marker<'a> {
    pub(super) fn new(key: &'a Key, paper: &'a Paper<'a>, stage: usize) -> Self {
        let given: Vec<_> = (0..paper.documents.len())
            .map(|at| paper.given(at, stage))
            .collect();
        let own = paper.documents.iter().zip(&paper.spans).zip(&given);
        let own: Vec<Sheet<'a, '_>> = own
            .zip(&paper.written)
            .map(|(((document, lines), given), written)| Sheet {
                document,
                lines,
                given,
                written: Some(written),
                entries: paper.entries,
            })
            .collect();
        let board = Board::new(
            &paper.meaning[stage],
            key.sheet(&key.stages[stage].given),
            &own,
        );
        let constants = (0..board.key.len()).filter(|&line| board.is_constant(line));
        let mut marker = Self {
            key,
            paper,
            stage,
            constants: constants.collect(),
            board,
            attempts: vec![],
        };
        marker.attempts = (0..paper.lines.len())
            .map(|line| marker.attempts_of(line))
            .collect();
        marker
    }

    pub(super) fn conflict(&self) -> bool {
        self.board.conflict
    }

    pub(super) fn worth(&self, line: usize) -> Worth {
        match self.paper.lines[line].worth[self.stage] {
            // A relation between letters of which nothing is told defines none of them.
            Worth::Defined if !self.entry(line).defines || self.entry(line).by_unknown => {
                Worth::Open
            }
            worth => worth,
        }
    }

    fn entry(&self, line: usize) -> &Entry {
        let line = &self.paper.lines[line];
        &self.board.own[line.document][line.number]
    }

    fn goal(&self, goal: Goal) -> Option<&Part> {
        self.board.key.get(goal.line)?.part(goal.part)
    }

    fn name(&self, line: usize) -> String {
        let place = &self.paper.lines[line].place;
        let name = line_name(place.cell, place.source_line);
        match &place.file {
            Some(file) => format!("{name} of {file}"),
            None => name,
        }
    }

    /// What each part of a wrong line is meant to be: what in the key is most like it.
    fn attempts_of(&self, line: usize) -> Vec<Attempt> {
        if self.worth(line) != Worth::False {
            return vec![];
        }
        let mut attempts = vec![];
        let entry = self.entry(line);
        let parts = entry.components().iter().chain(&*entry.ends);
        for (at, part) in parts.enumerate() {
            let goals = self.board.key.iter().enumerate().flat_map(|(line, entry)| {
                let parts = entry.components().iter().chain(&*entry.ends).enumerate();
                parts.map(move |(part, own)| (Goal { line, part }, own))
            });
            let like: Vec<(Goal, f64)> = goals
                .filter(|(_, own)| !part.is_multiple_of(own))
                .filter_map(|(goal, own)| Some((goal, part.likeness(own)?)))
                .collect();
            let most = like
                .iter()
                .map(|(_, likeness)| *likeness)
                .fold(0.0, f64::max);
            let best = like.into_iter().filter(|(_, likeness)| *likeness >= most);
            let best: Vec<Goal> = best.map(|(goal, _)| goal).collect();
            // A component is meant to be a component, and a vector the vector.
            let differs = |goal: &Goal| {
                components(&self.board.key[goal.line]).abs_diff(components(self.entry(line)))
            };
            let least = best.iter().map(differs).min();
            let best = best.iter().filter(|goal| Some(differs(goal)) == least);
            attempts.extend(best.map(|&goal| Attempt { part: at, goal }));
        }
        attempts
    }

    pub(super) fn attempts(&self, line: usize) -> &[Attempt] {
        &self.attempts[line]
    }

    /// What becomes of a milestone: the worst of its goals. A chain is reached by what its ends say, too, unless something
    /// between them was written wrong.
    pub(super) fn milestone(&mut self, milestone: &Milestone) -> Decision {
        let links = self.worst_of(milestone, |entry| 0..components(entry));
        let tried = |line: &usize| self.is_tried_between(*line);
        let has_ends = |line: &usize| !self.board.key[*line].ends.is_empty();
        let lines = milestone.lines.iter();
        let by_ends = lines.clone().all(has_ends) && !lines.clone().any(tried);
        if links.outcome == Outcome::Full || !by_ends {
            return links;
        }
        let ends = self.worst_of(milestone, |entry| {
            components(entry)..components(entry) + entry.ends.len()
        });
        match ends.outcome {
            Outcome::Full | Outcome::FollowThrough => ends,
            _ if ends.line.is_some() && links.line.is_none() => ends,
            _ => links,
        }
    }

    /// Whether something between the ends of a chain of the key was written wrong. Each side is held against the first, so
    /// that one of its components says what the ends do.
    fn is_tried_between(&self, line: usize) -> bool {
        let entry = &self.board.key[line];
        let parts = entry.components().iter().enumerate();
        let mut between =
            parts.filter(|(_, part)| !entry.ends.iter().any(|end| part.is_multiple_of(end)));
        between.any(|(part, _)| !self.wrong_at(Goal { line, part }).is_empty())
    }

    /// The worst decision on some parts of the lines of a milestone.
    fn worst_of(
        &mut self,
        milestone: &Milestone,
        parts: impl Fn(&Entry) -> Range<usize>,
    ) -> Decision {
        let lines = milestone.lines.iter().filter_map(|&line| {
            let entry = self.board.key.get(line)?;
            let goals = parts(entry).map(|part| Goal { line, part });
            let goals = goals.filter(|goal| self.goal(*goal).is_some_and(Part::says_something));
            Some(self.without_zeros(goals.collect()))
        });
        let goals: Vec<Goal> = lines.flatten().collect();
        let decided: Vec<Decision> = goals
            .iter()
            .map(|&goal| self.decide(goal, milestone.shown))
            .collect();
        let last = decided.iter().filter_map(|d| d.line).max();
        // Of equal ones that counts which speaks of a line.
        let worst = decided
            .into_iter()
            .max_by_key(|d| (d.outcome, d.line.is_some()));
        match worst {
            // Of several lines the last one reaches it.
            Some(worst) if worst.outcome == Outcome::Full => Decision {
                line: last,
                ..worst
            },
            Some(worst) => worst,
            None => decision(
                Outcome::Human,
                None,
                "the key says nothing that can be looked for",
            ),
        }
    }

    /// The goals of a vector without its components that are zero, which nobody need write, unless one was written wrong.
    fn without_zeros(&self, goals: Vec<Goal>) -> Vec<Goal> {
        let is_zero = |goal: &Goal| {
            let single = self.goal(*goal).is_some_and(|part| part.terms().len() == 1);
            single && self.wrong_at(*goal).is_empty()
        };
        match goals.iter().all(is_zero) {
            true => goals,
            false => goals.into_iter().filter(|goal| !is_zero(goal)).collect(),
        }
    }

    fn decide(&mut self, goal: Goal, shown: bool) -> Decision {
        let Some(part) = self.goal(goal).cloned() else {
            return decision(
                Outcome::Human,
                None,
                "the key says nothing that can be looked for",
            );
        };
        let wrong: Vec<usize> = self.wrong_at(goal);
        if wrong.len() > MOST_ATTEMPTS {
            return decision(
                Outcome::Human,
                wrong.last().copied(),
                "there are many attempts at it",
            );
        }
        let (direct, implied) = self.reaching(goal, &part);
        let wrong = wrong.last().copied();
        let decided = match (direct.first().copied(), direct.last().copied(), wrong) {
            (Some(first), _, None) => self.reached(goal, first),
            (Some(first), Some(last), Some(wrong)) => self.contradicting(goal, first, last, wrong),
            (_, _, Some(wrong)) => self.written_wrong(goal, wrong),
            (_, _, None) if !implied.is_empty() && shown => decision(
                Outcome::None,
                Some(implied[0]),
                format!(
                    "{} implies it, but it must be shown in a line of its own",
                    self.name(implied[0])
                ),
            ),
            (_, _, None) => match (implied.first(), self.right_in_wrong(goal, &part)) {
                (Some(&line), _) => self.reached(goal, line),
                (None, Some(line)) => {
                    let reason = format!("{} has this component right", self.name(line));
                    decision(Outcome::Full, Some(line), reason)
                }
                (None, None) => self.not_found(&part),
            },
        };
        self.unless_open(&part, decided)
    }

    /// The wrong lines that are meant to be a goal.
    fn wrong_at(&self, goal: Goal) -> Vec<usize> {
        let lines = self.attempts.iter().enumerate();
        let wrong = lines.filter(|(_, attempts)| attempts.iter().any(|a| a.goal == goal));
        wrong.map(|(line, _)| line).collect()
    }

    /// The last line with a wrong attempt at another component of the same line of the key, and this one right.
    fn right_in_wrong(&self, goal: Goal, part: &Part) -> Option<usize> {
        let lines = 0..self.paper.lines.len();
        lines.rev().find(|&line| {
            let mut attempts = self.attempts[line].iter();
            let mut own = self.entry(line).components().iter();
            attempts.any(|attempt| attempt.goal.line == goal.line)
                && own.any(|own| own.is_multiple_of(part))
        })
    }

    /// The true lines that say a goal: those that are it, and those from which it follows.
    fn reaching(&mut self, goal: Goal, part: &Part) -> (Vec<usize>, Vec<usize>) {
        let (mut direct, mut implied) = (vec![], vec![]);
        let most = components(&self.board.key[goal.line]);
        for line in 0..self.paper.lines.len() {
            if self.worth(line) != Worth::True {
                continue;
            }
            let entry = self.entry(line).clone();
            if !self.board.says(&entry, part) && !self.says_by_constants(&entry, goal, part) {
                continue;
            }
            let is_it = |own: &Part| {
                own.is_multiple_of(part) || own.head.is_some() && own.head == part.head
            };
            // The vector of which it is a component only implies it.
            match components(&entry) <= most && entry.components().iter().any(is_it) {
                true => direct.push(line),
                false => implied.push(line),
            }
        }
        (direct, implied)
    }

    /// Whether a line says a goal with what the key says of things that never change, such as a moment of inertia: what it
    /// says earlier, and what the student says too or leaves out of the line.
    fn says_by_constants(&mut self, entry: &Entry, goal: Goal, part: &Part) -> bool {
        let mut told: Vec<Entry> = vec![];
        for at in self.constants.clone() {
            if at < goal.line && (!self.stands_in(at, entry) || self.is_tried(at)) {
                told.push(self.board.key[at].clone());
            }
        }
        if told.is_empty() {
            return false;
        }
        // What holds anyway adds nothing.
        told.retain(|told| told.components().iter().any(Part::says_something));
        let goal = std::slice::from_ref(part);
        match told.as_slice() {
            [] if self.board.is_far_from(entry, part) => return false,
            [] => {}
            told if self.board.say_together(told, goal) == Some(true) => return false,
            _ => {}
        }
        let from: Vec<Entry> = told.into_iter().chain([entry.clone()]).collect();
        self.board.say_together(&from, goal) == Some(true)
    }

    /// Whether what a line of the key speaks of stands in another.
    fn stands_in(&self, line: usize, entry: &Entry) -> bool {
        let heads = self.board.key[line]
            .components()
            .iter()
            .map(|part| part.head);
        let mut heads = heads.flatten();
        heads.any(|head| entry.components().iter().any(|part| part.has(head)))
    }

    /// Whether a student has a line for a line of the key, true or wrong.
    fn is_tried(&mut self, line: usize) -> bool {
        let parts = components(&self.board.key[line]);
        (0..parts).any(|part| {
            let goal = Goal { line, part };
            let mut own = 0..self.paper.lines.len();
            !self.wrong_at(goal).is_empty()
                || own.any(|at| self.worth(at) == Worth::True && self.is_same(at, goal))
        })
    }

    /// The part of a line that is an attempt, and what it should be.
    pub(super) fn beside(&self, attempt: Attempt, line: usize) -> Option<(&Part, &Part)> {
        let own = self.entry(line).part(attempt.part)?;
        Some((own, self.goal(attempt.goal)?))
    }
}
