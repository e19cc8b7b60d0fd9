//! What does not change, and a new letter for its value: `A^2p^2 + B^2q^2 + C^2r^2 = G^2`.

use crate::notation::ast::{Kind, Node, Operator};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::growth::lasts;
use crate::verify::values::atoms::Owner;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

impl Checker<'_> {
    /// Takes in the letter of a number, or of the square of one, that something is which is proved not to change.
    pub(crate) fn names_an_integral(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let Some(named) = letter(right) else {
            return false;
        };
        let Some((entity, None)) = self.new_symbol(named) else {
            return false;
        };
        let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
        if !own || self.theory.mentions_entity(entity) {
            return false;
        }
        let Some(value) = self.lowering(Frame::Moving).scalar(left) else {
            return false;
        };
        let moves = !self.theory.atoms.derivative(&value).is_zero();
        if !moves || !lasts(&mut self.theory, &value) {
            return false;
        }
        self.theory.atoms.info_mut(entity).constant = true;
        self.accept(sides, Role::Define, finding);
        if finding.verdict == Verdict::Accepted {
            finding
                .remarks
                .push("what it names does not change".to_owned());
        }
        finding.verdict == Verdict::Accepted
    }
}

/// The G of `G^2` and of `2G`.
fn letter(node: &Node) -> Option<&Node> {
    match &inner(node).kind {
        Kind::Symbol(_) => Some(inner(node)),
        Kind::Power(base, exponent) if matches!(exponent.kind, Kind::Number(_)) => letter(base),
        Kind::Product(factors) => match factors.as_slice() {
            [number, factor]
                if matches!(number.node.kind, Kind::Number(_))
                    && factor.operator == Operator::Juxtaposed =>
            {
                letter(&factor.node)
            }
            _ => None,
        },
        _ => None,
    }
}
