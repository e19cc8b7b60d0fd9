//! Parts without mass that belong to a body: "the disc with its shaft" is the disc, where the shaft has no mass, and what acts
//! on the shaft acts on the disc.

use super::reader::ARTICLES;
use super::statement::Misread;
use super::words::{Kind, Token};

/// What says that a thing has no mass, behind its noun.
const WITHOUT_MASS: [&[&str]; 4] = [
    &["has", "no", "mass"],
    &["is", "massless"],
    &["is", "without", "mass"],
    &["has", "negligible", "mass"],
];

/// Joins each part without mass to the body of which a sentence says that it comes with it.
pub(super) fn join_attachments(sentences: &mut [Result<Vec<Token>, Misread>]) {
    let all: Vec<&[Token]> = sentences.iter().flatten().map(Vec::as_slice).collect();
    let parts: Vec<(String, Vec<Token>)> = all
        .iter()
        .flat_map(|tokens| parts_in(tokens))
        .filter(|(part, _)| all.iter().any(|tokens| is_massless(tokens, part)))
        .collect();
    for (part, body) in parts {
        for tokens in sentences.iter_mut().flatten() {
            if is_massless(tokens, &part) {
                continue;
            }
            *tokens = joined(tokens, &part, &body);
        }
    }
}

/// "the disc with its shaft": the parts with the nouns of their bodies.
fn parts_in(tokens: &[Token]) -> Vec<(String, Vec<Token>)> {
    let found = (1..tokens.len()).filter_map(|at| {
        let [with, its, part] = tokens.get(at..at + 3)? else {
            return None;
        };
        let body = &tokens[at - 1];
        let named = body.kind == Kind::Word && part.kind == Kind::Word;
        let joins = with.lower == "with" && its.lower == "its" && named;
        joins.then(|| (part.lower.clone(), vec![body.clone()]))
    });
    found.collect()
}

/// "The shaft has no mass."
fn is_massless(tokens: &[Token], part: &str) -> bool {
    let [article, noun, rest @ ..] = tokens else {
        return false;
    };
    let said = |words: &&[&str]| {
        rest.len() == words.len() && rest.iter().zip(*words).all(|(t, word)| t.lower == *word)
    };
    ARTICLES.contains(&article.lower.as_str())
        && noun.lower == part
        && WITHOUT_MASS.iter().any(said)
}

/// A sentence with the body in the place of its part.
fn joined(tokens: &[Token], part: &str, body: &[Token]) -> Vec<Token> {
    let mut new: Vec<Token> = vec![];
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let next = |ahead: usize| tokens.get(at + ahead).map_or("", |t| t.lower.as_str());
        if token.lower == "with" && next(1) == "its" && next(2) == part {
            at += 3;
        } else if token.lower == "the" && next(1) == part {
            new.push(token.clone());
            new.extend(body.iter().cloned());
            at += 2;
        } else {
            new.push(token.clone());
            at += 1;
        }
    }
    new
}
