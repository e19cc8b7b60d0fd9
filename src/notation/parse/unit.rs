//! Numbers and units by the commands of siunitx, and units behind an expression of numbers.

use super::Parser;
use super::text::{plain, unit_text};
use crate::notation::ast::{Factor, Kind, Node};
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

/// Names of units and prefixes as commands, with what they are written as.
const NAMES: &[(&str, &str)] = &[
    ("kilogram", "kg"),
    ("gram", "g"),
    ("meter", "m"),
    ("metre", "m"),
    ("second", "s"),
    ("minute", "min"),
    ("hour", "h"),
    ("newton", "N"),
    ("joule", "J"),
    ("watt", "W"),
    ("hertz", "Hz"),
    ("pascal", "Pa"),
    ("radian", "rad"),
    ("degree", "deg"),
    ("kilo", "k"),
    ("centi", "c"),
    ("milli", "m"),
    ("mega", "M"),
    ("rpm", "rpm"),
    ("rev", "rev"),
    ("kg", "kg"),
    ("mm", "mm"),
    ("cm", "cm"),
    ("rad", "rad"),
];

/// Prefixes: the next unit is written close behind them.
const PREFIXES: &[&str] = &["kilo", "centi", "milli", "mega"];

impl<'a> Parser<'_, 'a> {
    /// `\SI{3.0}{rad/s}`, `\qty`, `\num{2.0e-3}`, `\ang{30}`.
    pub(super) fn quantity(&mut self, name: &str, start: usize) -> Node {
        let figure = self.argument();
        let unit = match name {
            "SI" | "qty" => self.unit_argument(),
            "ang" => "deg".to_owned(),
            _ => String::new(),
        };
        let mut node = self.figure(figure);
        node.span = self.since(start);
        let node = self.scripts(node, start);
        match unit.as_str() {
            "" => node,
            _ => self.node(Kind::WithUnit(Box::new(node), unit), start),
        }
    }

    /// The number of a command; `2.0e-3` is one, and a sign may stand before it.
    fn figure(&self, tokens: &[Token<'a>]) -> Node {
        let text = plain(tokens).replace(' ', "");
        let digits = text.trim_start_matches(['+', '-']);
        let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
        let whole = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
        let numeric = mantissa.bytes().any(|b| b.is_ascii_digit())
            && mantissa.split('.').count() <= 2
            && mantissa.split('.').all(whole)
            && exponent.parse::<i32>().is_ok_and(|n| n.abs() <= 400)
            && digits.len() <= 60;
        if !numeric {
            return self.inside(tokens).whole();
        }
        let span = tokens
            .iter()
            .map(|t| t.span)
            .reduce(|a, b| a.to(b))
            .unwrap_or_default();
        let number = Node {
            kind: Kind::Number(super::product::read_number(digits)),
            span,
        };
        if text.starts_with('-') {
            return Node {
                kind: Kind::Negate(Box::new(number)),
                span,
            };
        }
        number
    }

    fn unit_argument(&mut self) -> String {
        let tokens = self.argument();
        let named = |t: &Token<'_>| matches!(t.kind, Lexeme::Command(name) if !matches!(name, "cdot" | "text" | "mathrm"));
        if tokens.iter().any(named) {
            spelled_out(tokens)
        } else {
            unit_text(tokens)
        }
    }

    /// A unit behind factors: `(0.012)(125.7)^2\,\text{N m}`, `\frac{a}{b}\,\si{N}`.
    pub(super) fn unit_behind(&mut self, factors: &mut [Factor]) {
        let before = self.at;
        self.skip_spaces();
        let text = match self.peek() {
            Some(Lexeme::Command("si" | "unit")) => {
                self.at += 1;
                self.unit_argument()
            }
            _ => {
                let mut probe = self.clone();
                let nothing = probe.node(Kind::Ellipsis, probe.at);
                // The factors are looked at only where a unit was met: there may be many.
                match probe.unit(nothing, before).kind {
                    Kind::WithUnit(_, text) if factors.iter().all(|f| in_numbers(&f.node)) => {
                        self.at = probe.at;
                        text
                    }
                    _ => String::new(),
                }
            }
        };
        let Some(last) = factors.last_mut().filter(|_| !text.is_empty()) else {
            self.at = before;
            return;
        };
        let empty = Node {
            kind: Kind::Ellipsis,
            span: Span::default(),
        };
        let inside = std::mem::replace(&mut last.node, empty);
        last.node = Node {
            span: inside.span,
            kind: Kind::WithUnit(Box::new(inside), text),
        };
    }
}

/// `\kilo\gram\metre\squared\per\second` as `kg m^2 /s`.
fn spelled_out(tokens: &[Token<'_>]) -> String {
    let mut out = String::new();
    let mut close = false;
    for token in tokens {
        match token.kind {
            Lexeme::Command("per") => out.push_str(" /"),
            Lexeme::Command("squared") => out.push_str("^2"),
            Lexeme::Command("cubed") => out.push_str("^3"),
            Lexeme::Command(name) => {
                let known = NAMES.iter().find(|(command, _)| *command == name);
                let Some((_, text)) = known else { continue };
                let spaced = !close && !out.is_empty() && !out.ends_with('/');
                out.push_str(if spaced { " " } else { "" });
                out.push_str(text);
                close = PREFIXES.contains(&name);
            }
            Lexeme::Char(c) | Lexeme::Letter(c) => out.push(c),
            Lexeme::Number(text) => out.push_str(text),
            Lexeme::Superscript => out.push('^'),
            _ => {}
        }
    }
    out
}

/// Whether nothing but numbers and π stands in a node.
fn in_numbers(node: &Node) -> bool {
    match &node.kind {
        Kind::Symbol(symbol) => symbol.name == "pi" && symbol.subscripts.is_empty(),
        Kind::Number(_) => true,
        Kind::WithUnit(..) | Kind::Ellipsis | Kind::Error(_) | Kind::Bold(_) => false,
        _ => node.children().all(in_numbers),
    }
}
