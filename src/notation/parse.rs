//! From tokens to the tree: a recursive descent over slices of tokens, one file for each kind of thing.
//!
//! Parsing never fails: what does not fit becomes an error node. The depth of nesting is bounded, so no input can
//! exhaust the stack.

mod arrows;
mod bracket;
mod call;
mod columns;
mod derivative;
mod environment;
mod factor;
mod frame_label;
mod function;
mod group;
mod integral;
mod letter;
pub(crate) mod line;
mod number;
mod over;
mod physics;
mod pieces;
mod product;
mod raised;
mod range;
pub(crate) mod rows;
mod script;
mod sum;
mod text;
mod unit;

use crate::notation::ast::{Kind, Node};
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

pub(crate) use letter::takes_argument;
pub(crate) use number::groups;
pub(crate) use script::symbol_of;
pub(crate) use text::is_unit;

/// Groups inside groups beyond this are refused: nobody writes them, and each costs a stack frame.
const DEEPEST: u32 = 100;

/// No tree has more levels: whatever walks one later may do so by recursion.
const TALLEST: usize = 120;

/// What is said of `2,5` where the document does not show what its commas part.
pub(crate) const COMMA_BETWEEN_DIGITS: &str =
    "a comma between digits, which may part decimals, thousands or a list";

/// Reads one expression from a slice of tokens.
#[derive(Clone)]
pub(crate) struct Parser<'t, 'a> {
    tokens: &'t [Token<'a>],
    at: usize,
    depth: u32,
    /// Where an error is placed when no token is left.
    end: Span,
}

impl<'t, 'a> Parser<'t, 'a> {
    /// A parser of a side of a relation.
    pub(crate) fn new(tokens: &'t [Token<'a>], end: Span) -> Self {
        Self {
            tokens,
            at: 0,
            depth: 0,
            end,
        }
    }

    /// A parser of the inside of a group.
    fn inside(&self, tokens: &'t [Token<'a>]) -> Self {
        let end = tokens.last().map_or(self.here(), |t| Span {
            start: t.span.end,
            end: t.span.end,
        });
        Self {
            tokens,
            at: 0,
            depth: self.depth + 1,
            end,
        }
    }

    /// A side of a relation, or all of a formula without one.
    pub(crate) fn side(self) -> Node {
        if let Some(span) = too_deep(self.tokens) {
            let kind = Kind::Error("brackets nested too deeply".into());
            return Node { kind, span };
        }
        // Each level takes a token at least.
        let may_be_tall = self.tokens.len() > TALLEST;
        let node = self.whole();
        if may_be_tall && is_tall(&node) {
            let kind = Kind::Error("brackets nested too deeply".into());
            return Node { kind, ..node };
        }
        node
    }

    /// The whole slice as one expression; what is left over is an error.
    pub(crate) fn whole(mut self) -> Node {
        if self.depth > DEEPEST {
            return self.error("brackets nested too deeply");
        }
        self.skip_spaces();
        if self.at_end() {
            return self.error("an empty place where an expression belongs");
        }
        let node = self.sum();
        self.skip_spaces();
        if self.at_end() {
            return node;
        }
        // A comma or a full stop closes a sentence, not an expression.
        if self.tokens[self.at..]
            .iter()
            .all(|t| matches!(t.kind, Lexeme::Char('.' | ',' | ';') | Lexeme::Space(_)))
        {
            return node;
        }
        if let Some((message, span)) = rows::error_in(&node) {
            return Node {
                kind: Kind::Error(message),
                span,
            };
        }
        let message = self.unexpected();
        let span = self.here();
        Node {
            kind: Kind::Error(message),
            span: node.span.to(span),
        }
    }

    fn unexpected(&self) -> String {
        match self.tokens.get(self.at).map(|t| t.kind) {
            Some(Lexeme::Command(name))
                if takes_argument(name) || letter::greek(name).is_some() =>
            {
                format!("\\{name} is not expected here")
            }
            Some(Lexeme::Command(name)) if !self.command_starts_factor(name) => {
                format!("a sign is missing an operand: \\{name}")
            }
            Some(Lexeme::Command(name)) => format!("the command \\{name} is not known"),
            Some(Lexeme::Char(',')) if self.between_digits() => COMMA_BETWEEN_DIGITS.into(),
            Some(Lexeme::Char(c)) => format!("{c:?} is not expected here"),
            Some(Lexeme::Close) => "a brace closes that was not opened".into(),
            Some(Lexeme::Begin(name)) => format!("the environment {name} is not known here"),
            Some(_) => "this is not expected here".into(),
            None => "the formula ends where more is expected".into(),
        }
    }

    fn between_digits(&self) -> bool {
        let digits = |i: Option<usize>| {
            i.and_then(|i| self.tokens.get(i))
                .is_some_and(|t| matches!(t.kind, Lexeme::Number(_)))
        };
        digits(self.at.checked_sub(1)) && digits(Some(self.at + 1))
    }

    fn peek(&self) -> Option<Lexeme<'a>> {
        self.tokens.get(self.at).map(|t| t.kind)
    }

    fn peek_at(&self, ahead: usize) -> Option<Lexeme<'a>> {
        self.tokens.get(self.at + ahead).map(|t| t.kind)
    }

    fn at_end(&self) -> bool {
        self.at >= self.tokens.len()
    }

    fn here(&self) -> Span {
        self.tokens.get(self.at).map_or(self.end, |t| t.span)
    }

    /// The bytes from a token to the last one read.
    fn since(&self, start: usize) -> Span {
        let first = self.tokens.get(start).map_or(self.end, |t| t.span);
        let last = self.at.checked_sub(1).and_then(|i| self.tokens.get(i));
        last.map_or(first, |t| first.to(t.span))
    }

    fn node(&self, kind: Kind, start: usize) -> Node {
        Node {
            kind,
            span: self.since(start),
        }
    }

    fn error(&self, message: impl Into<String>) -> Node {
        Node {
            kind: Kind::Error(message.into()),
            span: self.here(),
        }
    }

    fn skip_spaces(&mut self) {
        while matches!(self.peek(), Some(Lexeme::Space(_) | Lexeme::Ampersand)) {
            self.at += 1;
        }
    }

    fn take(&mut self, kind: Lexeme<'_>) -> bool {
        let found = self.peek() == Some(kind);
        self.at += usize::from(found);
        found
    }

    /// The tokens of an argument: the inside of braces, or one token.
    fn argument(&mut self) -> &'t [Token<'a>] {
        self.skip_spaces();
        let start = self.at;
        match self.peek() {
            Some(Lexeme::Open) => {
                let close = closing(self.tokens, start);
                self.at = (close + 1).min(self.tokens.len());
                &self.tokens[start + 1..close]
            }
            // An accent or alphabet command takes its own argument with it: `\frac\pi2`, `\dot\vec L`.
            Some(Lexeme::Command(name)) if takes_argument(name) => {
                while matches!(self.peek(), Some(Lexeme::Command(name)) if takes_argument(name)) {
                    self.at += 1;
                    self.skip_spaces();
                }
                let last = self.at;
                let open = self.peek() == Some(Lexeme::Open);
                let end = if open {
                    closing(self.tokens, last)
                } else {
                    last
                };
                self.at = (end + 1).min(self.tokens.len());
                &self.tokens[start..self.at]
            }
            Some(Lexeme::Command("frac" | "dfrac" | "tfrac")) => self.fraction_as_argument(),
            Some(_) => {
                self.at += 1;
                &self.tokens[start..self.at]
            }
            None => &[],
        }
    }

    /// A fraction that stands as an argument without braces takes its own two with it: `T^\frac32`.
    fn fraction_as_argument(&mut self) -> &'t [Token<'a>] {
        let start = self.at;
        let mut missing = 1;
        while missing > 0 {
            self.skip_spaces();
            match self.peek() {
                None => break,
                Some(Lexeme::Command("frac" | "dfrac" | "tfrac")) => missing += 1,
                Some(Lexeme::Command(name)) if takes_argument(name) => {}
                Some(Lexeme::Open) => {
                    self.at = closing(self.tokens, self.at).min(self.tokens.len() - 1);
                    missing -= 1;
                }
                Some(_) => missing -= 1,
            }
            self.at += 1;
        }
        &self.tokens[start..self.at]
    }

    /// An argument as an expression.
    fn argument_node(&mut self) -> Node {
        let tokens = self.argument();
        self.inside(tokens).whole()
    }
}

