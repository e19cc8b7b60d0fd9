//! One factor: whatever stands between two signs of operation.

use super::{DEEPEST, Parser, letter};
use crate::notation::ast::{Bracket, Factor, Kind, Node, Operator, Style, Symbol};
use crate::notation::token::Lexeme;
use crate::source::Span;

/// Whether a command is a relation, an arrow or a separator: no factor begins with it.
pub(super) fn is_relation(name: &str) -> bool {
    matches!(
        name,
        "equiv"
            | "approx"
            | "simeq"
            | "cong"
            | "ne"
            | "neq"
            | "le"
            | "leq"
            | "leqslant"
            | "ge"
            | "geq"
            | "geqslant"
            | "lt"
            | "gt"
            | "ll"
            | "gg"
            | "propto"
            | "sim"
            | "to"
            | "rightarrow"
            | "mapsto"
            | "in"
            | "perp"
            | "parallel"
            | "nparallel"
            | "nless"
            | "ngtr"
            | "nleq"
            | "ngeq"
            | "nsim"
            | "not"
            | "triangleq"
            | "doteq"
            | "coloneqq"
            | "longrightarrow"
            | "leftarrow"
            | "lesssim"
            | "gtrsim"
            | "gets"
            | "stackrel"
            | "overset"
            | "underset"
            | "eqdef"
            | "coloneq"
            | "notin"
            | "xrightarrow"
            | "leftrightarrow"
    )
}

pub(super) fn is_operator(name: &str) -> bool {
    is_relation(name)
        || matches!(
            name,
            "times"
                | "wedge"
                | "cross"
                | "land"
                | "cdot"
                | "vdot"
                | "bullet"
                | "otimes"
                | "circ"
                | "odot"
                | "ast"
                | "pm"
                | "mp"
        )
}

/// Commands that put one thing over another: a word over a relation, or a dot over a letter.
const STACKS: &[&str] = &["stackrel", "overset", "underset"];

