//! Products of small quantities that words leave out, "⟨w_2 w_3⟩ is neglected", and the spin that the next case is near to.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::theory::decide::{Decision, decide};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::Finding;
use crate::verify::words::book::lowered;
use crate::verify::words::small_words::{LEAVING_OUT, LEFT_OUT, THE_PRODUCT};

/// Words behind a component of ω that keeps its value.
const CONSTANT: &[&str] = &[
    "is constant",
    "remains constant",
    "stays constant",
    "is a constant",
];

impl Checker<'_> {
    /// "Neglecting the product ⟨w_2 w_3⟩": whether the words before an expression leave it out.
    pub(crate) fn leaves_out(&mut self, node: &Node) -> bool {
        let words = lowered(self.sentence.trim_end());
        let left_out = THE_PRODUCT.iter().any(|product| {
            let lead = words.strip_suffix(product).map(str::trim_end);
            lead.is_some_and(|lead| LEAVING_OUT.iter().any(|verb| lead.ends_with(verb)))
        });
        left_out && self.is_product_of_small(node)
    }

    /// The same for the words behind the last expression of a list.
    pub(crate) fn are_left_out(&mut self, text: &str, named: &[Node]) -> bool {
        LEFT_OUT.iter().any(|words| text.starts_with(words))
            && named
                .last()
                .is_some_and(|node| self.is_product_of_small(node))
    }

    fn is_product_of_small(&mut self, node: &Node) -> bool {
        let value = self.lowering(Frame::Moving).value(node);
        value.is_ok_and(|value| self.is_of_second_order(&value))
    }

    /// "Same steps. Now ⟨w_3⟩ is constant": of a component that was one of two small ones, in another case.
    pub(crate) fn spins_about_this_now(&mut self, text: &str, node: &Node) {
        let Kind::Symbol(symbol) = &inner(node).kind else {
            return;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let Meaning::Component(entity, axis) = self.meaning_of(symbol) else {
            return;
        };
        let was_small = self.small_turns.len() > 1 && self.small_turns.contains(&axis);
        let constant = CONSTANT.iter().any(|words| text.starts_with(words));
        if entity == omega && constant && was_small && self.linear {
            self.oscillation = None;
            self.hardly_changes(node);
            self.small_turns = (0..3).filter(|&c| c != axis).collect();
        }
    }

    /// `J_3\dot\epsilon_3 = 0`: whether a line is proved to its order with the equation about the axis of the spin, which the
    /// linear ones go on without.
    pub(crate) fn proved_about_the_spin(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let Some(axis) = self.theory.setting.dropped_axis else {
            return false;
        };
        self.theory.set(|setting| setting.dropped_axis = None);
        let readings = self.readings(sides).unwrap_or_default();
        let mut proof = None;
        for read in readings.into_iter().filter(|read| read.to_order) {
            if let Decision::True(found) = decide(&mut self.theory, &read.equations) {
                proof = Some((read, found));
                break;
            }
        }
        let proved = proof.is_some();
        if let Some((read, proof)) = proof {
            self.proved(&read, proof, finding);
        }
        self.theory.set(|setting| setting.dropped_axis = Some(axis));
        proved
    }
}