/// The first bracket that is nested too deeply to be read: each of them is a group and a factor. Without this look ahead
/// every level would walk through all that it holds before the innermost is refused.
fn too_deep(tokens: &[Token<'_>]) -> Option<Span> {
    let mut depth = 0;
    let deep = tokens.iter().find(|token| {
        depth = (depth + nesting(token)).max(0);
        depth > DEEPEST.cast_signed() / 2
    });
    deep.map(|token| token.span)
}

fn is_tall(root: &Node) -> bool {
    let mut open = vec![(root, 1)];
    while let Some((node, level)) = open.pop() {
        if level > TALLEST {
            return true;
        }
        open.extend(node.children().map(|child| (child, level + 1)));
    }
    false
}

/// The index of the token that closes the group, bracket or environment opened at `open`; the length where
/// none does.
pub(crate) fn closing(tokens: &[Token<'_>], open: usize) -> usize {
    let mut depth = 0usize;
    for (i, token) in tokens.iter().enumerate().skip(open) {
        match token.kind {
            Lexeme::Open | Lexeme::Begin(_) => depth += 1,
            Lexeme::Close | Lexeme::End(_) => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return i;
                }
            }
            _ => {}
        }
    }
    tokens.len()
}

/// The change of bracket depth at a token, all kinds of brackets counted alike.
pub(crate) fn nesting(token: &Token<'_>) -> i32 {
    match token.kind {
        Lexeme::Open
        | Lexeme::Begin(_)
        | Lexeme::Char('(' | '[' | '{' | '⟨' | '⌊')
        | Lexeme::LeftBar
        | Lexeme::LeftNull => 1,
        Lexeme::Close
        | Lexeme::End(_)
        | Lexeme::Char(')' | ']' | '}' | '⟩' | '⌋')
        | Lexeme::RightBar
        | Lexeme::RightNull => -1,
        _ => 0,
    }
}

/// The index of the token that closes the bracket of any kind opened at `open`.
pub(crate) fn bracket_end(tokens: &[Token<'_>], open: usize) -> Option<usize> {
    let mut depth = 0;
    for (i, token) in tokens.iter().enumerate().skip(open) {
        depth += nesting(token);
        if depth <= 0 {
            return Some(i);
        }
    }
    None
}

/// Splits tokens at those for which `cut` holds outside every bracket.
pub(crate) fn split_outside<'t, 'a>(
    tokens: &'t [Token<'a>],
    cut: impl Fn(&Token<'a>) -> bool,
) -> Vec<&'t [Token<'a>]> {
    let mut parts = vec![];
    let (mut depth, mut start) = (0i32, 0);
    for (i, token) in tokens.iter().enumerate() {
        depth = (depth + nesting(token)).max(0);
        if depth == 0 && cut(token) {
            parts.push(&tokens[start..i]);
            start = i + 1;
        }
    }
    parts.push(&tokens[start..]);
    parts
}
