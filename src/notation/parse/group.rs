//! Braces that group nothing: what TeX shows the same with and without them is read the same.
//!
//! `{}` makes room, `b {\color{red} + c}` colours a part of a sum, `\boxed{a = b}` frames a line, and
//! `\boldsymbol{\times}` is a bold cross. All that is settled on the tokens, in one pass each way.

use super::factor::{is_operator, is_relation};
use super::letter;
use crate::notation::token::{Lexeme, Token};

/// The tokens without the braces that group nothing.
pub(super) fn ungrouped<'a>(tokens: &[Token<'a>]) -> Vec<Token<'a>> {
    let grouping = |token: &Token<'_>| match token.kind {
        Lexeme::Open | Lexeme::LeftNull | Lexeme::RightNull => true,
        Lexeme::Command(name) => is_bold(name),
        _ => false,
    };
    if !tokens.iter().any(grouping) {
        return tokens.to_vec();
    }
    let tokens = &without_bold_lines(tokens);
    let mut scan = Scan::new(tokens);
    for i in 0..tokens.len() {
        scan.token(i);
    }
    scan.join_rows();
    let mut out = Vec::with_capacity(tokens.len());
    let mut i = 0;
    while i < tokens.len() {
        if let Some((operator, length)) = bold_operator(&tokens[i..]) {
            out.push(operator);
            i += length;
            continue;
        }
        if !scan.dropped[i] {
            out.push(tokens[i]);
        }
        if scan.emptied[i] {
            let kind = Lexeme::Close;
            out.push(Token { kind, ..tokens[i] });
        }
        i += 1;
    }
    out
}

/// An open group.
struct Group {
    open: usize,
    /// Whether it is the argument of a command or a script.
    argument: bool,
    /// What TeX would show without the braces is the same.
    idle: bool,
    /// How many arguments are still to come once it is closed.
    awaited: u8,
}

struct Scan<'t, 'a> {
    tokens: &'t [Token<'a>],
    dropped: Vec<bool>,
    /// Opening braces that are closed at once: `{^N}` is `{}^N`.
    emptied: Vec<bool>,
    groups: Vec<Group>,
    /// How many arguments the command before takes yet.
    awaited: u8,
    /// Inside the square brackets of an optional argument.
    optional: bool,
}

