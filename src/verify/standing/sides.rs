//! The two sides of a link, lowered and on the same axes.

use crate::notation::ast::{Kind, Node};
use crate::notation::print::latex;
use crate::verify::standing::chains::Link;
use crate::verify::term::applied::text_of_function;
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::{Trouble, Value};
use std::collections::BTreeMap;

/// Both sides of a link, and the letter that it settles if it could.
pub(super) struct Both {
    pub(super) left: Value,
    pub(super) right: Value,
    pub(super) settles: Option<String>,
}

/// The letter that a side consists of.
pub(super) fn lone(side: &Node) -> Option<String> {
    match &side.kind {
        Kind::Symbol(_) => Some(latex(side)),
        Kind::Group(_, inner) => lone(inner),
        Kind::Call(head, arguments) => match &head.kind {
            Kind::Symbol(symbol) => Some(text_of_function(symbol, arguments)),
            _ => None,
        },
        _ => None,
    }
}

/// The letters that are factors of a side.
pub(super) fn factors(side: &Node) -> Vec<String> {
    match &side.kind {
        Kind::Product(factors) => factors.iter().filter_map(|f| lone(&f.node)).collect(),
        _ => lone(side).into_iter().collect(),
    }
}

/// Lowers both sides; a lone letter of which nothing is told takes its shape from the other side.
pub(super) fn both(lowering: &mut Lowering<'_>, link: &Link<'_>) -> Result<Both, Trouble> {
    let left = lowering.value(&link.left)?;
    let unknown_left = lowering.unknown.clone();
    let right = lowering.value(&link.right)?;
    let custom = lowering.custom();
    let new = |side: &Node, unknown: &BTreeMap<String, bool>| {
        let lone = (!unknown.is_empty()).then(|| lone(side)).flatten();
        lone.filter(|l| unknown.contains_key(l) && !lowering.known.shapes.contains_key(l))
    };
    let letter = new(&link.left, &unknown_left);
    let other = new(&link.right, &lowering.unknown).filter(|_| letter.is_none());
    let alike = (left.rows, left.columns) == (right.rows, right.columns);
    match (letter, other) {
        (Some(name), _) => Ok(Both {
            left: lowering.unknown_of_shape(&name, right.shape()),
            right,
            settles: Some(name),
        }),
        (None, Some(name)) if !alike => Ok(Both {
            left: lowering.unknown_of_shape(&name, left.shape()),
            right: left,
            settles: Some(name),
        }),
        (None, settles) => {
            let (left, right) = lowering.beside_quaternions(left, right)?;
            let (left, right) = lowering.beside_matrix(left, right)?;
            let (left, right) = lowering.system.compared(&left, &right, custom)?;
            Ok(Both {
                left,
                right,
                settles,
            })
        }
    }
}
