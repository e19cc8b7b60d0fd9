//! Products, quotients with a slash, and numbers with a power of ten.

use super::{Parser, bracket_end};
use crate::notation::ast::{Factor, Kind, Node, Number, Operator};
use crate::notation::token::Lexeme;
use crate::source::Span;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// More digits than this are no number that anybody wrote.
const LONGEST_NUMBER: usize = 400;

impl Parser<'_, '_> {
    /// Factors from left to right.
    pub(super) fn product(&mut self) -> Node {
        let start = self.at;
        let mut factors: Vec<Factor> = vec![];
        let mut operator = Operator::Juxtaposed;
        let mut sign = Span {
            start: self.here().start,
            end: self.here().start,
        };
        loop {
            self.skip_spaces();
            let before = self.at;
            let node = self.signed_factor(operator, &factors);
            let unsigned = operator == Operator::Juxtaposed && sign.start == sign.end;
            let node = match unsigned {
                true => beside_number(node, factors.last()),
                false => node,
            };
            // Where something was read, the rest can be too.
            let broken = matches!(node.kind, Kind::Error(_)) && self.at == before;
            factors.push(Factor {
                operator,
                sign,
                node,
            });
            if broken {
                break;
            }
            self.slashes(&mut factors);
            self.bars(&mut factors);
            self.unit_behind(&mut factors);
            self.skip_spaces();
            self.cross_behind(&mut factors);
            match self.operator() {
                Some((next, span)) => (operator, sign) = (next, span),
                None if self.factor_starts() => {
                    operator = Operator::Juxtaposed;
                    sign = Span {
                        start: self.here().start,
                        end: self.here().start,
                    };
                }
                None => break,
            }
        }
        if factors.len() == 1
            && let Some(only) = factors.pop()
        {
            return only.node;
        }
        self.node(Kind::Product(factors), start)
    }

    /// `\omega\times` with nothing behind it to be crossed with is the matrix that multiplies by ω ×.
    fn cross_behind(&mut self, factors: &mut [Factor]) {
        if self.peek() != Some(Lexeme::Command("times")) {
            return;
        }
        let mut behind = self.tokens[self.at..].iter().skip(1).map(|t| t.kind);
        let next = behind.find(|kind| !matches!(kind, Lexeme::Space(_)));
        if !matches!(next, None | Some(Lexeme::Char('+' | '='))) {
            return;
        }
        // `\omega\times\omega\times`: so is each that is crossed with it.
        let crossed = factors.iter().rev();
        let crossed = crossed
            .take_while(|f| f.operator == Operator::Cross)
            .count();
        let first = factors.len().saturating_sub(crossed + 1);
        for factor in &mut factors[first..] {
            let vector = std::mem::replace(&mut factor.node, self.error(""));
            factor.node = super::raised::wrap(vector, Kind::Skew);
            factor.operator = Operator::Juxtaposed;
        }
        self.at += 1;
        self.skip_spaces();
    }

    /// A factor; after an operator a sign may stand before it.
    fn signed_factor(&mut self, operator: Operator, before: &[Factor]) -> Node {
        let start = self.at;
        if operator != Operator::Juxtaposed && !before.is_empty() && self.take(Lexeme::Char('-')) {
            let node = self.factor();
            return self.node(Kind::Negate(Box::new(node)), start);
        }
        self.factor()
    }

    fn operator(&mut self) -> Option<(Operator, Span)> {
        let operator = match self.peek()? {
            Lexeme::Command("times" | "wedge" | "cross" | "land") => Operator::Cross,
            Lexeme::Command("cdot" | "bullet" | "vdot") => Operator::Dot,
            Lexeme::Command("otimes" | "circ" | "odot") => Operator::Tensor,
            Lexeme::Char('*') | Lexeme::Command("ast") => Operator::Juxtaposed,
            Lexeme::Char('.') if self.point_joins() => Operator::Dot,
            _ => return None,
        };
        let span = self.here();
        self.at += 1;
        Some((operator, span))
    }

