//! What is set off from a clause by commas, or stands in front of it: words that begin with a preposition.

use super::lexicon::Lexicon;
use super::sentence_parts::{begins_with_verb, clause, preposition};
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

/// What may stand in front of a clause, for each place where that may end, and the rest: a comma is the likeliest end.
fn fronts<'t>(
    clause: &'t [Token],
    lexicon: &Lexicon,
) -> impl Iterator<Item = (&'t [Token], &'t [Token])> {
    let ends =
        preposition(clause, lexicon).map(|length| length + 1..clause.len().min(LONGEST_FRONT));
    let mut ends: Vec<usize> = ends.into_iter().flatten().collect();
    ends.sort_by_key(|&end| clause[end].kind != Kind::Comma);
    ends.into_iter().map(|end| {
        let (front, rest) = clause.split_at(end);
        let comma = usize::from(rest[0].kind == Kind::Comma);
        (front, &rest[comma..])
    })
}

/// What stands in front of a clause takes no more pieces than this.
const LONGEST_FRONT: usize = 9;

/// "Relative to B the wheel turns about z" with what stands in front of the first clause at its end.
pub(super) fn fronted(tokens: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let end = tokens.iter().position(|t| t.kind == Kind::Semicolon);
    let (clause, behind) = tokens.split_at(end.unwrap_or(tokens.len()));
    let moved = fronts(clause, lexicon).map(|(front, rest)| [rest, front, behind].concat());
    moved.collect()
}

/// "In B, the momentum of the body has the components `$a$`, `$b$`" with what stands in front behind the subject: "the momentum
/// of the body in B has …".
pub(super) fn front_behind_subject(tokens: &[Token], lexicon: &Lexicon) -> Vec<Vec<Token>> {
    let mut others = vec![];
    for (start, end) in clauses(tokens) {
        for (front, rest) in fronts(&tokens[start..end], lexicon) {
            let said = clause(rest, lexicon).filter(|_| begins_subject(rest, lexicon));
            if let Some((subject, verb, behind)) = said {
                let moved = [subject, front, verb, behind].concat();
                others.push([&tokens[..start], &moved, &tokens[end..]].concat());
            }
        }
    }
    others
}

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
        for open in (start + 1..end).filter(comma) {
            let close = (open + 1..end).find(comma).unwrap_or(end);
            let inside = &tokens[open + 1..close];
            let verb = (0..inside.len()).any(|at| begins_with_verb(&inside[at..], lexicon));
            if preposition(inside, lexicon).is_none() || verb {
                continue;
            }
            let (before, rest) = (&tokens[..open], &tokens[end..]);
            let behind = &tokens[(close + 1).min(end)..end];
            others.push([before, inside, behind, rest].concat());
            if !behind.is_empty() {
                others.push([before, behind, inside, rest].concat());
            }
        }
    }
    others
}
