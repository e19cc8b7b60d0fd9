//! What is set off from a clause by commas, or stands in front of it: words that begin with a preposition.

use super::lexicon::{Class, Lexicon};
use super::sentence_parts::{clause, preposition};
use super::words::{Kind, Token};

/// The clauses of a sentence, each with where it begins and ends.
fn clauses(tokens: &[Token]) -> impl Iterator<Item = (usize, usize)> + '_ {
    let ends = (0..=tokens.len()).filter(|&at| {
        let token = tokens.get(at);
        token.is_none_or(|token| token.kind == Kind::Semicolon)
    });
    ends.scan(0, |start, end| {
        let clause = (*start, end);
        *start = end + 1;
        Some(clause)
    })
}

/// "In B, the momentum of the body has the components `$a$`, `$b$`" with what stands in front behind the subject: "the momentum
/// of the body in B has …".
pub(super) fn front_behind_subject(tokens: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let mut others = vec![];
    for (start, end) in clauses(tokens) {
        let said = &tokens[start..end];
        let Some(length) = preposition(said, lexicon) else {
            continue;
        };
        for at in length + 1..said.len().min(LONGEST_FRONT) {
            let (front, rest) = said.split_at(at);
            let comma = usize::from(rest[0].kind == Kind::Comma);
            let rest = &rest[comma..];
            if !begins_subject(rest, lexicon) {
                continue;
            }
            if let Some((subject, verb, behind)) = clause(rest, lexicon) {
                let moved = [subject, front, verb, behind].concat();
                others.push([&tokens[..start], &moved, &tokens[end..]].concat());
            }
        }
    }
    others
}

/// What stands in front of a clause has no more words than this.
const LONGEST_FRONT: usize = 9;

/// Whether a subject begins here.
fn begins_subject(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let joins = |token: &Token| token.kind == Kind::Comma || token.lower == "and";
    tokens.first().is_some_and(|first| !joins(first)) && preposition(tokens, lexicon).is_none()
}

/// "The wheel has, about G, the moment `$I$`" without the commas around what begins with a preposition, and with that at the
/// end of its clause.
pub(super) fn without_commas(tokens: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let mut others = vec![];
    for (start, end) in clauses(tokens) {
        let comma = |&at: &usize| tokens[at].kind == Kind::Comma;
        let opens = (start + 1..end).filter(comma);
        for open in opens {
            let inside = &tokens[open + 1..end];
            let verb = |at: &usize| is_verb(&inside[*at..], lexicon);
            if preposition(inside, lexicon).is_none() {
                continue;
            }
            let close = (0..inside.len())
                .find(|&at| inside[at].kind == Kind::Comma)
                .unwrap_or(inside.len());
            if (0..close).any(|at| verb(&at)) {
                continue;
            }
            let (inside, behind) = inside.split_at(close);
            let behind = behind.get(1..).unwrap_or_default();
            let before = &tokens[..open];
            let rest = &tokens[end..];
            others.push([before, inside, behind, rest].concat());
            if !behind.is_empty() {
                others.push([before, behind, inside, rest].concat());
            }
        }
    }
    others
}

/// Whether a verb comes next.
fn is_verb(tokens: &[Token], lexicon: &Lexicon) -> bool {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    let copula = words
        .first()
        .is_some_and(|word| super::reader::COPULAS.contains(word));
    copula || lexicon.find(&words, &[Class::Verb]).is_some()
}
