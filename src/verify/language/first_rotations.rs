//! "F is turned relative to N by the first two of these rotations", behind a sentence that tells Euler angles in an order.

use super::rewrite::put_in;
use super::words::{Kind, Token};

/// Words for the turns that Euler angles are.
const TURNS: [&str; 4] = ["rotations", "turns", "angles", "rotation"];

/// The sentence with the first of the turns that the one before tells, by their angles and axes.
pub(super) fn with_first_rotations(tokens: &[Token], before: &[Token]) -> Option<Vec<Token>> {
    let word = |at: usize| tokens.get(at).map_or("", |t: &Token| t.lower.as_str());
    let at = (0..tokens.len()).find(|&at| word(at) == "the" && word(at + 1) == "first")?;
    let (count, of) = match word(at + 2) {
        "two" => (2, at + 3),
        _ => (1, at + 2),
    };
    let end = (of..tokens.len().min(of + 3)).find(|&at| TURNS.contains(&word(at)))?;
    let turns = told_in_order(before)?;
    let first = turns.get(..count).filter(|_| turns.len() > count)?;
    let near = &tokens[at];
    let said = |word: &str| put_in(Kind::Word, word, near);
    let mut told: Vec<Token> = vec![];
    for (number, (angle, axis)) in first.iter().enumerate() {
        if number > 0 {
            told.extend(["and", "then", "by"].map(said));
        }
        told.extend([(*angle).clone(), said("about")]);
        let ordinal = match axis.text.as_str() {
            "1" => Some("first"),
            "2" => Some("second"),
            "3" => Some("third"),
            _ => None,
        };
        match ordinal {
            Some(ordinal) => told.extend(["the", ordinal, "axis"].map(said)),
            None => told.push((*axis).clone()),
        }
    }
    Some([&tokens[..at], &told, &tokens[end + 1..]].concat())
}

/// "`$a$`, `$b$`, `$c$` are the Euler angles of B relative to N in the order 3, 1, 3": each angle with its axis.
fn told_in_order(before: &[Token]) -> Option<Vec<(&Token, &Token)>> {
    let order = before.iter().position(|t| t.lower == "order")?;
    let listed = |t: &&Token| t.kind != Kind::Comma && t.lower != "and";
    let axes = before[order + 1..].iter().filter(listed);
    let angles = before[..order]
        .iter()
        .take_while(|t| t.kind == Kind::Formula || t.kind == Kind::Comma || t.lower == "and");
    let turns: Vec<_> = angles.filter(listed).zip(axes).collect();
    (turns.len() == 3).then_some(turns)
}
