//! Jacobians of a step: `\frac{\partial\omega_{k+1}}{\partial\omega_k} = E + h\frac{\partial\dot\omega}{\partial\omega}`,
//! where the derivative on the right is meant at step k.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner, symbols};

impl Checker<'_> {
    /// Gives the derivatives in a symbol without an index that of the step at hand, where the letter has it elsewhere.
    pub(crate) fn put_at_the_step(&self, sides: &mut [Node]) {
        let [left, rest @ ..] = sides else { return };
        let Kind::Derivative { variables, .. } = &inner(left).kind else {
            return;
        };
        let step = variables
            .first()
            .and_then(|variable| match &inner(variable).kind {
                Kind::Symbol(symbol) => symbol.subscripts.last().cloned(),
                _ => None,
            });
        if let Some(step) = step.filter(|step| matches!(step.as_str(), "k" | "n")) {
            rest.iter_mut().for_each(|side| self.put_at(side, &step));
        }
    }

    fn put_at(&self, node: &mut Node, step: &str) {
        let bare =
            |node: &Node| matches!(&inner(node).kind, Kind::Symbol(s) if s.subscripts.is_empty());
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
