//! What a careful marker does with one milestone.
//!
//! Everything here speaks of one *goal*: one component of one line of the key. A milestone is as good as its worst goal.

use crate::grade::key::{Key, Milestone};
use crate::grade::matching::{Board, Entry, Part, Sheet};
use crate::grade::paper::{Paper, Worth};
use crate::grade::result::Outcome;
use crate::notation::document::line_name;

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
            .map(|((document, lines), given)| Sheet {
                document,
                lines,
                given,
                entries: paper.entries,
            })
            .collect();
        let board = Board::new(
            &paper.meaning[stage],
            key.sheet(&key.stages[stage].given),
            &own,
        );
        let mut marker = Self {
            key,
            paper,
            stage,
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
        self.board
            .key
            .get(goal.line)?
            .parts
            .as_ref()?
            .get(goal.part)
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
        for (at, part) in self.entry(line).components().iter().enumerate() {
            let goals = self.board.key.iter().enumerate().flat_map(|(line, entry)| {
                let parts = entry.components().iter().enumerate();
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

    /// What becomes of a milestone: the worst of its goals.
    pub(super) fn milestone(&mut self, milestone: &Milestone) -> Decision {
        let goals: Vec<Goal> = milestone
            .lines
            .iter()
            .flat_map(|&line| {
                let most = self.board.key.get(line).map_or(0, components);
                (0..most).map(move |part| Goal { line, part })
            })
            .filter(|goal| self.goal(*goal).is_some_and(Part::says_something))
            .collect();
        let decided: Vec<Decision> = goals
            .iter()
            .map(|&goal| self.decide(goal, milestone.shown))
            .collect();
        let last = decided.iter().filter_map(|d| d.line).max();
        let worst = decided.into_iter().max_by_key(|d| d.outcome);
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
            (_, _, None) => match implied.first() {
                Some(&line) => self.reached(goal, line),
                None => self.not_found(&part),
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

    /// The true lines that say a goal: those that are it, and those from which it follows.
    fn reaching(&mut self, goal: Goal, part: &Part) -> (Vec<usize>, Vec<usize>) {
        let (mut direct, mut implied) = (vec![], vec![]);
        let most = components(&self.board.key[goal.line]);
        for line in 0..self.paper.lines.len() {
            if self.worth(line) != Worth::True {
                continue;
            }
            let entry = self.entry(line).clone();
            if !self.board.says(&entry, part) {
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

    /// The part of a line that is an attempt, and what it should be.
    pub(super) fn beside(&self, attempt: Attempt, line: usize) -> Option<(&Part, &Part)> {
        let own = self.entry(line).parts.as_ref()?.get(attempt.part)?;
        Some((own, self.goal(attempt.goal)?))
    }
}
