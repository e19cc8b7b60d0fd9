//! "There" at the beginning of a sentence: in the part of the document of which the sentence before speaks.

use super::lexicon::Lexicon;
use super::reader::{ARTICLES, Reader};
use super::words::{Kind, Token};
use crate::notation::Macros;
use std::collections::BTreeSet;

/// Puts the part of the document in the place of the word.
pub(crate) fn say_where<E>(
    sentences: &mut [Result<Vec<Token>, E>],
    lexicon: &Lexicon,
    macros: &Macros,
) {
    let mut place: Vec<Token> = vec![];
    for tokens in sentences.iter_mut().flatten() {
        match length_of_there(tokens) {
            Some(length) if !place.is_empty() => {
                let column = tokens[0].column;
                let said = place.iter().map(|token| Token {
                    column,
                    ..token.clone()
                });
                let said: Vec<Token> = said.collect();
                tokens.splice(..length, said);
            }
            _ => place = place_of(tokens, lexicon, macros),
        }
    }
}

/// How many pieces the word takes with its comma, where a subject follows; "there is" is no place.
fn length_of_there(tokens: &[Token]) -> Option<usize> {
    tokens.first().filter(|t| t.lower == "there")?;
    let comma = tokens.get(1).is_some_and(|t| t.kind == Kind::Comma);
    let next = tokens.get(1 + usize::from(comma))?;
    let subject = next.kind == Kind::Formula || ARTICLES.contains(&next.lower.as_str());
    (comma || subject).then_some(1 + usize::from(comma))
}

/// The words with which a sentence says of which part of the document it speaks.
pub(super) fn place_of(tokens: &[Token], lexicon: &Lexicon, macros: &Macros) -> Vec<Token> {
    let bodies = BTreeSet::new();
    let mut reader = Reader::new(tokens, (1, 1), lexicon, macros, &bodies);
    let end = reader.extents().map_or(0, |_| reader.at);
    tokens[..end].to_vec()
}
