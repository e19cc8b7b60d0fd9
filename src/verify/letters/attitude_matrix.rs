//! Which letter of a document is its attitude matrix.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::attitude_reading::AttitudeReading;
use crate::verify::letters::usage::{Letter, axis, inner, symbols, undotted};
use crate::verify::words::attitude_words::{Sentence, way};
use crate::verify::words::book::has_any;
use std::collections::BTreeSet;

/// Letters that an attitude matrix has.
pub(crate) const MATRIX_LETTERS: &[&str] = &["R", "A", "C", "Q", "D", "T", "S", "B", "Lambda"];
/// Words that name an attitude matrix.
const MATRIX_WORDS: &[&str] = &[
    "rotation matrix",
    "attitude matrix",
    "orientation matrix",
    "direction cosine",
    "direction-cosine",
    "orthogonal matrix",
    "matrix of rotation",
    "rotation tensor",
];
impl AttitudeReading {
    /// Takes the letter that the words name so, or that stands as such a matrix does, and that is made of nothing else.
    pub(crate) fn find_matrix(
        &mut self,
        document: &Document,
        said: &[Sentence],
        taken: &impl Fn(&Letter) -> bool,
    ) {
        let stems = [
            "rotat",
            "attitude",
            "orientation",
            "orthogonal",
            "direction cosin",
        ];
        let about_turning = said.iter().any(|s| has_any(&s.text, &stems));
        let mut found: Vec<Letter> = vec![];
        let mut made: BTreeSet<Letter> = BTreeSet::new();
        for line in document.lines() {
            // What turned things before it is written out is written out for an example.
            if let [left, rest @ ..] = line.sides.as_slice()
                && let Kind::Symbol(symbol) = &inner(left).kind
                && rest.iter().any(|side| self.makes_matrix(side))
                && !found.contains(&Letter::of(symbol))
            {
                made.insert(Letter::of(symbol));
            }
            found.extend(turned_by_rate(&line.sides));
            found.extend(turning_to_label(&line.sides));
            if about_turning {
                line.sides.iter().for_each(|side| turns(side, &mut found));
            }
        }
        // "The matrix ⟨R⟩ turns components on the body axes into components on the fixed axes."
        let goes = |text: &str| text.contains("matrix ⟨") && way(text).is_some();
        let spoken = said
            .iter()
            .filter(|s| has_any(&s.text, MATRIX_WORDS) || goes(&s.text) || changes_axes(&s.text));
        found.extend(
            spoken
                .flat_map(|s| &s.letters)
                .map(|name| Letter::plain(name)),
        );
        let fit = |letter: &&Letter| {
            let usual = MATRIX_LETTERS.contains(&letter.name.as_str());
            usual && !taken(letter) && !made.contains(letter)
        };
        self.matrix = found.iter().find(fit).cloned();
    }

    /// Whether a side is a matrix that is written out, or a product of others, without the quaternion in it.
    fn makes_matrix(&self, side: &Node) -> bool {
        let of_quaternion = symbols(side).into_iter().any(|s| self.part(s).is_some());
        let written = match &inner(side).kind {
            Kind::Matrix(rows) => rows.len() > 1 && rows.iter().all(|row| row.len() > 1),
            Kind::Product(factors) => factors.iter().all(|f| {
                matches!(f.node.kind, Kind::Call(..) | Kind::Matrix(_))
                    || matches!(&f.node.kind, Kind::Symbol(s) if !s.subscripts.is_empty())
            }),
            Kind::Sum(_) => holds_function(side),
            _ => false,
        };
        written && !of_quaternion
    }
}

