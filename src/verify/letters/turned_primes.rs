//! Primes of axes that are turned: `\mathbf I' = R\mathbf I R^T`, `\mathbf v' = R\mathbf v`. The matrix turns the components on the body's axes
//! into those on others, as the attitude matrix does for the axes of space, whose label takes the place of the prime.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::attitude_matrix::MATRIX_LETTERS;
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::inner;

/// The label in the place of the prime.
pub(crate) const TURNED: &str = "s";

/// Writes the label of space for the primes of a document in which a line turns a letter into the one with a prime;
/// whether there were any.
pub(crate) fn label_turned_primes(document: &mut Document) -> bool {
    let Some(matrix) = document.lines().find_map(turning_matrix).cloned() else {
        return false;
    };
    let taken = |s: &&Symbol| {
        s.primes > 1
            || s.subscripts
                .iter()
                .any(|label| label == TURNED || label.contains('\''))
            || s.primes == 1 && s.name == matrix.name
    };
    if every_symbol(document).iter().any(taken) {
        return false;
    }
    for node in formulas_mut(document) {
        node.change_symbols(&mut |symbol| {
            if symbol.primes == 1 {
                symbol.primes = 0;
                symbol.subscripts.push(TURNED.to_owned());
            }
        });
    }
    true
}

/// The matrix R of a line `X' = R X` or `X' = R X R^T`.
pub(crate) fn turning_matrix(line: &Line) -> Option<&Symbol> {
    let [left, right] = line.sides.as_slice() else {
        return None;
    };
    let primed = symbol(left).filter(|s| s.primes == 1)?;
    let Kind::Product(factors) = &inner(right).kind else {
        return None;
    };
    let (matrix, turned, back) = match factors.as_slice() {
        [matrix, turned] => (matrix, turned, None),
        [matrix, turned, back] => (matrix, turned, Some(back)),
        _ => return None,
    };
    let matrix = symbol(&matrix.node)?;
    let plain =
        |s: &Symbol| s.name == primed.name && s.primes == 0 && s.subscripts == primed.subscripts;
    let undone = back.is_none_or(|back| match &inner(&back.node).kind {
        Kind::Transpose(inside) => symbol(inside) == Some(matrix),
        _ => false,
    });
    let usual = MATRIX_LETTERS.contains(&matrix.name.as_str()) && matrix.subscripts.is_empty();
    (usual && undone && symbol(&turned.node).is_some_and(plain)).then_some(matrix)
}

fn symbol(node: &Node) -> Option<&Symbol> {
    match &inner(node).kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}
