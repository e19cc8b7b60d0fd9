//! Subscripts, superscripts and primes, and what they mean on what they hang on.

use super::raised::{skew, tensor_square, vee, wrap};
use super::{Parser, text};
use crate::notation::ast::{Bracket, FrameLabel, Function, Kind, Node, Symbol};
use crate::notation::token::{Lexeme, Token};
use crate::source::Span;

/// A bracket with a prime: a rate, where a sentence says that a prime is one.
fn primed(bracket: Node, span: Span) -> Node {
    let label = FrameLabel {
        text: PRIME.into(),
        span,
    };
    super::frame_label::in_frame(super::letter::dotted(bracket, 1), label)
}

/// The label of a rate that is written with a prime.
const PRIME: &str = "\u{2032}";

/// Why a prime is not read.
pub(super) const PRIMED: &str =
    "a prime on what is no letter: give it a letter of its own, and prime that";

impl<'t, 'a> Parser<'t, 'a> {
    /// Reads the scripts that follow a factor.
    pub(super) fn scripts(&mut self, mut node: Node, start: usize) -> Node {
        // A bound keeps a chain of scripts from nesting the tree without end.
        for _ in 0..16 {
            if self.empty_base_closes() {
                self.at += 2;
            }
            match self.peek() {
                Some(Lexeme::Subscript | Lexeme::Superscript) if self.script_is_empty() => {
                    self.at += 1;
                    return self
                        .error("an index or a power without braces around what belongs to it");
                }
                Some(Lexeme::Subscript) => {
                    self.at += 1;
                    let tokens = self.argument();
                    node = self.subscript(node, tokens);
                }
                // `x'{}^2`: an empty group keeps a script apart from what is before it.
                Some(Lexeme::Open) if self.empty_group_leads_a_script() => self.at += 2,
                Some(Lexeme::Superscript)
                    if self.script_leads_a_matrix()
                        || matches!(node.kind, Kind::Number(_)) && self.frame_leads_a_letter() =>
                {
                    break;
                }
                Some(Lexeme::Superscript) => {
                    self.at += 1;
                    let tokens = self.argument();
                    node = self.superscript(node, tokens);
                }
                Some(Lexeme::Command("degree" | "textdegree")) => {
                    self.at += 1;
                    node = wrap(node, |number| Kind::WithUnit(number, "deg".into()));
                }
                // `(I\omega)\dot{}`: dots over nothing stand behind what they are the rate of.
                Some(Lexeme::Command(dots @ ("dot" | "ddot"))) if self.empty_group_follows() => {
                    self.at += 3;
                    node = super::letter::dotted(node, if dots == "dot" { 1 } else { 2 });
                }
                // `\vec r\,'`: a thin space keeps a prime off an arrow.
                Some(Lexeme::Space(_)) if self.space_leads_a_prime() => self.at += 1,
                Some(Lexeme::Char('\'')) => {
                    self.at += 1;
                    let bracket = matches!(node.kind, Kind::Group(..));
                    match symbol_of(&mut node) {
                        Some(symbol) => symbol.primes = symbol.primes.saturating_add(1),
                        None if bracket => node = primed(node, self.since(start)),
                        None => return self.error(PRIMED),
                    }
                }
                _ => break,
            }
            node.span = self.since(start);
        }
        node
    }

    fn empty_group_follows(&self) -> bool {
        self.peek_at(1) == Some(Lexeme::Open) && self.peek_at(2) == Some(Lexeme::Close)
    }

    fn space_leads_a_prime(&self) -> bool {
        let next = self.tokens.get(self.at + 1);
        next.is_some_and(|t| !t.spaced && t.kind == Lexeme::Char('\''))
    }

    fn empty_group_leads_a_script(&self) -> bool {
        let kind = |i: usize| self.tokens.get(self.at + i).map(|t| t.kind);
        let script = matches!(kind(2), Some(Lexeme::Subscript | Lexeme::Superscript));
        let near = self.tokens.get(self.at).is_some_and(|t| !t.spaced);
        near && script && kind(1) == Some(Lexeme::Close)
    }

