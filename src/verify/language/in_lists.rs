//! Lists whose members a sentence goes on to speak of, and adjectives in a list.

use super::lexicon::{Class, Lexicon};
use super::phrase::ORDINALS;
use super::rewrite::put_in;
use super::sentence_parts::joins;
use super::words::{Kind, Token};

/// "`$i$`, `$j$`, `$k$`, the last of which points up" as "`$i$`, `$j$`, `$k$`; `$k$` points up", and so "of which the third".
pub(crate) fn tell_listed_apart(tokens: &[Token]) -> Option<Vec<Token>> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let (at, which, behind) =
        (1..words.len().saturating_sub(3)).find_map(|at| match words[at..at + 4] {
            ["the", which, "of", "which" | "these" | "them"] | ["of", "which", "the", which] => {
                Some((at, which, at + 4))
            }
            _ => None,
        })?;
    let end = tokens[..at].iter().rposition(|t| !joins(t))? + 1;
    let list = &tokens[..end];
    let members = members_at_end(list);
    let member = match which {
        "last" => members.len().checked_sub(1)?,
        "latter" => members
            .len()
            .checked_sub(1)
            .filter(|_| members.len() == 2)?,
        "former" => Some(0).filter(|_| members.len() == 2)?,
        ordinal => ORDINALS.iter().position(|o| *o == ordinal)?,
    };
    let member = (*members.get(member).filter(|_| members.len() > 1)?).clone();
    let semicolon = put_in(Kind::Semicolon, "", &tokens[at]);
    Some([list, &[semicolon, member], &tokens[behind..]].concat())
}

/// The letters of a list at the end of a clause.
fn members_at_end(tokens: &[Token]) -> Vec<&Token> {
    let letter = |t: &&Token| matches!(t.kind, Kind::Formula | Kind::Plain) || is_short(t);
    let listed = tokens.iter().rev().take_while(|t| letter(t) || joins(t));
    let mut members: Vec<&Token> = listed.filter(letter).collect();
    members.reverse();
    members
}

/// A name of one letter: "x".
fn is_short(token: &Token) -> bool {
    token.kind == Kind::Word && token.text.chars().count() == 1
}

/// "a thin, massless, straight rod" without the commas.
pub(crate) fn join_adjectives(tokens: &[Token], lexicon: &Lexicon) -> Vec<Token> {
    let is = |at: usize, classes: &[Class]| {
        let word = tokens.get(at).map(|t| t.lower.as_str());
        word.is_some_and(|word| lexicon.find(&[word], classes).is_some())
    };
    let named = [Class::Adjective, Class::Thing, Class::Noun, Class::Place];
    let goes_on = |at: usize| {
        let comma = tokens.get(at).is_some_and(|t| t.kind == Kind::Comma);
        comma || is(at, &named)
    };
    let between = |at: usize| {
        let before = at
            .checked_sub(1)
            .is_some_and(|at| is(at, &[Class::Adjective]));
        before && is(at + 1, &[Class::Adjective]) && goes_on(at + 2)
    };
    let kept = (0..tokens.len()).filter(|&at| tokens[at].kind != Kind::Comma || !between(at));
    kept.map(|at| tokens[at].clone()).collect()
}
