//! "B is a hub-fixed frame": one that is fixed in the hub.

use super::rewrite::put_in;
use super::words::{Kind, Token};

/// How words end that say in which body something is fixed.
const ENDINGS: [&str; 3] = ["-fixed", "-attached", "-carried"];

/// What may be fixed in a body.
const FIXED: [&str; 6] = ["frame", "axes", "axis", "point", "triad", "basis"];

/// The body that a word names in which something is fixed; "body-fixed" and "space-fixed" are words of the language.
pub(super) fn body_of(word: &str) -> Option<&str> {
    let body = ENDINGS
        .iter()
        .find_map(|ending| word.strip_suffix(ending))?;
    let named = body.len() > 1 && body.chars().all(char::is_alphabetic);
    (named && !["body", "space", "inertially"].contains(&body)).then_some(body)
}

/// The sentence with "frame fixed in the hub" for "hub-fixed frame", with the name behind it.
pub(super) fn fixed_in_named(tokens: &[Token]) -> Option<Vec<Token>> {
    let body = |t: &Token| body_of(&t.lower).is_some();
    let at = tokens.iter().position(body)?;
    let noun = tokens
        .get(at + 1)
        .filter(|noun| FIXED.contains(&noun.lower.as_str()))?;
    let name = tokens.get(at + 2).filter(|name| {
        let capital = name.kind == Kind::Word && name.text.chars().all(char::is_uppercase);
        capital || name.kind == Kind::Formula
    });
    let behind = at + 2 + usize::from(name.is_some());
    let word = |text: &str| put_in(Kind::Word, text, &tokens[at]);
    let told = ["fixed", "in", "the", body_of(&tokens[at].lower)?].map(word);
    let named = [noun.clone()].into_iter().chain(name.cloned());
    let before = tokens[..at].iter().cloned();
    let rest = tokens[behind..].iter().cloned();
    Some(before.chain(named).chain(told).chain(rest).collect())
}
