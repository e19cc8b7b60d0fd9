//! Fractions, and those among them that are derivatives.

use super::Parser;
use crate::notation::ast::{DerivativeStyle, Kind, Node};
use crate::notation::token::{Lexeme, Token};

/// What a numerator or a denominator of differentials says.
struct Differential<'t, 'a> {
    partial: bool,
    order: u8,
    /// A frame written before the d: `{}^{N}d`.
    frame: Option<&'t [Token<'a>]>,
    rest: &'t [Token<'a>],
}

/// How many tokens a `d` or `∂` takes at the start of a slice, and whether it is partial.
pub(super) fn mark(tokens: &[Token<'_>]) -> Option<(usize, bool)> {
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    match kind(0)? {
        Lexeme::Letter('d') | Lexeme::Text("d") | Lexeme::Command("dd" | "dif" | "diff") => {
            Some((1, false))
        }
        Lexeme::Command("partial") => Some((1, true)),
        Lexeme::Open => grouped_mark(tokens),
        Lexeme::Command("mathrm" | "rm" | "mathit" | "operatorname") => match kind(1)? {
            Lexeme::Letter('d') => Some((2, false)),
            // Scanned formulas have spaces inside: `\mathrm{~d} t`.
            Lexeme::Open => {
                let spaces = |&i: &usize| matches!(kind(i), Some(Lexeme::Space(_)));
                let letter = 2 + (2..).take_while(spaces).count();
                let close = letter + 1 + (letter + 1..).take_while(spaces).count();
                (kind(letter) == Some(Lexeme::Letter('d')) && kind(close) == Some(Lexeme::Close))
                    .then_some((close + 1, false))
            }
            _ => None,
        },
        _ => None,
    }
}

/// What an author's own `\dd` leaves: a group, or a few in each other, with nothing else in it.
fn grouped_mark(tokens: &[Token<'_>]) -> Option<(usize, bool)> {
    let near = &tokens[..tokens.len().min(4)];
    let opened = near.iter().take_while(|t| t.kind == Lexeme::Open).count();
    let inside = tokens.get(opened..)?;
    if inside.first()?.kind == Lexeme::Open {
        return None;
    }
    let (length, partial) = mark(inside)?;
    let closing = inside.get(length..length + opened)?;
    let closed = closing.iter().all(|t| t.kind == Lexeme::Close);
    closed.then_some((length + 2 * opened, partial))
}

fn order(tokens: &[Token<'_>]) -> Option<(usize, u8)> {
    let kind = |i: usize| tokens.get(i).map(|t| t.kind);
    if kind(0) != Some(Lexeme::Superscript) {
        return Some((0, 1));
    }
    let digits = |k: Option<Lexeme<'_>>| match k {
        Some(Lexeme::Number(digits)) => digits.parse::<u8>().ok().filter(|n| (1..=8).contains(n)),
        _ => None,
    };
    match kind(1)? {
        Lexeme::Open if kind(3) == Some(Lexeme::Close) => digits(kind(2)).map(|n| (4, n)),
        one => digits(Some(one)).map(|n| (2, n)),
    }
}

fn above<'t, 'a>(tokens: &'t [Token<'a>]) -> Option<Differential<'t, 'a>> {
    let (frame, tokens) = prescript(tokens);
    let (length, partial) = mark(tokens)?;
    let (below, tokens) = subscript(&tokens[length..]);
    // d'/dt, the rate on axes that turn (Landau and Lifshitz, Mechanics, § 36).
    let (below, tokens) = match tokens {
        [first, rest @ ..] if first.kind == Lexeme::Char('\'') => (Some(&tokens[..1]), rest),
        _ => (below, tokens),
    };
    let (more, order) = order(tokens)?;
    let frame = frame.or(below);
    let rest = trim(&tokens[more..]);
    Some(Differential {
        partial,
        order,
        frame,
        rest,
    })
}

fn trim<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    let blank = |t: &&Token<'_>| matches!(t.kind, Lexeme::Space(_));
    let from = tokens.iter().take_while(blank).count();
    let to = tokens[from..].iter().rev().take_while(blank).count();
    &tokens[from..tokens.len() - to]
}

/// `_B` behind a d, as in `\frac{d_B L}{dt}`.
fn subscript<'t, 'a>(tokens: &'t [Token<'a>]) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    match tokens {
        [first, rest @ ..] if first.kind == Lexeme::Subscript => script(rest),
        _ => (None, tokens),
    }
}