    /// Whether a frame stands apart from what is before it and right before a matrix: it belongs to that.
    pub(super) fn script_leads_a_matrix(&self) -> bool {
        let apart = self.tokens.get(self.at).is_some_and(|t| t.spaced);
        if !apart || self.peek() != Some(Lexeme::Superscript) {
            return false;
        }
        let mut probe = self.clone();
        probe.at += 1;
        let label = text::plain(probe.argument());
        let frame =
            label.chars().all(char::is_alphabetic) && !matches!(label.as_str(), "T" | "top");
        probe.skip_spaces();
        frame && matches!(probe.peek(), Some(Lexeme::Begin(_)))
    }

    /// Whether a frame stands apart from a number and right before a letter, `2 ^N\omega`: it belongs to that.
    pub(super) fn frame_leads_a_letter(&self) -> bool {
        let apart = self.tokens.get(self.at).is_some_and(|t| t.spaced);
        let before = self.at.checked_sub(1).map(|at| self.tokens[at].kind);
        if !apart || !matches!(before, Some(Lexeme::Number(_))) {
            return false;
        }
        let mut probe = self.clone();
        probe.at += 1;
        let label = text::plain(probe.argument());
        let mut letters = label.chars();
        let frame =
            letters.next().is_some_and(|c| c.is_ascii_uppercase()) && letters.next().is_none();
        probe.skip_spaces();
        frame && matches!(probe.peek(), Some(Lexeme::Command(_) | Lexeme::Letter(_)))
    }

    fn script_is_empty(&self) -> bool {
        match self.peek_at(1) {
            None | Some(Lexeme::Subscript | Lexeme::Superscript | Lexeme::Close) => true,
            // TeX raises the minus alone in `x^-1`, which nobody means.
            Some(Lexeme::Char('-')) => matches!(self.tokens.get(self.at + 2),
                Some(t) if !t.spaced && matches!(t.kind, Lexeme::Number(_))),
            Some(Lexeme::Char(c)) => matches!(c, '=' | '<' | '>' | ')' | ']' | '}' | ','),
            _ => false,
        }
    }

    /// The argument of a script as a label of a frame.
    pub(super) fn frame_label(&mut self) -> FrameLabel {
        let from = self.at;
        let tokens = self.argument();
        FrameLabel {
            text: text::plain(tokens),
            span: self.since(from),
        }
    }

    fn subscript(&mut self, mut node: Node, tokens: &'t [Token<'a>]) -> Node {
        if matches!(tokens, [t] if matches!(t.kind, Lexeme::Command("times" | "wedge"))) {
            return skew(node);
        }
        // `\dot{\vec H}_{xyz}`: the axes under a dot are those that the rate is seen from.
        let seen = is_rate_of_vector(&node) && is_frame(&text::plain(tokens));
        if let Some(symbol) = indexed(&mut node).filter(|_| !seen) {
            let parts = match member_and_axis(tokens) {
                Some(parts) => parts,
                None => super::split_outside(tokens, |t| t.kind == Lexeme::Char(',')),
            };
            symbol
                .subscripts
                .extend(parts.into_iter().map(text::plain).filter(|s| !s.is_empty()));
            return node;
        }
        let span = tokens
            .iter()
            .map(|t| t.span)
            .reduce(|a, b| a.to(b))
            .unwrap_or(node.span);
        super::frame_label::in_frame(
            node,
            FrameLabel {
                text: text::plain(tokens),
                span,
            },
        )
    }

    pub(super) fn superscript(&mut self, mut node: Node, tokens: &'t [Token<'a>]) -> Node {
        let kinds: Vec<Lexeme<'a>> = tokens
            .iter()
            .map(|t| t.kind)
            .filter(|kind| !matches!(kind, Lexeme::Space(_)))
            .collect();
        match kinds.as_slice() {
            [Lexeme::Superscript | Lexeme::Command("prime"), _, ..] => {
                return self.raised_on_more(node, tokens);
            }
            [Lexeme::Command("times" | "wedge")] => return skew(node),
            [Lexeme::Command("vee")] => return vee(node),
            [Lexeme::Command("otimes"), Lexeme::Number("2")] => return tensor_square(node),
            [Lexeme::Command("prime")] => {
                match symbol_of(&mut node) {
                    Some(symbol) => symbol.primes = symbol.primes.saturating_add(1),
                    None => return self.error(PRIMED),
                }
                return node;
            }
            [Lexeme::Command("circ")] => {
                let span = node.span;
                return Node {
                    kind: Kind::WithUnit(Box::new(node), "deg".into()),
                    span,
                };
            }
            _ => {}
        }
        if is_transpose(&kinds) && !is_plain_number(&node) {
            return wrap(node, Kind::Transpose);
        }
        if let [Lexeme::Char('-'), rest @ ..] = kinds.as_slice()
            && is_transpose(rest)
        {
            let inverse = self.inside(&[]).power_minus_one(node);
            return wrap(inverse, Kind::Transpose);
        }
        if let Some(symbol) = symbol_of(&mut node)
            && (is_label(&kinds) || is_label_of_vector(symbol, &kinds))
        {
            symbol.superscripts.push(text::plain(tokens));
            return node;
        }
        let exponent = self.inside(tokens).whole();
        let span = node.span.to(exponent.span);
        let kind = match node.kind {
            Kind::Symbol(ref symbol) if is_e(symbol) => {
                Kind::Function(Function::Exp, Box::new(exponent))
            }
            _ => Kind::Power(Box::new(node), Box::new(exponent)),
        };
        Node { kind, span }
    }

    fn power_minus_one(&self, node: Node) -> Node {
        let span = node.span;
        let one = super::product::read_number("1");
        let minus = Node {
            kind: Kind::Negate(Box::new(Node {
                kind: Kind::Number(one),
                span,
            })),
            span,
        };
        Node {
            kind: Kind::Power(Box::new(node), Box::new(minus)),
            span,
        }
    }
}

