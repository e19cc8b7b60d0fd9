//! "In it", "these lines": the part of the document of which the sentence before spoke.

use super::lexicon::Lexicon;
use super::rewrite::put_in;
use super::there::place_of;
use super::words::{Kind, Token};
use crate::notation::Macros;

/// Words that mean the part of the sentence before, at the beginning of a sentence.
const IN_IT: [&[&str]; 4] = [
    &["in", "it"],
    &["in", "them"],
    &["on", "it"],
    &["on", "them"],
];

/// Lines as a whole, anywhere in a sentence.
const THESE_LINES: [&[&str]; 7] = [
    &["both", "of", "these", "lines"],
    &["all", "of", "these", "lines"],
    &["these", "lines"],
    &["those", "lines"],
    &["the", "same", "lines"],
    &["this", "line"],
    &["that", "line"],
];

/// The sentence with the lines of which the sentence before spoke in the place of the words that mean them. None where it
/// has no such words, or that sentence spoke of no lines or of several parts.
pub(crate) fn on_same_lines(
    tokens: &[Token],
    before: &[Token],
    lexicon: &Lexicon,
    macros: &Macros,
) -> Option<Vec<Token>> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let begins = |phrase: &&&[&str]| words.starts_with(phrase);
    if let Some(in_it) = IN_IT.iter().find(begins) {
        let extent = extent_of(before, lexicon, macros)?;
        let rest = &tokens[in_it.len()..];
        let comma = usize::from(rest.first()?.kind == Kind::Comma);
        return Some([&extent, &rest[comma..]].concat());
    }
    let (at, phrase) = (0..words.len()).find_map(|at| {
        let found = THESE_LINES.iter().find(|p| words[at..].starts_with(p));
        found.map(|phrase| (at, *phrase))
    })?;
    let lines = lines_named(before)?;
    Some([&tokens[..at], lines, &tokens[at + phrase.len()..]].concat())
}

/// Where a sentence speaks: the part of the document that it names at its beginning, or on the lines of which it tells.
fn extent_of(sentence: &[Token], lexicon: &Lexicon, macros: &Macros) -> Option<Vec<Token>> {
    let place = place_of(sentence, lexicon, macros);
    if !place.is_empty() {
        return Some(place);
    }
    let lines = lines_named(sentence)?;
    let near = lines.first()?;
    let (on, comma) = (
        put_in(Kind::Word, "on", near),
        put_in(Kind::Comma, ",", near),
    );
    Some([&[on], lines, &[comma]].concat())
}

/// "lines 3 to 7", if a sentence names lines once.
fn lines_named(sentence: &[Token]) -> Option<&[Token]> {
    let named = |t: &Token| matches!(t.lower.as_str(), "line" | "lines");
    let number = |t: Option<&Token>| t.is_some_and(|t| t.kind == Kind::Number);
    let mut all =
        (0..sentence.len()).filter(|&at| named(&sentence[at]) && number(sentence.get(at + 1)));
    let (start, None) = (all.next()?, all.next()) else {
        return None;
    };
    let mut end = start + 2;
    let joint =
        |t: &Token| t.kind == Kind::Comma || matches!(t.lower.as_str(), "and" | "to" | "through");
    while let Some(joined) = sentence.get(end).filter(|t| joint(t)) {
        let both =
            joined.kind == Kind::Comma && sentence.get(end + 1).is_some_and(|t| t.lower == "and");
        let next = end + 1 + usize::from(both);
        if !number(sentence.get(next)) {
            break;
        }
        end = next + 1;
    }
    Some(&sentence[start..end])
}
