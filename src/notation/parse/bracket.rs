//! Brackets: groups, lists of components, norms, evaluations.

use super::{Parser, bracket_end, nesting, split_outside};
use crate::notation::ast::{Bracket, Kind, Node};
use crate::notation::token::{Lexeme, Token};

impl<'t, 'a> Parser<'t, 'a> {
    /// A bracket that opens at `start`.
    pub(super) fn bracket(&mut self, start: usize) -> Node {
        let Some(end) = bracket_end(self.tokens, start) else {
            let node = self.error("a bracket that is not closed");
            self.at = self.tokens.len();
            return node;
        };
        let opened = self.tokens[start].kind;
        let inside = &self.tokens[start + 1..end];
        self.at = end + 1;
        let node = self.bracketed(opened, inside, start);
        self.scripts(node, start)
    }

    fn bracketed(&mut self, opened: Lexeme<'a>, inside: &'t [Token<'a>], start: usize) -> Node {
        // Braces around all that stands in a bracket are not seen.
        let inside = match super::line::trimmed(inside) {
            [open, list @ .., close]
                if open.kind == Lexeme::Open
                    && close.kind == Lexeme::Close
                    && super::closing(super::line::trimmed(inside), 0) == list.len() + 1 =>
            {
                list
            }
            _ => inside,
        };
        // `[\omega\times]` is the matrix that multiplies by ω ×.
        if let [vector @ .., cross] = super::line::trimmed(inside)
            && matches!(cross.kind, Lexeme::Command("times" | "wedge"))
            && !vector.last().is_none_or(marks_script)
            && !vector[1..]
                .iter()
                .any(|t| matches!(t.kind, Lexeme::Char('+' | '-')))
        {
            let vector = self.inside(vector).whole();
            return self.node(Kind::Skew(Box::new(vector)), start);
        }
        if opened == Lexeme::Char('⌊') && !self.cross_follows() {
            let message =
                "only a vector stands in these brackets, as in \\lfloor a\\rfloor_\\times";
            return self.node(Kind::Error(message.into()), start);
        }
        let bracket = match opened {
            Lexeme::Char('[') => Bracket::Square,
            Lexeme::Char('{') => Bracket::Curly,
            _ => Bracket::Round,
        };
        if let Some(entries) = self.columns_with_signs(inside) {
            let rows = entries.into_iter().map(|entry| vec![entry]).collect();
            return self.node(Kind::Matrix(rows), start);
        }
        if let Some(parts) = components(inside, bracket, self.transpose_follows()) {
            let entries = parts
                .into_iter()
                .map(|part| self.inside(part).whole())
                .collect();
            return self.node(Kind::Tuple(entries), start);
        }
        let inner = self.inside(inside).whole();
        match inner.kind {
            Kind::Matrix(_) => Node {
                span: self.since(start),
                ..inner
            },
            _ => self.grouped(bracket, inner, start),
        }
    }

    /// Whether a `^T` stands behind the bracket: two components may stand in it, and no factors.
    fn transpose_follows(&self) -> bool {
        let mut at = 1 + usize::from(self.peek_at(1) == Some(Lexeme::Open));
        if matches!(
            self.peek_at(at),
            Some(Lexeme::Command("mathsf" | "mathrm" | "text"))
        ) {
            at += 1 + usize::from(self.peek_at(at + 1) == Some(Lexeme::Open));
        }
        let mark = self.peek_at(at);
        let mark = matches!(
            mark,
            Some(Lexeme::Char('T') | Lexeme::Command("top" | "intercal"))
        );
        mark && matches!(self.peek(), Some(Lexeme::Superscript))
    }

    fn cross_follows(&self) -> bool {
        let script = matches!(self.peek(), Some(Lexeme::Subscript | Lexeme::Superscript));
        let at = 1 + usize::from(self.peek_at(1) == Some(Lexeme::Open));
        script && self.peek_at(at) == Some(Lexeme::Command("times"))
    }

    /// `|a|`, `||a||`, `\lVert a \rVert`, and `\left|` around an array, which is a determinant.
    pub(super) fn norm(&mut self, start: usize) -> Node {
        let double = self.double_bars(start);
        let end = match (double, self.tokens[start].kind) {
            (Some(end), _) => Some(end),
            (None, Lexeme::LeftBar) => bracket_end(self.tokens, start),
            (None, bar) => closing_bar(self.tokens, start, bar),
        };
        let Some(end) = end else {
            let node = self.error("a bar that is not closed");
            self.at = self.tokens.len();
            return node;
        };
        let bars = 1 + usize::from(double.is_some());
        let inside = &self.tokens[start + bars..end];
        self.at = end + bars;
        let inner = self.inside(inside).whole();
        let node = match inner.kind {
            Kind::Matrix(rows) => self.node(Kind::Determinant(rows), start),
            _ => self.node(Kind::Norm(Box::new(inner)), start),
        };
        self.scripts(node, start)
    }

    /// Where the two bars stand that close two bars written close together; `|` within them closes nothing.
    fn double_bars(&self, start: usize) -> Option<usize> {
        let bar = |at: usize| {
            self.tokens
                .get(at)
                .is_some_and(|t| t.kind == Lexeme::Char('|'))
        };
        let double = |at: usize| bar(at) && bar(at + 1) && !self.tokens[at + 1].spaced;
        if !double(start) {
            return None;
        }
        let end = closing_bar(self.tokens, start + 1, Lexeme::Char('|'))?;
        (end > start + 2 && double(end)).then_some(end)
    }
}

/// Whether what comes next is a script: the cross of `[a]_\times` belongs to its own bracket.
fn marks_script(token: &Token<'_>) -> bool {
    matches!(token.kind, Lexeme::Subscript | Lexeme::Superscript)
}

fn closing_bar(tokens: &[Token<'_>], start: usize, bar: Lexeme<'_>) -> Option<usize> {
    let mut depth = 0;
    for (i, token) in tokens.iter().enumerate().skip(start + 1) {
        if depth == 0 && token.kind == bar {
            return Some(i);
        }
        depth += nesting(token);
    }
    None
}

/// The parts between marks, if there are several and none is empty.
pub(super) fn list<'t, 'a>(inside: &'t [Token<'a>], mark: char) -> Option<Vec<&'t [Token<'a>]>> {
    let parts = split_outside(inside, |t| t.kind == Lexeme::Char(mark));
    (parts.len() > 1 && parts.iter().all(|p| !is_blank(p))).then_some(parts)
}

