//! What a careful marker does with one milestone.
//!
//! Everything here speaks of one *goal*: one component of one line of the key. A milestone is as good as its worst goal.

use crate::grade::key::{Key, Milestone};
use crate::grade::matching::{Board, Entry, Part, Sheet};
use crate::grade::paper::{Paper, Worth};
use crate::grade::result::Outcome;
use crate::notation::document::{Item, line_name};

/// Words by which a student takes back what stands before.
const SECOND_THOUGHTS: [&str; 12] = [
    "no",
    "wrong",
    "corrected",
    "correct",
    "correction",
    "mistake",
    "error",
    "sorry",
    "oops",
    "rather",
    "instead",
    "scratch",
];

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
    paper: &'a Paper,
    stage: usize,
    board: Board<'a>,
    /// For each line of the student that is wrong, what it is meant to be.
    attempts: Vec<Vec<Attempt>>,
}

/// Parts of lines that take the place of the key's own, and the wrong lines that they come from.
struct Carried {
    entry: Entry,
    wrong: Vec<usize>,
}

fn decision(outcome: Outcome, line: Option<usize>, reason: impl Into<String>) -> Decision {
    Decision {
        outcome,
        line,
        reason: reason.into(),
    }
}

impl<'a> Marker<'a> {
    pub(super) fn new(key: &'a Key, paper: &'a Paper, stage: usize) -> Self {
        let given: Vec<_> = (0..paper.documents.len())
            .map(|at| paper.given(at, stage))
            .collect();
        let own = paper.documents.iter().zip(&paper.spans).zip(&given);
        let own: Vec<Sheet<'a, '_>> = own
            .map(|((document, lines), given)| Sheet {
                document,
                lines,
                given,
            })
            .collect();
        let declared = &key.stages[stage].declared[usize::from(paper.entries)];
        let board = Board::new(
            &declared.declarations,
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
        self.paper.lines[line].worth[self.stage]
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
        for (at, part) in self.entry(line).parts.iter().flatten().enumerate() {
            let goals = self.board.key.iter().enumerate().flat_map(|(line, entry)| {
                let parts = entry.parts.iter().flatten().enumerate();
                parts.map(move |(part, own)| (Goal { line, part }, own))
            });
            let like: Vec<(Goal, f64)> = goals
                .filter(|(_, own)| !part.is_multiple_of(own))
                .filter_map(|(goal, own)| Some((goal, part.likeness(own)?)))
                .collect();
            let best = like
                .iter()
                .map(|(_, likeness)| *likeness)
                .fold(0.0, f64::max);
            let best = like.into_iter().filter(|(_, likeness)| *likeness >= best);
            attempts.extend(best.map(|(goal, _)| Attempt { part: at, goal }));
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
                let parts = self
                    .board
                    .key
                    .get(line)
                    .and_then(|entry| entry.parts.as_ref());
                (0..parts.map_or(0, Vec::len)).map(move |part| Goal { line, part })
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
        let (direct, implied) = self.reaching(&part);
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
    fn reaching(&mut self, part: &Part) -> (Vec<usize>, Vec<usize>) {
        let (mut direct, mut implied) = (vec![], vec![]);
        for line in 0..self.paper.lines.len() {
            if self.worth(line) != Worth::True {
                continue;
            }
            let entry = self.entry(line).clone();
            if !self.board.says(&entry, part) {
                continue;
            }
            let own = entry.parts.iter().flatten();
            let mut own = own.filter(|own| {
                own.is_multiple_of(part) || own.head == part.head && part.head.is_some()
            });
            match own.next() {
                Some(_) => direct.push(line),
                None => implied.push(line),
            }
        }
        (direct, implied)
    }

    /// A true line reaches a goal; is there working that leads to it?
    fn reached(&mut self, goal: Goal, line: usize) -> Decision {
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
        let reason = format!("{} is true", self.name(line));
        if !self.key.policy.working || self.route(goal.line).is_empty() || self.led_to(goal, line) {
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

    fn route(&self, line: usize) -> &[usize] {
        let routes = &self.key.stages[self.stage].routes;
        routes.get(line).map_or(&[], Vec::as_slice)
    }

    /// Whether a line says a goal alone, and so is no working for it.
    fn is_same(&mut self, line: usize, goal: Goal) -> bool {
        let entry = self.entry(line).clone();
        let Some(part) = self.goal(goal).cloned() else {
            return false;
        };
        self.board.says(&entry, &part)
    }

    /// Whether earlier true lines lead to a goal: it follows from them, or one of them is a line of the key's own way to it.
    fn led_to(&mut self, goal: Goal, line: usize) -> bool {
        let before: Vec<usize> = (0..line)
            .filter(|&at| self.worth(at) == Worth::True && !self.is_same(at, goal))
            .collect();
        let way = self.way_to(goal.line);
        for &at in &before {
            let entry = self.entry(at).clone();
            for &step in &way {
                let parts = self.board.key[step].parts.clone().unwrap_or_default();
                if parts.iter().any(|part| self.board.says(&entry, part)) {
                    return true;
                }
            }
        }
        let entries: Vec<Entry> = before.iter().map(|&at| self.entry(at).clone()).collect();
        let part = self.goal(goal).cloned();
        self.board.say_together(&entries, part.as_slice()) == Some(true)
    }

    /// All lines of the key on its way to one of its lines.
    fn way_to(&self, line: usize) -> Vec<usize> {
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

    /// The key's way to a goal, with the wrong lines of the student before a line in place of those that they are meant
    /// to be.
    fn carried_into(&mut self, goal: Goal, before: usize) -> Carried {
        let mut wrong = vec![];
        let parts = self.carried_parts(goal.line, before, &mut wrong, 0);
        let span = crate::source::Span::default();
        Carried {
            entry: Entry {
                span,
                parts: Some(parts),
            },
            wrong,
        }
    }

    fn carried_parts(
        &mut self,
        line: usize,
        before: usize,
        wrong: &mut Vec<usize>,
        depth: usize,
    ) -> Vec<Part> {
        let mut parts = vec![];
        for step in self.route(line).to_vec() {
            let own = self.board.key[step].parts.clone().unwrap_or_default();
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
    fn wrong_part(&mut self, goal: Goal, before: usize) -> Option<(usize, Part)> {
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
    pub(super) fn carries(&mut self, attempt: Attempt, line: usize) -> Option<Vec<usize>> {
        let carried = self.carried_into(attempt.goal, line);
        if carried.wrong.is_empty() {
            return Some(vec![]);
        }
        let part = self.entry(line).parts.as_ref()?.get(attempt.part)?.clone();
        let follows = self.board.say_together(&[carried.entry], &[part])?;
        Some(if follows { carried.wrong } else { vec![] })
    }

    /// A goal is written wrong.
    fn written_wrong(&mut self, goal: Goal, line: usize) -> Decision {
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
            Some(wrong) if wrong.is_empty() => {
                decision(Outcome::None, Some(line), format!("{name} is refuted"))
            }
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

    /// Whether a term of the key's line is gone.
    fn is_easier(&self, attempt: Attempt, line: usize) -> bool {
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

    /// A goal is written right and wrong.
    fn contradicting(&mut self, goal: Goal, first: usize, last: usize, wrong: usize) -> Decision {
        if last > wrong && self.thinks_again(wrong, last) {
            return self.reached(goal, last);
        }
        if first < wrong && last < wrong && self.thinks_again(last, wrong) {
            return self.written_wrong(goal, wrong);
        }
        let (a, b) = (self.name(first.min(wrong)), self.name(first.max(wrong)));
        decision(
            Outcome::Human,
            Some(last),
            format!("{a} and {b} contradict each other"),
        )
    }

    /// Whether words between two lines take back the first.
    fn thinks_again(&self, from: usize, to: usize) -> bool {
        let (from, to) = (&self.paper.lines[from], &self.paper.lines[to]);
        if from.document != to.document {
            return false;
        }
        let (start, end) = (
            from.found[self.stage].span.end,
            to.found[self.stage].span.start,
        );
        let items = self.paper.documents[from.document].items.iter();
        let mut words = items.filter_map(|item| match item {
            Item::Prose { text, span } if span.start >= start && span.end <= end => {
                Some(text.to_lowercase())
            }
            _ => None,
        });
        words.any(|text| {
            let mut words = text.split(|c: char| !c.is_alphabetic());
            words.any(|word| SECOND_THOUGHTS.contains(&word))
        })
    }

    /// No line that counts says a goal.
    fn not_found(&mut self, part: &Part) -> Decision {
        for line in 0..self.paper.lines.len() {
            let worth = self.worth(line);
            let entry = self.entry(line).clone();
            if matches!(worth, Worth::Resting | Worth::Assumed) && self.board.says(&entry, part) {
                let name = self.name(line);
                let reason = match worth {
                    Worth::Assumed => format!("{name} assumes it"),
                    _ => format!("{name} rests on an assumption that was not asked for"),
                };
                return decision(Outcome::None, Some(line), reason);
            }
        }
        match (0..self.paper.lines.len()).find(|&line| self.may_be(line, part)) {
            Some(line) => decision(
                Outcome::Human,
                Some(line),
                format!(
                    "{} may be it, and was not matched to the key",
                    self.name(line)
                ),
            ),
            None => decision(Outcome::None, None, "no line gives it"),
        }
    }

    /// Whether a line that was not matched speaks of the same.
    fn may_be(&self, line: usize, part: &Part) -> bool {
        let worth = self.worth(line);
        if !matches!(worth, Worth::True | Worth::False) || !self.attempts[line].is_empty() {
            return false;
        }
        let Some(own) = &self.entry(line).parts else {
            return true;
        };
        let keys = self
            .board
            .key
            .iter()
            .flat_map(|entry| entry.parts.iter().flatten());
        let keys: Vec<&Part> = keys.collect();
        let matched = |own: &Part| keys.iter().any(|key| own.is_multiple_of(key));
        own.iter().any(|own| {
            let about = part
                .head
                .is_some_and(|head| own.residual.variables().contains(&head));
            (about || own.likeness(part).is_some()) && !matched(own)
        })
    }

    /// A goal that is not reached waits for a person while a line that may be it is open.
    fn unless_open(&self, part: &Part, decided: Decision) -> Decision {
        if matches!(decided.outcome, Outcome::Full | Outcome::Human) {
            return decided;
        }
        let open = (0..self.paper.lines.len())
            .find(|&line| self.worth(line) == Worth::Open && self.concerns(line, part));
        match open {
            Some(line) => {
                let reason = &self.paper.lines[line].found[self.stage].reason;
                let reason = reason.as_deref().unwrap_or("it is not decided");
                decision(
                    Outcome::Human,
                    Some(line),
                    format!("{} is open: {reason}", self.name(line)),
                )
            }
            None => decided,
        }
    }

    fn concerns(&self, line: usize, part: &Part) -> bool {
        let entry = self.entry(line);
        let Some(parts) = &entry.parts else {
            return true;
        };
        let alike = |own: &Part| own.shares_variable(part) || own.likeness(part).is_some();
        self.board.has_unknown(entry) || parts.iter().any(alike)
    }

    /// The part of a line that is an attempt, and what it should be.
    pub(super) fn beside(&self, attempt: Attempt, line: usize) -> Option<(&Part, &Part)> {
        let own = self.entry(line).parts.as_ref()?.get(attempt.part)?;
        Some((own, self.goal(attempt.goal)?))
    }
}
