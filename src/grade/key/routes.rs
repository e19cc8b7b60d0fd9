//! From which of its earlier lines a line of the key follows.

use crate::grade::matching::{Board, Entry};

/// More lines than this no route to a milestone has.
const LONGEST_ROUTE: usize = 40;

/// The lines before a line from which it follows without a law, as few and as late as can be; none where it does not.
pub(super) fn route(board: &mut Board<'_>, line: usize) -> Vec<usize> {
    let Some(goals) = board.key[line].parts.clone() else {
        return vec![];
    };
    let entries = |board: &Board<'_>, lines: &[usize]| -> Vec<Entry> {
        lines.iter().map(|&at| board.key[at].clone()).collect()
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
        let from = entries(board, &chosen);
        found = board.say_together(&from, &goals) == Some(true);
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
        let from = entries(board, &fewer);
        if board.say_together(&from, &goals) == Some(true) {
            chosen = fewer;
        }
    }
    chosen
}
