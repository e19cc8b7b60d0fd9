//! Parts of a line that say nothing because they vanish.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::decide::passes_filter;

impl Checker<'_> {
    /// How many sums and symbols inside some sides are zero. A repair that makes a part vanish is none.
    pub(crate) fn hollow(&mut self, sides: &[Node]) -> usize {
        let mut count = match sides.iter().any(is_zero) {
            true => 0,
            false => usize::from(sides.iter().all(|side| self.is_nothing(side))),
        };
        for side in sides.iter().map(inner) {
            // A side itself may be what is said to vanish, though not as a − a.
            let value = self.lowering(Frame::Moving).value(side);
            let cancels = matches!(side.kind, Kind::Sum(_)) && value.is_ok_and(|v| v.is_zero());
            let parts = side.children();
            count +=
                usize::from(cancels) + parts.map(|part| self.hollow_parts(part)).sum::<usize>();
        }
        count
    }

    fn is_nothing(&mut self, node: &Node) -> bool {
        let value = self.lowering(Frame::Moving).value(node);
        value.is_ok_and(|value| passes_filter(&mut self.theory, &value) == Some(true))
    }

    fn hollow_parts(&mut self, node: &Node) -> usize {
        let rate_of_symbol = matches!(&node.kind, Kind::TimeDerivative { operand, .. } if matches!(operand.kind, Kind::Symbol(_)));
        let part = rate_of_symbol || matches!(node.kind, Kind::Sum(_) | Kind::Symbol(_));
        if part && self.is_nothing(node) {
            return 1;
        }
        if rate_of_symbol {
            return 0;
        }
        let children = node.children();
        children.map(|child| self.hollow_parts(child)).sum()
    }
}
