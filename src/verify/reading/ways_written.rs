//! How formulas are written at their heads: which lines may carry the sign of an operator of which nothing is made.

use crate::notation::ast::{Kind, Node};
use crate::verify::reading::unused::names_one;
use std::collections::BTreeSet;
use std::mem::discriminant;

/// Whether a formula may carry the sign of an operator that is no rate, at its head: brackets are read in several ways, and so is what
/// stands raised or side by side.
pub(super) fn may_be_written_as(node: &Node, operator: &Node) -> bool {
    if let Kind::Call(name, _) = &operator.kind
        && let Kind::Symbol(name) = &name.kind
    {
        return names_one(node, &BTreeSet::from([name.name.clone()]));
    }
    let (own, its) = (ways_written(node), ways_written(operator));
    own.iter().any(|way| its.contains(way))
        || discriminant(&node.kind) == discriminant(&operator.kind)
}

/// How a formula is written at its head.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Brackets,
    SideBySide,
    Raised,
    Quotient,
}

fn ways_written(node: &Node) -> &'static [Way] {
    match &node.kind {
        Kind::Call(..) | Kind::Group(..) => &[Way::Brackets, Way::SideBySide],
        Kind::Tuple(_) | Kind::Matrix(_) | Kind::Determinant(_) | Kind::Norm(_) => &[Way::Brackets],
        Kind::Skew(_) | Kind::InFrame(..) => &[Way::Brackets, Way::Raised],
        Kind::Product(_) => &[Way::SideBySide],
        Kind::Power(..) | Kind::Transpose(_) => &[Way::Raised],
        Kind::Symbol(symbol) if !symbol.superscripts.is_empty() || symbol.primes > 0 => {
            &[Way::Raised]
        }
        Kind::Quotient(..) | Kind::TimeDerivative { .. } | Kind::Derivative { .. } => {
            &[Way::Quotient]
        }
        _ => &[],
    }
}
