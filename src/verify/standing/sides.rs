//! The two sides of a link, lowered and on the same axes.

use crate::notation::ast::{Kind, Node};
use crate::verify::standing::chains::Link;
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::{Shape, Trouble, Value};

/// Both sides of a link, and the letter that it settles if it could.
pub(super) struct Both {
    pub(super) left: Value,
    pub(super) right: Value,
    pub(super) settles: Option<String>,
}

/// Lowers both sides; a lone letter of which nothing is told takes its shape from the other side.
pub(super) fn both(lowering: &mut Lowering<'_>, link: &Link) -> Result<Both, Trouble> {
    let left = lowering.value(&link.left)?;
    let unknown_left = lowering.unknown.clone();
    let right = lowering.value(&link.right)?;
    let custom = lowering.custom();
    fn lone(node: &Node) -> Option<String> {
        match &node.kind {
            Kind::Symbol(_) => Some(crate::notation::print::latex(node)),
            Kind::Group(_, inner) => lone(inner),
            _ => None,
        }
    }
    let new = |l: &String| !lowering.shapes.contains_key(l);
    let letter = lone(&link.left).filter(|l| unknown_left.contains(l) && new(l));
    let other =
        lone(&link.right).filter(|l| lowering.unknown.contains(l) && letter.is_none() && new(l));
    match (&letter, &other) {
        (Some(name), _) if (left.rows, left.columns) != (right.rows, right.columns) => {
            let shaped = shaped(lowering, name, &right);
            Ok(Both {
                left: shaped,
                right,
                settles: letter,
            })
        }
        (_, Some(name)) if (left.rows, left.columns) != (right.rows, right.columns) => {
            let shaped = shaped(lowering, name, &left);
            Ok(Both {
                left: shaped,
                right: left,
                settles: other,
            })
        }
        (Some(name), _) => {
            let left = shaped(lowering, name, &right);
            Ok(Both {
                left,
                right,
                settles: letter,
            })
        }
        _ => {
            let (left, right) = lowering.system.compared(&left, &right, custom)?;
            Ok(Both {
                left,
                right,
                settles: letter.or(other),
            })
        }
    }
}

/// A letter of which nothing is told, in the shape of what it is set equal to.
fn shaped(lowering: &mut Lowering<'_>, name: &str, like: &Value) -> Value {
    let Value {
        rows,
        columns,
        basis,
        ..
    } = *like;
    lowering.unknown_of_shape(
        name,
        Shape {
            rows,
            columns,
            basis,
        },
    )
}
