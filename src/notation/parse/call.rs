//! A symbol with a bracket behind it: `R(t)`, `F(\omega)`, `m(a+b)`.

use super::derivative::mark;
use super::{Parser, split_outside};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::token::Lexeme;
use crate::source::Span;

impl Parser<'_, '_> {
    /// `m(a+b)`, `R(t)`: the reader can't tell a product from a call, so it says that a list stands there. A power
    /// behind the bracket shows that it is a factor of its own.
    pub(super) fn call(&mut self, head: Node, start: usize) -> Node {
        if self.peek() != Some(Lexeme::Char('(')) || self.is_element(&head, start) {
            return head;
        }
        let Some((from, to)) = self.bracket_inside() else {
            return head;
        };
        let after = self.tokens.get(to + 1).map(|t| t.kind);
        let inside = &self.tokens[from..to];
        let of_time =
            matches!(inside, [t] if matches!(t.kind, Lexeme::Letter('t') | Lexeme::Number("0")));
        let parts = split_outside(inside, |t| t.kind == Lexeme::Char(','));
        // Nor is anything multiplied by a list: `\dot\omega(\omega_k, \tau_k)`.
        let rate = matches!(&head.kind, Kind::TimeDerivative { operand, .. } if matches!(operand.kind, Kind::Symbol(_)));
        let of_list = rate && parts.len() > 1;
        let callable = matches!(head.kind, Kind::Symbol(_)) || of_time || of_list;
        if !callable || inside.is_empty() {
            return head;
        }
        let arguments: Vec<Node> = parts
            .into_iter()
            .map(|part| self.inside(part).whole())
            .collect();
        // Of two vectors side by side no power is taken, so the `\mathbf S(\mathbf a)^T` is one of a matrix S(a).
        let vector = |node: &Node| matches!(&node.kind, Kind::Symbol(s) if s.style.vector);
        let of_vector = vector(&head) && matches!(arguments.as_slice(), [one] if vector(one));
        let scripted = matches!(after, Some(Lexeme::Superscript | Lexeme::Subscript));
        // Nor is a number transposed, and `J(\omega)^{-1}` is the inverse of a matrix that depends on ω.
        let of_state = may_be_matrix(&head)
            && matches!(arguments.as_slice(), [one] if matches!(one.kind, Kind::Symbol(_)));
        if scripted && !of_vector && !of_state {
            return head;
        }
        let before = self.at;
        self.at = to + 1;
        let node = called(head.clone(), arguments, self.since(start));
        let node = self.scripts(node, start);
        let power = matches!(&head.kind, Kind::Symbol(s) if is_greek_capital(s));
        if scripted && !of_vector && !power && !is_turned_or_inverted(&node) {
            self.at = before;
            return head;
        }
        node
    }
}

impl Parser<'_, '_> {
    /// The m of `dm(a + b)`: the mass of an element is no function.
    fn is_element(&self, head: &Node, start: usize) -> bool {
        let of_body =
            matches!(&head.kind, Kind::Symbol(s) if ["m", "M", "V"].contains(&s.name.as_str()));
        let behind = |length: usize| {
            let before = start
                .checked_sub(length)
                .and_then(|at| self.tokens.get(at..));
            before.and_then(mark) == Some((length, false))
        };
        of_body && (1..=LONGEST_MARK).any(behind)
    }
}

/// The d of an element takes no more tokens.
const LONGEST_MARK: usize = 6;

/// The Ω of `\Omega(\omega)^2`, which is a matrix.
fn is_greek_capital(symbol: &Symbol) -> bool {
    symbol.name.len() > 1 && symbol.name.starts_with(|c: char| c.is_ascii_uppercase())
}

/// Whether a symbol is a capital, Latin or Greek, without any mark or index.
fn may_be_matrix(node: &Node) -> bool {
    matches!(&node.kind, Kind::Symbol(s) if s.subscripts.is_empty() && (is_greek_capital(s) || s.name.chars().all(|c| c.is_ascii_uppercase())))
}

/// Whether a call is transposed or inverted.
fn is_turned_or_inverted(node: &Node) -> bool {
    match &node.kind {
        Kind::Transpose(inside) => matches!(inside.kind, Kind::Call(..)),
        Kind::Power(base, exponent) => {
            matches!(base.kind, Kind::Call(..)) && exponent.is_minus_one()
        }
        _ => false,
    }
}

/// A call of the innermost symbol: `\dot\theta(t)` is the rate of θ(t).
fn called(head: Node, arguments: Vec<Node>, span: Span) -> Node {
    let kind = match head.kind {
        Kind::TimeDerivative {
            operand,
            order,
            style,
            frame,
        } if arguments.len() == 1 => Kind::TimeDerivative {
            operand: Box::new(called(*operand, arguments, span)),
            order,
            style,
            frame,
        },
        _ => Kind::Call(Box::new(head), arguments),
    };
    Node { kind, span }
}