/// `x_{\alpha i}`: a Greek letter that counts members, and one that numbers axes.
fn member_and_axis<'t, 'a>(tokens: &'t [Token<'a>]) -> Option<Vec<&'t [Token<'a>]>> {
    let first = tokens
        .iter()
        .position(|t| !matches!(t.kind, Lexeme::Space(_)))?;
    let rest = tokens.get(first + 1..)?;
    let behind = |t: &&Token<'_>| !matches!(t.kind, Lexeme::Space(_));
    let mut letters = rest.iter().filter(behind);
    let axis = matches!(letters.next()?.kind, Lexeme::Letter('i'..='n'));
    let member =
        matches!(tokens[first].kind, Lexeme::Command(c) if super::letter::greek(c).is_some());
    let both = member && axis && letters.next().is_none();
    both.then(|| vec![&tokens[first..=first], rest])
}

/// The symbol that a subscript hangs on; `\omega^2_x` is the square of ω_x, and `A^T_B` is A_B transposed.
fn indexed(node: &mut Node) -> Option<&mut Symbol> {
    if !matches!(node.kind, Kind::Power(..) | Kind::Transpose(_)) {
        return symbol_of(node);
    }
    match &mut node.kind {
        Kind::Power(base, _) | Kind::Transpose(base) => {
            symbol_of(base).filter(|symbol| symbol.subscripts.is_empty())
        }
        _ => None,
    }
}

/// Whether a node is the rate of a vector that has no index.
fn is_rate_of_vector(node: &Node) -> bool {
    match &node.kind {
        Kind::TimeDerivative {
            operand,
            frame: None,
            ..
        } => {
            matches!(&operand.kind, Kind::Symbol(s) if (s.style.vector || s.style.bar) && s.subscripts.is_empty())
        }
        _ => false,
    }
}

/// Whether a label is the three axes of a frame.
fn is_frame(label: &str) -> bool {
    matches!(label, "xyz" | "XYZ" | "Oxyz" | "OXYZ" | "Gxyz" | "x'y'z'")
}

fn is_e(symbol: &Symbol) -> bool {
    *symbol
        == Symbol {
            name: "e".into(),
            ..Symbol::default()
        }
        || (symbol.name == "e" && symbol.style.upright && symbol.subscripts.is_empty())
}

fn is_plain_number(node: &Node) -> bool {
    matches!(node.kind, Kind::Number(_))
}

