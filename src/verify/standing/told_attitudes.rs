//! Lines that may tell how a frame turns of which no sentence tells it.

use crate::notation::ast::{Kind, Node, Operator};
use crate::verify::language::messages;
use crate::verify::model::system::{FrameId, Turn};
use crate::verify::standing::chains::Link;
use crate::verify::standing::judge::Judge;
use crate::verify::term::letters::{Letter, Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;

impl Judge<'_> {
    /// Why a link is not denied that sets the matrix of a frame, or its rate, to a product of other matrices: where no sentence
    /// says how the frame turns, `T = T_1 T_2` may say it.
    pub(super) fn may_tell_attitude(&mut self, link: &Link<'_>) -> Option<String> {
        let is_rotation = |letter: &Letter| {
            matches!(
                &letter.meaning,
                Meaning::Quantity(Quantity::Rotation { .. })
            )
        };
        if !self.reading.letters.letters.iter().any(is_rotation) {
            return None;
        }
        let [left, right] = link.sides();
        [(left, right), (right, left)]
            .into_iter()
            .find_map(|(matrix, other)| {
                let frame = self.untold_frame_of(undotted(matrix))?;
                let name = self.reading.system.frames[frame].name.clone();
                let told = self.is_made_of_matrices(other, &spelled(undotted(matrix)));
                told.then(|| messages::untold_attitude(&name))
            })
    }

    /// The frame that a matrix turns, where no sentence tells more of it than that it turns.
    fn untold_frame_of(&self, matrix: &Node) -> Option<FrameId> {
        let letters = &self.reading.letters;
        let letter = letters.find(&spelled(matrix), &loosely(matrix), &self.at, 0)?;
        let Meaning::Quantity(Quantity::Rotation { from, to }) = &letter.meaning else {
            return None;
        };
        let system = &self.reading.system;
        let untold = |&frame: &FrameId| {
            let own = &system.frames[frame];
            let carries = system.bodies.iter().any(|body| body.frame == Some(frame));
            own.turn == Turn::Free && own.parent.is_some() && !carries && !own.by_quaternion
        };
        let pair = [*from, *to];
        let of_pair = |&frame: &FrameId| {
            system.frames[frame]
                .parent
                .is_some_and(|p| pair.contains(&p))
        };
        pair.into_iter()
            .find(|frame| untold(frame) && of_pair(frame))
    }

    /// Whether a formula is made of matrices, and not of one of them.
    fn is_made_of_matrices(&mut self, node: &Node, but: &str) -> bool {
        match &node.kind {
            Kind::Symbol(_) | Kind::Call(..) => {
                let value = self.lowering().value(node);
                spelled(node) != but && value.is_ok_and(|value| value.is_matrix())
            }
            Kind::Product(factors) => factors.iter().all(|factor| {
                let plain = matches!(factor.operator, Operator::Juxtaposed | Operator::Dot);
                plain && self.is_made_of_matrices(&factor.node, but)
            }),
            Kind::Sum(terms) => terms
                .iter()
                .all(|term| self.is_made_of_matrices(&term.node, but)),
            Kind::Group(_, inner)
            | Kind::Transpose(inner)
            | Kind::Power(inner, _)
            | Kind::TimeDerivative { operand: inner, .. } => self.is_made_of_matrices(inner, but),
            _ => false,
        }
    }
}

/// A letter without the sign of its rate.
fn undotted(node: &Node) -> &Node {
    match &node.kind {
        Kind::TimeDerivative { operand, .. } => operand,
        Kind::Group(_, inner) => undotted(inner),
        _ => node,
    }
}
