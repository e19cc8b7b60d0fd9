//! Motion near a spin that words give as a list, "near the spin ⟨(0, 0, n)⟩": the component along the axis keeps its value.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::lowered;

/// Words before the list.
const NEAR: &[&str] = &[
    "near the spin",
    "near the rotation",
    "near the motion",
    "near the steady spin",
    "near the steady rotation",
    "close to the spin",
    "close to the rotation",
    "about the spin",
    "around the spin",
    "around the rotation",
];

impl Checker<'_> {
    /// Takes in that the only component of such a list that is not zero is that of the body.
    pub(crate) fn turns_near(&mut self, node: &Node) {
        let Kind::Tuple(parts) = &inner(node).kind else {
            return;
        };
        let words = lowered(self.sentence.trim_end());
        let said = NEAR.iter().any(|near| words.ends_with(near));
        let mut moving = (0u8..).zip(parts).filter(|(_, part)| !is_zero(part));
        let (Some((axis, rate)), None, 3, true) = (moving.next(), moving.next(), parts.len(), said)
        else {
            return;
        };
        let Some(rate) = self.lowering(Frame::Moving).scalar(rate) else {
            return;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let own = self.theory.atoms.part(omega, axis, 0);
        let name = "the spin that the motion is near to".to_owned();
        let premise = Premise {
            name: name.clone(),
            residuals: vec![variable_fraction(own) - rate],
            preferred: vec![own],
            definition: false,
        };
        if self.theory.assume(premise) == Taken::Solved {
            self.keep(&name, false);
            self.tell(node.span, name);
            self.now_known([node]);
            self.small_turns.extend((0..3).filter(|&c| c != axis));
            self.drop_second_order();
        }
    }
}
