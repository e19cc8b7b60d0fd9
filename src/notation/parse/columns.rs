//! Columns side by side with columns of signs between them: one column, each row of which reads across.

use super::line::trimmed;
use super::{Parser, closing, split_outside};
use crate::notation::ast::{Kind, Node, Term};
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

/// Braces around a column are taken off as often as this.
const MOST_BRACES: usize = 4;

/// A column of an environment: what stands in each row.
type Column<'t, 'a> = Vec<&'t [Token<'a>]>;

impl<'t, 'a> Parser<'t, 'a> {
    /// The entries of the one column, if there are columns of signs and they part all others.
    pub(super) fn columns_with_signs(&self, inside: &'t [Token<'a>]) -> Option<Vec<Node>> {
        let columns = columns(inside)?;
        let height = columns.first()?.len();
        let signs: Vec<_> = columns.iter().map(|column| signs(column)).collect();
        let parted = |pair: &[Option<Vec<_>>]| pair[0].is_some() != pair[1].is_some();
        let ends = signs.last()?.is_none() && columns.len() > 1;
        let even = columns.iter().all(|column| column.len() == height);
        if !ends || !even || !signs.windows(2).all(parted) {
            return None;
        }
        let entry = |row: usize| {
            let mut terms: Vec<Term> = vec![];
            let mut sign = (false, Span::default());
            for (column, signs) in columns.iter().zip(&signs) {
                match signs {
                    Some(signs) => sign = signs[row],
                    None => push(&mut terms, sign, self.inside(column[row]).whole()),
                }
            }
            Node {
                span: terms.first().map_or(self.here(), |term| term.node.span),
                kind: Kind::Sum(terms),
            }
        };
        Some((0..height).map(entry).collect())
    }
}

/// A sign stands before what is written behind it: of a sum before its first term.
fn push(terms: &mut Vec<Term>, (negative, sign): (bool, Span), node: Node) {
    match node.kind {
        Kind::Sum(inner) => {
            let first = terms.len();
            terms.extend(inner);
            if let Some(term) = terms.get_mut(first) {
                term.negative ^= negative;
            }
        }
        _ => terms.push(Term {
            negative,
            sign,
            node,
        }),
    }
}

/// The columns, if nothing but columns stands there.
fn columns<'t, 'a>(inside: &'t [Token<'a>]) -> Option<Vec<Column<'t, 'a>>> {
    let mut columns = vec![];
    let mut rest = trimmed(inside);
    while let Some(first) = rest.first() {
        if !matches!(first.kind, Lexeme::Begin(_) | Lexeme::Open) {
            return None;
        }
        let end = closing(rest, 0);
        columns.push(rows(column(rest.get(..=end)?)?)?);
        rest = trimmed(&rest[end + 1..]);
    }
    Some(columns)
}

/// What stands in an environment of one column; braces around it may give it a colour.
fn column<'t, 'a>(mut tokens: &'t [Token<'a>]) -> Option<&'t [Token<'a>]> {
    for _ in 0..MOST_BRACES {
        let [open, inner @ .., _] = tokens else {
            return None;
        };
        match open.kind {
            Lexeme::Begin("matrix" | "array" | "smallmatrix") => return Some(inner),
            Lexeme::Open => tokens = trimmed(inner),
            _ => return None,
        }
    }
    None
}

fn rows<'t, 'a>(inside: &'t [Token<'a>]) -> Option<Column<'t, 'a>> {
    let mut rows = split_outside(inside, |token| token.kind == Lexeme::Row);
    if rows.last().is_some_and(|row| trimmed(row).is_empty()) {
        rows.pop();
    }
    let one = |row: &&[Token<'a>]| row.iter().all(|token| token.kind != Lexeme::Ampersand);
    rows.iter().all(one).then_some(rows)
}

/// Whether each row is a sign alone, and which are minus.
fn signs(column: &Column<'_, '_>) -> Option<Vec<(bool, Span)>> {
    let sign = |row: &&[Token<'_>]| match trimmed(row) {
        [token] => match token.kind {
            Lexeme::Char('+') => Some((false, token.span)),
            Lexeme::Char('-') => Some((true, token.span)),
            _ => None,
        },
        _ => None,
    };
    column.iter().map(sign).collect()
}
