//! Names that are words of the language as well: "World is a frame". They keep their capital wherever they stand.

use super::words::{Kind, Token};
use std::collections::BTreeSet;

/// What is named by a word with a capital.
const NAMED: [&str; 3] = ["frame", "point", "origin"];

/// So many words stand before the noun at most: "an inertial reference frame".
const LONGEST: usize = 3;

/// Makes words that are names differ from the words of the language that they are like.
pub(crate) fn keep_capitals<E>(sentences: &mut [Result<Vec<Token>, E>]) {
    let told = sentences.iter().flatten();
    let names: BTreeSet<String> = told.flat_map(|tokens| named(tokens)).collect();
    for token in sentences.iter_mut().flatten().flatten() {
        if names.contains(&token.text) {
            token.lower.clone_from(&token.text);
        }
    }
}

/// The names that a sentence gives: "World is an inertial frame", "Local and World are frames".
fn named(tokens: &[Token]) -> Vec<String> {
    let Some(verb) = tokens
        .iter()
        .position(|t| matches!(&*t.lower, "is" | "are"))
    else {
        return vec![];
    };
    let (subjects, rest) = tokens.split_at(verb);
    let noun = rest.iter().skip(1).take(LONGEST + 1);
    let mut noun = noun.take_while(|t| t.kind == Kind::Word && t.lower != "of");
    let frame = noun.any(|t| NAMED.contains(&t.lower.trim_end_matches('s')));
    let listed = |t: &Token| t.kind == Kind::Comma || t.lower == "and" || is_capital(t);
    match frame && subjects.iter().all(listed) {
        true => subjects
            .iter()
            .filter(|t| is_capital(t))
            .map(|t| t.text.clone())
            .collect(),
        false => vec![],
    }
}

/// "World"
fn is_capital(token: &Token) -> bool {
    let mut letters = token.text.chars();
    let capital = letters.next().is_some_and(char::is_uppercase);
    let rest = letters.as_str();
    token.kind == Kind::Word && capital && rest.len() > 1 && rest.chars().all(char::is_lowercase)
}
