//! Functions with names of their own, roots, and how far an argument without brackets reaches.

use super::Parser;
use crate::notation::ast::{Bracket, Factor, Function, Kind, Node, Operator, Symbol};
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

/// The function of that name.
pub(super) fn named(name: &str) -> Option<Function> {
    Some(match name {
        "sin" => Function::Sin,
        "cos" => Function::Cos,
        "tan" | "tg" => Function::Tan,
        "cot" | "ctg" | "cotg" => Function::Cot,
        "sec" => Function::Sec,
        "csc" | "cosec" => Function::Csc,
        "arcsin" | "asin" => Function::Arcsin,
        "arccos" | "acos" => Function::Arccos,
        "arctan" | "atan" | "arctg" => Function::Arctan,
        "sinh" => Function::Sinh,
        "cosh" => Function::Cosh,
        "tanh" => Function::Tanh,
        "exp" => Function::Exp,
        "ln" | "log" => Function::Ln,
        "sqrt" => Function::Sqrt,
        "det" => Function::Det,
        "tr" | "trace" | "Tr" => Function::Trace,
        "vee" => Function::Vee,
        "diag" => Function::Diag,
        "skew" => Function::Skew,
        "sgn" | "sign" => Function::Sign,
        "abs" => Function::Abs,
        "min" => Function::Min,
        "max" => Function::Max,
        _ => return None,
    })
}