impl<'a> Parser<'_, 'a> {
    pub(super) fn command_starts_factor(&self, name: &str) -> bool {
        let drawn_over =
            STACKS.contains(&name) && super::line::relation(&self.tokens[self.at..]).is_none();
        drawn_over || !is_operator(name)
    }

    /// A factor with everything that hangs on it.
    pub(super) fn factor(&mut self) -> Node {
        self.skip_spaces();
        if self.depth > DEEPEST {
            // Nothing behind it is tried again at every level above.
            let node = self.error("brackets nested too deeply");
            self.at = self.tokens.len();
            return node;
        }
        // A command reads what follows it on more frames of the stack than a bracket does.
        let cost = match self.peek() {
            Some(Lexeme::Command(_)) => 2,
            _ => 1,
        };
        self.depth += cost;
        let node = self.bare_factor();
        self.depth -= cost;
        node
    }

    fn bare_factor(&mut self) -> Node {
        if let Some(node) = self.slashed_derivative() {
            return node;
        }
        let start = self.at;
        match self.peek() {
            None => self.error("the formula ends where more is expected"),
            Some(Lexeme::Number(digits)) => {
                let node = self.number(digits);
                let node = self.scripts(node, start);
                self.unit(node, start)
            }
            Some(Lexeme::Letter(letter)) => {
                self.at += 1;
                self.symbol(letter.to_string(), start)
            }
            Some(Lexeme::Open) => self.braces(start),
            Some(Lexeme::Superscript) => self.prescripted(start),
            Some(Lexeme::Char('(' | '[' | '{' | '⟨' | '⌊') | Lexeme::LeftNull) => {
                let node = self.bracket(start);
                self.unit(node, start)
            }
            Some(Lexeme::Char('|' | '‖') | Lexeme::LeftBar) => self.norm(start),
            Some(Lexeme::Begin(name)) => self.environment(name, start),
            Some(Lexeme::Text(text)) if super::function::named(text.trim()).is_some() => {
                self.at += 1;
                self.function(text.trim(), start)
            }
            Some(Lexeme::Text(text)) => {
                self.at += 1;
                let constant = super::text::is_constant(text);
                let name = if constant { "const" } else { text.trim() };
                self.upright(name.to_owned(), start)
            }
            Some(Lexeme::Command(name)) => self.command(name, start),
            Some(_) => {
                let node = self.error(self.unexpected());
                self.at += 1;
                node
            }
        }
    }

    /// A letter, its scripts, and its arguments if a parenthesis follows.
    pub(super) fn symbol(&mut self, name: String, start: usize) -> Node {
        let symbol = Symbol {
            name,
            ..Symbol::default()
        };
        let node = self.node(Kind::Symbol(symbol), start);
        let node = self.scripts(node, start);
        self.call(node, start)
    }

    /// The letter of a set of numbers.
    fn board(&mut self, name: &str, start: usize) -> Node {
        let symbol = Symbol {
            name: name.to_owned(),
            style: Style {
                tensor: true,
                ..Style::default()
            },
            ..Symbol::default()
        };
        let node = self.node(Kind::Symbol(symbol), start);
        self.scripts(node, start)
    }

    /// A word in upright letters.
    pub(super) fn upright(&mut self, name: String, start: usize) -> Node {
        let style = Style {
            upright: true,
            ..Style::default()
        };
        let symbol = Symbol {
            name,
            style,
            ..Symbol::default()
        };
        let node = self.node(Kind::Symbol(symbol), start);
        let node = self.scripts(node, start);
        self.call(node, start)
    }

    /// Braces group without a sign; empty ones carry a script of what follows: `{}^{N}\omega`.
    fn braces(&mut self, start: usize) -> Node {
        let inside = self.argument();
        if !inside.is_empty() {
            // In braces too the parts between commas are a list.
            if let Some(parts) = super::bracket::list(inside, ',') {
                let entries = parts
                    .into_iter()
                    .map(|part| self.inside(part).whole())
                    .collect();
                return self.node(Kind::Tuple(entries), start);
            }
            let node = self.inside(inside).whole();
            let node = self.scripts(node, start);
            // `{\bf C}_A(v)` is one letter with what it is applied to.
            return match node.kind {
                Kind::Symbol(_) => self.call(node, start),
                _ => node,
            };
        }
        self.prescripted(start)
    }

    /// `^{N}\omega`: what is written before a letter belongs to it.
    fn prescripted(&mut self, start: usize) -> Node {
        let mut labels = vec![];
        while matches!(self.peek(), Some(Lexeme::Superscript | Lexeme::Subscript))
            && labels.len() < 8
        {
            self.at += 1;
            labels.push(self.frame_label());
        }
        let mut node = self.factor();
        if matches!(node.kind, Kind::Error(_)) {
            return node;
        }
        for label in labels {
            node = super::frame_label::marked(node, label);
        }
        node.span = self.since(start);
        node
    }

    /// `\prescript{N}{}{\omega}`: what stands at the upper and the lower left, and the letter.
    fn prescript(&mut self, start: usize) -> Node {
        let labels = [self.frame_label(), self.frame_label()];
        let mut node = self.argument_node();
        for label in labels.into_iter().filter(|label| !label.text.is_empty()) {
            node = super::frame_label::marked(node, label);
        }
        node.span = self.since(start);
        self.scripts(node, start)
    }

    fn command(&mut self, name: &'a str, start: usize) -> Node {
        self.at += 1;
        match name {
            "frac" | "dfrac" | "tfrac" | "cfrac" | "sfrac" | "nicefrac" | "flatfrac" => {
                self.fraction(start)
            }
            "dv" | "odv" | "od" | "td" | "diff" | "derivative" => {
                self.physics_derivative(false, start)
            }
            "pdv" | "pd" | "pdiff" | "diffp" => self.physics_derivative(true, start),
            "sqrt" => self.root(start),
            "sum" => self.sum_sign(true, start),
            "Sigma" => self.sum_sign(false, start),
            "int" | "iint" | "iiint" | "oint" | "idotsint" => self.integral(start),
            "partial" | "nabla" => self.prefix_derivative(start),
            "delta" | "Delta" if self.letter_follows() => self.variation(start),
            "dots" | "ldots" | "cdots" | "vdots" | "ddots" | "dotsb" | "dotsc" => {
                self.node(Kind::Ellipsis, start)
            }
            "det" | "tr" | "exp" | "ln" | "log" | "max" | "min" => self.function(name, start),
            "underbrace" | "overbrace" => self.braced_remark(),
            "stackrel" | "overset" | "underset" => self.stacked(name == "underset", start),
            "norm" => {
                self.take(Lexeme::Char('*'));
                let inner = match self.peek() {
                    Some(Lexeme::Char('(' | '[')) => self.factor(),
                    _ => self.argument_node(),
                };
                let node = self.node(Kind::Norm(Box::new(inner)), start);
                self.scripts(node, start)
            }
            "crossof" | "dotof" => self.product_of(name == "crossof", start),
            "inverseof" | "transposeof" => self.matrix_call(name == "inverseof", start),
            "prescript" => self.prescript(start),
            "cbrt" => {
                let argument = self.argument_node();
                let kind = self.root_as_power(argument, "3");
                self.node(kind, start)
            }
            "dmat" | "diagonalmatrix" => self.diagonal(start),
            "imath" => self.symbol("i".into(), start),
            "jmath" => self.symbol("j".into(), start),
            "SI" | "qty" | "num" | "ang" => self.quantity(name, start),
            "unit" | "si" => {
                let _ = self.argument();
                self.error("a unit without a number before it")
            }
            _ if letter::takes_argument(name) => self.styled(name, start),
            _ if super::function::named(name).is_some() => self.function(name, start),
            _ => match letter::greek(name) {
                Some(name) => self.symbol(name.to_owned(), start),
                None => match letter::set_of_numbers(name) {
                    Some(set) => self.board(set, start),
                    None => self.unknown(name, start),
                },
            },
        }
    }

    /// `cross(a, b)` and `dot(a, b)` of plain text.
    fn product_of(&mut self, cross: bool, start: usize) -> Node {
        let operands = self.bracket_inside().map(|(from, to)| {
            self.at = to + 1;
            super::split_outside(&self.tokens[from..to], |t| t.kind == Lexeme::Char(','))
        });
        let Some([left, right]) = operands.as_deref() else {
            return self.error("a product of two things in brackets belongs here");
        };
        let operator = if cross {
            Operator::Cross
        } else {
            Operator::Dot
        };
        let empty = |node: &Node| Span {
            start: node.span.start,
            end: node.span.start,
        };
        let operands = [(Operator::Juxtaposed, *left), (operator, *right)];
        let factors = operands.map(|(operator, tokens)| {
            let inner = self.inside(tokens).whole();
            let span = inner.span;
            let kind = Kind::Group(Bracket::Round, Box::new(inner));
            let node = Node { kind, span };
            Factor {
                operator,
                sign: empty(&node),
                node,
            }
        });
        let product = self.node(Kind::Product(factors.into()), start);
        self.grouped(Bracket::Round, product, start)
    }

    /// `inv(I)` and `transpose(R)` of plain text.
    fn matrix_call(&mut self, inverse: bool, start: usize) -> Node {
        let matrix = self.factor();
        let kind = match inverse {
            true => {
                let power = Kind::Number(super::product::read_number("1"));
                let power = self.node(power, start);
                let minus = self.node(Kind::Negate(Box::new(power)), start);
                Kind::Power(Box::new(matrix), Box::new(minus))
            }
            false => Kind::Transpose(Box::new(matrix)),
        };
        self.node(kind, start)
    }

    /// What follows an unknown command is read on, and the error stands at the command.
    fn unknown(&mut self, name: &str, start: usize) -> Node {
        let message = match name {
            "grad" | "div" | "curl" | "laplacian" | "gradient" | "divergence" => {
                format!("\\{name}, a derivative in space, is not read")
            }
            "substack" => "conditions under each other are not read".to_owned(),
            _ => format!("the command \\{name} is not known"),
        };
        while self.peek() == Some(Lexeme::Open) {
            let _ = self.argument();
        }
        self.node(Kind::Error(message), start)
    }

    /// `\underbrace{a}_{remark}`: a, with the remark passed over.
    fn braced_remark(&mut self) -> Node {
        let start = self.at;
        let mut node = self.argument_node();
        while matches!(self.peek(), Some(Lexeme::Subscript | Lexeme::Superscript)) {
            self.at += 1;
            let _ = self.argument();
        }
        node.span = self.since(start);
        node
    }

    fn letter_follows(&self) -> bool {
        match self.peek() {
            Some(Lexeme::Letter(_)) => true,
            Some(Lexeme::Command(name)) => {
                letter::takes_argument(name) || letter::greek(name).is_some()
            }
            _ => false,
        }
    }

    /// `\Delta t`: a change of what follows.
    fn variation(&mut self, start: usize) -> Node {
        let mut node = self.factor();
        if !super::integral::mark_letter(&mut node, |symbol| symbol.variation = true) {
            return self.error("a change of this is not read");
        }
        node.span = self.since(start);
        node
    }
}
