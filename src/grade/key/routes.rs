//! From which of its earlier lines a line of the key follows.

use crate::grade::matching::{Board, Entry, Part};

/// More lines than this no route to a milestone has.
const LONGEST_ROUTE: usize = 40;

/// How a line of the key follows from earlier ones.
#[derive(Clone, Debug, Default)]
pub(in crate::grade) struct Route {
    /// These lines; none where it does not follow from any.
    pub(in crate::grade) lines: Vec<usize>,
    /// The laws that are needed besides, as that the moment is the rate of the angular momentum: no more than with these
    /// lines.
    pub(in crate::grade) laws: Vec<Part>,
    /// Whether it is by a rule, as a period is: who knows the rule need not have these lines.
    pub(in crate::grade) by_rule: bool,
    /// The last line before it that says the same alone, as a vector says its components: no step towards it, but a slip
    /// in that one is carried on into this one.
    pub(in crate::grade) said_by: Option<usize>,
}

impl Route {
    /// The lines on which a slip is carried into this one, and the laws that are needed besides.
    pub(in crate::grade) fn carriers(&self) -> (&[usize], &[Part]) {
        match &self.said_by {
            Some(line) if self.lines.is_empty() || !self.laws.is_empty() => {
                (std::slice::from_ref(line), &[])
            }
            _ => (&self.lines, &self.laws),
        }
    }
}

/// Of more laws none is left out to see whether it is needed.
const MOST_LAWS: usize = 60;

/// The lines before a line from which it follows, without a law if it can be, as few and as late as can be.
pub(super) fn route(board: &mut Board<'_>, line: usize) -> Route {
    let mut route = Route {
        lines: lines_to(board, line, &[]),
        by_rule: board.is_by_rule(line),
        ..Route::default()
    };
    if !route.lines.is_empty() {
        return route;
    }
    let goals = board.key[line].parts.clone().unwrap_or_default();
    route.said_by = (0..line).rev().find(|&before| {
        let entry = board.key[before].clone();
        !goals.is_empty() && goals.iter().all(|goal| board.says(&entry, goal))
    });
    let laws = needed_laws(board, line);
    route.lines = lines_to(board, line, &laws);
    if !route.lines.is_empty() {
        route.laws = laws;
    }
    route
}

/// The laws without which a line does not follow from the lines before it. The laws alone may say all that it does; what the
/// lines say is not taken from them.
fn needed_laws(board: &mut Board<'_>, line: usize) -> Vec<Part> {
    let laws = board.laws().components().to_vec();
    let Some(goals) = board.key[line].parts.clone() else {
        return vec![];
    };
    let before: Vec<usize> = candidates(board, line, &goals);
    if before.is_empty() || laws.is_empty() || !follow(board, &before, &laws, &goals) {
        return vec![];
    }
    if laws.len() > MOST_LAWS {
        return laws;
    }
    // First those that say it by themselves.
    let mut order: Vec<usize> = (0..laws.len()).collect();
    let alone: Vec<bool> = (0..laws.len())
        .map(|at| follow(board, &[], &laws[at..=at], &goals))
        .collect();
    order.sort_by_key(|&at| !alone[at]);
    let mut left: Vec<usize> = (0..laws.len()).collect();
    for at in order {
        let fewer: Vec<usize> = left.iter().copied().filter(|&own| own != at).collect();
        let some: Vec<Part> = fewer.iter().map(|&own| laws[own].clone()).collect();
        if follow(board, &before, &some, &goals) {
            left = fewer;
        }
    }
    left.into_iter().map(|own| laws[own].clone()).collect()
}

/// The lines before a line that may lead to it: one that says the same is no step towards it.
fn candidates(board: &mut Board<'_>, line: usize, goals: &[Part]) -> Vec<usize> {
    let before = (0..line).rev().take(LONGEST_ROUTE);
    let before = before.filter(|&at| {
        let entry = board.key[at].clone();
        let same = goals.iter().all(|goal| board.says(&entry, goal));
        !same && entry.parts.is_some()
    });
    before.collect()
}

/// Whether lines of the key and laws say goals together.
fn follow(board: &mut Board<'_>, lines: &[usize], laws: &[Part], goals: &[Part]) -> bool {
    let lines = lines.iter().map(|&at| board.key[at].clone());
    let from: Vec<Entry> = lines.chain([Entry::of(laws.to_vec())]).collect();
    board.say_together(&from, goals) == Some(true)
}

/// The lines before a line from which it follows with these laws.
fn lines_to(board: &mut Board<'_>, line: usize, laws: &[Part]) -> Vec<usize> {
    let Some(goals) = board.key[line].parts.clone() else {
        return vec![];
    };
    let mut chosen: Vec<usize> = vec![];
    let mut found = false;
    for before in candidates(board, line, &goals) {
        chosen.insert(0, before);
        found = follow(board, &chosen, laws, &goals);
        if found {
            break;
        }
    }
    if !found {
        return vec![];
    }
    for at in (0..chosen.len()).rev() {
        let mut fewer = chosen.clone();
        fewer.remove(at);
        if follow(board, &fewer, laws, &goals) {
            chosen = fewer;
        }
    }
    chosen
}
