//! Motion near a spin that words give as a list, "near the spin ⟨(0, 0, n)⟩": the component along the axis keeps its value.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::Premise;
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

/// Words that call the components of ω small that no line has given.
const OTHERS: &[&str] = &[
    "other components",
    "other two components",
    "other two",
    "other rates",
];
const VERBS: &[&str] = &[
    "",
    "are ",
    "being ",
    "be ",
    "remain ",
    "stay ",
    "remaining ",
    "staying ",
];
const SMALL: &[&str] = &[
    "small",
    "very small",
    "tiny",
    "infinitesimal",
    "much smaller",
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
        let premise = Premise {
            name: "the spin that the motion is near to".to_owned(),
            residuals: vec![variable_fraction(own) - rate],
            preferred: vec![own],
            definition: false,
        };
        if self.take_from_words(premise, node.span) {
            self.now_known([node]);
            self.small_turns.extend((0..3).filter(|&c| c != axis));
            self.drop_second_order();
        }
    }

    /// "Let ⟨ω_3 = n⟩ be constant and the other components small."
    pub(crate) fn others_are_small(&mut self, text: &str) {
        let behind = OTHERS.iter().filter_map(|others| text.split_once(others));
        let mut rests = behind.map(|(_, rest)| rest.trim_start());
        let small = |rest: &str| {
            let called = |rest: &str| SMALL.iter().any(|word| rest.starts_with(word));
            let mut verbs = VERBS.iter();
            verbs.any(|verb| rest.strip_prefix(verb).is_some_and(called))
        };
        if !rests.any(small) {
            return;
        }
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let given: Vec<u8> = (0..3)
            .filter(|&c| {
                let variable = self.theory.atoms.part(omega, c, 0);
                self.theory.rule(variable).is_some()
            })
            .collect();
        if let [axis] = given.as_slice() {
            self.small_turns.extend((0..3).filter(|c| c != axis));
            self.drop_second_order();
        }
    }
}