/// "⟨R⟩ takes components on the old axes to components on the new axes."
fn changes_axes(sentence: &str) -> bool {
    let takes = [
        "take",
        "takes",
        "carry",
        "carries",
        "convert",
        "converts",
        "transform",
        "transforms",
        "map",
        "maps",
    ];
    let mut behind = sentence.split('⟩').skip(1);
    behind.any(|text| {
        let mut words = text.split_whitespace();
        let takes = words.next().is_some_and(|word| takes.contains(&word));
        let mut parts = words.filter(|word| !matches!(*word, "the" | "vector" | "a" | "any"));
        let parts = parts.next();
        let of_vector = |word: &str| {
            ["component", "coordinate"]
                .iter()
                .any(|w| word.starts_with(w))
        };
        takes && parts.is_some_and(of_vector) && has_any(text, &["axes", "frame", "basis"])
    })
}

/// The matrix of `\dot{\mathbf R} = \mathbf R\,[\boldsymbol\omega]_\times`, which no vector can be.
fn turned_by_rate(sides: &[Node]) -> Option<Letter> {
    let [left, right] = sides else { return None };
    let (Kind::TimeDerivative { operand, .. }, Kind::Product(factors)) =
        (&inner(left).kind, &inner(right).kind)
    else {
        return None;
    };
    let Kind::Symbol(matrix) = &inner(operand).kind else {
        return None;
    };
    let [one, other] = factors.as_slice() else {
        return None;
    };
    let itself = |node: &Node| matches!(&node.kind, Kind::Symbol(s) if s == matrix);
    let skew = |node: &Node| matches!(&inner(node).kind, Kind::Skew(_));
    let beside = other.operator == Operator::Juxtaposed;
    (beside && itself(&one.node) && skew(&other.node)).then(|| Letter::of(matrix))
}

/// The matrix of `\mathbf v_s = R\mathbf v` or `\mathbf I_s = R\mathbf I R^T`, which turns a vector or a tensor into the one with a label.
fn turning_to_label(sides: &[Node]) -> Option<Letter> {
    let [left, right] = sides else { return None };
    let symbol = |node: &'_ Node| match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol.clone()),
        _ => None,
    };
    let Kind::Product(factors) = &inner(right).kind else {
        return None;
    };
    let (labelled, first, second) = (
        symbol(left)?,
        symbol(&factors.first()?.node)?,
        symbol(&factors.get(1)?.node)?,
    );
    let undone = match &factors[2..] {
        [] => second.style.vector,
        [back] => matches!(&inner(&back.node).kind, Kind::Transpose(inside)
            if symbol(inside).as_ref() == Some(&first)),
        _ => false,
    };
    let own = labelled.name == second.name
        && labelled.style == second.style
        && second.subscripts.is_empty()
        && matches!(labelled.subscripts.as_slice(), [one] if axis(one).is_none());
    (own && undone && first.subscripts.is_empty() && !first.style.vector)
        .then(|| Letter::of(&first))
}

/// Letters that stand as an attitude matrix does: transposed beside a factor, or differentiated beside a skew matrix.
fn turns(node: &Node, found: &mut Vec<Letter>) {
    let mut note = |node: &Node| {
        if let Kind::Symbol(symbol) = &undotted(node).kind
            && (symbol.subscripts.is_empty() || leads(symbol))
        {
            found.push(Letter::of(symbol));
        }
    };
    if let Kind::Product(factors) = &node.kind {
        let skewed = factors
            .iter()
            .any(|f| matches!(inner(&f.node).kind, Kind::Skew(_)));
        for factor in factors
            .iter()
            .filter(|f| f.operator == Operator::Juxtaposed)
        {
            match &factor.node.kind {
                Kind::Transpose(inside) if factors.len() > 1 => note(inside),
                Kind::Symbol(symbol) if skewed && (!symbol.style.vector || leads(symbol)) => {
                    note(&factor.node);
                }
                _ => {}
            }
        }
    }
    node.children().for_each(|child| turns(child, found));
}

/// Whether a symbol wears the labels of two frames: `R_{WB}`.
fn leads(symbol: &Symbol) -> bool {
    let [labels] = symbol.subscripts.as_slice() else {
        return false;
    };
    labels.chars().count() == 2 && labels.chars().all(|c| c.is_ascii_uppercase())
}

fn holds_function(node: &Node) -> bool {
    matches!(node.kind, Kind::Function(..)) || node.children().any(holds_function)
}
