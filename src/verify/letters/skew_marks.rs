//! Marks of a document's own for the matrix of a cross product: `[\omega]` beside `[\omega] u = \omega \times u`, and
//! powers and transposes of a matrix function: `S(a)^T`, which a reader of formulas alone takes for `S\,(a)^T`.

use crate::notation::ast::{Bracket, Factor, Kind, Line, Node, Operator, Symbol};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::space_axes::turns_a_tensor;
use crate::verify::letters::usage::{Letter, Usage, inner, symbols};
use crate::verify::words::attitude_words::{rate_in_space, sentences};
use crate::verify::words::book::has_any;
use num_traits::Zero;
use std::collections::BTreeSet;

/// What a document shows of its marks.
#[derive(Default)]
struct Marks {
    /// Letters of vectors that stand in square brackets for their matrix.
    vectors: BTreeSet<Letter>,
    /// Symbols of functions that are matrices.
    functions: Vec<Symbol>,
    /// Whether brackets with an x under them are marks, for want of a small ×: `[a]_x b = a \times b`.
    crossed: bool,
    /// Matrices R of `dR/dt = [\omega] R`, whose vector stands on the axes that R leads to: lines with them are left as
    /// they are written.
    turning: Vec<Symbol>,
    /// Whether a hat makes a vector its matrix, as in `\hat a\,b = a \times b`.
    hat_map: bool,
    /// Letters that stand without the hat too, and so are no unit vectors.
    unhatted: BTreeSet<Letter>,
}

/// Reads the marks of a document and puts what they mean in their place.
pub(crate) fn note_skew_marks(document: &mut Document) {
    let mut marks = Marks::default();
    for row in document.items.iter().filter_map(rows).flatten() {
        if let Row::Line(line) = row {
            marks.look(line);
        }
    }
    let hats = has_any(&document.source.text, &[" hat", "\nhat", "Hat"]);
    if hats || !marks.turning.is_empty() {
        let said = sentences(document);
        // Where the words or the inertia put ω on those axes, the lines can be read.
        let in_space = said.iter().any(|s| rate_in_space(&s.text) == Some(true));
        if in_space || turns_a_tensor(document) {
            marks.turning.clear();
        }
        let matrix = ["matrix", "skew", "cross product"];
        let named = |text: &str| text.contains(" hat ") && has_any(text, &matrix);
        marks.hat_map |= said.iter().any(|s| named(&format!(" {}", s.text)));
    }
    if marks.hat_map {
        let usage = Usage::of(document);
        let plain = usage
            .letters()
            .filter(|(_, used)| used.bare > used.hats || used.vector > used.hatted);
        marks.unhatted = plain.map(|(letter, _)| letter.clone()).collect();
    }
    if !marks.vectors.is_empty() {
        let usage = Usage::of(document);
        let vectors = usage
            .letters()
            .filter(|(letter, _)| usage.is_vector(letter));
        marks
            .vectors
            .extend(vectors.map(|(letter, _)| letter.clone()));
    } else if marks.functions.is_empty() && !marks.crossed && !marks.hat_map {
        return;
    }
    for item in &mut document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &mut formula.rows {
            match row {
                Row::Line(line) => {
                    let mut met = line.sides.iter().flat_map(symbols);
                    if !met.any(|symbol| marks.turning.contains(symbol)) {
                        line.sides.iter_mut().for_each(|side| marks.put(side));
                    }
                }
                Row::Expression(node) => marks.put(node),
                Row::Unreadable { .. } => {}
            }
        }
    }
}

fn rows(item: &Item) -> Option<&[Row]> {
    match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    }
}