/// The entries of a list: split at commas, semicolons, or, in square brackets, at written spaces.
fn components<'t, 'a>(
    inside: &'t [Token<'a>],
    bracket: Bracket,
    transposed: bool,
) -> Option<Vec<&'t [Token<'a>]>> {
    if let Some(parts) = list(inside, ',').or_else(|| list(inside, ';')) {
        return Some(parts);
    }
    if bracket == Bracket::Curly {
        return None;
    }
    let wide = |t: &Token<'a>| {
        matches!(t.kind, Lexeme::Space(width) if width >= 5) || t.kind == Lexeme::Ampersand
    };
    let parts: Vec<_> = split_outside(inside, wide)
        .into_iter()
        .filter(|p| !is_blank(p))
        .collect();
    // The terms of a sum in round brackets are no list: `(\sin a~x + \cos a~y)`.
    let sum = |part: &&[Token<'a>]| bracket == Bracket::Round && is_sum(part);
    let joined = parts.iter().any(|p| begins_or_ends_with_sign(p)) || parts.iter().any(sum);
    let fewest = if transposed && bracket == Bracket::Square {
        2
    } else {
        3
    };
    (parts.len() >= fewest && !joined).then_some(parts)
}

fn is_blank(tokens: &[Token<'_>]) -> bool {
    tokens.iter().all(|t| matches!(t.kind, Lexeme::Space(_)))
}

/// Whether a sign stands between two terms.
fn is_sum(tokens: &[Token<'_>]) -> bool {
    let sign = |t: &Token<'_>| matches!(t.kind, Lexeme::Char('+' | '-'));
    let terms = split_outside(tokens, sign);
    terms.iter().filter(|term| !is_blank(term)).count() > 1
}

/// A part that ends with a sign goes on; one that begins with a plus or a product sign does too.
fn begins_or_ends_with_sign(tokens: &[Token<'_>]) -> bool {
    let sign = |t: Option<&Token<'_>>| {
        matches!(
            t.map(|t| t.kind),
            Some(Lexeme::Char('+' | '=' | '/' | '*') | Lexeme::Command("times" | "cdot"))
        )
    };
    let minus_last = matches!(tokens.last().map(|t| t.kind), Some(Lexeme::Char('-')));
    sign(tokens.first()) || sign(tokens.last()) || minus_last
}