    /// `\vec a.\vec b`, `\vec a.(\vec b+\vec c)`: whether a full stop stands close between what is no number and a marked
    /// letter, or one in parentheses.
    fn point_joins(&self) -> bool {
        let kind = |at: usize| self.tokens.get(at).map(|token| token.kind);
        let before = self.at.checked_sub(1).and_then(kind);
        let number = matches!(before, None | Some(Lexeme::Number(_) | Lexeme::Space(_)));
        let next = kind(self.at + 1);
        let next = match next {
            Some(Lexeme::Char('(')) => kind(self.at + 2),
            next => next,
        };
        !number && matches!(next, Some(Lexeme::Command(name)) if self.command_starts_factor(name))
    }

    pub(super) fn factor_starts(&self) -> bool {
        match self.peek() {
            Some(Lexeme::Command(name)) => self.command_starts_factor(name),
            Some(Lexeme::Char(c)) => {
                matches!(c, '(' | '[' | '{' | '⟨' | '⌊' | '‖' | '|') && self.bar_opens(c)
            }
            Some(
                Lexeme::Letter(_)
                | Lexeme::Number(_)
                | Lexeme::Open
                | Lexeme::LeftBar
                | Lexeme::LeftNull
                | Lexeme::Begin(_),
            ) => true,
            // Behind a space that is written, a script belongs to what follows: `R\,^{W}I`.
            Some(Lexeme::Superscript) => {
                let space = |at: usize| matches!(self.tokens[at].kind, Lexeme::Space(_));
                let leads = self.script_leads_a_matrix() || self.frame_leads_a_letter();
                self.at > 0 && (space(self.at - 1) || leads)
            }
            Some(Lexeme::Text(text)) => {
                super::text::is_symbol(text) || super::function::named(text.trim()).is_some()
            }
            _ => false,
        }
    }

    /// A bar inside a norm closes it; elsewhere one opens.
    fn bar_opens(&self, c: char) -> bool {
        !matches!(c, '|' | '‖')
            || self.tokens[self.at + 1..]
                .iter()
                .any(|t| t.kind == Lexeme::Char(c))
    }

    /// `a/b`: the factor before the slash over what is written close behind it.
    fn slashes(&mut self, factors: &mut Vec<Factor>) {
        // Each slash is a level of the tree.
        for _ in 0..16 {
            if !self.take(Lexeme::Char('/')) {
                return;
            }
            let Some(last) = factors.pop() else { return };
            self.skip_spaces();
            let below = self.denominator(matches!(last.node.kind, Kind::Number(_)));
            let span = last.node.span.to(below.span);
            factors.push(Factor {
                node: Node {
                    kind: Kind::Quotient(Box::new(last.node), Box::new(below)),
                    span,
                },
                ..last
            });
        }
    }

    /// In `1/2mv^2` the 2 alone stands below; in `H^2/2I` the whole `2I` does.
    fn denominator(&mut self, number_above: bool) -> Node {
        let start = self.at;
        let first = self.factor();
        if number_above || !matches!(first.kind, Kind::Number(_)) {
            return first;
        }
        let mut factors = vec![first];
        while self.factor_starts() && !self.tokens[self.at].spaced {
            factors.push(self.factor());
        }
        let here = |node: &Node| Span {
            start: node.span.start,
            end: node.span.start,
        };
        match <[Node; 1]>::try_from(factors) {
            Ok([only]) => only,
            Err(factors) => {
                let factors = factors.into_iter().map(|node| Factor {
                    operator: Operator::Juxtaposed,
                    sign: here(&node),
                    node,
                });
                self.node(Kind::Product(factors.collect()), start)
            }
        }
    }

    /// A bar with a subscript behind a factor names the frame: `\frac{dL}{dt}|_{B}`.
    fn bars(&mut self, factors: &mut [Factor]) {
        let bar = matches!(self.peek(), Some(Lexeme::Char('|') | Lexeme::RightBar));
        if !bar || self.peek_at(1) != Some(Lexeme::Subscript) {
            return;
        }
        self.at += 2;
        let label = self.frame_label();
        if let Some(last) = factors.last_mut() {
            let node = std::mem::replace(&mut last.node, self.error(""));
            last.node = super::frame_label::in_frame(node, label);
        }
    }

