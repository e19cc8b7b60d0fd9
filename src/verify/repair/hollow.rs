//! Parts of a line that say nothing because they vanish.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::theory::decide::passes_filter;

impl Checker<'_> {
    /// How many sums and symbols inside some sides are zero. A repair that makes a part vanish is none.
    pub(crate) fn hollow(&mut self, sides: &[Node]) -> usize {
        let mut count = 0;
        for side in sides.iter().map(inner) {
            // A side itself may be what is said to vanish, though not as a − a.
            let value = self.lowering(Frame::Moving).value(side);
            let cancels = matches!(side.kind, Kind::Sum(_)) && value.is_ok_and(|v| v.is_zero());
            let parts = side.children().into_iter();
            count +=
                usize::from(cancels) + parts.map(|part| self.hollow_parts(part)).sum::<usize>();
        }
        count
    }

    fn hollow_parts(&mut self, node: &Node) -> usize {
        let rate_of_symbol = matches!(&node.kind, Kind::TimeDerivative { operand, .. } if matches!(operand.kind, Kind::Symbol(_)));
        let part = rate_of_symbol || matches!(node.kind, Kind::Sum(_) | Kind::Symbol(_));
        if part {
            let value = self.lowering(Frame::Moving).value(node);
            if value.is_ok_and(|value| passes_filter(&mut self.theory, &value) == Some(true)) {
                return 1;
            }
        }
        if rate_of_symbol {
            return 0;
        }
        let children = node.children().into_iter();
        children.map(|child| self.hollow_parts(child)).sum()
    }
}
