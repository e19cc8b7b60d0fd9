//! From which of its earlier lines a line of the key follows.

use crate::grade::matching::{Board, Entry};

/// More lines than this no route to a milestone has.
const LONGEST_ROUTE: usize = 40;

/// How a line of the key follows from earlier ones.
#[derive(Clone, Debug, Default)]
pub(in crate::grade) struct Route {
    /// These lines; none where it does not follow from any.
    pub(in crate::grade) lines: Vec<usize>,
    /// Whether a law is needed besides: that the moment is the rate of the angular momentum.
    pub(in crate::grade) by_law: bool,
    /// Whether it is by a rule, as a period is: who knows the rule need not have these lines.
    pub(in crate::grade) by_rule: bool,
}

/// The lines before a line from which it follows, without a law if it can be, as few and as late as can be.
pub(super) fn route(board: &mut Board<'_>, line: usize) -> Route {
    let without = lines_to(board, line, &Entry::of(vec![]));
    if !without.is_empty() {
        return Route {
            lines: without,
            by_law: false,
            by_rule: board.is_by_rule(line),
        };
    }
    let laws = board.laws();
    let lines = match laws.components().is_empty() {
        true => vec![],
        false => lines_to(board, line, &laws),
    };
    Route {
        by_law: !lines.is_empty(),
        by_rule: board.is_by_rule(line),
        lines,
    }
}

/// The lines before a line from which it follows with these laws.
fn lines_to(board: &mut Board<'_>, line: usize, laws: &Entry) -> Vec<usize> {
    let Some(goals) = board.key[line].parts.clone() else {
        return vec![];
    };
    let follow = |board: &mut Board<'_>, lines: &[usize]| {
        let lines = lines.iter().map(|&at| board.key[at].clone());
        let from: Vec<Entry> = lines.chain([laws.clone()]).collect();
        board.say_together(&from, &goals) == Some(true)
    };
    let mut chosen: Vec<usize> = vec![];
    let mut found = false;
    for before in (0..line).rev().take(LONGEST_ROUTE) {
        // A line that says the same is no step towards it.
        let entry = board.key[before].clone();
        let same = goals.iter().all(|goal| board.says(&entry, goal));
        if same || entry.parts.is_none() {
            continue;
        }
        chosen.insert(0, before);
        found = follow(board, &chosen);
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
        if follow(board, &fewer) {
            chosen = fewer;
        }
    }
    chosen
}
