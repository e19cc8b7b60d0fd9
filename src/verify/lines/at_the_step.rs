//! Jacobians of a step: `\frac{\partial\omega_{k+1}}{\partial\omega_k} = E + h\frac{\partial\dot\omega}{\partial\omega}`,
//! where the derivative on the right is meant at step k.

use crate::notation::ast::{Factor, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner, symbols};

impl Checker<'_> {
    /// Gives the derivatives in a symbol without an index that of the step at hand, where the letter has it elsewhere.
    pub(crate) fn put_at_the_step(&self, sides: &mut [Node]) {
        let found = sides
            .iter()
            .enumerate()
            .find_map(|(at, side)| Some((at, step_of(side)?)));
        if let Some((at, step)) = found {
            let behind = sides.iter_mut().skip(at + 1);
            behind.for_each(|side| self.put_at(side, &step));
        }
    }

    fn put_at(&self, node: &mut Node, step: &str) {
        let bare =
            |node: &Node| matches!(&inner(node).kind, Kind::Symbol(s) if s.subscripts.is_empty());
        if let Kind::Product(factors) = &mut node.kind {
            take_in_where(factors);
            if let [whole] = factors.as_slice() {
                *node = whole.node.clone();
            }
        }
        let placed = match &node.kind {
            Kind::Call(head, _) | Kind::InFrame(head, _) => is_slope(head),
            _ => false,
        };
        if placed {
            return;
        }
        if let Kind::Derivative { variables, .. } = &node.kind
            && variables.iter().all(bare)
        {
            let mut arguments: Vec<Node> = vec![];
            for symbol in symbols(node) {
                let moves = self.reading.usage.has_index(&Letter::of(symbol), step);
                let mut at = symbol.clone();
                at.subscripts.push(step.to_owned());
                let kind = Kind::Symbol(at);
                if symbol.subscripts.is_empty() && moves && arguments.iter().all(|a| a.kind != kind)
                {
                    let span = node.span;
                    arguments.push(Node { kind, span });
                }
            }
            if !arguments.is_empty() {
                let head = Box::new(node.clone());
                node.kind = Kind::Call(head, arguments);
            }
            return;
        }
        let children = node.children_mut().into_iter();
        children.for_each(|child| self.put_at(child, step));
    }
}

/// The step k of a derivative in ω_k.
fn step_of(side: &Node) -> Option<String> {
    let Kind::Derivative { variables, .. } = &inner(side).kind else {
        return None;
    };
    let Kind::Symbol(symbol) = &inner(variables.first()?).kind else {
        return None;
    };
    let step = symbol.subscripts.last().cloned();
    step.filter(|step| matches!(step.as_str(), "k" | "n"))
}

fn is_slope(node: &Node) -> bool {
    matches!(inner(node).kind, Kind::Derivative { .. })
}

/// Joins a derivative to the bracket behind it that says where it is taken, `\frac{\partial f}{\partial\omega}(\omega_k)`.
fn take_in_where(factors: &mut Vec<Factor>) {
    let says = |pair: &[Factor]| is_slope(&pair[0].node) && is_place(&pair[1].node);
    let Some(at) = factors.windows(2).position(says) else {
        return;
    };
    let place = inner(&factors.remove(at + 1).node).clone();
    let slope = &mut factors[at].node;
    slope.kind = Kind::Call(Box::new(slope.clone()), vec![place]);
}

/// A lone symbol in a bracket.
fn is_place(node: &Node) -> bool {
    matches!(&node.kind, Kind::Group(..)) && matches!(inner(node).kind, Kind::Symbol(_))
}