impl Marks {
    fn look(&mut self, line: &Line) {
        for pair in line.sides.windows(2) {
            for (left, right) in [(&pair[0], &pair[1]), (&pair[1], &pair[0])] {
                if let Some(vector) = bracketed(left).filter(|_| is_skew_matrix(right)) {
                    self.vectors.insert(Letter::of(vector));
                }
                if let Some(vector) = acts_as_cross(left, right, &bracketed) {
                    self.vectors.insert(Letter::of(vector));
                }
                self.crossed |=
                    acts_as_cross(left, right, &|node| under_x(node).and_then(lone)).is_some();
                self.turning.extend(turned_from_the_left(left, right));
                self.hat_map |= hat_acts(left, right)
                    || lone(left).is_some_and(|s| s.style.hat) && is_skew_matrix(right);
                if let Kind::Transpose(inside) = &left.kind
                    && let Kind::Negate(same) = &right.kind
                    && let (Some(vector), Some(again)) = (bracketed(inside), bracketed(same))
                    && vector == again
                {
                    self.vectors.insert(Letter::of(vector));
                }
                if let Kind::Call(head, _) = &left.kind
                    && let Kind::Symbol(symbol) = &head.kind
                    && is_square(right)
                {
                    self.functions.push(symbol.clone());
                }
            }
        }
    }

    fn put(&self, node: &mut Node) {
        if let Kind::Product(factors) = &mut node.kind {
            self.calls(factors);
            if let [only] = factors.as_slice() {
                *node = only.node.clone();
            }
        }
        if let Some(inside) = under_x(node).filter(|_| self.crossed) {
            node.kind = Kind::Skew(Box::new(inside.clone()));
        }
        if let Kind::Symbol(symbol) = &mut node.kind
            && self.hat_map
            && symbol.style.hat
            && self.unhatted.contains(&Letter::of(symbol))
        {
            symbol.style.hat = false;
            node.kind = Kind::Skew(Box::new(node.clone()));
            return;
        }
        let framed = matches!(node.kind, Kind::InFrame(..));
        if let Some(vector) = bracketed(node)
            && self.vectors.contains(&Letter::of(vector))
            && let Kind::Group(_, inside) = &node.kind
        {
            node.kind = Kind::Skew(inside.clone());
        }
        let children = node.children_mut().into_iter();
        children
            .filter(|child| !(framed && bracketed(child).is_some()))
            .for_each(|child| self.put(child));
    }

    /// Joins a matrix function to the bracket with a power behind it.
    fn calls(&self, factors: &mut Vec<Factor>) {
        let mut at = 0;
        while at + 1 < factors.len() {
            let head = factors[at].node.clone();
            let function = matches!(&head.kind, Kind::Symbol(s) if self.functions.contains(s));
            let beside = factors[at + 1].operator == Operator::Juxtaposed;
            if function && beside && call_under_power(&mut factors[at + 1].node, &head) {
                let joined = factors.remove(at + 1).node;
                factors[at].node = joined;
            }
            at += 1;
        }
    }
}

/// Makes the bracket under a power or a transpose the argument of a function.
fn call_under_power(node: &mut Node, head: &Node) -> bool {
    let (Kind::Power(base, _) | Kind::Transpose(base)) = &mut node.kind else {
        return false;
    };
    let Kind::Group(Bracket::Round, argument) = &base.kind else {
        return false;
    };
    base.kind = Kind::Call(Box::new(head.clone()), vec![(**argument).clone()]);
    base.span = head.span.to(base.span);
    node.span = head.span.to(node.span);
    true
}

/// The lone symbol in square brackets.
fn bracketed(node: &Node) -> Option<&Symbol> {
    match &node.kind {
        Kind::Group(Bracket::Square, inside) => {
            // Under a tilde a vector is its matrix already.
            lone(inside).filter(|symbol| !symbol.style.tilde)
        }
        _ => None,
    }
}

