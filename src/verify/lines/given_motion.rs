//! Lines that hand over how the body or the axes turn.

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Role, Verdict};

impl Checker<'_> {
    /// Whether a side is the rate of the angular velocity, or of a component of it, that nothing determines.
    pub(crate) fn is_free_rate(&mut self, side: &Node) -> bool {
        let Kind::TimeDerivative { operand, .. } = &inner(side).kind else {
            return false;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let turning = self.entities([&**operand]) == [omega];
        let Ok(value) = self.lowering(Frame::Moving).value(side) else {
            return false;
        };
        let mut entries = value.entries.iter();
        turning && entries.all(|entry| self.theory.normal(entry).as_variable().is_some())
    }

    /// Whether a side is how the body or the axes turn, which no law determines: words that derive it speak of the
    /// figure ("the axes point so that").
    pub(crate) fn sets_motion(&mut self, side: &Node) -> bool {
        let turns = |q: &Quantity| matches!(q, Quantity::AngularVelocity | Quantity::FrameRate);
        self.entities([side]).first().is_some_and(|entity| {
            matches!(&self.theory.atoms.info(*entity).owner, Owner::Quantity(q, _) if turns(q))
        })
    }

    /// Whether a line says how the axes turn by how the body does: they follow all of it but a spin.
    pub(crate) fn is_turn_of_axes(&mut self, first: &Node, last: &Node) -> bool {
        let turns = |checker: &Self, entity| match &checker.theory.atoms.info(entity).owner {
            Owner::Quantity(q, _) => {
                matches!(q, Quantity::AngularVelocity | Quantity::FrameRate)
            }
            Owner::Symbol(_) => true,
        };
        let axes = self.entities([first]).first().is_some_and(|&entity| {
            matches!(
                &self.theory.atoms.info(entity).owner,
                Owner::Quantity(Quantity::FrameRate, _)
            )
        });
        let body = !matches!(inner(last).kind, Kind::Symbol(_));
        axes && body
            && self
                .entities([last])
                .into_iter()
                .all(|entity| turns(self, entity))
    }

    /// Whether a line in the same breath gives another component of how the body turns.
    pub(crate) fn stands_beside_motion(&mut self, side: &Node) -> bool {
        let beside = std::mem::take(&mut self.beside);
        let given = beside.iter().any(|(left, last)| {
            left.span != side.span
                && !is_zero(last)
                && self.sets_motion(left)
                && self.is_free_input(left)
        });
        self.beside = beside;
        if given {
            return self.sets_motion(side);
        }
        let (line, _, _) = self.place(side.span.start);
        let handed = self.findings.last().is_some_and(|before| {
            before.role == Role::Given
                && before.verdict == Verdict::Accepted
                && before.source_line + 1 >= line
        });
        handed && self.sets_motion(side)
    }

    /// Whether a display says the second rate of a symbol of which earlier lines speak: what follows from laws, which
    /// may not be known here.
    pub(crate) fn is_equation_of_motion(&mut self, sides: &[Node]) -> bool {
        let second = match &inner(&sides[0]).kind {
            Kind::TimeDerivative { operand, order, .. } => {
                *order >= 2 && self.is_mentioned(operand)
            }
            _ => false,
        };
        second && self.displayed
    }

    /// Whether an earlier line speaks of something in a node.
    fn is_mentioned(&mut self, node: &Node) -> bool {
        let entities = self.entities([node]);
        entities
            .into_iter()
            .any(|entity| self.theory.mentions_entity(entity))
    }
}