impl<'a> Parser<'_, 'a> {
    /// A function, its power and its argument; the name is already read.
    pub(super) fn function(&mut self, name: &str, start: usize) -> Node {
        let Some(function) = named(name) else {
            return self.error(format!("the function {name} is not known"));
        };
        let mut power = None;
        while let Some(Lexeme::Superscript | Lexeme::Subscript) = self.peek() {
            let raised = self.take(Lexeme::Superscript);
            self.at += usize::from(!raised);
            let exponent = self.argument_node();
            if raised {
                power = Some(exponent);
            }
        }
        power = power.or_else(|| self.power_between_brackets());
        let argument = self.function_argument();
        let (function, power) = match power {
            Some(exponent) if exponent.is_minus_one() => (inverse(function), None),
            power => (function, power),
        };
        let kind = match (function, argument.kind) {
            (Function::Skew, kind) => Kind::Skew(Box::new(Node {
                kind,
                span: argument.span,
            })),
            (Function::Det, Kind::Matrix(rows)) => Kind::Determinant(rows),
            (_, kind) => Kind::Function(
                function,
                Box::new(Node {
                    kind,
                    span: argument.span,
                }),
            ),
        };
        let node = self.node(kind, start);
        match power {
            Some(exponent) => self.node(Kind::Power(Box::new(node), Box::new(exponent)), start),
            None => self.scripts(node, start),
        }
    }

    /// The 2 of `\cos[2](x)`, as the package physics writes it.
    fn power_between_brackets(&mut self) -> Option<Node> {
        let next = |ahead: usize| self.tokens.get(self.at + ahead).map(|t| t.kind);
        let ahead = [next(0), next(1), next(2), next(3)];
        let [
            Some(Lexeme::Char('[')),
            Some(Lexeme::Number(_)),
            Some(Lexeme::Char(']')),
            Some(Lexeme::Char('(') | Lexeme::Open),
        ] = ahead
        else {
            return None;
        };
        let number = self.inside(&self.tokens[self.at + 1..self.at + 2]).whole();
        self.at += 3;
        Some(number)
    }

    /// `\sqrt{x}`.
    pub(super) fn root(&mut self, start: usize) -> Node {
        let degree = match self.peek() {
            Some(Lexeme::Char('[')) => self.degree(),
            _ => Some("2"),
        };
        let argument = match self.peek() {
            Some(Lexeme::Char('(')) => ungrouped(self.factor()),
            _ => self.argument_node(),
        };
        let kind = match degree {
            Some("2") => Kind::Function(Function::Sqrt, Box::new(argument)),
            Some(degree) => self.root_as_power(argument, degree),
            None => Kind::Error("a root needs a whole number for its degree".into()),
        };
        let node = self.node(kind, start);
        self.scripts(node, start)
    }

    /// The number in `\sqrt[3]{x}`; `None` where something else stands there.
    fn degree(&mut self) -> Option<&'a str> {
        let (from, to) = self.bracket_inside()?;
        self.at = to + 1;
        match &self.tokens[from..to] {
            [token] => match token.kind {
                Lexeme::Number(digits) if digits.parse::<u8>().is_ok_and(|n| n > 0) => Some(digits),
                _ => None,
            },
            _ => None,
        }
    }

    /// `\sqrt[3]{x}` is x to the power of 1/3.
    pub(super) fn root_as_power(&self, argument: Node, degree: &str) -> Kind {
        let span = argument.span;
        let number = |digits: &str| {
            let kind = Kind::Number(super::product::read_number(digits));
            Box::new(Node { kind, span })
        };
        let kind = Kind::Quotient(number("1"), number(degree));
        let base = match argument.kind {
            Kind::Symbol(_) | Kind::Number(_) => argument,
            _ => Node {
                kind: Kind::Group(Bracket::Round, Box::new(argument)),
                span,
            },
        };
        Kind::Power(Box::new(base), Box::new(Node { kind, span }))
    }

    fn function_argument(&mut self) -> Node {
        self.skip_spaces();
        if matches!(
            self.peek(),
            Some(Lexeme::Char('(' | '[') | Lexeme::Begin(_))
        ) {
            let start = self.at;
            return match self.bracket_inside() {
                Some((from, to)) if self.peek() == Some(Lexeme::Char('(')) => {
                    self.at = to + 1;
                    let inside = &self.tokens[from..to];
                    let parts = super::split_outside(inside, |t| t.kind == Lexeme::Char(','));
                    let mut nodes: Vec<Node> = parts
                        .into_iter()
                        .map(|part| self.inside(part).whole())
                        .collect();
                    match nodes.pop() {
                        Some(only) if nodes.is_empty() => only,
                        Some(last) => {
                            nodes.push(last);
                            self.node(Kind::Tuple(nodes), start)
                        }
                        None => self.error("a function without an argument"),
                    }
                }
                _ => ungrouped(self.factor()),
            };
        }
        self.open_argument()
    }

    /// An argument without brackets: numbers and fractions first, then letters as far as a `t` closes them
    /// (`\cos\Omega t`), and never past another function, a vector or a dotted letter.
    fn open_argument(&mut self) -> Node {
        let start = self.at;
        let empty = Span {
            start: self.here().start,
            end: self.here().start,
        };
        let negative = self.take(Lexeme::Char('-'));
        let mut factors: Vec<Factor> = vec![];
        loop {
            let node = self.argument_factor();
            let leading = matches!(node.kind, Kind::Number(_) | Kind::Quotient(..));
            let time = matches!(&node.kind, Kind::Symbol(s) if s.name == "t");
            factors.push(Factor {
                operator: Operator::Juxtaposed,
                sign: empty,
                node,
            });
            if self.peek() == Some(Lexeme::Char('/')) && self.divides_argument(&factors) {
                self.slash(&mut factors);
            }
            self.skip_thin_spaces();
            if time || !(self.plain_letter_ahead() && (leading || self.time_ahead())) {
                break;
            }
        }
        let node = match <[Factor; 1]>::try_from(factors) {
            Ok([only]) => only.node,
            Err(factors) => self.node(Kind::Product(factors), start),
        };
        if negative {
            self.node(Kind::Negate(Box::new(node)), start)
        } else {
            node
        }
    }

    /// A letter before a bracket is called only with something in the time: `\cos\theta(a+b)` is a product.
    fn argument_factor(&mut self) -> Node {
        let start = self.at;
        let angle = match self.peek() {
            Some(Lexeme::Command(name)) => {
                super::letter::greek(name).filter(|n| ANGLES.contains(n))
            }
            _ => None,
        };
        let Some(angle) = angle else {
            return self.factor();
        };
        self.at += 1;
        let symbol = Symbol {
            name: angle.to_owned(),
            ..Symbol::default()
        };
        let node = self.node(Kind::Symbol(symbol), start);
        let node = self.scripts(node, start);
        let in_time = self.peek() == Some(Lexeme::Char('('))
            && self.bracket_inside().is_some_and(|(from, to)| {
                let time = |t: &Token<'_>| t.kind == Lexeme::Letter('t');
                self.tokens[from..to].iter().any(time)
            });
        if in_time {
            self.call(node, start)
        } else {
            node
        }
    }

    /// `\sin\theta/2` is the sine of a half, `\sin\theta/\cos\theta` and `\sin\theta/I` are quotients.
    fn divides_argument(&self, factors: &[Factor]) -> bool {
        let number = matches!(self.peek_at(1), Some(Lexeme::Number(_)));
        let turns = |f: &Factor| matches!(&f.node.kind, Kind::Symbol(s) if s.name == "pi");
        !self.spaced_here() && (number || factors.iter().any(turns))
    }

    fn slash(&mut self, factors: &mut Vec<Factor>) {
        self.at += 1;
        let below = self.factor();
        if let Some(last) = factors.pop() {
            let span = last.node.span.to(below.span);
            let node = Node {
                kind: Kind::Quotient(Box::new(last.node), Box::new(below)),
                span,
            };
            factors.push(Factor { node, ..last });
        }
    }

    fn spaced_here(&self) -> bool {
        self.tokens.get(self.at).is_some_and(|t| t.spaced)
    }

    fn skip_thin_spaces(&mut self) {
        while matches!(self.peek(), Some(Lexeme::Space(width)) if width < 6)
            && self.plain_letter_at(1)
        {
            self.at += 1;
        }
    }

    fn plain_letter_ahead(&self) -> bool {
        self.plain_letter_at(0)
    }

    fn plain_letter_at(&self, ahead: usize) -> bool {
        match self.peek_at(ahead) {
            Some(Lexeme::Letter(_)) => true,
            Some(Lexeme::Command(name)) => super::letter::greek(name).is_some(),
            _ => false,
        }
    }

    /// Whether the letter ahead, scripts passed over, is a `t` or is followed by one.
    fn time_ahead(&self) -> bool {
        if self.peek() == Some(Lexeme::Letter('t')) {
            return true;
        }
        let mut probe = self.clone();
        probe.at += 1;
        while matches!(probe.peek(), Some(Lexeme::Subscript)) {
            probe.at += 1;
            let _ = probe.argument();
        }
        probe.skip_spaces();
        probe.peek() == Some(Lexeme::Letter('t'))
    }
}

/// Letters of angles; the others are those of rates and of what else multiplies a time.
const ANGLES: &[&str] = &[
    "theta", "phi", "psi", "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "lambda",
    "xi", "chi", "Theta", "Phi", "Psi",
];

fn ungrouped(node: Node) -> Node {
    match node.kind {
        Kind::Group(_, inner) => *inner,
        kind => Node {
            kind,
            span: node.span,
        },
    }
}

fn inverse(function: Function) -> Function {
    match function {
        Function::Sin => Function::Arcsin,
        Function::Cos => Function::Arccos,
        Function::Tan => Function::Arctan,
        other => other,
    }
}