fn lone(node: &Node) -> Option<&Symbol> {
    match &node.kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

/// What stands in square brackets with an x under them.
fn under_x(node: &Node) -> Option<&Node> {
    match &node.kind {
        Kind::InFrame(group, label) if label.text.trim() == "x" => match &group.kind {
            Kind::Group(Bracket::Square, inside) => Some(inside),
            _ => None,
        },
        _ => None,
    }
}

/// The a of `[a] u = a × u`.
fn acts_as_cross<'n>(
    matrix: &'n Node,
    cross: &Node,
    vector_of: &impl Fn(&'n Node) -> Option<&'n Symbol>,
) -> Option<&'n Symbol> {
    let (Kind::Product(left), Kind::Product(right)) = (&matrix.kind, &cross.kind) else {
        return None;
    };
    let ([first, _], [vector, other]) = (left.as_slice(), right.as_slice()) else {
        return None;
    };
    let symbol = vector_of(&first.node)?;
    let same = matches!(&inner(&vector.node).kind, Kind::Symbol(s) if s == symbol);
    (same && other.operator == Operator::Cross).then_some(symbol)
}

/// Whether a line shows what a hat does: `\hat a\,b = a \times b`, or `\dot R = R\,\hat\omega`.
fn hat_acts(left: &Node, right: &Node) -> bool {
    let hatted = |node: &Node| lone(inner(node)).filter(|s| s.style.hat).cloned();
    let two = |node: &Node| match &node.kind {
        Kind::Product(factors) => <[Factor; 2]>::try_from(factors.clone()).ok(),
        _ => None,
    };
    let Some([matrix, vector]) = two(left) else {
        return false;
    };
    if let Kind::TimeDerivative { operand, .. } = &inner(right).kind {
        let own =
            |node: &Node| lone(node).is_some_and(|s| !s.style.hat) && lone(node) == lone(operand);
        let beside = vector.operator == Operator::Juxtaposed;
        return beside && own(&matrix.node) && hatted(&vector.node).is_some();
    }
    let Some(mut bare) = hatted(&matrix.node) else {
        return false;
    };
    bare.style.hat = false;
    two(right).is_some_and(|[first, second]| {
        second.operator == Operator::Cross && lone(inner(&first.node)) == Some(&bare)
    })
}

/// The R of `dR/dt = [a] R`.
fn turned_from_the_left(rate: &Node, product: &Node) -> Option<Symbol> {
    let (Kind::TimeDerivative { operand, .. }, Kind::Product(factors)) =
        (&inner(rate).kind, &product.kind)
    else {
        return None;
    };
    let [first, second] = factors.as_slice() else {
        return None;
    };
    let Kind::Symbol(matrix) = &inner(operand).kind else {
        return None;
    };
    let same = matches!(&inner(&second.node).kind, Kind::Symbol(s) if s == matrix);
    (same && bracketed(&first.node).is_some()).then(|| matrix.clone())
}

fn is_square(node: &Node) -> bool {
    matches!(&node.kind, Kind::Matrix(rows) if rows.len() == 3 && rows.iter().all(|row| row.len() == 3))
}

/// Whether a written matrix has a diagonal of zeros.
fn is_skew_matrix(node: &Node) -> bool {
    let zero = |node: &Node| matches!(&node.kind, Kind::Number(n) if n.value.is_zero());
    match &node.kind {
        Kind::Matrix(rows) if is_square(node) => {
            let mut diagonal = rows.iter().enumerate();
            diagonal.all(|(i, row)| row.get(i).is_some_and(zero))
        }
        _ => false,
    }
}

/// The matrix `R^T\dot R`, or `\dot R R^T`.
pub(crate) fn is_rate_of_turn(factors: &[Factor]) -> bool {
    let [first, second] = factors else {
        return false;
    };
    let turned = |node: &Node| match &inner(node).kind {
        Kind::Transpose(matrix) => lone(matrix).cloned(),
        _ => None,
    };
    let rate = |node: &Node| match &inner(node).kind {
        Kind::TimeDerivative {
            operand, order: 1, ..
        } => lone(operand).cloned(),
        _ => None,
    };
    let pair = |turned: Option<Symbol>, rate: Option<Symbol>| {
        turned
            .zip(rate)
            .is_some_and(|(turned, rate)| turned == rate && rate.name != "omega")
    };
    pair(turned(&first.node), rate(&second.node)) || pair(turned(&second.node), rate(&first.node))
}