impl<'t, 'a> Scan<'t, 'a> {
    fn new(tokens: &'t [Token<'a>]) -> Self {
        Self {
            tokens,
            dropped: vec![false; tokens.len()],
            emptied: vec![false; tokens.len()],
            groups: vec![],
            awaited: 0,
            optional: false,
        }
    }

    fn token(&mut self, i: usize) {
        let kind = self.tokens[i].kind;
        if self.optional {
            self.optional = kind != Lexeme::Char(']');
            return;
        }
        match kind {
            Lexeme::Space(_) => {}
            Lexeme::Open => self.open(i),
            Lexeme::Close => self.close(i),
            Lexeme::Char('[') if self.awaited > 0 => self.optional = true,
            Lexeme::Subscript | Lexeme::Superscript => self.awaited = 1,
            Lexeme::Command(name) => {
                self.relation(kind);
                let arguments = arguments(name);
                self.awaited = self.awaited.saturating_sub(1).max(arguments);
            }
            _ => {
                self.relation(kind);
                self.awaited = self.awaited.saturating_sub(1);
            }
        }
    }

    fn open(&mut self, i: usize) {
        let next = self.tokens[i + 1..]
            .iter()
            .find(|t| !matches!(t.kind, Lexeme::Space(_)));
        self.groups.push(Group {
            open: i,
            argument: self.awaited > 0,
            idle: next.is_some_and(|t| is_sign(t.kind)),
            awaited: self.awaited.saturating_sub(1),
        });
        self.awaited = 0;
    }

    fn close(&mut self, i: usize) {
        let Some(group) = self.groups.pop() else {
            return;
        };
        self.awaited = group.awaited;
        let inside = &self.tokens[group.open + 1..i];
        let last = inside
            .iter()
            .rev()
            .find(|t| !matches!(t.kind, Lexeme::Space(_)));
        let script = matches!(
            self.tokens.get(i + 1).map(|t| t.kind),
            Some(Lexeme::Superscript | Lexeme::Subscript)
        );
        let idle = match last {
            None => !script,
            Some(last) => {
                group.idle
                    || is_sign(last.kind)
                    || is_function(inside)
                    || is_environment(inside)
                    || is_rate(inside)
                    || !script && is_bracket(inside)
            }
        };
        if idle && !group.argument {
            self.dropped[group.open] = true;
            self.dropped[i] = true;
        } else if !group.argument && is_script_alone(inside) {
            self.script_alone(group.open, i);
        }
    }

    /// Scripts alone in braces belong to what follows, `{^N}v` being `{}^Nv`, or to what stands close before. Where both
    /// may be meant, `x{^n}v`, they are left as they are; an index is that of what stands before it.
    fn script_alone(&mut self, open: usize, close: usize) {
        let before = open.checked_sub(1).map(|at| self.tokens[at].kind);
        let behind = self.tokens.get(close + 1).map(|t| t.kind);
        let operand = match before {
            Some(Lexeme::Command(name)) => letter::greek(name).is_some(),
            Some(kind) => matches!(
                kind,
                Lexeme::Letter(_)
                    | Lexeme::Number(_)
                    | Lexeme::Close
                    | Lexeme::RightBar
                    | Lexeme::End(_)
                    | Lexeme::Char(')' | ']' | '\'')
            ),
            None => false,
        };
        let followed = match behind {
            Some(Lexeme::Letter(_) | Lexeme::Number(_) | Lexeme::Open | Lexeme::Begin(_)) => true,
            Some(Lexeme::Char('(' | '[')) => true,
            Some(Lexeme::Command(name)) => !is_operator(name),
            _ => false,
        };
        let index = self.tokens[open + 1].kind == Lexeme::Subscript;
        let apart = self.tokens[open].spaced;
        if operand && index && !apart {
            self.dropped[open] = true;
            self.dropped[close] = true;
        } else if !operand || !followed || apart && !index {
            self.emptied[open] = true;
            self.dropped[close] = true;
        }
    }

    /// `\left( a \right. \\ \left. + b \right)` is one bracket over two rows.
    fn join_rows(&mut self) {
        let idle = |t: &Token<'_>| {
            matches!(t.kind, Lexeme::Space(_) | Lexeme::Ampersand) || is_sign(t.kind)
        };
        let is_open = |t: &Token<'_>| t.kind == Lexeme::RightNull;
        let Some(first) = self.tokens.iter().position(is_open) else {
            return;
        };
        let mut closed = None;
        let mut row = false;
        for (i, token) in self.tokens.iter().enumerate().skip(first) {
            match token.kind {
                Lexeme::RightNull => (closed, row) = (Some(i), false),
                Lexeme::Row if closed.is_some() => row = true,
                Lexeme::LeftNull if row => {
                    if let Some(closed) = closed.take() {
                        self.dropped[closed] = true;
                        self.dropped[i] = true;
                    }
                }
                _ if idle(token) => {}
                _ => closed = None,
            }
        }
    }

    /// A sign of relation shows that the braces around it hold a line.
    fn relation(&mut self, kind: Lexeme<'_>) {
        if self.awaited > 0 || self.groups.is_empty() {
            return;
        }
        let relates = match kind {
            Lexeme::Char('=' | '<' | '>') => true,
            Lexeme::Command(name) => is_relation(name),
            _ => false,
        };
        if relates && let Some(group) = self.groups.last_mut() {
            group.idle = true;
        }
    }
}

/// `{\operatorname{skew}}` is what a macro of that name leaves.
fn is_function(tokens: &[Token<'_>]) -> bool {
    match tokens {
        [one] => {
            matches!(one.kind, Lexeme::Command(name) if super::function::named(name).is_some())
        }
        [first, second, .., last] if tokens.len() < 24 => {
            first.kind == Lexeme::Command("operatorname")
                && second.kind == Lexeme::Open
                && last.kind == Lexeme::Close
                && super::closing(tokens, 1) + 1 == tokens.len()
        }
        _ => false,
    }
}

/// `{\left(t\right)}` shows what the brackets alone do.
fn is_bracket(tokens: &[Token<'_>]) -> bool {
    let first = tokens.first().map(|token| token.kind);
    first == Some(Lexeme::Char('(')) && super::bracket_end(tokens, 0) == Some(tokens.len() - 1)
}

pub(super) fn is_sign(kind: Lexeme<'_>) -> bool {
    match kind {
        Lexeme::Char('+' | '-' | '=' | '<' | '>' | ':') => true,
        Lexeme::Command(name) => is_operator(name),
        _ => false,
    }
}

/// How many groups behind a command are its own. What is not known may have any number.
fn arguments(name: &str) -> u8 {
    match name {
        _ if letter::greek(name).is_some() => 0,
        "frac" | "dfrac" | "tfrac" | "cfrac" | "sfrac" | "nicefrac" | "flatfrac" | "dv" | "pdv"
        | "odv" | "od" | "td" | "diff" | "pd" | "pdiff" | "diffp" | "derivative" | "stackrel"
        | "overset" | "underset" | "binom" => 2,
        "quad" | "qquad" | "displaystyle" => 0,
        _ if is_operator(name) => 0,
        _ if letter::takes_argument(name) || super::function::named(name).is_some() => 1,
        "SI" | "qty" => 2,
        "sqrt" | "underbrace" | "overbrace" | "unit" | "si" | "num" | "ang" | "dd" => 1,
        "sum" | "int" | "iint" | "iiint" | "oint" | "partial" | "nabla" | "dots" | "ldots"
        | "cdots" | "imath" | "jmath" | "Rightarrow" | "implies" | "iff" | "therefore" => 0,
        _ => u8::MAX,
    }
}

fn is_bold(name: &str) -> bool {
    matches!(name, "boldsymbol" | "bm" | "mathbf" | "pmb" | "mathrm")
}

/// `\boldsymbol{\times}`, `\bm\cdot`: the operator, and how many tokens were spent on it.
fn bold_operator<'a>(tokens: &[Token<'a>]) -> Option<(Token<'a>, usize)> {
    let first = tokens.first()?;
    if !matches!(first.kind, Lexeme::Command(name) if is_bold(name)) {
        return None;
    }
    let grouped = tokens.get(1)?.kind == Lexeme::Open;
    let at = 1 + usize::from(grouped);
    let operator = tokens
        .get(at)
        .filter(|t| matches!(t.kind, Lexeme::Command(name) if is_operator(name)))?;
    if grouped && tokens.get(at + 1)?.kind != Lexeme::Close {
        return None;
    }
    let span = first.span.to(tokens[at + usize::from(grouped)].span);
    Some((Token { span, ..*operator }, at + 1 + usize::from(grouped)))
}

