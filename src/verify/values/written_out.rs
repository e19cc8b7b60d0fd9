//! Sides that are written out: along unit vectors, or as a list of plain letters.

use crate::notation::ast::{Factor, Kind, Node, Operator, Symbol};
use crate::verify::letters::usage::inner;

/// Whether an expression is a vector by its unit vectors: `3\,\mathbf i + \mathbf j`, other than those of the letter itself.
pub(crate) fn is_directed(node: &Node, of: &Symbol) -> bool {
    match &node.kind {
        Kind::Symbol(symbol) => {
            let unit = matches!(symbol.name.as_str(), "i" | "j" | "k") || symbol.style.hat;
            unit && (symbol.style.vector || symbol.style.hat) && symbol.name != of.name
        }
        Kind::Group(_, inside) | Kind::Negate(inside) => is_directed(inside, of),
        Kind::Quotient(above, _) => is_directed(above, of),
        Kind::Sum(terms) => terms.iter().any(|term| is_directed(&term.node, of)),
        Kind::Product(factors) => {
            let scaled = |f: &Factor| f.operator == Operator::Juxtaposed;
            factors.iter().all(scaled) && factors.iter().any(|f| is_directed(&f.node, of))
        }
        _ => false,
    }
}

/// The letters of a row or column of three.
pub(crate) fn plain_list(side: &Node) -> Option<[String; 3]> {
    let entries: Vec<&Node> = match &inner(side).kind {
        Kind::Transpose(inside) => return plain_list(inside),
        Kind::Tuple(entries) => entries.iter().collect(),
        Kind::Matrix(rows) => rows.iter().flatten().collect(),
        _ => return None,
    };
    let plain = |node: &&Node| match &node.kind {
        Kind::Symbol(s) if !s.style.vector && s.subscripts.is_empty() => Some(s.name.clone()),
        _ => None,
    };
    let names: Option<Vec<String>> = entries.iter().map(plain).collect();
    names?.try_into().ok()
}

/// Whether a side is a sum along the plain letters i, j, k, or a determinant with them in its first row.
pub(crate) fn along_plain_units(side: &Node) -> bool {
    along(side, ["i", "j", "k"], |_| true)
}

/// The same of vectors called x, y, z.
pub(crate) fn along_vectors_xyz(side: &Node) -> bool {
    along(side, ["x", "y", "z"], |symbol| symbol.style.vector)
}

fn along(side: &Node, names: [&str; 3], fits: impl Fn(&Symbol) -> bool) -> bool {
    let unit = |node: &Node, name: &str| matches!(&node.kind, Kind::Symbol(s) if s.name == name && s.subscripts.is_empty() && fits(s));
    let named = |nodes: &[&Node]| {
        nodes.len() == 3 && nodes.iter().zip(names).all(|(n, name)| unit(n, name))
    };
    match &side.kind {
        Kind::Sum(terms) => {
            let last = terms.iter().map(|term| match &inner(&term.node).kind {
                Kind::Product(factors) => factors.last().map(|f| &f.node),
                _ => None,
            });
            let last: Option<Vec<&Node>> = last.collect();
            last.is_some_and(|last| named(&last))
        }
        Kind::Determinant(rows) => {
            let first = rows.first().map(|row| row.iter().collect::<Vec<_>>());
            first.is_some_and(|first| named(&first))
        }
        _ => false,
    }
}