/// `D t` below a line makes the D above it a d: `\frac{D L}{D t}`.
fn total<'t, 'a>(top: &'t [Token<'a>], bottom: &[Token<'a>]) -> Option<Differential<'t, 'a>> {
    let time = trim(bottom).iter().map(|t| t.kind);
    let [first, rest @ ..] = trim(top) else {
        return None;
    };
    let total =
        first.kind == Lexeme::Letter('D') && time.eq([Lexeme::Letter('D'), Lexeme::Letter('t')]);
    total.then(|| Differential {
        partial: false,
        order: 1,
        frame: None,
        rest: trim(rest),
    })
}

/// `{}^{N}` before the rest.
fn prescript<'t, 'a>(tokens: &'t [Token<'a>]) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    let kinds = (
        tokens.first().map(|t| t.kind),
        tokens.get(1).map(|t| t.kind),
        tokens.get(2).map(|t| t.kind),
    );
    let skip = match kinds {
        (Some(Lexeme::Open), Some(Lexeme::Close), Some(Lexeme::Superscript)) => 3,
        (Some(Lexeme::Superscript), ..) => 1,
        _ => return (None, tokens),
    };
    script(&tokens[skip..])
}

/// The argument of a script and what follows it.
fn script<'t, 'a>(tokens: &'t [Token<'a>]) -> (Option<&'t [Token<'a>]>, &'t [Token<'a>]) {
    match tokens.first().map(|t| t.kind) {
        Some(Lexeme::Open) => {
            let close = super::closing(tokens, 0);
            (
                Some(&tokens[1..close]),
                &tokens[(close + 1).min(tokens.len())..],
            )
        }
        Some(_) => (Some(&tokens[..1]), &tokens[1..]),
        None => (None, tokens),
    }
}

impl<'t, 'a> Parser<'t, 'a> {
    /// `\frac{a}{b}`: a derivative if differentials stand above and below, a quotient otherwise.
    pub(super) fn fraction(&mut self, start: usize) -> Node {
        let top = self.argument();
        let bottom = self.argument();
        if let Some(differential) = above(top)
            && let Some(variables) = self.variables(bottom)
        {
            return self.derivative(differential, variables, start);
        }
        if let Some(differential) = total(top, bottom) {
            let time = self.inside(&trim(bottom)[1..]).whole();
            return self.derivative(differential, vec![time], start);
        }
        let above = self.inside(top).whole();
        let below = self.inside(bottom).whole();
        let node = self.node(Kind::Quotient(Box::new(above), Box::new(below)), start);
        self.scripts(node, start)
    }

