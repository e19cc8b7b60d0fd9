//! The values of an index beside a line: `(i = 1, 2, 3)`.

use super::line::trimmed;
use super::split_outside;
use crate::notation::token::{Lexeme, Token};

/// An index and its values.
pub(super) type Range = (String, Vec<String>);

/// `(i = 1, 2, 3)`.
pub(super) fn range_in_brackets(tokens: &[Token<'_>]) -> Option<Range> {
    let [open, inner @ .., close] = tokens else {
        return None;
    };
    if open.kind != Lexeme::Char('(') || close.kind != Lexeme::Char(')') {
        return None;
    }
    range(inner)
}

/// `i = 1, 2, 3`: an index letter and whole numbers or axes.
pub(super) fn range(tokens: &[Token<'_>]) -> Option<Range> {
    let [index, equals, values @ ..] = tokens else {
        return None;
    };
    let Lexeme::Letter(letter @ ('i' | 'j' | 'k' | 'n' | 'a' | 'b')) = index.kind else {
        return None;
    };
    if equals.kind != Lexeme::Char('=') || values.is_empty() {
        return None;
    }
    let mut out = vec![];
    for part in split_outside(values, |t| t.kind == Lexeme::Char(',')) {
        match trimmed(part) {
            [one] => out.push(index_value(one.kind)?),
            _ => return None,
        }
    }
    Some((letter.to_string(), spelled(out)))
}

pub(super) fn index_value(kind: Lexeme<'_>) -> Option<String> {
    match kind {
        Lexeme::Number(value) => Some(value.to_owned()),
        Lexeme::Letter(axis @ 'x'..='z') => Some(axis.to_string()),
        Lexeme::Command("dots" | "ldots" | "cdots") => Some("…".into()),
        _ => None,
    }
}

/// `1, …, 3` with what was left out.
pub(super) fn spelled(values: Vec<String>) -> Vec<String> {
    if let [first, dots, last] = values.as_slice()
        && dots == "…"
        && let (Ok(first), Ok(last)) = (first.parse::<u32>(), last.parse::<u32>())
        && last < first.saturating_add(20)
    {
        return (first..=last).map(|n| n.to_string()).collect();
    }
    values
}