fn is_transpose(kinds: &[Lexeme<'_>]) -> bool {
    let sole = |k: &Lexeme<'_>| {
        matches!(
            k,
            Lexeme::Letter('T') | Lexeme::Command("top" | "intercal") | Lexeme::Text("T" | "t")
        )
    };
    match kinds {
        [one] => sole(one),
        [
            Lexeme::Command("mathsf" | "mathrm" | "rm" | "sf" | "mathit" | "mathtt"),
            rest @ ..,
        ] => {
            matches!(
                rest,
                [Lexeme::Letter('T' | 't')]
                    | [Lexeme::Open, Lexeme::Letter('T' | 't'), Lexeme::Close]
            )
        }
        _ => false,
    }
}

/// A vector has no power but its square: letters above it are a label.
fn is_label_of_vector(symbol: &Symbol, kinds: &[Lexeme<'_>]) -> bool {
    let letter = |k: &Lexeme<'_>| matches!(k, Lexeme::Letter(_));
    symbol.style.vector && !kinds.is_empty() && kinds.iter().all(letter)
}

/// Superscripts that name a point, a frame or an instant, and are no powers.
fn is_label(kinds: &[Lexeme<'_>]) -> bool {
    match kinds {
        [Lexeme::Char('(' | '['), .., Lexeme::Char(')' | ']')] => true,
        [Lexeme::Char('*') | Lexeme::Command("ast" | "star" | "dagger" | "circledast")] => true,
        [Lexeme::Letter(c)] => c.is_ascii_uppercase(),
        [Lexeme::Text(_)] => true,
        [Lexeme::Command(font), ..] if is_font(font) => {
            !kinds.iter().any(|k| matches!(k, Lexeme::Number(_))) && is_set_in_fonts(kinds)
        }
        [Lexeme::Char('+' | '-')] => true,
        // `\vec r^{\cdot a}`: the rate seen from a.
        [Lexeme::Command("cdot" | "bullet"), Lexeme::Letter(_)] => true,
        [Lexeme::Letter(a), Lexeme::Char('/'), Lexeme::Letter(b)] => {
            a.is_ascii_uppercase() && b.is_ascii_uppercase()
        }
        [Lexeme::Letter(a), Lexeme::Letter(b)] => a.is_ascii_uppercase() && b.is_ascii_uppercase(),
        _ => false,
    }
}

fn is_font(command: &str) -> bool {
    matches!(
        command,
        "mathcal" | "mathrm" | "mathscr" | "mathsf" | "mathbf" | "rm"
    )
}

/// Whether every letter stands in a group with a font of its own, as in `\mathcal{B}/\mathcal{N}`: the exponent
/// `\mathrm{i}\lambda t` begins with such a group.
fn is_set_in_fonts(kinds: &[Lexeme<'_>]) -> bool {
    let mut rest = kinds;
    while let [first, behind @ ..] = rest {
        rest = match (first, behind) {
            (Lexeme::Command("rm"), _) => return true,
            (Lexeme::Command(font), [Lexeme::Open, inside @ ..]) if is_font(font) => {
                let end = inside.iter().position(|k| *k == Lexeme::Close);
                &inside[end.map_or(inside.len(), |at| at + 1)..]
            }
            (Lexeme::Command(font), [_, behind @ ..]) if is_font(font) => behind,
            (Lexeme::Letter(_) | Lexeme::Command(_), _) => return false,
            _ => behind,
        };
    }
    true
}

/// The symbol that a script hangs on: that under dots, or in the bracket of a skew mark.
pub(crate) fn symbol_of(node: &mut Node) -> Option<&mut Symbol> {
    match &mut node.kind {
        Kind::Symbol(symbol) => Some(symbol),
        Kind::TimeDerivative {
            operand,
            frame: None,
            style: crate::notation::ast::DerivativeStyle::Dots,
            ..
        } => symbol_of(operand),
        Kind::Skew(operand) => symbol_of(operand),
        _ => None,
    }
}

impl Parser<'_, '_> {
    /// What a bracket holds, as a node of its kind.
    pub(super) fn grouped(&self, bracket: Bracket, inner: Node, start: usize) -> Node {
        self.node(Kind::Group(bracket, Box::new(inner)), start)
    }
}
