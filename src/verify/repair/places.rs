//! The places of a line in which something may be wanted.

use crate::notation::ast::{Kind, Node};

/// What kind of place it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// A symbol, under its dots.
    Symbol,
    /// A term of a sum, or a whole side.
    Term,
    /// A sum, or what may become one by a further term.
    Sum,
}

/// What stands around a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Around {
    /// Nothing that a further term would have to be kept from.
    Nothing,
    /// A stroke of division: a further term needs brackets.
    Stroke,
    /// Factors or terms: a further term needs brackets, and is one symbol.
    Factors,
}

/// A place of a line.
pub(crate) struct Place<'a> {
    pub(crate) node: &'a Node,
    pub(crate) roles: &'static [Role],
    pub(crate) around: Around,
}

/// The places in a tree.
pub(crate) fn visit<'a>(node: &'a Node, around: Around, out: &mut Vec<Place<'a>>) {
    let mut push = |node, roles, around| {
        out.push(Place {
            node,
            roles,
            around,
        })
    };
    // A factor of a term stands for the whole of it, but for another symbol in its place or beside it.
    let whole: &[Role] = match around {
        Around::Factors => &[],
        _ => &[Role::Term, Role::Sum],
    };
    let symbol: &[Role] = match around {
        Around::Factors => &[Role::Symbol, Role::Sum],
        _ => &[Role::Symbol, Role::Term, Role::Sum],
    };
    match &node.kind {
        Kind::Number(_) => {}
        Kind::Symbol(_) => push(node, symbol, around),
        Kind::TimeDerivative { operand, .. } if matches!(operand.kind, Kind::Symbol(_)) => {
            push(node, symbol, around);
        }
        Kind::TimeDerivative { .. } | Kind::Derivative { .. } => push(node, &[Role::Sum], around),
        Kind::Sum(terms) => {
            push(node, &[Role::Sum], around);
            for term in terms {
                // A symbol that is a term is one place, with all it can be.
                let before = out.len();
                visit(&term.node, Around::Factors, out);
                match out.get_mut(before) {
                    Some(first) if std::ptr::eq(first.node, &term.node) => {
                        first.roles = &[Role::Symbol, Role::Term, Role::Sum];
                    }
                    _ => out.push(Place {
                        node: &term.node,
                        roles: &[Role::Term],
                        around: Around::Factors,
                    }),
                }
            }
        }
        Kind::Quotient(top, bottom) => {
            push(node, whole, around);
            // Between \frac and its braces the parts are apart; beside a stroke they are not.
            let braced = node.span.start < top.span.start && top.span.end < bottom.span.start;
            let inner = if braced {
                Around::Nothing
            } else {
                Around::Stroke
            };
            visit(top, inner, out);
        }
        // What stands inside is not linear in the line; the line is in the whole.
        Kind::Power(..) | Kind::Function(..) | Kind::Norm(_) => {
            push(node, whole, around);
        }
        kind => {
            push(node, whole, around);
            let apart = matches!(
                kind,
                Kind::Group(..) | Kind::Matrix(_) | Kind::Tuple(_) | Kind::Call(..)
            );
            let inner = if apart {
                Around::Nothing
            } else {
                Around::Factors
            };
            for child in node.children() {
                visit(child, inner, out);
            }
        }
    }
}
