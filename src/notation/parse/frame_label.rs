//! Labels of frames that are written before something.

use super::script::symbol_of;
use crate::notation::ast::{FrameLabel, Kind, Node};

/// A label of a frame on a bracket or a derivative. A derivative takes the label as its own.
pub(super) fn in_frame(node: Node, label: FrameLabel) -> Node {
    let span = node.span.to(label.span);
    let kind = match node.kind {
        Kind::TimeDerivative {
            operand,
            order,
            style,
            frame: None,
        } => Kind::TimeDerivative {
            operand,
            order,
            style,
            frame: Some(label),
        },
        Kind::Group(bracket, inner) => match inner.kind {
            Kind::TimeDerivative { frame: None, .. } => {
                return Node {
                    span,
                    ..in_frame(*inner, label)
                };
            }
            _ => Kind::InFrame(
                Box::new(Node {
                    kind: Kind::Group(bracket, inner),
                    span: node.span,
                }),
                label,
            ),
        },
        kind => Kind::InFrame(
            Box::new(Node {
                kind,
                span: node.span,
            }),
            label,
        ),
    };
    Node { kind, span }
}

/// A label written before something: the frame of a derivative, a superscript of a symbol.
pub(super) fn marked(mut node: Node, label: FrameLabel) -> Node {
    if matches!(
        node.kind,
        Kind::TimeDerivative {
            frame: None,
            style: crate::notation::ast::DerivativeStyle::Leibniz,
            ..
        }
    ) {
        return in_frame(node, label);
    }
    // Before a letter with its arguments it belongs to the letter.
    let marked = match &mut node.kind {
        Kind::Call(head, _) => symbol_of(head),
        _ => symbol_of(&mut node),
    };
    match marked {
        Some(symbol) => {
            symbol.superscripts.insert(0, label.text);
            node
        }
        None => in_frame(node, label),
    }
}
