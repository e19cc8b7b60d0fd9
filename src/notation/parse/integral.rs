//! Integrals and sums with an index.

use super::{Parser, derivative, nesting, text};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::token::Lexeme;

type Limits = Option<(Box<Node>, Box<Node>)>;

/// Integrals that stand inside one: over a volume there are two.
const INSIDE: usize = 2;

impl Parser<'_, '_> {
    /// An integral up to its differential.
    pub(super) fn integral(&mut self, start: usize) -> Node {
        self.integral_within(start, 0)
    }

    /// The same inside so many others; inside another integral `dx\,dy` is no element of volume, but the differentials of both.
    fn integral_within(&mut self, start: usize, others: usize) -> Node {
        let (lower, upper) = (self.limit(), self.limit());
        let limits: Limits = lower
            .zip(upper)
            .map(|(a, b)| (Box::new(a.1), Box::new(b.1)));
        if limits.is_some()
            && others < INSIDE
            && let Some(inner) = self.inner_integral(others + 1)
        {
            let before = self.at;
            self.skip_spaces();
            let Some((length, _)) = derivative::mark(&self.tokens[self.at..]) else {
                self.at = before;
                return inner;
            };
            self.at += length;
            let variable = self.differential_variable();
            let kind = Kind::Integral {
                integrand: Box::new(inner),
                variable: Box::new(variable),
                limits,
            };
            return self.node(kind, start);
        }
        let Some((at, length)) = self.differential_ahead() else {
            let node = self.error("an integral without a differential");
            self.at = self.tokens.len();
            return node;
        };
        let braced = at > self.at && self.tokens[at - 1].kind == Lexeme::Open;
        let inside = &self.tokens[self.at..at - usize::from(braced)];
        self.at = at + length;
        let volume = if others > 0 { None } else { self.volume() };
        let variable = volume.unwrap_or_else(|| self.differential_variable());
        self.at += usize::from(braced && self.peek() == Some(Lexeme::Close));
        self.skip_spaces();
        let first = inside.iter().all(|t| matches!(t.kind, Lexeme::Space(_)));
        let integrand = match first {
            // `\int dm\, r^2`: what is integrated may stand behind the differential.
            true if self.factor_starts() => self.product(),
            true => Node {
                kind: Kind::Number(super::product::read_number("1")),
                span: variable.span,
            },
            false => self.inside(inside).whole(),
        };
        let kind = Kind::Integral {
            integrand: Box::new(integrand),
            variable: Box::new(variable),
            limits,
        };
        self.node(kind, start)
    }

    /// The integral right behind the sign and the limits of another: `\int_0^a\!\int_0^b f\,dx\,dy`.
    fn inner_integral(&mut self, others: usize) -> Option<Node> {
        let before = self.at;
        self.skip_spaces();
        let start = self.at;
        if self.peek() == Some(Lexeme::Command("int")) {
            self.at += 1;
            return Some(self.integral_within(start, others));
        }
        self.at = before;
        None
    }

    fn differential_variable(&mut self) -> Node {
        self.skip_spaces();
        let start = self.at;
        if matches!(
            self.peek(),
            Some(Lexeme::Letter(_) | Lexeme::Command(_) | Lexeme::Open)
        ) {
            let tokens = self.argument();
            let node = self.inside(tokens).whole();
            return self.scripts(node, start);
        }
        self.error("an integral without a variable")
    }

    /// `dx\,dy\,dz` and `d^3x` are the element of volume.
    fn volume(&mut self) -> Option<Node> {
        let start = self.at;
        if let Some((length, _)) = self.cube_at(self.at) {
            self.at += length;
            self.differential_variable();
            return Some(self.volume_since(start));
        }
        let mut probe = self.clone();
        let mut axes = vec![];
        loop {
            match probe.peek()? {
                Lexeme::Letter(c @ ('x' | 'y' | 'z')) => axes.push(c),
                _ => return None,
            }
            probe.at += 1;
            if axes.len() == 3 {
                break;
            }
            probe.skip_spaces();
            let (length, _) = derivative::mark(&probe.tokens[probe.at..])?;
            probe.at += length;
        }
        self.at = probe.at;
        Some(self.volume_since(start))
    }

    fn volume_since(&self, start: usize) -> Node {
        let symbol = Symbol {
            name: "V".into(),
            ..Symbol::default()
        };
        self.node(Kind::Symbol(symbol), start)
    }

    /// The `^3` of `d^3x` and how many tokens it takes.
    fn cube_at(&self, at: usize) -> Option<(usize, u8)> {
        derivative::order(self.tokens.get(at..)?)
            .filter(|(length, times)| *length > 0 && *times == 3)
    }

    fn limit(&mut self) -> Option<(bool, Node)> {
        let lower = match self.peek() {
            Some(Lexeme::Subscript) => true,
            Some(Lexeme::Superscript) => false,
            _ => return None,
        };
        self.at += 1;
        Some((lower, self.argument_node()))
    }

    /// Where the differential stands and how many tokens its d takes.
    fn differential_ahead(&self) -> Option<(usize, usize)> {
        let mut depth = 0;
        for i in self.at..self.tokens.len() {
            if depth == 0
                && let Some((length, false)) = derivative::mark(&self.tokens[i..])
                && self.variable_at(i, i + length)
            {
                return Some((i, length));
            }
            if depth == 0 && self.is_braced_differential(i) {
                let length = derivative::mark(&self.tokens[i + 1..]).map(|(length, _)| length);
                return length.map(|length| (i + 1, length));
            }
            depth += nesting(&self.tokens[i]);
            if depth < 0 {
                return None;
            }
        }
        None
    }