    /// The variables of a denominator: `dt^2`, `\partial x\,\partial y`.
    fn variables(&self, tokens: &'t [Token<'a>]) -> Option<Vec<Node>> {
        let mut rest = trim(tokens);
        let mut variables = vec![];
        while !rest.is_empty() {
            let (length, _) = mark(rest)?;
            rest = trim(&rest[length..]);
            let end = (1..=rest.len()).find(|&i| {
                i == rest.len() || rest[i].kind == Lexeme::Superscript || mark(&rest[i..]).is_some()
            })?;
            // What is differentiated in is short, and it is read a second time where this fails.
            if end > 24 {
                return None;
            }
            let variable = self.inside(&rest[..end]).whole();
            let (more, times) = order(&rest[end..])?;
            rest = trim(&rest[end + more..]);
            variables.extend(std::iter::repeat_n(variable, times.into()));
        }
        (!variables.is_empty()).then_some(variables)
    }

    fn derivative(
        &mut self,
        above: Differential<'t, 'a>,
        variables: Vec<Node>,
        start: usize,
    ) -> Node {
        let operand = if above.rest.is_empty() {
            self.differentiated()
        } else {
            self.inside(above.rest).whole()
        };
        let frame = above.frame.map(|tokens| crate::notation::ast::FrameLabel {
            text: super::text::plain(tokens),
            span: tokens
                .iter()
                .map(|t| t.span)
                .reduce(|a, b| a.to(b))
                .unwrap_or_default(),
        });
        let time = variables.iter().all(
            |v| matches!(&v.kind, Kind::Symbol(s) if s.name == "t" && s.subscripts.is_empty()),
        );
        let operand = Box::new(operand);
        let node = if time && !above.partial {
            let order = above.order;
            self.node(
                Kind::TimeDerivative {
                    operand,
                    order,
                    style: DerivativeStyle::Leibniz,
                    frame,
                },
                start,
            )
        } else {
            self.node(
                Kind::Derivative {
                    operand,
                    variables,
                    partial: above.partial,
                },
                start,
            )
        };
        if above.rest.is_empty() {
            node
        } else {
            self.scripts(node, start)
        }
    }

    /// What an operator `d/dt` acts on: the bracket behind it, or all factors to the end of the term.
    fn differentiated(&mut self) -> Node {
        self.skip_spaces();
        match self.peek() {
            Some(Lexeme::Char('(' | '[' | '{') | Lexeme::Begin(_) | Lexeme::Open) => {
                let node = self.factor();
                match node.kind {
                    Kind::Group(_, inner) => Node {
                        span: node.span,
                        ..*inner
                    },
                    kind => Node {
                        kind,
                        span: node.span,
                    },
                }
            }
            _ => self.product(),
        }
    }

    /// `dT/dt`, `d/dt (…)` in one line.
    pub(super) fn slashed_derivative(&mut self) -> Option<Node> {
        let start = self.at;
        let (length, partial) = mark(&self.tokens[start..])?;
        let slash = self.slash_ahead(start + length)?;
        mark(&self.tokens[slash + 1..])?;
        // What is differentiated ends at the slash; nothing behind it is looked at twice.
        let mut probe = self.clone();
        probe.tokens = &self.tokens[..slash];
        probe.at += length;
        let (more, order) = order(&probe.tokens[probe.at..])?;
        probe.at += more;
        let from = probe.at;
        if probe.at < slash {
            let _ = probe.factor();
        }
        if probe.at != slash {
            return None;
        }
        let bottom = slash + 1;
        let (length, _) = mark(&self.tokens[bottom..])?;
        let mut below = self.clone();
        below.at = bottom + length;
        if !below.factor_starts() {
            return None;
        }
        below.at += 1;
        while matches!(below.peek(), Some(Lexeme::Subscript | Lexeme::Superscript)) {
            below.at += 1;
            let _ = below.argument();
        }
        let variables = self.variables(&self.tokens[bottom..below.at])?;
        self.at = below.at;
        let rest = &self.tokens[from..slash];
        Some(self.derivative(
            Differential {
                partial,
                order,
                frame: None,
                rest,
            },
            variables,
            start,
        ))
    }

    /// The next slash outside brackets, if it is near.
    fn slash_ahead(&self, from: usize) -> Option<usize> {
        let mut depth = 0;
        for (i, token) in self.tokens.iter().enumerate().skip(from).take(40) {
            if depth == 0 && token.kind == Lexeme::Char('/') {
                return Some(i);
            }
            depth += super::nesting(token);
            if depth < 0 {
                return None;
            }
        }
        None
    }

    /// `\dv{L}{t}`, `\dv{t}(…)`, `\pdv{F}{x}`, `\dv[2]{r}{t}`.
    pub(super) fn physics_derivative(&mut self, partial: bool, start: usize) -> Node {
        let mut times = 1;
        if self.take(Lexeme::Char('[')) {
            if let Some(Lexeme::Number(digits)) = self.peek() {
                times = digits.parse().unwrap_or(1).clamp(1, 8);
                self.at += 1;
            }
            self.take(Lexeme::Char(']'));
        }
        let first = self.argument();
        let (rest, variable): (&'t [Token<'a>], _) = match self.peek() {
            Some(Lexeme::Open) => (first, self.argument()),
            _ => (&[], first),
        };
        let variable = self.inside(variable).whole();
        let variables = vec![variable; usize::from(times)];
        self.derivative(
            Differential {
                partial,
                order: times,
                frame: None,
                rest,
            },
            variables,
            start,
        )
    }

    /// `\partial_x f`, `\nabla_x f`.
    pub(super) fn prefix_derivative(&mut self, start: usize) -> Node {
        if !self.take(Lexeme::Subscript) {
            return self
                .error("a \\partial or \\nabla that says in what to differentiate belongs here");
        }
        let variable = self.argument_node();
        let operand = Box::new(self.factor());
        self.node(
            Kind::Derivative {
                operand,
                variables: vec![variable],
                partial: true,
            },
            start,
        )
    }
}
