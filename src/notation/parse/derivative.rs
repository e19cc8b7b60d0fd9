//! Fractions, and those among them that are derivatives.

mod differential;

use super::Parser;
use super::frame_label::in_frame;
use super::letter::is_mark;
use crate::notation::ast::{DerivativeStyle, FrameLabel, Kind, Node};
use crate::notation::plain_words;
use crate::notation::token::{Lexeme, Token};
use differential::{Differential, above, script, total, total_mark, trim};
pub(super) use differential::{mark, order};

/// `(dt^B)^2`: what stands in the brackets, and how often.
fn raised_group<'t, 'a>(tokens: &'t [Token<'a>]) -> Option<(&'t [Token<'a>], usize)> {
    let [open, inside @ .., close, raised, power] = tokens else {
        return None;
    };
    let kinds = (open.kind, close.kind, raised.kind);
    let brackets = (Lexeme::Char('('), Lexeme::Char(')'), Lexeme::Superscript);
    match power.kind {
        Lexeme::Number("2") if kinds == brackets => Some((inside, 2)),
        _ => None,
    }
}

/// `dt^B`: the frame from which the rate is seen.
fn frame_of_time(variables: &[Node]) -> Option<FrameLabel> {
    let first = variables.first()?;
    let Kind::Symbol(symbol) = &first.kind else {
        return None;
    };
    let [label] = symbol.superscripts.as_slice() else {
        return None;
    };
    let same = |v: &Node| matches!(&v.kind, Kind::Symbol(s) if s == symbol);
    (symbol.name == "t" && variables.iter().all(same)).then(|| FrameLabel {
        text: label.clone(),
        span: first.span,
    })
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
            let bottom = trim(bottom);
            let time = self
                .inside(&bottom[total_mark(bottom).unwrap_or(1)..])
                .whole();
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
        if let Some((inside, times)) = raised_group(rest) {
            let variables = self.variables(inside)?;
            return Some(std::iter::repeat_n(variables, times).flatten().collect());
        }
        let mut variables = vec![];
        while !rest.is_empty() {
            let (length, _) = mark(rest)?;
            rest = trim(&rest[length..]);
            let mut end = (1..=rest.len()).find(|&i| {
                i == rest.len() || rest[i].kind == Lexeme::Superscript || mark(&rest[i..]).is_some()
            })?;
            // What is no number above the variable belongs to it: the step of `\partial x^{n}`.
            if end < rest.len() && order(&rest[end..]).is_none() {
                end = rest.len() - script(&rest[end + 1..]).1.len();
            }
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
        if usize::from(above.order) != variables.len() {
            return self.error("a derivative has the same order above and below its line");
        }
        let operand = if above.rest.is_empty() {
            self.differentiated()
        } else {
            self.inside(above.rest).whole()
        };
        let frame = above.frame.or_else(|| frame_of_time(&variables));
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
        // The mark of a vector and its letter are one: `\partial T/\partial\vec\omega`.
        let dots = |name: &str| matches!(name, "dot" | "ddot");
        let marked =
            matches!(below.peek(), Some(Lexeme::Command(name)) if is_mark(name) || dots(name));
        if below.peek() == Some(Lexeme::Open) {
            let _ = below.argument();
        } else {
            below.at += 1;
        }
        if marked {
            let _ = below.argument();
        }
        while matches!(below.peek(), Some(Lexeme::Subscript | Lexeme::Superscript)) {
            below.at += 1;
            let _ = below.argument();
        }
        let variables = self.variables(&self.tokens[bottom..below.at])?;
        self.at = below.at;
        let rest = &self.tokens[from..slash];
        let differential = Differential {
            partial,
            order,
            frame: None,
            rest,
        };
        let rate = self.derivative(differential, variables, start);
        Some(match self.frame_in_brackets() {
            Some(frame) => in_frame(rate, frame),
            None => rate,
        })
    }

    /// The `(inertial)` of `dH/dt (inertial)`.
    fn frame_in_brackets(&mut self) -> Option<FrameLabel> {
        let [open, word, close, ..] = self.tokens.get(self.at..)? else {
            return None;
        };
        match (open.kind, word.kind, close.kind) {
            (Lexeme::Char('('), Lexeme::Text(text), Lexeme::Char(')'))
                if plain_words::is_frame(text.trim()) =>
            {
                self.at += 3;
                Some(FrameLabel {
                    text: text.trim().to_owned(),
                    span: word.span,
                })
            }
            _ => None,
        }
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
        let mut times = 1_u8;
        self.take(Lexeme::Char('*'));
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
        let mut variables = vec![variable; usize::from(times)];
        // `\pdv{f}{x}{y}` is a mixed one.
        if partial && !rest.is_empty() && self.peek() == Some(Lexeme::Open) {
            variables.push(self.argument_node());
        }
        self.derivative(
            Differential {
                partial,
                order: variables.len() as u8,
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