    /// A number, together with a power of ten written behind it.
    pub(super) fn number(&mut self, digits: &str) -> Node {
        let start = self.at;
        self.at += 1;
        if digits.len() > LONGEST_NUMBER {
            self.at -= 1;
            let node = self.error("a number with too many digits");
            self.at += 1;
            return node;
        }
        let Some(digits) = super::number::joined(digits) else {
            self.at -= 1;
            let message = "a comma that may part thousands or decimals; 1000 and 1.000 are clear";
            let node = self.error(message);
            self.at += 1;
            return node;
        };
        let mut number = read_number(&digits);
        if let Some((exponent, tokens)) = self.power_of_ten() {
            self.at += tokens;
            number.exponent += exponent;
            number.value *= BigRational::from_integer(10.into()).pow(exponent);
        }
        self.node(Kind::Number(number), start)
    }

    /// `\times 10^{-5}` ahead: the exponent and how many tokens it takes.
    fn power_of_ten(&self) -> Option<(i32, usize)> {
        let mut i = self.at;
        let kind = |i: usize| self.tokens.get(i).map(|t| t.kind);
        while matches!(kind(i), Some(Lexeme::Space(_))) {
            i += 1;
        }
        if !matches!(kind(i), Some(Lexeme::Command("times" | "cdot"))) {
            return None;
        }
        i += 1;
        while matches!(kind(i), Some(Lexeme::Space(_))) {
            i += 1;
        }
        if kind(i) != Some(Lexeme::Number("10")) || kind(i + 1) != Some(Lexeme::Superscript) {
            return None;
        }
        let grouped = kind(i + 2) == Some(Lexeme::Open);
        let mut at = i + 2 + usize::from(grouped);
        let negative = kind(at) == Some(Lexeme::Char('-'));
        at += usize::from(negative);
        let Some(Lexeme::Number(digits)) = kind(at) else {
            return None;
        };
        if grouped && kind(at + 1) != Some(Lexeme::Close) {
            return None;
        }
        let exponent: i32 = digits.parse().ok().filter(|n| *n <= 400)?;
        let sign = if negative { -1 } else { 1 };
        Some((sign * exponent, at + 1 + usize::from(grouped) - self.at))
    }

    /// The range of a bracket that opens here, as indices of its inside.
    pub(super) fn bracket_inside(&self) -> Option<(usize, usize)> {
        bracket_end(self.tokens, self.at).map(|end| (self.at + 1, end))
    }
}

/// Digits beside digits are no product: `1 0` and `2 .5` are slips, or numbers in groups that are not read.
fn beside_number(node: Node, before: Option<&Factor>) -> Node {
    let number = |node: &Node| match &node.kind {
        Kind::WithUnit(inner, _) | Kind::Power(inner, _) => matches!(inner.kind, Kind::Number(_)),
        kind => matches!(kind, Kind::Number(_)),
    };
    let beside = before.is_some_and(|f| matches!(f.node.kind, Kind::Number(_)));
    if beside && number(&node) {
        let message = "two numbers stand side by side, which may be one number or a product";
        return Node {
            kind: Kind::Error(message.into()),
            span: node.span,
        };
    }
    node
}

/// A decimal number as an exact one; `digits` is what the lexer takes for a number.
pub(super) fn read_number(digits: &str) -> Number {
    if let Ok(value) = digits.parse::<u64>() {
        return Number {
            value: BigRational::from_integer(value.into()),
            decimals: None,
            exponent: 0,
        };
    }
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{part}");
    let value = all.parse::<BigInt>().unwrap_or_else(|_| BigInt::zero());
    let decimals = u32::try_from(part.len()).unwrap_or(0);
    let scale = BigInt::from(10).pow(decimals);
    let power = BigRational::new(BigInt::from(10), BigInt::one()).pow(exponent.clamp(-9999, 9999));
    Number {
        value: BigRational::new(value, scale) * power,
        decimals: mantissa.contains('.').then_some(decimals),
        exponent,
    }
}
