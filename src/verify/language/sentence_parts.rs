//! The parts of a sentence by its words, before the grammar reads it: subject, verb and rest, and the noun at a beginning.

use super::lexicon::{Class, Lexicon};
use super::reader::{ARTICLES, COPULAS};
use super::words::{Kind, Token};

/// Words by which clauses are joined.
const JOINS: [&str; 8] = [
    "and", "while", "whereas", "where", "but", "with", "likewise", "then",
];

/// What is done to bodies that something else carries.
pub(super) const HELD: [&str; 11] = [
    "hinged",
    "pinned",
    "pivoted",
    "suspended",
    "hung",
    "mounted",
    "attached",
    "carried",
    "held",
    "placed",
    "connected",
];

/// Subject, verb, and the rest of a clause.
pub(super) fn clause<'t>(
    tokens: &'t [Token],
    lexicon: &Lexicon,
) -> Option<(&'t [Token], &'t [Token], &'t [Token])> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let (at, length) = (1..tokens.len()).find_map(|at| {
        if COPULAS.contains(&words[at]) || matches!(words[at], "means" | "mean") {
            return Some((at, 1));
        }
        let verb = lexicon.find(&words[at..], &[Class::Verb])?;
        let nouns = [Class::Noun, Class::Place, Class::Thing];
        let noun = lexicon.find(&words[at..], &nouns);
        // "`$x$` points east", "the disc rolls": behind a letter or another noun it is no noun
        let before = &tokens[at - 1];
        let letter = matches!(before.kind, Kind::Formula | Kind::Plain);
        let things = [Class::Thing, Class::Place];
        let thing = lexicon.find(&words[at - 1..at], &things).is_some();
        (noun.is_none() || letter || thing).then_some((at, verb.length))
    })?;
    let (subject, rest) = tokens.split_at(at);
    let (verb, rest) = rest.split_at(length);
    Some((subject, verb, rest))
}

/// The noun with which something begins, without its article: what stands before the first preposition.
pub(super) fn head<'t>(tokens: &'t [Token], lexicon: &Lexicon) -> &'t [Token] {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let start = usize::from(words.first().is_some_and(|word| ARTICLES.contains(word)));
    let nouns = [Class::Noun, Class::Place, Class::Thing];
    let mut at = start;
    while at < tokens.len() {
        if let Some(noun) = lexicon.find(&words[at..], &nouns) {
            return &tokens[start..at + noun.length];
        }
        if lexicon.find(&words[at..], &[Class::Preposition]).is_some() {
            break;
        }
        at += 1;
    }
    &tokens[start..at]
}

/// Where a noun for a thing stands, behind adjectives alone.
pub(super) fn thing_in(noun: &[Token], lexicon: &Lexicon) -> Option<(usize, usize)> {
    let words: Vec<&str> = noun.iter().map(|t| t.lower.as_str()).collect();
    let mut at = 0;
    loop {
        let rest = words.get(at..).filter(|rest| !rest.is_empty())?;
        if let Some(thing) = lexicon.find(rest, &[Class::Thing]) {
            return Some((at, at + thing.length));
        }
        at += lexicon.find(rest, &[Class::Adjective])?.length;
    }
}

/// Where the noun ends with which something begins.
pub(super) fn nouns_end(tokens: &[Token], lexicon: &Lexicon) -> usize {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let nouns = [Class::Noun, Class::Place];
    let found = (0..tokens.len().min(4)).find_map(|at| {
        let noun = lexicon.find(&words[at..], &nouns)?;
        Some(at + noun.length)
    });
    found.unwrap_or(0)
}

/// Whether some words name several things.
pub(super) fn is_list(tokens: &[Token]) -> bool {
    let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain) && t.text.contains(',');
    tokens.iter().any(|t| joins(t) || formula(t))
}

/// Whether a verb comes next.
pub(super) fn begins_with_verb(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let copula = words.first().is_some_and(|word| COPULAS.contains(word));
    copula || lexicon.find(&words, &[Class::Verb]).is_some()
}

/// Whether a preposition comes next.
pub(super) fn preposition(tokens: &[Token], lexicon: &Lexicon) -> Option<usize> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    Some(lexicon.find(&words, &[Class::Preposition])?.length)
}

/// Whether a word or a comma may join clauses.
pub(crate) fn joins(token: &Token) -> bool {
    token.kind == Kind::Comma || token.kind == Kind::Word && JOINS.contains(&token.lower.as_str())
}