    /// `{dV}`: braces around nothing but a differential, and no label.
    fn is_braced_differential(&self, at: usize) -> bool {
        let before = at.checked_sub(1).map(|before| self.tokens[before].kind);
        if matches!(before, Some(Lexeme::Subscript | Lexeme::Superscript)) {
            return false;
        }
        let Some(inside) = self
            .tokens
            .get(at + 1..)
            .filter(|_| self.tokens[at].kind == Lexeme::Open)
        else {
            return false;
        };
        match derivative::mark(inside) {
            Some((length, false)) => {
                let kinds = [length, length + 1].map(|at| inside.get(at).map(|token| token.kind));
                matches!(kinds, [Some(Lexeme::Letter(_)), Some(Lexeme::Close)])
            }
            _ => false,
        }
    }

    /// Whether a variable stands behind a d: a letter, or a group behind `\dd`.
    fn variable_at(&self, d: usize, at: usize) -> bool {
        let command = |name| matches!(name, "dd" | "dif" | "diff");
        let cube = self.cube_at(at).map_or(0, |(length, _)| length);
        let at = at + cube;
        match self.tokens.get(at).map(|t| t.kind) {
            Some(Lexeme::Letter(_) | Lexeme::Command(_)) => true,
            Some(Lexeme::Open) => {
                cube > 0 || matches!(self.tokens[d].kind, Lexeme::Command(name) if command(name))
            }
            _ => false,
        }
    }

    /// `\sum_{i=1}^{3} …`, or `\sum M` and `\Sigma M`, the resultant of M.
    pub(super) fn sum_sign(&mut self, sum: bool, start: usize) -> Node {
        let scripted = matches!(self.peek(), Some(Lexeme::Subscript | Lexeme::Superscript));
        if scripted && sum {
            return self.indexed_sum(start);
        }
        self.skip_spaces();
        if scripted || !self.factor_starts() {
            return self.symbol("Sigma".into(), start);
        }
        let before = self.at;
        let mut node = self.factor();
        self.skip_spaces();
        // `\sum m (y^2 + z^2)` goes over the particles of a body.
        let mass = |symbol: &Symbol| symbol.name == "m" && !symbol.style.vector;
        let over_mass = match &node.kind {
            Kind::Symbol(symbol) => mass(symbol) && self.factor_starts(),
            Kind::Call(head, _) => matches!(&head.kind, Kind::Symbol(symbol) if mass(symbol)),
            _ => false,
        };
        if over_mass {
            self.at = before;
            let body = Box::new(self.product());
            let index = Box::new(Symbol {
                name: running_index(&node).unwrap_or_default(),
                ..Symbol::default()
            });
            let limits = None;
            return self.node(
                Kind::IndexedSum {
                    index,
                    limits,
                    body,
                },
                start,
            );
        }
        mark_letter(&mut node, |symbol| symbol.resultant = true);
        node.span = self.since(start);
        node
    }

    fn indexed_sum(&mut self, start: usize) -> Node {
        let (mut index, mut lower, mut upper) = (String::new(), None, None);
        while let Some(script @ (Lexeme::Subscript | Lexeme::Superscript)) = self.peek() {
            self.at += 1;
            let tokens = self.argument();
            if script == Lexeme::Superscript {
                upper = Some(self.inside(tokens).whole());
                continue;
            }
            let parts = super::split_outside(tokens, |t| t.kind == Lexeme::Char('='));
            index = parts
                .first()
                .map_or(String::new(), |part| text::plain(part));
            lower = parts.get(1).map(|part| self.inside(part).whole());
        }
        let body = self.product_with_sign();
        if index.contains("substack") {
            let message = "conditions under a sum, one below the other, are not read";
            return self.node(Kind::Error(message.into()), start);
        }
        let limits: Limits = lower.zip(upper).map(|(a, b)| (Box::new(a), Box::new(b)));
        indices(index).into_iter().rfold(body, |body, name| {
            let index = Box::new(Symbol {
                name,
                ..Symbol::default()
            });
            self.node(
                Kind::IndexedSum {
                    index,
                    limits: limits.clone(),
                    body: Box::new(body),
                },
                start,
            )
        })
    }
}

/// The indices under a sum: `i,j` and `ij` are two, over each of which it goes.
fn indices(text: String) -> Vec<String> {
    let letters: Vec<char> = text.chars().filter(|c| !matches!(c, ',' | ' ')).collect();
    match letters.len() {
        2..=4 if letters.iter().all(|c| ('i'..='n').contains(c)) => {
            letters.into_iter().map(String::from).collect()
        }
        _ => vec![text],
    }
}

/// The index under a mass that a sum without one goes over: `\sum m_i x_i^2`.
fn running_index(mass: &Node) -> Option<String> {
    let symbol = match &mass.kind {
        Kind::Call(head, _) => head,
        _ => mass,
    };
    let Kind::Symbol(symbol) = &symbol.kind else {
        return None;
    };
    let running = |index: &&String| matches!(index.as_str(), "i" | "j" | "k");
    symbol.subscripts.last().filter(running).cloned()
}

/// Marks the letter that a sign before a factor belongs to: in `\delta\omega^2` and `\sum\dot L(t)` that is the first.
/// Whether there is one.
pub(super) fn mark_letter(node: &mut Node, mark: impl FnOnce(&mut Symbol)) -> bool {
    match &mut node.kind {
        Kind::Symbol(symbol) => {
            mark(symbol);
            true
        }
        Kind::TimeDerivative { operand: a, .. }
        | Kind::Call(a, _)
        | Kind::InFrame(a, _)
        | Kind::Group(_, a)
        | Kind::Power(a, _)
        | Kind::Skew(a)
        | Kind::Transpose(a) => mark_letter(a, mark),
        _ => false,
    }
}