/// The tokens without the commands and braces that make whole lines bold.
fn without_bold_lines<'a>(tokens: &[Token<'a>]) -> Vec<Token<'a>> {
    let (mut kept, mut from) = (vec![true; tokens.len()], 0);
    while from < tokens.len() {
        let at = from;
        from += 1;
        if let Some(close) = bold_line(tokens, at) {
            [at, at + 1, close]
                .into_iter()
                .for_each(|end| kept[end] = false);
            from = close;
        }
    }
    let kept = tokens.iter().zip(kept).filter(|(_, kept)| *kept);
    kept.map(|(token, _)| *token).collect()
}

/// `\mathbf{a = b}`: where the bold line ends that begins at a place.
fn bold_line(tokens: &[Token<'_>], at: usize) -> Option<usize> {
    let bold = matches!(tokens[at].kind, Lexeme::Command(name) if is_bold(name));
    if !bold || tokens.get(at + 1)?.kind != Lexeme::Open {
        return None;
    }
    let close = super::closing(tokens, at + 1);
    let inside = tokens.get(at + 2..close)?;
    Some(close).filter(|_| !super::line::relations(inside).is_empty())
}

/// Whether tokens are scripts that stand on nothing: `^N`, `^{N}_{B}`.
fn is_script_alone(inside: &[Token<'_>]) -> bool {
    let mut rest = inside;
    while let [script, argument, behind @ ..] = rest {
        if !super::line::is_script(script.kind) {
            return false;
        }
        let grouped = |at: usize| match rest.get(at).map(|t| t.kind) {
            Some(Lexeme::Open) => rest.get(super::closing(rest, at) + 1..),
            _ => None,
        };
        rest = match argument.kind {
            Lexeme::Open => grouped(1).unwrap_or_default(),
            Lexeme::Command(name) if letter::takes_argument(name) => {
                grouped(2).unwrap_or(behind.get(1..).unwrap_or_default())
            }
            kind if super::line::is_script(kind) => return false,
            _ => behind,
        };
    }
    rest.is_empty() && !inside.is_empty()
}

/// `{\begin{aligned} … \end{aligned}}`, in a few more braces or not.
fn is_environment(inside: &[Token<'_>]) -> bool {
    let mut rest = without_spaces(inside);
    for _ in 0..4 {
        match rest {
            [open, inner @ .., close]
                if open.kind == Lexeme::Open && close.kind == Lexeme::Close =>
            {
                rest = without_spaces(inner);
            }
            _ => break,
        }
    }
    match rest {
        [first, .., last] => {
            matches!(first.kind, Lexeme::Begin(_)) && matches!(last.kind, Lexeme::End(_))
        }
        _ => false,
    }
}

/// The tokens without the spaces at the two ends.
fn without_spaces<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    let space = |t: &&Token<'_>| matches!(t.kind, Lexeme::Space(_));
    let from = tokens.iter().take_while(space).count();
    let to = tokens[from..].iter().rev().take_while(space).count();
    &tokens[from..tokens.len() - to]
}

/// `{\frac {d}{dt}}`: the rate of what follows.
fn is_rate(inside: &[Token<'_>]) -> bool {
    if !(8..=24).contains(&inside.len()) {
        return false;
    }
    let kinds: Vec<_> = inside
        .iter()
        .map(|t| t.kind)
        .filter(|k| !matches!(k, Lexeme::Space(_)))
        .collect();
    matches!(
        kinds.as_slice(),
        [
            Lexeme::Command("frac" | "dfrac" | "tfrac"),
            Lexeme::Open,
            Lexeme::Letter('d'),
            Lexeme::Close,
            Lexeme::Open,
            Lexeme::Letter('d'),
            Lexeme::Letter(_),
            Lexeme::Close
        ]
    )
}
